//! What a row of the solver asks of velocities.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::LeEqU32;

use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::scalar::product::{add_dot, dot};
use crate::scalar::step::{Column, Velocity};
use crate::scalar::step32::columns::ARM;
use crate::scalar::step32::round::near;
use crate::scalar::wide::{bits, bits_of};

/// The speed of a body's point along a direction.
#[inline(always)]
pub fn lone_speed<F: LeEqU32>(
    d: &Vec3<I2F30>,
    body: &Velocity<FixedI32<F>>,
    column: &Column<FixedI32<F>>,
) -> FixedI32<F>
where
    FixedI32<F>: Scalar<Unit = I2F30>,
{
    // |v . d| < 2^60 and |w . arm| < 3 2^60.
    let sum = add_dot(dot(bits_of(&body.v), bits(d)), bits_of(&body.w), bits(&column.arm));
    FixedI32::from_bits(near::<ARM>(sum))
}

/// The speed of the second body's point relative to the first's.
#[inline(always)]
pub fn pair_speed<F: LeEqU32>(
    d: &Vec3<I2F30>,
    [a, b]: [&Velocity<FixedI32<F>>; 2],
    columns: &[Column<FixedI32<F>>; 2],
) -> FixedI32<F>
where
    FixedI32<F>: Scalar<Unit = I2F30>,
{
    let linear = dot(bits_of(&(b.v - a.v)), bits(d));
    let turned = add_dot(linear, bits_of(&a.w), bits(&columns[0].arm));
    FixedI32::from_bits(near::<ARM>(add_dot(turned, bits_of(&b.w), bits(&columns[1].arm))))
}

/// The speed of the second body's centre relative to the first's.
#[inline(always)]
pub fn central_speed<F: LeEqU32>(d: &Vec3<I2F30>, [a, b]: [&Vec3<FixedI32<F>>; 2]) -> FixedI32<F>
where
    FixedI32<F>: Scalar<Unit = I2F30>,
{
    FixedI32::from_bits(near::<ARM>(dot(bits_of(&(*b - *a)), bits(d))))
}
