//! Integer arithmetic under the fixed-point formats: rounding shifts, a quotient and a square root.
//!
//! Every function is total, wraps nowhere within its stated domain, and uses wrapping operators, so that a build
//! with `overflow-checks` contains no panic. There is one rounding: to the nearest, ties away from zero, which is
//! symmetric under a change of sign.

use super::machine::plus_sign;
use super::product::{product, unsigned_product};

/// How many leading digits of `x` are zero; 32 for zero.
#[cfg(not(multiply = "short"))]
#[inline(always)]
pub(super) const fn leading_zeros(x: u32) -> u32 {
    x.leading_zeros()
}

#[cfg(multiply = "short")]
pub(super) use super::machine::{leading_zeros, long_quotient, reciprocal};

/// The leading zeros of a number above zero.
#[inline(always)]
pub(super) fn leading_zeros64(x: u64) -> u32 {
    let (high, low) = ((x >> 32) as u32, x as u32);
    if high == 0 { leading_zeros(low).wrapping_add(32) } else { leading_zeros(high) }
}

/// `x / 2^s` rounded. `s` in `0..=62`; |x| < 2^63 - 2^(s-1).
#[inline(always)]
pub(crate) fn round_shift(x: i64, s: u32) -> i64 {
    if s == 0 {
        return x;
    }
    let half = 1i64.wrapping_shl(s.wrapping_sub(1));
    // The sign turns "ties up" into "ties away from zero".
    plus_sign(x).wrapping_add(half).wrapping_shr(s)
}

/// Seeds of the reciprocal: `2^16 / (129 + 2i) - 256`, the reciprocal of the middle of the i-th of 64 intervals that
/// divide `[1/2, 1)`, in 1/256, without its leading 256. Off by at most 2^-6.9 in relative terms.
pub(super) static RECIPROCAL_SEED: [u8; 64] = {
    let mut table = [0; 64];
    let mut i = 0;
    while i < 64 {
        let divisor = 129 + 2 * i as u32;
        table[i] = ((65536 + divisor / 2) / divisor - 256) as u8;
        i += 1;
    }
    table
};

/// The upper half of the product.
#[inline(always)]
pub(crate) fn high_product(a: u32, b: u32) -> u32 {
    (unsigned_product(a, b) >> 32) as u32
}

/// `2^62 / d` for `d >= 2^31`; off by at most 2^-26 in relative terms.
///
/// Two Newton steps `x (2 - d x)` from a 64-byte table: 7, 13, then 26 bits.
#[cfg(not(multiply = "short"))]
#[inline(always)]
pub(crate) fn reciprocal(d: u32) -> u32 {
    let x0 = RECIPROCAL_SEED[((d >> 25) & 63) as usize] as u32 | 256;
    let rest_q23 = (2u32 << 23).wrapping_sub((d >> 17).wrapping_mul(x0));
    let x1_q15 = x0.wrapping_mul(rest_q23 >> 8) >> 8;
    let rest_q30 = (2u32 << 30).wrapping_sub((unsigned_product(d, x1_q15) >> 17) as u32);
    (unsigned_product(rest_q30, x1_q15 << 16) >> 31) as u32
}

/// `n 2^30 / d` to one unit, for `n` and `d` of 32 bits.
///
/// The reciprocal gives 26 bits; what is left of the dividend, times the reciprocal, the rest.
#[cfg(not(multiply = "short"))]
#[inline(always)]
pub(crate) fn long_quotient(n: u32, d: u32) -> u32 {
    let x = reciprocal(d);
    let q = high_product(n, x);
    // Below 2^38 in magnitude.
    let rest = ((n as u64) << 30).wrapping_sub(unsigned_product(q, d)) as i64;
    let step = product((rest >> 8) as i32, (x >> 1) as i32) >> 53;
    q.wrapping_add(step as u32)
}

