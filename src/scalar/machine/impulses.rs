//! The impulse of a contact and what it does to a body, for the cores with a long multiplication and the host.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U30};

use crate::math::Vec3;
use crate::scalar::lever32::{self, Lever32};
use crate::scalar::product::product;
use crate::scalar::scaled32::Scaled32;
use crate::scalar::stored32::add_scaled;
use crate::scalar::wide::{bits_of, narrow};

/// `-(1 + e) speed / k` where the points approach each other, or else two numbers of which
/// `impulse/lever.rs` says what it says of the speed and k.
#[inline(always)]
pub fn approach_impulse<F: LeEqU32>(
    factor: u32,
    v: [&Vec3<FixedI32<F>>; 2],
    d: [&Vec3<I2F30>; 2],
    inv_masses: [Scaled32; 2],
    levers: [&Lever32; 2],
) -> Result<Scaled32, (Scaled32, Scaled32)> {
    lever32::approach_impulse(factor, [bits_of(v[0]), bits_of(v[1])], d, inv_masses, levers, F::I32)
}

/// Adds an impulse j along d to a body's velocity, and to its angular velocity by the lever; whether a component met the end of
/// the range.
#[inline(always)]
pub fn push<F>(
    v: &mut Vec3<FixedI32<F>>,
    w: &mut Vec3<FixedI32<F>>,
    (d, inv_mass): (&Vec3<I2F30>, Scaled32),
    lever: &Lever32,
    j: Scaled32,
) -> bool
where
    F: LeEqU32 + IsLessOrEqual<U30, Output = True>,
{
    let q = j.mantissa();
    let k = narrow::<29>(product(inv_mass.mantissa(), q));
    let exponent = inv_mass.exponent().wrapping_add(j.exponent()).wrapping_sub(1);
    let met = add_scaled(v, d, k, exponent);
    let (u, exponent) = lever.turn(F::I32);
    met | add_scaled(w, u, q, j.exponent().wrapping_add(exponent))
}
