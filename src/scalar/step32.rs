//! The arithmetic of a step in fixed point: 32-bit numbers in the units of the step, and Q2.30 columns.
//!
//! A body's spin is kept times a power of two near its size rho, 5.6 to 16 times the square root of (1/m) / trace(I^-1). So spins
//! and speeds are of one magnitude, |r x d| / rho is at most 4 for arms up to 18 times the thickness of a rod, and the
//! change of spin for an impulse, rho |I^-1 (r x d)|/K, at most rho sqrt(m / 4 I_min) < 8, whatever the shape and the arm.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U30, U31};

use super::integer::{round_shift, round_sqrt, wide_quotient};
use super::product::{dot, dot2, leading_zeros, product};
use super::scaled32::{Scaled32, shift_product};
use super::step::{Column, StepArithmetic};
use super::stored32::clip;
use super::wide::{bits, bits_of, magnitude, narrow};
use crate::math::{SymMat3, Vec3};

/// The arithmetic of a step for `FixedI32`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedStep;

/// r x d and I^-1 (r x d): blocks of Q2.30.
#[derive(Clone, Copy, Debug)]
pub struct StepLever32 {
    arm: [i32; 3],
    arm_exponent: i32,
    turn: [i32; 3],
    turn_exponent: i32,
}

/// Fraction bits of directions and of arms, which are below 4.
const ARM: u32 = 28;
/// Fraction bits of a turn, which is below 8.
const TURN: u32 = 27;
/// Fraction bits of a ratio.
const RATIO: u32 = 20;
/// The size of a body in powers of two, at either end.
const LARGEST: i32 = 14;
/// What is stored of a velocity beyond its format.
const REST: i32 = 16;

/// `x` without the places that rounding takes, clipped.
#[inline(always)]
fn near(x: i64, places: u32) -> i32 {
    let rounded = round_shift(x, places);
    if rounded as i32 as i64 == rounded { rounded as i32 } else { clip(rounded).0 }
}

/// `x / 2^down` rounded and clipped, for any `down`.
#[inline(always)]
fn shifted(x: i64, down: i32) -> i32 {
    clip(shift_product(x, down)).0
}

/// The same within +-2^30.
#[inline(always)]
fn unit(x: i64, down: i32) -> I2F30 {
    let bits = shift_product(x, down);
    let one = 1 << 30;
    I2F30::from_bits(if bits > one { 1 << 30 } else if bits < -one { -(1 << 30) } else { bits as i32 })
}

#[inline(always)]
fn vector<F>(v: [i32; 3]) -> Vec3<FixedI32<F>> {
    Vec3::new(FixedI32::from_bits(v[0]), FixedI32::from_bits(v[1]), FixedI32::from_bits(v[2]))
}

/// The sum of two 64-bit numbers without the places of an arm, rounded and clipped.
#[inline(always)]
fn near_sum(x: i64, y: i64) -> i32 {
    match x.checked_add(y) {
        Some(sum) => near_far(sum),
        None => end(x),
    }
}

#[inline(always)]
fn near_far(sum: i64) -> i32 {
    // Rounding does not leave 64 bits: it is done on what is above the last 27 places.
    let rounded = ((sum >> (ARM - 1)).wrapping_add(1).wrapping_add(sum >> 63)) >> 1;
    if rounded as i32 as i64 == rounded { rounded as i32 } else { end(rounded) }
}

#[cold]
#[inline(never)]
fn end(x: i64) -> i32 {
    if x < 0 { i32::MIN } else { i32::MAX }
}

