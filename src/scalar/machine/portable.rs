//! What `mainline.rs` and `baseline.rs` do in instructions of their cores, for all others.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::LeEqU32;

use crate::body::Body;
use crate::math::{SymMat3, Vec3};
use crate::scalar::Scalar;
use crate::scalar::integer::leading_zeros;
use crate::scalar::lever32::Lever32;
use crate::scalar::product::{dot, dot2, product};
use crate::scalar::scaled32::Scaled32;
use crate::scalar::step32::columns::{ARM, TURN};
use crate::scalar::step32::round::round;
use crate::scalar::stored32::{add_change, add_far, moved};
use crate::scalar::wide::{bits, bits_of, high, magnitude, narrow, shift_left, units};

use super::shifts::at_most_31;

/// The lever of an arm and an angular velocity of one format.
#[inline(always)]
pub fn lever<F>(body: &Body<FixedI32<F>>, r: &Vec3<FixedI32<F>>, d: &Vec3<I2F30>) -> Lever32
where
    FixedI32<F>: Scalar<Unit = I2F30, Exponent = i32>,
{
    lever_of(bits_of(r), bits_of(&body.angular_velocity), d, &body.inv_inertia_world, body.exponent)
}

#[inline(never)]
fn lever_of(r: [i32; 3], w: [i32; 3], d: &Vec3<I2F30>, inv_inertia: &SymMat3<I2F30>, exponent: i32) -> Lever32 {
    let places = leading_zeros(magnitude(r)).wrapping_sub(1);
    let r = [r[0].wrapping_shl(places), r[1].wrapping_shl(places), r[2].wrapping_shl(places)];
    let d = bits(d);
    let m = [d[0].wrapping_neg(), d[1].wrapping_neg(), d[2].wrapping_neg()];
    // Without a multiply-and-subtract products with -d are added instead.
    let c = [
        narrow::<32>(dot2([r[1], r[2]], [d[2], m[1]])),
        narrow::<32>(dot2([r[2], r[0]], [d[0], m[2]])),
        narrow::<32>(dot2([r[0], r[1]], [d[1], m[0]])),
    ];
    let spin = dot(w, c);
    let SymMat3 { xx, xy, xz, yy, yz, zz } = inv_inertia;
    let x = narrow::<29>(dot([xx.to_bits(), xy.to_bits(), xz.to_bits()], c));
    let y = narrow::<29>(dot([xy.to_bits(), yy.to_bits(), yz.to_bits()], c));
    let z = narrow::<29>(dot([xz.to_bits(), yz.to_bits(), zz.to_bits()], c));
    // Never negative: cutting off must not make it so.
    let product = dot(c, [x, y, z]);
    let product = if product < 0 { 0 } else { product };
    let zeros = leading_zeros((product >> 32) as u32 | 1);
    let inverse_mass = shift_left(product, zeros) as u32 >> 2;
    let places = places as i32;
    let turn_exponent = exponent.wrapping_sub(places);
    // What is zero has no say in which power of two a sum takes.
    let of_product = turn_exponent.wrapping_sub(places).wrapping_sub(zeros as i32);
    let inverse_mass_exponent = if inverse_mass == 0 { Scaled32::LOWEST } else { of_product };
    Lever32 { spin, turn: units([x, y, z]), places, turn_exponent, inverse_mass, inverse_mass_exponent }
}

/// Adds `d k / 2^(32 + down)` to `x`, rounded once a component; whether a component met the end of the range. The upper half of
/// `d k` has 29 bits at most.
#[inline(always)]
pub fn add_scaled<F>(x: &mut Vec3<FixedI32<F>>, d: &Vec3<I2F30>, k: i32, down: i32) -> bool {
    if down <= 0 {
        return add_far(x, d, k, down);
    }
    // By a place or more: what was cut off below makes no difference to the rounding.
    let places = at_most_31(down);
    let half = (1u32.wrapping_shl(places) >> 1) as i32;
    let [d0, d1, d2] = bits(d);
    let d_k = [high(product(d0, k)), high(product(d1, k)), high(product(d2, k))];
    let change = [moved(d_k[0], half, places), moved(d_k[1], half, places), moved(d_k[2], half, places)];
    if add_change(x, change) { add_far(x, d, k, down) } else { false }
}

/// Adds `d k / 2^K` to `v`, rounded once a component; what leaves the range stays at its end.
#[inline(always)]
fn add_product<const K: u32, F: LeEqU32>(v: &mut Vec3<FixedI32<F>>, d: &Vec3<I2F30>, k: i32) {
    let d = bits(d);
    v.x = v.x.saturating_add(FixedI32::from_bits(round::<K>(product(d[0], k))));
    v.y = v.y.saturating_add(FixedI32::from_bits(round::<K>(product(d[1], k))));
    v.z = v.z.saturating_add(FixedI32::from_bits(round::<K>(product(d[2], k))));
}

/// Adds `k` times a direction to `v`, for |k| <= 2^26.
#[inline(always)]
pub fn add_along<F: LeEqU32>(v: &mut Vec3<FixedI32<F>>, d: &Vec3<I2F30>, k: i32) {
    add_product::<ARM, F>(v, d, k);
}

/// Adds `k` times a turn to `w`, for |k| <= 2^26.
#[inline(always)]
pub fn add_turn<F: LeEqU32>(w: &mut Vec3<FixedI32<F>>, turn: &Vec3<I2F30>, k: i32) {
    add_product::<TURN, F>(w, turn, k);
}
