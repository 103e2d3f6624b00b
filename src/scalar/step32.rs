//! The arithmetic of a step in fixed point: 32-bit numbers in the units of the step, and prepared columns.
//!
//! A body's spin is kept times a power of two near its size rho, 11 to 32 times the square root of (1/m) / trace(I^-1). So spins
//! and speeds are of one magnitude, |r x d| / rho is below 2 for arms up to 18 times the thickness of a rod, and the change of
//! spin for an impulse, rho |I^-1 (r x d)|/K, at most rho sqrt(m / 4 I_min) < 16, whatever the shape and the arm.
//!
//! In the inner loops sums of products are rounded once, to the nearest. A check of the impulse before it is applied, and of
//! a speed after it is formed, leads to slower code where a number could leave its range: there it stays at the end of it.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U30, U31};

use super::integer::{leading_zeros, round_shift, round_sqrt, wide_quotient};
use super::product::{add_dot, dot, dot2, product};
use super::scaled32::{Scaled32, shift_product};
use super::step::{Column, StepArithmetic, Weights};
use super::stored32::clip;
use super::wide::{bits, bits_of, high, inverse, magnitude, max, narrow};
use crate::math::{SymMat3, Vec3};

/// The arithmetic of a step for `FixedI32`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedStep;

/// r x d and I^-1 (r x d) for three directions: blocks of Q2.30.
#[derive(Clone, Copy, Debug)]
pub struct StepLevers32 {
    arms: [[i32; 3]; 3],
    arm_exponent: i32,
    turns: [[i32; 3]; 3],
    turn_exponent: i32,
}

/// Fraction bits of directions and of arms, which are below 2.
const ARM: u32 = 28;
/// Fraction bits of a turn, which is below 16.
const TURN: u32 = 26;
/// Impulses whose effects are within 32 bits without a look: less than this.
const LARGE: i32 = 1 << 26;
/// Fraction bits of a ratio.
const RATIO: u32 = 20;
/// Beyond the range of every result.
const FAR: i64 = 1 << 62;
/// The size of a body in powers of two, at either end.
const LARGEST: i32 = 14;
/// What is stored of a velocity beyond its format.
const REST: i32 = 16;

/// `x / 2^K` rounded, for results within 32 bits.
#[inline(always)]
fn round<const K: u32>(x: i64) -> i32 {
    narrow::<K>(x.wrapping_add(1 << (K - 1)))
}

/// `x / 2^K` rounded and clipped, for `|x|` below 2^63 - 2^K.
#[inline(always)]
fn near<const K: u32>(x: i64) -> i32 {
    let rounded = x.wrapping_add(1 << (K - 1)) >> K;
    if rounded as i32 as i64 == rounded { rounded as i32 } else { end(rounded) }
}

#[cold]
#[inline(never)]
fn end(x: i64) -> i32 {
    if x < 0 { i32::MIN } else { i32::MAX }
}

/// `x / 2^down` rounded and clipped, for any `down`.
#[inline(never)]
fn shifted(x: i64, down: i32) -> i32 {
    clip(shift_product(x, down)).0
}

/// The same within +-2^PLACES.
#[inline(never)]
fn within<const PLACES: u32>(x: i64, down: i32) -> i32 {
    let (x, end) = (shift_product(x, down), 1i64 << PLACES);
    if x > end {
        1 << PLACES
    } else if x < -end {
        -(1 << PLACES)
    } else {
        x as i32
    }
}

/// `x / 2^down` rounded, for `|x|` up to 2^30 and `down` from 1 on.
#[inline(always)]
fn rounded_down(x: i32, down: i32) -> i32 {
    let down = (down as u32).min(31);
    x.wrapping_add(1i32.wrapping_shl(down.wrapping_sub(1))).wrapping_shr(down)
}

#[inline(always)]
fn unit_vector(v: [i32; 3]) -> Vec3<I2F30> {
    Vec3::new(I2F30::from_bits(v[0]), I2F30::from_bits(v[1]), I2F30::from_bits(v[2]))
}