impl<Frac> StepArithmetic<FixedI32<Frac>> for FixedStep
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
    type Places = i32;
    type Rest = i16;
    type Ratio = i32;
    type Lever = StepLever32;

    const NO_PLACES: i32 = 0;
    const MOST_PLACES: i32 = REST;
    const NO_REST: i16 = 0;
    const NO_RATIO: i32 = 0;

    #[inline(always)]
    fn size(inv_mass: Scaled32, exponent: i32) -> i32 {
        let square = inv_mass.exponent().wrapping_sub(exponent).clamp(-64, 64);
        (square >> 1).wrapping_add(4).clamp(-LARGEST, LARGEST)
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
        let wide = (x.to_bits() as i64).wrapping_shl(REST as u32).wrapping_add(rest as i64);
        FixedI32::from_bits(shifted(wide, REST.wrapping_sub(places)))
    }

    #[inline(always)]
    fn lower(x: FixedI32<Frac>, places: i32) -> (FixedI32<Frac>, i16, bool) {
        let wide = shift_product(x.to_bits() as i64, places.wrapping_sub(REST));
        let stored = wide.wrapping_add(1 << (REST - 1)) >> REST;
        let (bits, clipped) = clip(stored);
        let rest = if clipped { 0 } else { wide as i16 };
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
        unit(product(turned.to_bits(), h.to_bits()), Frac::I32.wrapping_add(places).wrapping_add(2))
    }

    #[inline(never)]
    fn lever(r: &Vec3<FixedI32<Frac>>, d: &Vec3<I2F30>, inv_inertia: &SymMat3<I2F30>, exponent: i32) -> StepLever32 {
        let r = bits_of(r);
        let places = leading_zeros(magnitude(r)).wrapping_sub(1);
        let r = [r[0].wrapping_shl(places), r[1].wrapping_shl(places), r[2].wrapping_shl(places)];
        let d = bits(d);
        let m = [d[0].wrapping_neg(), d[1].wrapping_neg(), d[2].wrapping_neg()];
        let arm = [
            narrow::<32>(dot2([r[1], r[2]], [d[2], m[1]])),
            narrow::<32>(dot2([r[2], r[0]], [d[0], m[2]])),
            narrow::<32>(dot2([r[0], r[1]], [d[1], m[0]])),
        ];
        let arm_exponent = 32i32.wrapping_sub(Frac::I32).wrapping_sub(places as i32);
        let SymMat3 { xx, xy, xz, yy, yz, zz } = inv_inertia;
        let turn = [
            narrow::<29>(dot([xx.to_bits(), xy.to_bits(), xz.to_bits()], arm)),
            narrow::<29>(dot([xy.to_bits(), yy.to_bits(), yz.to_bits()], arm)),
            narrow::<29>(dot([xz.to_bits(), yz.to_bits(), zz.to_bits()], arm)),
        ];
        let turn_exponent = arm_exponent.wrapping_add(exponent).wrapping_sub(1);
        StepLever32 { arm, arm_exponent, turn, turn_exponent }
    }

    #[inline(always)]
    fn coupling(d: &StepLever32, other: &StepLever32) -> Scaled32 {
        Scaled32::new(dot(d.arm, other.turn), d.arm_exponent.wrapping_add(other.turn_exponent).wrapping_sub(60))
    }

    #[inline(never)]
    fn column(lever: &StepLever32, inv_mass: Scaled32, inv_k: Scaled32, size: i32) -> Column<FixedI32<Frac>> {
        let down = size.wrapping_sub(lever.arm_exponent).wrapping_add(30 - ARM as i32);
        let [x, y, z] = lever.arm;
        let arm = Vec3::new(unit(x as i64, down), unit(y as i64, down), unit(z as i64, down));
        let down = 60i32
            .wrapping_sub(TURN as i32)
            .wrapping_sub(lever.turn_exponent)
            .wrapping_sub(inv_k.exponent())
            .wrapping_sub(size);
        let [x, y, z] = lever.turn;
        let turn = |x| I2F30::from_bits(shifted(product(x, inv_k.mantissa()), down));
        let turn = Vec3::new(turn(x), turn(y), turn(z));
        let down = 30i32.wrapping_sub(inv_mass.exponent()).wrapping_sub(inv_k.exponent());
        Column { arm, turn, share: unit(product(inv_mass.mantissa(), inv_k.mantissa()), down) }
    }

    #[inline(always)]
    fn opposite_column(lever: &StepLever32, inv_mass: Scaled32, inv_k: Scaled32, size: i32) -> Column<FixedI32<Frac>> {
        let column: Column<FixedI32<Frac>> = Self::column(lever, inv_mass, inv_k, size);
        Column { arm: -column.arm, turn: -column.turn, share: column.share.wrapping_neg() }
    }

    #[inline(always)]
    fn direction(d: &Vec3<I2F30>) -> Vec3<I2F30> {
        let near = |x: i32| I2F30::from_bits(round_shift(x as i64, 30 - ARM) as i32);
        let [x, y, z] = bits(d);
        Vec3::new(near(x), near(y), near(z))
    }

    #[inline(always)]
    fn lone_speed(
        d: &Vec3<I2F30>,
        v: &Vec3<FixedI32<Frac>>,
        w: &Vec3<FixedI32<Frac>>,
        column: &Column<FixedI32<Frac>>,
    ) -> FixedI32<Frac> {
        let (linear, turned) = (dot(bits_of(v), bits(d)), dot(bits_of(w), bits(&column.arm)));
        FixedI32::from_bits(near_sum(linear, turned))
    }

    #[inline(always)]
    fn pair_speed(
        d: &Vec3<I2F30>,
        v: [&Vec3<FixedI32<Frac>>; 2],
        w: [&Vec3<FixedI32<Frac>>; 2],
        columns: [&Column<FixedI32<Frac>>; 2],
    ) -> FixedI32<Frac> {
        let linear = dot(bits_of(&(*v[1] - *v[0])), bits(d));
        let turned_a = dot(bits_of(w[0]), bits(&columns[0].arm));
        let turned_b = dot(bits_of(w[1]), bits(&columns[1].arm));
        match linear.checked_add(turned_a) {
            Some(sum) => FixedI32::from_bits(near_sum(sum, turned_b)),
            None => FixedI32::from_bits(end(linear)),
        }
    }

    #[inline(always)]
    fn push(
        v: &mut Vec3<FixedI32<Frac>>,
        w: &mut Vec3<FixedI32<Frac>>,
        d: &Vec3<I2F30>,
        column: &Column<FixedI32<Frac>>,
        impulse: FixedI32<Frac>,
    ) {
        let impulse = impulse.to_bits();
        let share = near(product(column.share.to_bits(), impulse), 30);
        let [x, y, z] = bits(d);
        *v += vector([near(product(x, share), ARM), near(product(y, share), ARM), near(product(z, share), ARM)]);
        let [x, y, z] = bits(&column.turn);
        *w += vector([
            near(product(x, impulse), TURN),
            near(product(y, impulse), TURN),
            near(product(z, impulse), TURN),
        ]);
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
        FixedI32::from_bits(near(product(x.to_bits(), factor.to_bits()), 30))
    }

    #[inline(always)]
    fn ratio(x: Scaled32) -> i32 {
        clip(x.to_bits(RATIO as i32)).0.max(-i32::MAX)
    }

    #[inline(always)]
    fn by_ratio(x: FixedI32<Frac>, factor: i32) -> FixedI32<Frac> {
        FixedI32::from_bits(near(product(x.to_bits(), factor), RATIO))
    }

    #[inline(always)]
    fn by_block(v: [FixedI32<Frac>; 2], [xx, xy, yy]: [i32; 3]) -> [FixedI32<Frac>; 2] {
        let v = [v[0].to_bits(), v[1].to_bits()];
        [FixedI32::from_bits(near(dot2([xx, xy], v), RATIO)), FixedI32::from_bits(near(dot2([xy, yy], v), RATIO))]
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
        [FixedI32::from_bits(near(product(v[0], factor), 31)), FixedI32::from_bits(near(product(v[1], factor), 31))]
    }

    #[inline(never)]
    fn speed_after(speed: FixedI32<Frac>, change: FixedI32<Frac>, fall: FixedI32<Frac>) -> FixedI32<Frac> {
        let twice = product(change.to_bits(), fall.to_bits()).saturating_mul(2);
        let square = product(speed.to_bits(), speed.to_bits()).saturating_add(twice);
        let root = if square > 0 { round_sqrt(square as u64) } else { 0 };
        FixedI32::from_bits(clip(root as i64).0)
    }
}
