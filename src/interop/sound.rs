//! Whether what came in from outside is what a constructor could have made.

use crate::body::Body;
use crate::error::MassError;
use crate::mass::MassProperties;
use crate::math::{SymMat3, Vec3};
use crate::scalar::{Scalar, Scaled};

/// Mass properties as stored.
pub(super) fn mass<S: Scalar>(mass: &MassProperties<S>) -> Result<(), MassError> {
    if !(mass.inv_mass.is_finite() && mass.inv_mass > S::Scaled::ZERO) {
        return Err(MassError::Mass);
    }
    let valid = exponent_is_in_use::<S>(mass.exponent) && is_semidefinite(mass) && gyration_fits(mass);
    if valid { Ok(()) } else { Err(MassError::Inertia) }
}

/// In floating point what a position carries is a number, too: the position that it leads to without a velocity is finite.
pub(super) fn rests_are_finite<S: Scalar>(body: &Body<S>) -> bool {
    let Ok(h) = S::sub_step(1, 2) else { return false };
    body.rests.position.iter().all(|rest| {
        let mut rest = *rest;
        S::ZERO.advance(S::ZERO, h, &mut rest).0.is_finite()
    })
}

/// A power of two that a body may have; beyond it sums of exponents would wrap.
fn exponent_is_in_use<S: Scalar>(exponent: S::Exponent) -> bool {
    let power = S::Unit::ONE.to_scaled().raised(exponent);
    let (least, most) = (S::Scaled::from_parts(1, -(1 << 20)), S::Scaled::from_parts(1, 1 << 20));
    exponent == S::NO_EXPONENT || (least <= power && power <= most)
}

/// The mantissas of the tensor, and what rounding them may have changed, for each.
fn mantissas<S: Scalar>(mass: &MassProperties<S>) -> ([S::Scaled; 6], S::Scaled) {
    let SymMat3 { xx, xy, xz, yy, yz, zz } = mass.inv_inertia;
    let tensor = [xx, xy, xz, yy, yz, zz].map(|x| x.to_scaled());
    (tensor, S::Unit::STEP.to_scaled())
}

/// Finite, none of the principal minors below zero by more than rounding makes it. Zero: the rotation is locked.
fn is_semidefinite<S: Scalar>(mass: &MassProperties<S>) -> bool {
    // A quarter of each, so that the trace does not leave the range of a float before they do.
    let [xx, xy, xz, yy, yz, zz] = mantissas(mass).0.map(|x| x * S::Scaled::from_parts(1, -2));
    let zero = S::Scaled::ZERO;
    let trace = xx + yy + zz;
    if !([xx, xy, xz, yy, yz, zz].iter().all(|x| x.is_finite()) && xx >= zero && yy >= zero && zz >= zero) {
        return false;
    }
    if trace == zero {
        return [xy, xz, yz] == [zero; 3];
    }
    // Of unit trace, so that no power leaves the range of a float.
    let [xx, xy, xz, yy, yz, zz] = [xx, xy, xz, yy, yz, zz].map(|x| x / trace);
    let noise = S::Scaled::from_parts(1, -20);
    let minors = [xx * yy - xy * xy, xx * zz - xz * xz, yy * zz - yz * yz];
    let determinant = xx * minors[2] - xy * (xy * zz - xz * yz) + xz * (xy * yz - xz * yy);
    trace.is_finite() && minors.iter().all(|minor| *minor >= -noise) && determinant >= -noise
}

/// The ratios of principal moments are those of the tensor, up to its rounding.
fn gyration_fits<S: Scalar>(mass: &MassProperties<S>) -> bool {
    let ([x, xy, xz, y, yz, z], step) = mantissas(mass);
    let computed = crate::mass::gyration::<S>([x, xy, xz, y, yz, z]);
    if computed == mass.gyration {
        return true;
    }
    let zero = S::Scaled::ZERO;
    if step == zero || x + y + z == zero {
        return false;
    }
    // Of a tensor whose entries off the diagonal were rounded away.
    if mass.gyration == Vec3::ZERO {
        return true;
    }
    // Half a step of each mantissa, relative to it; twice that for what the ratios' own arithmetic rounds. Of a rod the moments
    // whose difference counts are many times the one that it is divided by; where a mantissa is rounded to zero, they say nothing.
    let relative = step / x + step / y + step / z;
    let near = |i: usize, moments: S::Scaled| {
        let gap = computed.to_array()[i].to_scaled() - mass.gyration.to_array()[i].to_scaled();
        gap.max(-gap) <= (moments + S::Scaled::ONE) * relative
    };
    near(0, x / y + x / z) && near(1, y / z + y / x) && near(2, z / x + z / y)
}
