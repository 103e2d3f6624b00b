//! Number types as the host's tools and tests see them: those of the features under test. For the crate's root.
// Each test uses the part that it needs.
#![allow(dead_code, unused_imports, unused_macros)]

use std::convert::identity;

#[macro_use]
#[path = "host_scalar.rs"]
mod host_scalar;

pub use host_scalar::HostScalar;

#[cfg(feature = "f32")]
host_float!(f32, f32, identity, identity);
#[cfg(feature = "f64")]
host_float!(f64, f64, identity, identity);
#[cfg(feature = "micromath")]
host_float!(micromath::F32, f32, micromath::F32, |x: micromath::F32| x.0);
#[cfg(feature = "fixed")]
host_fixed!(fixed::types::I16F16, fixed::types::I12F20, fixed::types::I8F24);