/// `n 2^k / d` rounded, for `n` and `d` in `[2^29, 2^30)` and `k` = 29 or 30: a quotient below 2^31.
///
/// The reciprocal gives the quotient to 26 bits, its remainder corrects it to one unit, and the last remainder decides
/// the rounding: the result is correctly rounded whatever the reciprocal's error was.
#[inline(always)]
pub(crate) fn quotient(n: u32, d: u32, k: u32) -> u32 {
    let x = reciprocal(d << 2);
    // Of 31 bits at most after 30 places.
    let mut q = ((unsigned_product(n, x) >> 30) as u32).wrapping_shr(30u32.wrapping_sub(k));
    // Below 2^36 in magnitude: the correction is its high part times the reciprocal.
    let rest = (n as u64).wrapping_shl(k).wrapping_sub(unsigned_product(q, d)) as i64;
    let step = (product((rest >> 8) as i32, (x >> 1) as i32) >> 51) as i32;
    q = q.wrapping_add(step as u32);
    // Within two divisors: 32 bits.
    let divisor = d as i32;
    let mut r = (rest as i32).wrapping_sub(step.wrapping_mul(divisor));
    if r < 0 {
        q = q.wrapping_sub(1);
        r = r.wrapping_add(divisor);
    }
    if r >= divisor {
        q = q.wrapping_add(1);
        r = r.wrapping_sub(divisor);
    }
    if r.wrapping_shl(1) >= divisor {
        q = q.wrapping_add(1);
    }
    q
}

/// `n 2^shift / d` rounded, or `None` where the result would not fit 31 bits. `d > 0`, `shift <= 31`.
#[inline]
pub(crate) fn wide_quotient(n: u32, d: u32, shift: u32) -> Option<u32> {
    if n == 0 {
        return Some(0);
    }
    // By halves: where size counts, the compiler calls a function to shift 64 bits.
    let wide = ((n >> 1).wrapping_shr(31 ^ shift) as u64) << 32 | n.wrapping_shl(shift) as u64;
    let (n_zeros, d_zeros) = (leading_zeros(n), leading_zeros(d));
    // floor(log2) of the quotient, or one more.
    let magnitude = (shift as i32).wrapping_add(d_zeros as i32).wrapping_sub(n_zeros as i32);
    if magnitude > 31 {
        return None;
    }
    // An estimate from the leading 30 bits of both.
    let n30 = leading30(n, n_zeros);
    let d30 = leading30(d, d_zeros);
    let q30 = quotient(n30, d30, 30);
    // -1 at least, for which 31 bits still have room.
    let down = 30i32.wrapping_sub(magnitude);
    let mut q = match down {
        ..0 => q30.wrapping_shl(1),
        0..32 => q30.wrapping_shr(down as u32),
        32.. => 0,
    };
    let mut r = wide.wrapping_sub(unsigned_product(q, d)) as i64;
    let divisor = d as i64;
    // Cutting both to 30 bits moved the estimate by at most six units of 2^31, the shift by one. Eight too few, the
    // remainder is positive; the rest is a comparison a binary digit. (Of a loop that subtracts the compiler makes a 64-bit
    // division, and a loop at all it leaves as it is where size counts.)
    q = q.wrapping_sub(8);
    r = r.wrapping_add(divisor.wrapping_shl(3));
    (q, r) = digit(q, r, divisor, 4);
    (q, r) = digit(q, r, divisor, 3);
    (q, r) = digit(q, r, divisor, 2);
    (q, r) = digit(q, r, divisor, 1);
    (q, r) = digit(q, r, divisor, 0);
    if r.wrapping_shl(1) >= divisor {
        q = q.wrapping_add(1);
    }
    if q > i32::MAX as u32 { None } else { Some(q) }
}

/// A binary digit of a quotient: q and what remains, with 2^place more of the divisor in q where that many remain.
#[inline(always)]
const fn digit(q: u32, r: i64, divisor: i64, place: u32) -> (u32, i64) {
    let part = divisor.wrapping_shl(place);
    if r >= part { (q.wrapping_add(1 << place), r.wrapping_sub(part)) } else { (q, r) }
}

/// The leading 30 bits of `x > 0`, in `[2^29, 2^30)`, cut off below.
#[inline(always)]
const fn leading30(x: u32, zeros: u32) -> u32 {
    x.wrapping_shl(zeros) >> 2
}

