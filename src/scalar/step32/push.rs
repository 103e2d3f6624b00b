//! What an impulse does to a body's velocities.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::LeEqU32;

use super::columns::{ARM, TURN};
use super::round::{near, round};
use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::scalar::machine::{add_along, add_turn};
use crate::scalar::product::product;
use crate::scalar::step::{Column, Velocity};
use crate::scalar::wide::bits;

/// Impulses whose effects are within 32 bits without a look: less than this.
const LARGE: i32 = 1 << 26;

/// Adds a change to each component.
#[inline(always)]
fn add<F: LeEqU32>(v: &mut Vec3<FixedI32<F>>, change: [i32; 3]) {
    v.x = v.x.saturating_add(FixedI32::from_bits(change[0]));
    v.y = v.y.saturating_add(FixedI32::from_bits(change[1]));
    v.z = v.z.saturating_add(FixedI32::from_bits(change[2]));
}

/// A vector of Q2.30 after that of 2^-28, or opposite to it, times its length; and a turn.
#[inline(always)]
pub fn apply<F: LeEqU32>(
    body: &mut Velocity<FixedI32<F>>,
    d: &Vec3<I2F30>,
    column: &Column<FixedI32<F>>,
    impulse: i32,
    sign: i32,
) where
    FixedI32<F>: Scalar<Unit = I2F30>,
{
    let Velocity { v, w } = body;
    if impulse.wrapping_add(LARGE) as u32 >= 2 * LARGE as u32 {
        return apply_large(v, w, [bits(d), bits(&column.turn)], column.share.to_bits(), impulse, sign);
    }
    let share = round::<30>(product(column.share.to_bits(), impulse)).wrapping_mul(sign);
    add_along(v, d, share);
    add_turn(w, &column.turn, impulse);
}

#[cold]
#[inline(never)]
fn apply_large<F: LeEqU32>(
    v: &mut Vec3<FixedI32<F>>,
    w: &mut Vec3<FixedI32<F>>,
    [d, turn]: [[i32; 3]; 2],
    share: i32,
    impulse: i32,
    sign: i32,
) {
    let share = near::<30>(product(share, impulse)).saturating_mul(sign);
    add(v, [near::<ARM>(product(d[0], share)), near::<ARM>(product(d[1], share)), near::<ARM>(product(d[2], share))]);
    let turned = |u| near::<TURN>(product(u, impulse));
    add(w, [turned(turn[0]), turned(turn[1]), turned(turn[2])]);
}

/// The same without a turn.
#[inline(always)]
pub fn thrust<F: LeEqU32>(v: &mut Vec3<FixedI32<F>>, d: &Vec3<I2F30>, share: i32, impulse: i32) {
    if impulse.wrapping_add(LARGE) as u32 >= 2 * LARGE as u32 {
        return thrust_large(v, bits(d), share, impulse);
    }
    add_along(v, d, round::<30>(product(share, impulse)));
}

#[cold]
#[inline(never)]
fn thrust_large<F: LeEqU32>(v: &mut Vec3<FixedI32<F>>, d: [i32; 3], share: i32, impulse: i32) {
    let share = near::<30>(product(share, impulse));
    add(v, [near::<ARM>(product(d[0], share)), near::<ARM>(product(d[1], share)), near::<ARM>(product(d[2], share))]);
}
