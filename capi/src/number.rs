//! The number types as C sees them: a float, or an integer with the bits of a fixed-point number.

use carom::{Quat, Scalar, SymMat3, UnitVec3, Vec3};
#[cfg(feature = "fixed")]
use fixed::FixedI32;
#[cfg(feature = "fixed")]
use fixed::types::{I2F30, I12F20, I16F16};

use crate::status::carom_status;

/// A number type with a form that C can hold.
pub trait Number: Scalar {
    /// `float`, or `int32_t` with the bits of the fixed-point number.
    type Raw: Copy;

    /// Tells worlds of one number type from those of another: in memory that was never initialised it is not.
    const TAG: u32;

    /// From what C holds.
    fn from_raw(raw: Self::Raw) -> Self;

    /// To what C holds.
    fn raw(self) -> Self::Raw;

    /// The same for components of directions and orientations.
    fn unit_from_raw(raw: Self::Raw) -> Self::Unit;

    /// The same for components of directions and orientations.
    fn unit_raw(unit: Self::Unit) -> Self::Raw;
}

#[cfg(feature = "f32")]
impl Number for f32 {
    type Raw = f32;
    const TAG: u32 = 0xca20_0f32;

    fn from_raw(raw: f32) -> Self {
        raw
    }

    fn raw(self) -> f32 {
        self
    }

    fn unit_from_raw(raw: f32) -> f32 {
        raw
    }

    fn unit_raw(unit: f32) -> f32 {
        unit
    }
}

#[cfg(feature = "fixed")]
macro_rules! fixed_number {
    ($($type:ty: $tag:literal;)+) => {$(
        impl Number for $type {
            type Raw = i32;
            const TAG: u32 = $tag;

            fn from_raw(raw: i32) -> Self {
                Self::from_bits(raw)
            }

            fn raw(self) -> i32 {
                self.to_bits()
            }

            fn unit_from_raw(raw: i32) -> I2F30 {
                FixedI32::from_bits(raw)
            }

            fn unit_raw(unit: I2F30) -> i32 {
                unit.to_bits()
            }
        }
    )+};
}

#[cfg(feature = "fixed")]
fixed_number! {
    I16F16: 0xca20_0016;
    I12F20: 0xca20_0020;
}

pub(crate) fn vec3<N: Number>([x, y, z]: [N::Raw; 3]) -> Vec3<N> {
    Vec3::new(N::from_raw(x), N::from_raw(y), N::from_raw(z))
}

pub(crate) fn raw_vec3<N: Number>(v: Vec3<N>) -> [N::Raw; 3] {
    v.to_array().map(N::raw)
}

/// A vector of finite components.
pub(crate) fn finite<N: Number>(v: Vec3<N>) -> Result<Vec3<N>, carom_status> {
    if v.is_finite() { Ok(v) } else { Err(carom_status::CAROM_NOT_FINITE) }
}

pub(crate) fn unit_vec3<N: Number>([x, y, z]: [N::Raw; 3]) -> Result<UnitVec3<N>, carom_status> {
    Ok(UnitVec3::new(Vec3::new(N::unit_from_raw(x), N::unit_from_raw(y), N::unit_from_raw(z)))?)
}

pub(crate) fn raw_unit_vec3<N: Number>(d: UnitVec3<N>) -> [N::Raw; 3] {
    d.get().to_array().map(N::unit_raw)
}

pub(crate) fn quat<N: Number>(q: [N::Raw; 4]) -> Result<Quat<N>, carom_status> {
    let [w, x, y, z] = q.map(N::unit_from_raw);
    Ok(Quat::new(w, x, y, z)?)
}

pub(crate) fn normalized<N: Number>(q: [N::Raw; 4]) -> Result<Quat<N>, carom_status> {
    let [w, x, y, z] = q.map(N::unit_from_raw);
    Ok(Quat::normalize(w, x, y, z)?)
}

pub(crate) fn raw_quat<N: Number>(q: Quat<N>) -> [N::Raw; 4] {
    q.to_array().map(N::unit_raw)
}

pub(crate) fn tensor<N: Number>(six: [N::Raw; 6]) -> SymMat3<N> {
    let [xx, xy, xz, yy, yz, zz] = six.map(N::from_raw);
    SymMat3 { xx, xy, xz, yy, yz, zz }
}
