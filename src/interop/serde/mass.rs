//! Solids and mass properties.

use ::serde::{Deserialize, Serialize};

use super::as_data;
use crate::error::{MassError, SolidError};
use crate::mass::{MassProperties, Solid};
use crate::math::{SymMat3, Vec3};
use crate::scalar::{Scalar, Scaled};

#[derive(Serialize, Deserialize)]
#[serde(rename = "Solid")]
struct SolidData<T> {
    measure: T,
    moments: [T; 3],
}

impl<S: Scalar> From<Solid<S>> for SolidData<S::Scaled> {
    fn from(solid: Solid<S>) -> Self {
        Self { measure: solid.measure(), moments: solid.moments() }
    }
}

impl<S: Scalar> TryFrom<SolidData<S::Scaled>> for Solid<S> {
    type Error = SolidError;

    fn try_from(SolidData { measure, moments }: SolidData<S::Scaled>) -> Result<Self, SolidError> {
        Self::new(measure, moments, SolidError::HalfExtent)
    }
}

as_data!(Solid as SolidData<S::Scaled>: S::Scaled);

/// As stored: bodies of equal mass properties are equal bit for bit.
#[derive(Serialize, Deserialize)]
#[serde(rename = "MassProperties")]
struct MassData<T, U, E> {
    inv_mass: T,
    inv_inertia: SymMat3<U>,
    exponent: E,
    gyration: Vec3<U>,
}

type Data<S> = MassData<<S as Scalar>::Scaled, <S as Scalar>::Unit, <S as Scalar>::Exponent>;

impl<S: Scalar> From<MassProperties<S>> for MassData<S::Scaled, S::Unit, S::Exponent> {
    fn from(mass: MassProperties<S>) -> Self {
        let MassProperties { inv_mass, inv_inertia, exponent, gyration } = mass;
        Self { inv_mass, inv_inertia, exponent, gyration }
    }
}

impl<S: Scalar> TryFrom<MassData<S::Scaled, S::Unit, S::Exponent>> for MassProperties<S> {
    type Error = MassError;

    fn try_from(data: Data<S>) -> Result<Self, MassError> {
        let MassData { inv_mass, inv_inertia, exponent, gyration } = data;
        if !(inv_mass.is_finite() && inv_mass > S::Scaled::ZERO) {
            return Err(MassError::Mass);
        }
        let mass = Self { inv_mass, inv_inertia, exponent, gyration };
        let valid = exponent_is_in_use::<S>(exponent) && is_semidefinite(&mass) && gyration_fits(&mass);
        if valid { Ok(mass) } else { Err(MassError::Inertia) }
    }
}

as_data!(MassProperties as Data<S>: S::Scaled, S::Unit, S::Exponent);

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
    let ([xx, xy, xz, yy, yz, zz], _) = mantissas(mass);
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
    if step == zero || x == zero || y == zero || z == zero {
        return false;
    }
    // Half a step of each mantissa, relative to it; twice that for what the ratios' own arithmetic rounds.
    let relative = step / x + step / y + step / z;
    let near = |a: S::Unit, b: S::Unit| {
        let (a, b) = (a.to_scaled(), b.to_scaled());
        let (gap, size) = (a - b, a.max(-a) + S::Scaled::from_parts(2, 0));
        gap.max(-gap) <= size * relative
    };
    let (a, b) = (computed.to_array(), mass.gyration.to_array());
    near(a[0], b[0]) && near(a[1], b[1]) && near(a[2], b[2])
}
