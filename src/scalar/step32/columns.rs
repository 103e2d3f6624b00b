//! From arms and inertia to the columns that rows of the solver work with.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U30};

use super::round::{round, rounded_down, shifted};
use crate::math::{SymMat3, Vec3};
use crate::scalar::Scalar;
use crate::scalar::integer::{leading_zeros, leading_zeros64, long_quotient};
use crate::scalar::machine::filled;
use crate::scalar::product::{dot, dot2, product};
use crate::scalar::scaled32::Scaled32;
use crate::scalar::step::{Column, Weights};
use crate::scalar::wide::{bits, bits_of, high, inverse, magnitude, max, narrow, upper};

/// Fraction bits of directions and of arms, which are below 2.
pub const ARM: u32 = 28;
/// Fraction bits of a turn, which is below 16.
pub const TURN: u32 = 26;
/// Fraction bits of a ratio.
pub const RATIO: u32 = 20;

/// The symmetric matrix that changes nothing.
pub const EVEN: [i32; 3] = [1 << RATIO, 0, 1 << RATIO];

/// r x d and I^-1 (r x d) for three directions: blocks of Q2.30.
#[derive(Clone, Copy, Debug)]
pub struct StepLevers32 {
    arms: [[i32; 3]; 3],
    arm_exponent: i32,
    turns: [[i32; 3]; 3],
    turn_exponent: i32,
}

#[inline(always)]
pub fn unit_vector(v: [i32; 3]) -> Vec3<I2F30> {
    Vec3::new(I2F30::from_bits(v[0]), I2F30::from_bits(v[1]), I2F30::from_bits(v[2]))
}

/// r x d and I^-1 (r x d).
#[inline(never)]
pub fn levers<Frac>(
    r: &Vec3<FixedI32<Frac>>,
    d: [&Vec3<I2F30>; 3],
    inv_inertia: &SymMat3<I2F30>,
    exponent: i32,
) -> StepLevers32
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
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

/// The inverses of K along the normal and across it.
#[inline(never)]
pub fn weights<Frac>(sides: [Option<(&StepLevers32, Scaled32)>; 2], friction: FixedI32<Frac>) -> Weights<FixedI32<Frac>>
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
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
    let block = if uneven <= tangent >> 16 { EVEN } else { block(xx, xy, yy, tangent) };
    let friction = friction_ratio(friction, tangent, inv_normal, unit);
    Weights { inv_normal, inv_tangent, block, friction }
}

/// mu tangent/normal, for `tangent / 2^unit`.
#[inline(always)]
pub(super) fn friction_ratio<Frac: LeEqU32>(
    friction: FixedI32<Frac>,
    tangent: i32,
    inv_normal: Scaled32,
    unit: i32,
) -> i32 {
    let factor = narrow::<30>(product(tangent, inv_normal.mantissa()));
    let down = unit.wrapping_add(Frac::I32 - RATIO as i32).wrapping_sub(inv_normal.exponent());
    shifted(product(friction.to_bits(), factor), down)
}

/// The columns of a body.
#[inline(never)]
pub fn columns<Frac>(
    levers: &StepLevers32,
    inv_mass: Scaled32,
    weights: &Weights<FixedI32<Frac>>,
    size: i32,
    central: bool,
    [normal, first, second]: [&mut Column<FixedI32<Frac>>; 3],
) where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
    let ([n, x, y], [turn_n, turn_x, turn_y]) = (levers.arms, levers.turns);
    let exponents = [levers.arm_exponent, levers.turn_exponent];
    let along = share(inv_mass, weights.inv_normal);
    if central {
        *normal = Column { share: along, ..Column::NONE };
    } else {
        *normal = column(n, turn_n, exponents, along, weights.inv_normal, size);
    }
    let across = share(inv_mass, weights.inv_tangent);
    *first = column(x, turn_x, exponents, across, weights.inv_tangent, size);
    *second = column(y, turn_y, exponents, across, weights.inv_tangent, size);
}

