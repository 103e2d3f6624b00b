//! Halves, shifts and sizes of 64-bit numbers, and arithmetic in Q2.30 that is cut off: what blocks are computed with.

use fixed::FixedI32;
use fixed::types::I2F30;

use super::integer::long_quotient;
use super::machine::times30;
use super::product::dot;
use crate::math::Vec3;

/// `x / 2^K` cut off, for results within 32 bits. (From halves: the compiler then knows that a product of it is one of
/// 32-bit numbers.)
#[inline(always)]
pub(super) const fn narrow<const K: u32>(x: i64) -> i32 {
    let (low, high) = (x as u32, (x >> 32) as u32);
    if K == 32 { high as i32 } else { (high.wrapping_shl(32 - K) | low >> K) as i32 }
}

/// `x / 2^places` cut off. `places` in `0..=31`.
#[inline(always)]
pub(in crate::scalar) const fn shift_right(x: i64, places: u32) -> i64 {
    let (low, high) = (x as u32, (x >> 32) as i32);
    let low = low.wrapping_shr(places) | ((high as u32) << 1).wrapping_shl(31 ^ places);
    (high.wrapping_shr(places) as i64) << 32 | low as i64
}

/// `x 2^places / 2^32` cut off, for results within 32 bits. `places` in `0..=31`.
#[inline(always)]
pub(in crate::scalar) const fn shift_left(x: i64, places: u32) -> i32 {
    ((x >> 32) as u32).wrapping_shl(places) as i32 | (x as u32 >> 1).wrapping_shr(31 ^ places) as i32
}

/// A number with as many bits as the largest of three, at least one.
#[inline(always)]
pub(super) const fn magnitude(v: [i32; 3]) -> u32 {
    // x ^ (x >> 31) is |x| for this purpose, without its exception at the lowest number.
    ((v[0] ^ (v[0] >> 31)) | (v[1] ^ (v[1] >> 31)) | (v[2] ^ (v[2] >> 31)) | 1) as u32
}

#[inline(always)]
pub(super) fn bits_of<Frac>(v: &Vec3<FixedI32<Frac>>) -> [i32; 3] {
    [v.x.to_bits(), v.y.to_bits(), v.z.to_bits()]
}

#[inline(always)]
pub(super) fn bits(v: &Vec3<I2F30>) -> [i32; 3] {
    [v.x.to_bits(), v.y.to_bits(), v.z.to_bits()]
}

#[inline(always)]
pub(super) fn units(v: [i32; 3]) -> Vec3<I2F30> {
    Vec3::new(I2F30::from_bits(v[0]), I2F30::from_bits(v[1]), I2F30::from_bits(v[2]))
}

#[inline(always)]
pub(super) fn high(x: i64) -> i32 {
    (x >> 32) as i32
}

/// The leading 32 bits of a number of at least 2^32, for the number of its leading zeros.
#[inline(always)]
pub(super) fn leading32(x: i64, zeros: u32) -> u32 {
    shift_left(x, zeros) as u32
}

/// The upper half of `x 2^places`, for `places` in `0..=63` and what fits 64 bits.
#[inline(always)]
pub(super) fn upper(x: i64, places: u32) -> i32 {
    if places > 31 { (x as u32).wrapping_shl(places) as i32 } else { shift_left(x, places) }
}

#[inline(always)]
pub(super) const fn max(a: i32, b: i32) -> i32 {
    if a < b { b } else { a }
}

#[inline(always)]
pub(super) const fn min(a: i32, b: i32) -> i32 {
    if b < a { b } else { a }
}

/// The sum of three such products, cut off once.
#[inline(always)]
pub(super) fn dot30(a: [i32; 3], b: [i32; 3]) -> i32 {
    narrow::<30>(dot(a, b))
}

/// `v + k n` for a unit vector n, cut off.
#[inline(always)]
pub(super) fn plus30(v: [i32; 3], n: [i32; 3], k: i32) -> [i32; 3] {
    [v[0].wrapping_add(times30(k, n[0])), v[1].wrapping_add(times30(k, n[1])), v[2].wrapping_add(times30(k, n[2]))]
}

/// `-v`, for components above the lowest number.
#[inline(always)]
pub(super) const fn minus(v: [i32; 3]) -> [i32; 3] {
    [v[0].wrapping_neg(), v[1].wrapping_neg(), v[2].wrapping_neg()]
}

/// `2^61 / d` for `d` in `[2^31, 2^32)`.
#[inline(always)]
pub(super) fn inverse(d: u32) -> i32 {
    long_quotient(1 << 31, d) as i32
}
