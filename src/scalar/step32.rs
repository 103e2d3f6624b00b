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

mod ball;
pub(super) mod columns;
mod push;
pub(super) mod round;
mod turn;

pub use self::ball::Ball32;
pub use self::columns::StepLevers32;

use self::columns::{ARM, RATIO, unit_vector};
use self::push::apply;
use self::round::{near, rounded_down, shifted, within};
use super::integer::{leading_zeros, round_shift, round_sqrt, wide_quotient};
use super::machine;
use super::product::{dot, dot2, product};
use super::scaled32::{Scaled32, shift_product};
use super::step::{Column, StepArithmetic, Velocity, Weights};
use super::stored32::clip;
use super::wide::{bits, bits_of, magnitude};
use crate::math::{SymMat3, Vec3};

/// The arithmetic of a step for `FixedI32`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedStep;

/// Beyond the range of every result.
const FAR: i64 = 1 << 62;
/// The size of a body in powers of two, at either end.
const LARGEST: i32 = 14;
/// What is stored of a velocity beyond its format.
const REST: i32 = 16;

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
    type Ball = Ball32;

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

    #[inline(always)]
    fn levers(
        r: &Vec3<FixedI32<Frac>>,
        d: [&Vec3<I2F30>; 3],
        inv_inertia: &SymMat3<I2F30>,
        exponent: i32,
    ) -> StepLevers32 {
        columns::levers(r, d, inv_inertia, exponent)
    }

    #[inline(always)]
    fn weights(sides: [Option<(&StepLevers32, Scaled32)>; 2], friction: FixedI32<Frac>) -> Weights<FixedI32<Frac>> {
        columns::weights(sides, friction)
    }

    #[inline(always)]
    fn columns(
        levers: &StepLevers32,
        inv_mass: Scaled32,
        weights: &Weights<FixedI32<Frac>>,
        size: i32,
        central: bool,
        columns: [&mut Column<FixedI32<Frac>>; 3],
    ) {
        columns::columns(levers, inv_mass, weights, size, central, columns);
    }

    #[inline(always)]
    fn is_along(r: &Vec3<FixedI32<Frac>>, d: &Vec3<I2F30>) -> bool {
        columns::is_along(bits_of(r), bits(d))
    }

    #[inline(always)]
    fn ball(r: &Vec3<FixedI32<Frac>>, d: &Vec3<I2F30>, inv_inertia: I2F30, exponent: i32) -> Ball32 {
        Ball32::new(r, d, inv_inertia, exponent)
    }

    #[inline(always)]
    fn ball_weights(sides: [Option<(&Ball32, Scaled32)>; 2], friction: FixedI32<Frac>) -> Weights<FixedI32<Frac>> {
        ball::weights(sides, friction)
    }

    #[inline(always)]
    fn ball_columns(
        ball: &Ball32,
        inv_mass: Scaled32,
        weights: &Weights<FixedI32<Frac>>,
        size: i32,
        tangents: &[Vec3<I2F30>; 2],
        columns: [&mut Column<FixedI32<Frac>>; 3],
    ) {
        ball.columns(inv_mass, weights, size, tangents, columns);
    }

    #[inline(always)]
    fn direction(d: &Vec3<I2F30>) -> Vec3<I2F30> {
        let [x, y, z] = bits(d);
        let near = |x| rounded_down(x, 30 - ARM as i32);
        unit_vector([near(x), near(y), near(z)])
    }

    #[inline(always)]
    fn lone_speed(d: &Vec3<I2F30>, body: &Velocity<FixedI32<Frac>>, column: &Column<FixedI32<Frac>>) -> FixedI32<Frac> {
        machine::lone_speed(d, body, column)
    }

    #[inline(always)]
    fn pair_speed(
        d: &Vec3<I2F30>,
        bodies: [&Velocity<FixedI32<Frac>>; 2],
        columns: &[Column<FixedI32<Frac>>; 2],
    ) -> FixedI32<Frac> {
        machine::pair_speed(d, bodies, columns)
    }

    #[inline(always)]
    fn push(
        body: &mut Velocity<FixedI32<Frac>>,
        d: &Vec3<I2F30>,
        column: &Column<FixedI32<Frac>>,
        impulse: FixedI32<Frac>,
    ) {
        apply(body, d, column, impulse.to_bits(), 1);
    }

    #[inline(always)]
    fn push_pair(
        [a, b]: [&mut Velocity<FixedI32<Frac>>; 2],
        d: &Vec3<I2F30>,
        columns: &[Column<FixedI32<Frac>>; 2],
        impulse: FixedI32<Frac>,
    ) {
        apply(a, d, &columns[0], impulse.to_bits(), -1);
        apply(b, d, &columns[1], impulse.to_bits(), 1);
    }

    #[inline(always)]
    fn turned(orientation: [I2F30; 4], u: Vec3<I2F30>) -> [I2F30; 4] {
        turn::turned(orientation, u)
    }

    #[inline(always)]
    fn central_speed(d: &Vec3<I2F30>, v: [&Vec3<FixedI32<Frac>>; 2]) -> FixedI32<Frac> {
        machine::central_speed(d, v)
    }

    #[inline(always)]
    fn thrust(v: &mut Vec3<FixedI32<Frac>>, d: &Vec3<I2F30>, share: I2F30, impulse: FixedI32<Frac>) {
        push::thrust(v, d, share.to_bits(), impulse.to_bits());
    }

    #[inline(always)]
    fn is_central(levers: &StepLevers32, _: &Vec3<FixedI32<Frac>>) -> bool {
        columns::is_central::<Frac>(levers)
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
        let exponent = places.wrapping_add(30 + Frac::I32).wrapping_neg();
        Scaled32::near_quotient(Scaled32::cut(product(x.to_bits(), share.to_bits()), exponent), inv_mass)
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