/// Adds a change to each component.
#[inline(always)]
fn add<F: LeEqU32>(v: &mut Vec3<FixedI32<F>>, change: [i32; 3]) {
    v.x = v.x.saturating_add(FixedI32::from_bits(change[0]));
    v.y = v.y.saturating_add(FixedI32::from_bits(change[1]));
    v.z = v.z.saturating_add(FixedI32::from_bits(change[2]));
}

/// A vector of Q2.30 after that of 2^-28, or opposite to it, times its length; and a turn.
#[inline(always)]
fn apply<F: LeEqU32>(
    v: &mut Vec3<FixedI32<F>>,
    w: &mut Vec3<FixedI32<F>>,
    d: &Vec3<I2F30>,
    column: &Column<FixedI32<F>>,
    impulse: i32,
    sign: i32,
) where
    FixedI32<F>: super::Scalar<Unit = I2F30>,
{
    let (d, turn) = (bits(d), bits(&column.turn));
    if impulse.wrapping_add(LARGE) as u32 >= 2 * LARGE as u32 {
        return apply_large(v, w, [d, turn], column.share.to_bits(), impulse, sign);
    }
    let share = round::<30>(product(column.share.to_bits(), impulse)).wrapping_mul(sign);
    let along = |d| round::<ARM>(product(d, share));
    add(v, [along(d[0]), along(d[1]), along(d[2])]);
    let turned = |u| round::<TURN>(product(u, impulse));
    add(w, [turned(turn[0]), turned(turn[1]), turned(turn[2])]);
}

#[cold]
#[inline(never)]
fn apply_large<F: LeEqU32>(
    v: &mut Vec3<FixedI32<F>>,
    w: &mut Vec3<FixedI32<F>>,
    [d, turn]: [[i32; 3]; 2],
    share: i32,
    impulse: i32,
    sign: i32,
) {
    let share = near::<30>(product(share, impulse)).saturating_mul(sign);
    add(v, [near::<ARM>(product(d[0], share)), near::<ARM>(product(d[1], share)), near::<ARM>(product(d[2], share))]);
    let turned = |u| near::<TURN>(product(u, impulse));
    add(w, [turned(turn[0]), turned(turn[1]), turned(turn[2])]);
}

#[cold]
#[inline(never)]
fn thrust_large<F: LeEqU32>(v: &mut Vec3<FixedI32<F>>, d: [i32; 3], share: i32, impulse: i32) {
    let share = near::<30>(product(share, impulse));
    add(v, [near::<ARM>(product(d[0], share)), near::<ARM>(product(d[1], share)), near::<ARM>(product(d[2], share))]);
}

/// A vector `x / 2^down` rounded, within +-2^PLACES, for any `down` and components up to 2^30.
#[inline(always)]
fn fitted3<const PLACES: u32>(v: [i32; 3], down: i32) -> [i32; 3] {
    if down >= 1 {
        return [rounded_down(v[0], down), rounded_down(v[1], down), rounded_down(v[2], down)];
    }
    let up = down.wrapping_neg() as u32;
    if up <= 30 && magnitude(v).wrapping_shr((PLACES - 1).saturating_sub(up)) <= 1 {
        return [v[0].wrapping_shl(up), v[1].wrapping_shl(up), v[2].wrapping_shl(up)];
    }
    [raised::<PLACES>(v[0], up), raised::<PLACES>(v[1], up), raised::<PLACES>(v[2], up)]
}

/// `x / 2^down` rounded, within +-2^PLACES, for any `down` and `|x|` up to 2^30.
#[inline(always)]
fn fitted<const PLACES: u32>(x: i32, down: i32) -> i32 {
    if down >= 1 { rounded_down(x, down) } else { raised::<PLACES>(x, down.wrapping_neg() as u32) }
}

