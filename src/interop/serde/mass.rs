//! Solids and mass properties.

use ::serde::{Deserialize, Serialize};

use super::as_data;
use crate::error::{MassError, SolidError};
use crate::interop::sound;
use crate::mass::{MassProperties, Solid};
use crate::math::{SymMat3, Vec3};
use crate::scalar::Scalar;

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
        let mass = Self { inv_mass, inv_inertia, exponent, gyration };
        sound::mass(&mass)?;
        Ok(mass)
    }
}

as_data!(MassProperties as Data<S>: S::Scaled, S::Unit, S::Exponent);
