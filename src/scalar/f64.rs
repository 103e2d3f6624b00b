//! `f64`: for hosts, and for parts with a double-precision unit.

use super::float::float_scalar;
use super::float_step::rows;

#[inline(always)]
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits((exponent.wrapping_add(1023) as u64) << 52)
}

float_scalar!(f64,
    rows: rows,
    sqrt: libm::sqrt,
    int: |n: i32| f64::from(n),
    cut: |x: f64| x as i32,
    bits: f64::to_bits,
    power: power_of_two,
    max_exponent: 1022,
    zero: 0.0,
    one: 1.0,
    largest: f64::MAX,
    pi: core::f64::consts::PI,
    epsilon: f64::EPSILON,
    small: f64::from_bits((1023 - 510) << 52),
    finite: f64::is_finite);
