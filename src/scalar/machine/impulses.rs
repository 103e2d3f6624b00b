//! What the impulse of a contact does to a body, for the cores with a long multiplication and the host.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U30};

use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::arm32::Arm32;
use crate::scalar::lever32::Lever32;
use crate::scalar::machine;
use crate::scalar::product::product;
use crate::scalar::scaled32::Scaled32;
use crate::scalar::stored32::add_block;
use crate::scalar::wide::{bits, narrow};

/// `x + k d` for a block `d` of Q2.30 and components of `x` in units of 2^-frac: rounded once a component, and whether a
/// component met the end of the range.
#[inline(always)]
fn add_scaled<F>(x: &mut Vec3<FixedI32<F>>, d: &Vec3<I2F30>, k: i32, exponent: i32) -> bool
where
    F: LeEqU32 + IsLessOrEqual<U30, Output = True>,
{
    machine::add_scaled(x, d, k, 28i32.wrapping_sub(F::I32).wrapping_sub(exponent))
}

/// Adds an impulse j along d to a body's velocity, and to its angular velocity by the lever; whether a component met the end of
/// the range.
#[inline(always)]
pub fn push<F>(body: &mut Body<FixedI32<F>>, d: &Vec3<I2F30>, lever: &Lever32, j: Scaled32) -> bool
where
    F: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
    let (inv_mass, q) = (body.inv_mass, j.mantissa());
    let k = narrow::<29>(product(inv_mass.mantissa(), q));
    let exponent = inv_mass.exponent().wrapping_add(j.exponent()).wrapping_sub(1);
    let met = add_scaled(&mut body.linear_velocity, d, k, exponent);
    let (u, exponent) = lever.turn(F::I32);
    met | add_scaled(&mut body.angular_velocity, u, q, j.exponent().wrapping_add(exponent))
}

/// Adds the impulse `j 2^exponent` at the end of an arm to both velocities of a body; whether a component met the end of the range.
#[inline(never)]
pub fn kick<F>(body: &mut Body<FixedI32<F>>, arm: &Arm32, j: &Vec3<I2F30>, exponent: i32) -> bool
where
    F: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
    let k = body.inv_mass;
    let met = add_scaled(&mut body.linear_velocity, j, k.mantissa(), k.exponent().wrapping_add(exponent));
    let (u, of_arm) = arm.turn(bits(j));
    // `u` in units of 2^of_arm and `j` in units of 2^-30 of its own.
    met | add_block(&mut body.angular_velocity, u, of_arm.wrapping_add(exponent).wrapping_sub(30))
}
