//! Roundings to 32 bits.

use crate::scalar::scaled32::shift_product;
use crate::scalar::stored32::clip;
use crate::scalar::wide::narrow;

/// `x / 2^K` rounded, for results within 32 bits.
#[inline(always)]
pub fn round<const K: u32>(x: i64) -> i32 {
    narrow::<K>(x.wrapping_add(1 << (K - 1)))
}

/// `x / 2^K` rounded and clipped, for `|x|` below 2^63 - 2^K.
#[inline(always)]
pub fn near<const K: u32>(x: i64) -> i32 {
    let rounded = x.wrapping_add(1 << (K - 1)) >> K;
    if rounded as i32 as i64 == rounded { rounded as i32 } else { end(rounded) }
}

#[cold]
#[inline(never)]
pub fn end(x: i64) -> i32 {
    if x < 0 { i32::MIN } else { i32::MAX }
}

/// `x / 2^down` rounded and clipped, for any `down`.
#[inline(never)]
pub fn shifted(x: i64, down: i32) -> i32 {
    clip(shift_product(x, down)).0
}

/// The same within +-2^PLACES.
#[inline(never)]
pub fn within<const PLACES: u32>(x: i64, down: i32) -> i32 {
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
pub fn rounded_down(x: i32, down: i32) -> i32 {
    let down = (down as u32).min(31);
    x.wrapping_add(1i32.wrapping_shl(down.wrapping_sub(1))).wrapping_shr(down)
}
