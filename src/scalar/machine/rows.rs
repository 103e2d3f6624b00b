//! Arms, and products in Q2.30, for the cores with a long multiplication and the host.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::LeEqU32;

use crate::math::{SymMat3, Vec3};
use crate::scalar::arm32::Arm32;
use crate::scalar::integer::leading_zeros;
use crate::scalar::product::{dot2, product};
use crate::scalar::scaled32::Scaled32;
use crate::scalar::wide::{bits_of, magnitude, minus, narrow};

/// `a b - c d` without its last 29 places.
#[inline(always)]
fn minor(a: i32, b: i32, c: i32, minus_d: i32) -> i32 {
    narrow::<29>(dot2([a, c], [b, minus_d]))
}

/// A row of I^-1 (r x .), for a row of I^-1 and `m` = -r.
#[inline(always)]
fn row([x, y, z]: [I2F30; 3], r: [i32; 3], m: [i32; 3]) -> [i32; 3] {
    let (x, y, z) = (x.to_bits(), y.to_bits(), z.to_bits());
    [minor(y, r[2], z, m[1]), minor(z, r[0], x, m[2]), minor(x, r[1], y, m[0])]
}

/// An arm r and W = I^-1 (r x .).
#[inline(always)]
pub fn arm<F: LeEqU32>(r: &Vec3<FixedI32<F>>, inv_inertia: &SymMat3<I2F30>, exponent: i32) -> Arm32 {
    arm_of(bits_of(r), inv_inertia, exponent, F::I32)
}

#[inline(never)]
fn arm_of(r: [i32; 3], inv_inertia: &SymMat3<I2F30>, exponent: i32, frac: i32) -> Arm32 {
    let places = leading_zeros(magnitude(r)).wrapping_sub(1);
    // Exact but for arms of 31 bits, which lose the last; and what follows can change their signs.
    let r = [r[0].wrapping_shl(places) >> 1, r[1].wrapping_shl(places) >> 1, r[2].wrapping_shl(places) >> 1];
    // No arm, no say in which power of two a sum takes.
    let of_arm =
        if r[0] | r[1] | r[2] == 0 { Scaled32::LOWEST } else { 1i32.wrapping_sub(frac).wrapping_sub(places as i32) };
    let turn_exponent = of_arm.wrapping_add(exponent).wrapping_sub(1);
    Arm32 { r, exponent: of_arm, turn: turn_rows(&r, inv_inertia), turn_exponent }
}

/// The rows of I^-1 (r x .) without their last 29 places.
#[inline(always)]
fn turn_rows(r: &[i32; 3], inv_inertia: &SymMat3<I2F30>) -> [[i32; 3]; 3] {
    let (r, m) = (*r, minus(*r));
    let SymMat3 { xx, xy, xz, yy, yz, zz } = *inv_inertia;
    [row([xx, xy, xz], r, m), row([xy, yy, yz], r, m), row([xz, yz, zz], r, m)]
}

/// `a b / 2^30` cut off, for results within 32 bits.
#[inline(always)]
pub fn times30(a: i32, b: i32) -> i32 {
    narrow::<30>(product(a, b))
}