#[cold]
#[inline(never)]
fn raised<const PLACES: u32>(x: i32, up: u32) -> i32 {
    let end = 1i32 << PLACES;
    if up > 30 || x.unsigned_abs() > (end as u32).wrapping_shr(up) {
        return if x < 0 {
            -end
        } else if x > 0 {
            end
        } else {
            0
        };
    }
    x.wrapping_shl(up)
}

/// One lever's column for an inverse mass `m` and an inverse K `k`, as mantissa and exponent.
#[inline(always)]
fn column<F: LeEqU32>(
    arm: [i32; 3],
    turn: [i32; 3],
    [arm_exponent, turn_exponent]: [i32; 2],
    m: Scaled32,
    k: Scaled32,
    size: i32,
) -> Column<FixedI32<F>>
where
    FixedI32<F>: super::Scalar<Unit = I2F30>,
{
    let down = size.wrapping_sub(arm_exponent).wrapping_add(30 - ARM as i32);
    let arm = fitted3::<{ ARM + 1 }>(arm, down);
    // Products below 2^59.8, of which 30 places go first.
    let down = (60 - TURN as i32).wrapping_sub(turn_exponent).wrapping_sub(k.exponent()).wrapping_sub(size);
    let near = |x| round::<30>(product(x, k.mantissa()));
    let turn = fitted3::<30>([near(turn[0]), near(turn[1]), near(turn[2])], down.wrapping_sub(30));
    Column { arm: unit_vector(arm), turn: unit_vector(turn), share: share(m, k) }
}

/// The product of an inverse mass and an inverse K.
#[inline(always)]
fn share(m: Scaled32, k: Scaled32) -> I2F30 {
    let down = 0i32.wrapping_sub(m.exponent()).wrapping_sub(k.exponent());
    I2F30::from_bits(fitted::<30>(round::<30>(product(m.mantissa(), k.mantissa())), down))
}

/// `2^exponent / k` for `k > 0`.
#[inline(always)]
fn inverted(k: i32, exponent: i32) -> Scaled32 {
    let zeros = leading_zeros(k as u32 | 1);
    // 2^61 / d, between 2^29 and 2^30.
    let q = inverse((k as u32).wrapping_shl(zeros));
    Scaled32::cut(q as i64, exponent.wrapping_add(zeros as i32).wrapping_sub(61))
}

/// A term moved right to the unit of the sum.
#[inline(always)]
fn aligned(x: i32, down: i32) -> i32 {
    x.wrapping_shr((down as u32).min(31))
}

/// The inverse of the tangents' matrix in units of 1/`tangent`.
#[inline(never)]
fn block(xx: i32, xy: i32, yy: i32, tangent: i32) -> [i32; 3] {
    let number = |x: i32| Scaled32::new(x as i64, -30);
    let (xx, xy, yy, tangent) = (number(xx), number(xy), number(yy), number(tangent));
    let determinant = xx * yy - xy * xy;
    if determinant <= tangent * tangent * <Scaled32 as super::Scaled>::EPSILON {
        return [1 << RATIO, 0, 1 << RATIO];
    }
    let factor = tangent / determinant;
    [ratio(yy * factor), ratio(-(xy * factor)), ratio(xx * factor)]
}

#[inline(always)]
fn ratio(x: Scaled32) -> i32 {
    clip(shift_product(x.mantissa() as i64, (30 - RATIO as i32).wrapping_sub(x.exponent()))).0.max(-i32::MAX)
}

/// A quaternion that is nearly of unit length, brought to it.
#[inline(always)]
fn normalized(q: [i32; 4]) -> [I2F30; 4] {
    let square = dot2([q[0], q[1]], [q[0], q[1]]).wrapping_add(dot2([q[2], q[3]], [q[2], q[3]]));
    let excess = narrow::<30>(square.wrapping_sub(1 << 60));
    let factor = if excess.wrapping_add(1 << 20) as u32 <= 1 << 21 {
        // 1 - e/2 + 3/8 e^2, for |e| below 2^-10.
        let second = narrow::<30>(product(excess, excess));
        (1i32 << 30).wrapping_sub(excess >> 1).wrapping_add((second >> 1).wrapping_sub(second >> 3))
    } else {
        inverse_length(square)
    };
    let part = |x| I2F30::from_bits(round::<30>(product(x, factor)));
    [part(q[0]), part(q[1]), part(q[2]), part(q[3])]
}

