//! Shifts for the cores that have no better ones than the compiler's.

use crate::scalar::integer::leading_zeros;
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

/// A number above zero moved left until it fills 32 bits, and by how many places.
#[inline(always)]
pub fn filled(x: u32) -> (u32, u32) {
    let zeros = leading_zeros(x | 1);
    (x.wrapping_shl(zeros), zeros)
}
