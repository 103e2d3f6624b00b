//! Shifts for the cores that have no better ones than the compiler's.

use fixed::types::extra::Unsigned;

use crate::scalar::integer::{leading_zeros, round_shift};
pub(in crate::scalar) use crate::scalar::wide::{shift_left, shift_right};

/// Places to move right by: 31 leave of a word as much as more do. `places` is not negative.
#[inline(always)]
pub fn at_most_31(places: i32) -> u32 {
    (places as u32).min(31)
}

/// `x / 2^places` rounded, ties up, for |x| <= 2^30 and one place or more.
#[inline(always)]
pub fn round_right(x: i32, places: i32) -> i32 {
    let places = at_most_31(places);
    x.wrapping_add((1u32.wrapping_shl(places) >> 1) as i32).wrapping_shr(places)
}

/// One less, where `x` is below zero.
#[inline(always)]
pub fn plus_sign(x: i64) -> i64 {
    x.wrapping_add(x >> 63)
}

/// `x / 2^Frac` rounded and clipped, for a product of 32-bit numbers or the difference of two, and 30 places at most.
///
/// Of two products of the lowest numbers the difference is nearest to the end of 64 bits: it leaves 2^31, more than rounding
/// adds.
#[inline(always)]
pub fn round_product<Frac: Unsigned>(x: i64) -> i32 {
    let rounded = round_shift(x, Frac::U32);
    if rounded as i32 as i64 == rounded { rounded as i32 } else { i32::MAX ^ (x >> 63) as i32 }
}

/// A number above zero moved left until it fills 32 bits, and by how many places.
#[inline(always)]
pub fn filled(x: u32) -> (u32, u32) {
    let zeros = leading_zeros(x | 1);
    (x.wrapping_shl(zeros), zeros)
}
