//! What is stored: velocities and reports in the format, rounded once, and at the end of the range where they leave it.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U30};

use super::machine::{at_most_31, round_right};
use super::product::product;
use super::scaled32::{Scaled32, shift_product};
use super::wide::{bits, bits_of, units};
use crate::math::Vec3;

/// `x` clipped to 32 bits, and whether that changed it.
#[inline(always)]
pub(super) const fn clip(x: i64) -> (i32, bool) {
    if x > i32::MAX as i64 {
        (i32::MAX, true)
    } else if x < i32::MIN as i64 {
        (i32::MIN, true)
    } else {
        (x as i32, false)
    }
}

/// `x + d` for a vector `d` in units of 2^exponent, and components of `x` in units of 2^-frac.
#[inline(always)]
pub(super) fn add_block<Frac>(x: &mut Vec3<FixedI32<Frac>>, d: [i32; 3], exponent: i32) -> bool
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True>,
{
    let down = exponent.wrapping_add(Frac::I32).wrapping_neg();
    if down <= 0 {
        return add_far(x, &units(d), 1 << 29, down.wrapping_sub(3));
    }
    let (half, places) = half_of(down);
    let change = [moved(d[0] >> 1, half, places), moved(d[1] >> 1, half, places), moved(d[2] >> 1, half, places)];
    if add_change(x, change) { add_far(x, &units(d), 1 << 29, down.wrapping_sub(3)) } else { false }
}

/// The half to add and the places to move right by, for a number of 31 bits whose last place has been cut off: with one half
/// of 2^31, it would leave the range.
#[inline(always)]
fn half_of(down: i32) -> (i32, u32) {
    let down = at_most_31(down).wrapping_sub(1);
    ((1u32.wrapping_shl(down) >> 1) as i32, down)
}

/// `x` moved right and rounded.
#[inline(always)]
pub(super) const fn moved(x: i32, half: i32, down: u32) -> i32 {
    x.wrapping_add(half).wrapping_shr(down)
}

/// Adds `change`, or where a component would leave the range nothing; and says so.
#[inline(always)]
pub(super) fn add_change<Frac>(x: &mut Vec3<FixedI32<Frac>>, change: [i32; 3]) -> bool {
    let bits = bits_of(x);
    let Some(x0) = bits[0].checked_add(change[0]) else { return true };
    let Some(x1) = bits[1].checked_add(change[1]) else { return true };
    let Some(x2) = bits[2].checked_add(change[2]) else { return true };
    *x = Vec3::new(FixedI32::from_bits(x0), FixedI32::from_bits(x1), FixedI32::from_bits(x2));
    false
}

/// The nearest number to one of 2^29 units of the last place and more.
#[cold]
#[inline(never)]
fn from_large<Frac>(x: Scaled32) -> (FixedI32<Frac>, bool)
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True>,
{
    let add = if is_rare(Frac::U32) { sum_apart } else { sum };
    let (bits, met) = add(0, x.mantissa() as i64, 30i32.wrapping_sub(x.exponent()).wrapping_sub(Frac::I32));
    (FixedI32::from_bits(bits), met)
}

/// `x + change / 2^down`, rounded and clipped, and whether the end of the range was met.
#[inline(always)]
fn sum(x: i32, change: i64, down: i32) -> (i32, bool) {
    clip(shift_product(change, down).wrapping_add(x as i64))
}

/// Whether numbers of 2^26 units of the last place are rare in a format: then they may take longer.
const fn is_rare(frac: u32) -> bool {
    frac <= 20
}

/// The same sum outside the caller.
#[cold]
#[inline(never)]
fn sum_apart(x: i32, change: i64, down: i32) -> (i32, bool) {
    sum(x, change, down)
}

/// Adds `d k / 2^(32 + down)` where that changes a component by 2^26 units of the last place or more.
#[cold]
#[inline(never)]
pub(super) fn add_far<Frac>(x: &mut Vec3<FixedI32<Frac>>, d: &Vec3<I2F30>, k: i32, down: i32) -> bool {
    let (d, bits) = (bits(d), bits_of(x));
    let down = down.wrapping_add(32);
    let (x0, met0) = sum_apart(bits[0], product(d[0], k), down);
    let (x1, met1) = sum_apart(bits[1], product(d[1], k), down);
    let (x2, met2) = sum_apart(bits[2], product(d[2], k), down);
    *x = Vec3::new(FixedI32::from_bits(x0), FixedI32::from_bits(x1), FixedI32::from_bits(x2));
    met0 | met1 | met2
}

/// The nearest number, and whether the end of the range was met.
#[inline(always)]
pub(super) fn from_scaled<Frac>(x: Scaled32) -> (FixedI32<Frac>, bool)
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True>,
{
    let down = 30i32.wrapping_sub(x.exponent()).wrapping_sub(Frac::I32);
    if down <= 0 {
        return from_large(x);
    }
    let m = x.mantissa();
    (FixedI32::from_bits(round_right(m.wrapping_add(m >> 31), down)), false)
}

/// The same for `mantissa * 2^exponent`.
#[inline(always)]
pub(super) fn from_block<Frac>(mantissa: I2F30, exponent: i32) -> (FixedI32<Frac>, bool)
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True>,
{
    let down = 30i32.wrapping_sub(exponent).wrapping_sub(Frac::I32);
    if down <= 0 {
        return from_large(Scaled32::new(mantissa.to_bits() as i64, exponent.wrapping_sub(30)));
    }
    let (half, down) = half_of(down);
    (FixedI32::from_bits(moved(mantissa.to_bits() >> 1, half, down)), false)
}
