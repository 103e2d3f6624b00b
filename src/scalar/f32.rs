//! `f32`: the square root from the FPU where the target has one, from `libm` elsewhere. Both are correctly rounded.

use super::float::float_scalar;
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
use super::float_step::rows;
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
use super::fpu::rows;

#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
use super::fpu::sqrt;
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
use libm::sqrtf as sqrt;

#[inline(always)]
fn power_of_two(exponent: i32) -> f32 {
    f32::from_bits((exponent.wrapping_add(127) as u32) << 23)
}

float_scalar!(f32,
    rows: rows,
    sqrt: sqrt,
    int: |n: i32| n as f32,
    cut: |x: f32| x as i32,
    bits: |x: f32| u64::from(x.to_bits()),
    power: power_of_two,
    max_exponent: 126,
    zero: 0.0,
    one: 1.0,
    largest: f32::MAX,
    pi: core::f32::consts::PI,
    epsilon: f32::EPSILON,
    small: 1.0 / (1u64 << 62) as f32,
    finite: f32::is_finite);
