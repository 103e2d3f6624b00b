//! The rows of W and products in Q2.30, for the cores with a long multiplication and the host.

use fixed::types::I2F30;

use crate::math::SymMat3;
use crate::scalar::product::{dot2, product};
use crate::scalar::wide::{minus, narrow};

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

/// The rows of I^-1 (r x .) without their last 29 places.
#[inline(always)]
pub fn turn_rows(r: &[i32; 3], inv_inertia: &SymMat3<I2F30>) -> [[i32; 3]; 3] {
    let (r, m) = (*r, minus(*r));
    let SymMat3 { xx, xy, xz, yy, yz, zz } = *inv_inertia;
    [row([xx, xy, xz], r, m), row([xy, yy, yz], r, m), row([xz, yz, zz], r, m)]
}

/// `a b / 2^30` cut off, for results within 32 bits.
#[inline(always)]
pub fn times30(a: i32, b: i32) -> i32 {
    narrow::<30>(product(a, b))
}