/// Whether the arm is along the first direction, to a unit of the format's last place.
#[inline(always)]
pub fn is_central<Frac>(levers: &StepLevers32) -> bool
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
    // A unit of the last place of the arm is 2^(30 - exponent - fraction bits) here.
    let places = 30i32.wrapping_sub(levers.arm_exponent).wrapping_sub(Frac::I32);
    let [arm, ..] = levers.arms;
    magnitude(arm).wrapping_shr(places.clamp(0, 31) as u32) <= 1
}

/// Whether no component of r x d is two units of the last place of `r`, `d` in Q2.30.
#[inline(always)]
pub fn is_along(r: [i32; 3], d: [i32; 3]) -> bool {
    let m = [d[0].wrapping_neg(), d[1].wrapping_neg(), d[2].wrapping_neg()];
    let is_small = |area: i64| area.wrapping_add(1 << 31) as u64 >> 32 == 0;
    is_small(dot2([r[1], r[2]], [d[2], m[1]]))
        && is_small(dot2([r[2], r[0]], [d[0], m[2]]))
        && is_small(dot2([r[0], r[1]], [d[1], m[0]]))
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
pub(super) fn fitted<const PLACES: u32>(x: i32, down: i32) -> i32 {
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

/// One lever's column for an inverse K `k`.
#[inline(always)]
fn column<F: LeEqU32>(
    arm: [i32; 3],
    turn: [i32; 3],
    [arm_exponent, turn_exponent]: [i32; 2],
    share: I2F30,
    k: Scaled32,
    size: i32,
) -> Column<FixedI32<F>>
where
    FixedI32<F>: Scalar<Unit = I2F30>,
{
    let down = size.wrapping_sub(arm_exponent).wrapping_add(30 - ARM as i32);
    let arm = fitted3::<{ ARM + 1 }>(arm, down);
    // Products below 2^59.8, of which 30 places go first.
    let down = (60 - TURN as i32).wrapping_sub(turn_exponent).wrapping_sub(k.exponent()).wrapping_sub(size);
    let near = |x| round::<30>(product(x, k.mantissa()));
    let turn = fitted3::<30>([near(turn[0]), near(turn[1]), near(turn[2])], down.wrapping_sub(30));
    Column { arm: unit_vector(arm), turn: unit_vector(turn), share }
}

/// The product of an inverse mass and an inverse K.
#[inline(always)]
pub(super) fn share(m: Scaled32, k: Scaled32) -> I2F30 {
    let down = 0i32.wrapping_sub(m.exponent()).wrapping_sub(k.exponent());
    I2F30::from_bits(fitted::<30>(round::<30>(product(m.mantissa(), k.mantissa())), down))
}

/// `2^exponent / k` for `k > 0`.
#[inline(always)]
pub(super) fn inverted(k: i32, exponent: i32) -> Scaled32 {
    let zeros = leading_zeros(k as u32 | 1);
    // 2^61 / d, between 2^29 and 2^30.
    let q = inverse((k as u32).wrapping_shl(zeros));
    Scaled32::cut(q as i64, exponent.wrapping_add(zeros as i32).wrapping_sub(61))
}

/// A term moved right to the unit of the sum.
#[inline(always)]
pub(super) fn aligned(x: i32, down: i32) -> i32 {
    x.wrapping_shr((down as u32).min(31))
}

/// The inverse of the tangents' matrix in units of 1/`tangent`, to 2^-27.
#[inline(never)]
fn block(xx: i32, xy: i32, yy: i32, tangent: i32) -> [i32; 3] {
    let determinant = product(xx, yy).wrapping_sub(product(xy, xy));
    // Without a second direction in which anything gives way, each is taken alone.
    if determinant <= product(tangent, tangent) >> 29 {
        return EVEN;
    }
    let zeros = leading_zeros64(determinant as u64);
    let (n, n_zeros) = filled(tangent as u32);
    let factor = long_quotient(n, upper(determinant, zeros) as u32);
    // tangent / determinant is `factor 2^(zeros - n_zeros - 62)`, of which the last bit is left out.
    let down = (61i32 - RATIO as i32).wrapping_sub(zeros as i32).wrapping_add(n_zeros as i32);
    let ratio = |x: i32| shifted(product(x, (factor >> 1) as i32), down).max(-i32::MAX);
    [ratio(yy), ratio(xy.wrapping_neg()), ratio(xx)]
}
