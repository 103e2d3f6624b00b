//! Number types as the host's tools and tests see them: those of the features under test. For the crate's root.
// Each test uses the part that it needs.
#![allow(dead_code, unused_imports, unused_macros)]

use std::convert::identity;

#[macro_use]
#[path = "host_scalar.rs"]
mod host_scalar;

use carom::{UnitVec3, Vec3};
pub use host_scalar::HostScalar;

/// The nearest number of the format, which has to hold it.
pub fn number<S: HostScalar>(x: f64) -> S {
    S::from_f64(x).expect("a number within the format")
}

pub fn vector<S: HostScalar>(v: [f64; 3]) -> Vec3<S> {
    Vec3::from_array(v.map(number))
}

pub fn floats<S: HostScalar>(v: Vec3<S>) -> [f64; 3] {
    v.to_array().map(S::to_f64)
}

pub fn direction<S: HostScalar>(n: UnitVec3<S>) -> [f64; 3] {
    n.get().to_array().map(S::unit_to_f64)
}

#[cfg(feature = "f32")]
host_float!(f32, f32, identity, identity);
#[cfg(feature = "f64")]
host_float!(f64, f64, identity, identity);
#[cfg(feature = "micromath")]
host_float!(micromath::F32, f32, micromath::F32, |x: micromath::F32| x.0);
#[cfg(feature = "fixed")]
host_fixed!(fixed::types::I16F16, fixed::types::I12F20, fixed::types::I8F24);