/// Seeds of the inverse square root: for the i-th of 64 intervals that divide `[0, 1)`, that of its middle in 1/256,
/// without its leading 256. From 1/4 on, where they are used, off by at most 2^-6 in relative terms.
const INVERSE_ROOT_SEED: [u8; 64] = {
    let mut table = [0; 64];
    let mut i = 16;
    while i < 64 {
        // y^2 (2i + 1)/128 = 2^16, for the largest y of eight bits and one.
        let mut y = 256u32;
        while y < 511 && (y + 1) * (y + 1) * (2 * i as u32 + 1) <= 128 << 16 {
            y += 1;
        }
        table[i] = (y - 256) as u8;
        i += 1;
    }
    table
};

/// `2^46 / sqrt(a)` for `a >= 2^30`, between 2^30 and 2^31; off by at most 2^-22 in relative terms, next to a = 2^30.
#[inline(always)]
pub(crate) fn inverse_root(a: u32) -> u32 {
    let y0 = INVERSE_ROOT_SEED[(a >> 26) as usize] as u32 | 256;
    let rest_q30 = (3u32 << 30).wrapping_sub((a >> 18).wrapping_mul(y0.wrapping_mul(y0)));
    let y1_q16 = y0.wrapping_mul(rest_q30 >> 16) >> 7;
    let root_q31 = (unsigned_product(a, y1_q16) >> 17) as u32;
    let rest_q30 = (3u32 << 30).wrapping_sub((unsigned_product(root_q31, y1_q16) >> 17) as u32);
    (unsigned_product(y1_q16 << 14, rest_q30) >> 31) as u32
}

/// The square root of `x`, cut to an integer.
///
/// Two Newton steps `y (3 - a y^2)/2` for the inverse root of the leading 32 bits give the root to 25 bits, what is left of
/// `x` the rest, and two comparisons each way the last unit: the result is right whatever the estimate's error was.
#[inline]
fn floor_sqrt(x: u64) -> u32 {
    if x == 0 {
        return 0;
    }
    let places = leading_zeros64(x) & 62;
    let n = x.wrapping_shl(places);
    // n / 2^64 in [1/4, 1).
    let a = (n >> 32) as u32;
    let y2_q30 = inverse_root(a) as u64;
    let estimate = (a as u64).wrapping_mul(y2_q30) >> 30;
    let mut root = if estimate > u32::MAX as u64 { u32::MAX as u64 } else { estimate };
    // Below 2^42 in magnitude.
    let rest = n.wrapping_sub(root.wrapping_mul(root)) as i64;
    root = root.wrapping_add((((rest >> 12).wrapping_mul(y2_q30 as i64)) >> 51) as u64);
    let mut rest = n.wrapping_sub(root.wrapping_mul(root)) as i64;
    (root, rest) = nearer(root, rest);
    (root, _) = nearer(root, rest);
    (root as u32).wrapping_shr(places / 2)
}

/// A root at most one unit nearer to the one cut to an integer, and what remains.
#[inline(always)]
const fn nearer(root: u64, rest: i64) -> (u64, i64) {
    let (mut root, mut rest) = (root, rest);
    if rest < 0 {
        root = root.wrapping_sub(1);
        rest = rest.wrapping_add((root as i64).wrapping_mul(2).wrapping_add(1));
    }
    if rest > (root as i64).wrapping_mul(2) {
        rest = rest.wrapping_sub((root as i64).wrapping_mul(2).wrapping_add(1));
        root = root.wrapping_add(1);
    }
    (root, rest)
}

/// The square root of `x`, rounded to the nearest integer (a tie cannot happen); `u32::MAX` where that is 2^32.
#[inline]
pub(crate) fn round_sqrt(x: u64) -> u32 {
    let root = floor_sqrt(x);
    let rest = x.wrapping_sub((root as u64).wrapping_mul(root as u64));
    // sqrt(x) > root + 1/2 exactly where x > root^2 + root.
    if rest > root as u64 { root.saturating_add(1) } else { root }
}
