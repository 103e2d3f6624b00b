//! `micromath::F32`: f32 with an approximate square root that costs no table and no loop, for parts without an FPU.
//! All other operations have the bits of `f32`.

use micromath::F32;

use super::float::float_scalar;
use super::float_step::rows;

#[inline]
fn sqrt(x: F32) -> F32 {
    if !(x.0 > 0.0 && x.0 < f32::INFINITY) {
        // Zero, infinity and NaN are their own roots; negative numbers have none.
        return if x.0 < 0.0 { F32::NAN } else { x };
    }
    if x.0 < f32::MIN_POSITIVE {
        return subnormal_sqrt(x.0);
    }
    F32(normal_sqrt(x.0))
}

/// Micromath halves the exponent, of which subnormal numbers have none: 2^24 makes them normal.
#[cold]
#[inline(never)]
fn subnormal_sqrt(x: f32) -> F32 {
    F32(normal_sqrt(x * 16_777_216.0) * (1.0 / 4096.0))
}

/// Micromath's square root is off by up to 6 %; two Newton steps bring it to less than 1e-5 (1.6e-6 in the worst case
/// found), at the price of two divisions.
#[inline(always)]
fn normal_sqrt(x: f32) -> f32 {
    // Without its sign bit the number is one whose bits micromath can add to without an overflow check that could fail.
    let guess = F32::from_bits(x.to_bits() & 0x7fff_ffff).sqrt().0;
    let guess = (guess + x / guess) * 0.5;
    (guess + x / guess) * 0.5
}

#[inline(always)]
fn power_of_two(exponent: i32) -> F32 {
    F32(f32::from_bits((exponent.wrapping_add(127) as u32) << 23))
}

float_scalar!(F32,
    rows: rows,
    sqrt: sqrt,
    int: |n: i32| F32(n as f32),
    cut: |x: F32| x.0 as i32,
    bits: |x: F32| u64::from(x.0.to_bits()),
    power: power_of_two,
    max_exponent: 126,
    zero: F32(0.0),
    one: F32(1.0),
    largest: F32(f32::MAX),
    pi: F32(core::f32::consts::PI),
    epsilon: F32(f32::EPSILON),
    small: F32(1.0 / (1u64 << 62) as f32),
    finite: |x: F32| x.0.is_finite());