/// 1/length in Q2.30, for a square between 1 and 4 in units of 2^-60.
#[cold]
#[inline(never)]
fn inverse_length(square: i64) -> i32 {
    let length = round_sqrt(square as u64) | 1 << 30;
    inverse(length << 1)
}

/// A number of 2^-16 units of the last place as the nearest one and its rest, and whether the end of the range was met.
#[inline(always)]
fn parted(wide: i64) -> (i32, i16, bool) {
    let (bits, clipped) = clip(wide.wrapping_add(1 << (REST - 1)) >> REST);
    (bits, if clipped { 0 } else { wide as i16 }, clipped)
}

impl<Frac> StepArithmetic<FixedI32<Frac>> for FixedStep
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
    type Places = i32;
    type Rest = i16;
    type Ratio = i32;
    type Levers = StepLevers32;

    const NO_PLACES: i32 = 0;
    const MOST_PLACES: i32 = REST;
    const NO_REST: i16 = 0;
    const NO_RATIO: i32 = 0;

    #[inline(always)]
    fn size(inv_mass: Scaled32, exponent: i32) -> i32 {
        let square = inv_mass.exponent().wrapping_sub(exponent).clamp(-64, 64);
        (square >> 1).wrapping_add(5).clamp(-LARGEST, LARGEST)
    }

    #[inline(always)]
    fn more(places: i32, size: i32) -> i32 {
        places.wrapping_add(size)
    }

    #[inline(always)]
    fn fit(places: i32, v: &Vec3<FixedI32<Frac>>, size: i32, head: u32) -> i32 {
        let room = (leading_zeros(magnitude(bits_of(v))) as i32).wrapping_sub(1).wrapping_sub(head as i32);
        places.min(room.wrapping_sub(size)).max(-LARGEST)
    }

    #[inline(always)]
    fn lift(x: FixedI32<Frac>, rest: i16, places: i32) -> FixedI32<Frac> {
        let (x, zeros) = (x.to_bits(), leading_zeros(magnitude([x.to_bits(), 0, 0])) as i32);
        if places > 0 && places < REST && places.wrapping_add(1) < zeros {
            let rest = rounded_down(rest as i32, REST.wrapping_sub(places));
            return FixedI32::from_bits(x.wrapping_shl(places as u32).wrapping_add(rest));
        }
        let wide = (x as i64).wrapping_shl(REST as u32).wrapping_add(rest as i64);
        FixedI32::from_bits(shifted(wide, REST.wrapping_sub(places)))
    }

    #[inline(always)]
    fn lower(x: FixedI32<Frac>, places: i32) -> (FixedI32<Frac>, i16, bool) {
        let x = x.to_bits();
        if places > 0 && places <= REST && (x.wrapping_add(1 << 30) as u32) < 1 << 31 {
            let places = places as u32;
            let stored = rounded_down(x, places as i32);
            let rest = x.wrapping_sub(stored.wrapping_shl(places)).wrapping_shl((REST as u32).wrapping_sub(places));
            return (FixedI32::from_bits(stored), rest as i16, false);
        }
        let (bits, rest, clipped) = parted(shift_product(x as i64, places.wrapping_sub(REST)));
        (FixedI32::from_bits(bits), rest, clipped)
    }

    #[inline(never)]
    fn changed(x: FixedI32<Frac>, rest: i16, change: Scaled32) -> (FixedI32<Frac>, i16, bool) {
        let down = (30 - REST - Frac::I32).wrapping_sub(change.exponent());
        let wide = (x.to_bits() as i64).wrapping_shl(REST as u32).wrapping_add(rest as i64);
        // Within 2^48 and 2^61.
        let (bits, rest, clipped) = parted(wide.wrapping_add(shift_product(change.mantissa() as i64, down)));
        (FixedI32::from_bits(bits), rest, clipped)
    }

    #[inline(always)]
    fn gain(acceleration: FixedI32<Frac>, h: FixedI32<U31>, places: i32) -> FixedI32<Frac> {
        FixedI32::from_bits(shifted(product(acceleration.to_bits(), h.to_bits()), 31i32.wrapping_sub(places)))
    }

    #[inline(always)]
    fn gap(separation: FixedI32<Frac>, inv_h: Scaled32, places: i32) -> FixedI32<Frac> {
        let down = 30i32.wrapping_sub(inv_h.exponent()).wrapping_sub(places);
        FixedI32::from_bits(shifted(product(separation.to_bits(), inv_h.mantissa()), down))
    }

    #[inline(always)]
    fn travel(
        x: FixedI32<Frac>,
        moved: FixedI32<Frac>,
        h: FixedI32<U31>,
        places: i32,
        remainder: &mut u16,
    ) -> (FixedI32<Frac>, bool) {
        let place = (x.to_bits() as i64).wrapping_shl(16) | *remainder as i64;
        let way = shift_product(product(moved.to_bits(), h.to_bits()), places.wrapping_add(15));
        let place = place.wrapping_add(way);
        *remainder = place as u16;
        let (bits, clipped) = clip(place >> 16);
        (FixedI32::from_bits(bits), clipped)
    }

    #[inline(always)]
    fn half_angle(turned: FixedI32<Frac>, h: FixedI32<U31>, places: i32) -> I2F30 {
        let down = Frac::I32.wrapping_add(places).wrapping_add(2);
        I2F30::from_bits(within::<30>(product(turned.to_bits(), h.to_bits()), down))
    }

    #[inline(never)]
    fn levers(
        r: &Vec3<FixedI32<Frac>>,
        d: [&Vec3<I2F30>; 3],
        inv_inertia: &SymMat3<I2F30>,
        exponent: i32,
    ) -> StepLevers32 {
        let r = bits_of(r);
        let places = leading_zeros(magnitude(r)).wrapping_sub(1);
        let r = [r[0].wrapping_shl(places), r[1].wrapping_shl(places), r[2].wrapping_shl(places)];
        let arm = |d: &Vec3<I2F30>| {
            let d = bits(d);
            let m = [d[0].wrapping_neg(), d[1].wrapping_neg(), d[2].wrapping_neg()];
            [
                narrow::<32>(dot2([r[1], r[2]], [d[2], m[1]])),
                narrow::<32>(dot2([r[2], r[0]], [d[0], m[2]])),
                narrow::<32>(dot2([r[0], r[1]], [d[1], m[0]])),
            ]
        };
        let arms = [arm(d[0]), arm(d[1]), arm(d[2])];
        let arm_exponent = 32i32.wrapping_sub(Frac::I32).wrapping_sub(places as i32);
        let SymMat3 { xx, xy, xz, yy, yz, zz } = inv_inertia;
        let [xx, xy, xz] = [xx.to_bits(), xy.to_bits(), xz.to_bits()];
        let [yy, yz, zz] = [yy.to_bits(), yz.to_bits(), zz.to_bits()];
        let turn = |c: [i32; 3]| {
            if xy | xz | yz | (xx ^ yy) | (xx ^ zz) == 0 {
                let part = |c| narrow::<29>(product(xx, c));
                return [part(c[0]), part(c[1]), part(c[2])];
            }
            [narrow::<29>(dot([xx, xy, xz], c)), narrow::<29>(dot([xy, yy, yz], c)), narrow::<29>(dot([xz, yz, zz], c))]
        };
        let turns = [turn(arms[0]), turn(arms[1]), turn(arms[2])];
        StepLevers32 { arms, arm_exponent, turns, turn_exponent: arm_exponent.wrapping_add(exponent).wrapping_sub(1) }
    }

    #[inline(never)]
    fn weights(sides: [Option<(&StepLevers32, Scaled32)>; 2], friction: FixedI32<Frac>) -> Weights<FixedI32<Frac>> {
        let mut top = Scaled32::LOWEST;
        let exponent = |levers: &StepLevers32| levers.arm_exponent.wrapping_add(levers.turn_exponent).wrapping_add(2);
        for (levers, inv_mass) in sides.iter().flatten() {
            top = max(top, max(inv_mass.exponent(), exponent(levers)));
        }
        // Four terms below 2^30.
        let top = top.wrapping_add(2);
        let mut k = [0i32; 4];
        for (levers, inv_mass) in sides.iter().flatten() {
            let mass = aligned(inv_mass.mantissa(), top.wrapping_sub(inv_mass.exponent()));
            let down = top.wrapping_sub(exponent(levers));
            let ([n, x, y], [turn_n, turn_x, turn_y]) = (levers.arms, levers.turns);
            let part = |c, u| aligned(high(dot(c, u)), down);
            k[0] = k[0].wrapping_add(mass).wrapping_add(max(part(n, turn_n), 0));
            k[1] = k[1].wrapping_add(mass).wrapping_add(max(part(x, turn_x), 0));
            k[2] = k[2].wrapping_add(part(x, turn_y));
            k[3] = k[3].wrapping_add(mass).wrapping_add(max(part(y, turn_y), 0));
        }
        let [normal, xx, xy, yy] = k;
        let aside = xy.wrapping_abs();
        let tangent = max(xx, yy).wrapping_add(aside);
        let unit = 30i32.wrapping_sub(top);
        let (inv_normal, inv_tangent) = (inverted(normal, unit), inverted(tangent, unit));
        // Of a ball the matrix is a multiple of one, up to rounding.
        let uneven = aside.wrapping_add(xx.wrapping_sub(yy).wrapping_abs());
        let block = if uneven <= tangent >> 16 { [1 << RATIO, 0, 1 << RATIO] } else { block(xx, xy, yy, tangent) };
        // mu tangent/normal, in units of 2^-20.
        let factor = narrow::<30>(product(tangent, inv_normal.mantissa()));
        let down = unit.wrapping_add(Frac::I32 - RATIO as i32).wrapping_sub(inv_normal.exponent());
        let friction = shifted(product(friction.to_bits(), factor), down);
        Weights { inv_normal, inv_tangent, block, friction }
    }

    #[inline(never)]
    fn columns(
        levers: &StepLevers32,
        inv_mass: Scaled32,
        weights: &Weights<FixedI32<Frac>>,
        size: i32,
        central: bool,
        [normal, first, second]: [&mut Column<FixedI32<Frac>>; 3],
    ) {
        let ([n, x, y], [turn_n, turn_x, turn_y]) = (levers.arms, levers.turns);
        let exponents = [levers.arm_exponent, levers.turn_exponent];
        if central {
            *normal = Column { share: share(inv_mass, weights.inv_normal), ..Column::NONE };
        } else {
            *normal = column(n, turn_n, exponents, inv_mass, weights.inv_normal, size);
        }
        *first = column(x, turn_x, exponents, inv_mass, weights.inv_tangent, size);
        *second = column(y, turn_y, exponents, inv_mass, weights.inv_tangent, size);
    }

    #[inline(always)]
    fn direction(d: &Vec3<I2F30>) -> Vec3<I2F30> {
        let [x, y, z] = bits(d);
        let near = |x| rounded_down(x, 30 - ARM as i32);
        unit_vector([near(x), near(y), near(z)])
    }

    #[inline(always)]
    fn lone_speed(
        d: &Vec3<I2F30>,
        v: &Vec3<FixedI32<Frac>>,
        w: &Vec3<FixedI32<Frac>>,
        column: &Column<FixedI32<Frac>>,
    ) -> FixedI32<Frac> {
        // |v . d| < 2^60 and |w . arm| < 3 2^60.
        let sum = add_dot(dot(bits_of(v), bits(d)), bits_of(w), bits(&column.arm));
        FixedI32::from_bits(near::<ARM>(sum))
    }

    #[inline(always)]
    fn pair_speed(
        d: &Vec3<I2F30>,
        v: [&Vec3<FixedI32<Frac>>; 2],
        w: [&Vec3<FixedI32<Frac>>; 2],
        columns: [&Column<FixedI32<Frac>>; 2],
    ) -> FixedI32<Frac> {
        let linear = dot(bits_of(&(*v[1] - *v[0])), bits(d));
        let turned = add_dot(linear, bits_of(w[0]), bits(&columns[0].arm));
        FixedI32::from_bits(near::<ARM>(add_dot(turned, bits_of(w[1]), bits(&columns[1].arm))))
    }

    #[inline(always)]
    fn push(
        v: &mut Vec3<FixedI32<Frac>>,
        w: &mut Vec3<FixedI32<Frac>>,
        d: &Vec3<I2F30>,
        column: &Column<FixedI32<Frac>>,
        impulse: FixedI32<Frac>,
    ) {
        apply(v, w, d, column, impulse.to_bits(), 1);
    }

    #[inline(always)]
    fn pull(
        v: &mut Vec3<FixedI32<Frac>>,
        w: &mut Vec3<FixedI32<Frac>>,
        d: &Vec3<I2F30>,
        column: &Column<FixedI32<Frac>>,
        impulse: FixedI32<Frac>,
    ) {
        apply(v, w, d, column, impulse.to_bits(), -1);
    }

    #[inline(never)]
    fn turned(orientation: [I2F30; 4], u: Vec3<I2F30>) -> [I2F30; 4] {
        let [w, x, y, z] =
            [orientation[0].to_bits(), orientation[1].to_bits(), orientation[2].to_bits(), orientation[3].to_bits()];
        // tan a = a + a^3/3 + ...; 357913941 is a third.
        let u = bits(&u);
        let third = round::<30>(product(round::<30>(dot(u, u)), 357_913_941));
        let more = |x: i32| x.wrapping_add(round::<30>(product(x, third)));
        let u = [more(u[0]), more(u[1]), more(u[2])];
        let part = |d| round::<30>(dot(u, d));
        let neg = i32::wrapping_neg;
        normalized([
            w.wrapping_sub(part([x, y, z])),
            x.wrapping_add(part([w, z, neg(y)])),
            y.wrapping_add(part([neg(z), w, x])),
            z.wrapping_add(part([y, neg(x), w])),
        ])
    }

    #[inline(always)]
    fn thrust(v: &mut Vec3<FixedI32<Frac>>, d: &Vec3<I2F30>, share: I2F30, impulse: FixedI32<Frac>) {
        let (d, impulse) = (bits(d), impulse.to_bits());
        if impulse.wrapping_add(LARGE) as u32 >= 2 * LARGE as u32 {
            return thrust_large(v, d, share.to_bits(), impulse);
        }
        let share = round::<30>(product(share.to_bits(), impulse));
        let along = |d| round::<ARM>(product(d, share));
        add(v, [along(d[0]), along(d[1]), along(d[2])]);
    }

    #[inline(always)]
    fn is_central(levers: &StepLevers32, _: &Vec3<FixedI32<Frac>>) -> bool {
        // A unit of the last place of the arm is 2^(30 - exponent - fraction bits) here.
        let places = 30i32.wrapping_sub(levers.arm_exponent).wrapping_sub(Frac::I32);
        let [arm, ..] = levers.arms;
        magnitude(arm).wrapping_shr(places.clamp(0, 31) as u32) <= 1
    }

    #[inline(always)]
    fn bearing(r: &Vec3<FixedI32<Frac>>) -> [i8; 3] {
        let r = bits_of(r);
        let places = leading_zeros(magnitude(r)).wrapping_sub(1);
        let part = |x: i32| (x.wrapping_shl(places) >> 25) as i8;
        [part(r[0]), part(r[1]), part(r[2])]
    }

    #[inline(always)]
    fn along(v: &Vec3<FixedI32<Frac>>, d: &Vec3<I2F30>) -> FixedI32<Frac> {
        FixedI32::from_bits(near::<ARM>(dot(bits_of(v), bits(d))))
    }

    #[inline(never)]
    fn impulse(x: FixedI32<Frac>, places: i32, share: I2F30, inv_mass: Scaled32) -> Scaled32 {
        if inv_mass.mantissa() == 0 {
            return Scaled32::ZERO;
        }
        let speed = Scaled32::new(x.to_bits() as i64, Frac::I32.wrapping_add(places).wrapping_neg());
        speed * (Scaled32::new(share.to_bits() as i64, -30) / inv_mass)
    }

    #[inline(always)]
    fn moved(x: FixedI32<Frac>, from: i32, to: i32) -> FixedI32<Frac> {
        if from == to { x } else { FixedI32::from_bits(shifted(x.to_bits() as i64, from.wrapping_sub(to))) }
    }

    #[inline(always)]
    fn half(x: FixedI32<Frac>) -> FixedI32<Frac> {
        FixedI32::from_bits(round_shift(x.to_bits() as i64, 1) as i32)
    }

    #[inline(always)]
    fn times(x: FixedI32<Frac>, factor: I2F30) -> FixedI32<Frac> {
        FixedI32::from_bits(near::<30>(product(x.to_bits(), factor.to_bits())))
    }

    #[inline(always)]
    fn by_ratio(x: FixedI32<Frac>, factor: i32) -> FixedI32<Frac> {
        FixedI32::from_bits(near::<RATIO>(product(x.to_bits(), factor)))
    }

    #[inline(always)]
    fn by_block(v: [FixedI32<Frac>; 2], [xx, xy, yy]: [i32; 3]) -> [FixedI32<Frac>; 2] {
        if xy == 0 && xx == 1 << RATIO && yy == 1 << RATIO {
            return v;
        }
        let v = [v[0].to_bits(), v[1].to_bits()];
        let row = |x, y| FixedI32::from_bits(near::<RATIO>(dot2([x, y], v).clamp(-FAR, FAR)));
        [row(xx, xy), row(xy, yy)]
    }

    #[inline(always)]
    fn is_within(v: [FixedI32<Frac>; 2], length: FixedI32<Frac>) -> bool {
        let v = [v[0].to_bits(), v[1].to_bits()];
        dot2(v, v) as u64 <= product(length.to_bits(), length.to_bits()) as u64
    }

    #[inline(never)]
    fn shortened(v: [FixedI32<Frac>; 2], length: FixedI32<Frac>) -> [FixedI32<Frac>; 2] {
        let v = [v[0].to_bits(), v[1].to_bits()];
        let whole = round_sqrt(dot2(v, v) as u64);
        let factor = wide_quotient(length.to_bits().unsigned_abs(), whole, 31).unwrap_or(i32::MAX as u32) as i32;
        [FixedI32::from_bits(near::<31>(product(v[0], factor))), FixedI32::from_bits(near::<31>(product(v[1], factor)))]
    }

    #[inline(never)]
    fn speed_after(speed: FixedI32<Frac>, change: FixedI32<Frac>, fall: FixedI32<Frac>) -> FixedI32<Frac> {
        let twice = product(change.to_bits(), fall.to_bits()).saturating_mul(2);
        let square = product(speed.to_bits(), speed.to_bits()).saturating_add(twice);
        let root = if square > 0 { round_sqrt(square as u64) } else { 0 };
        FixedI32::from_bits(clip(root as i64).0)
    }
}
