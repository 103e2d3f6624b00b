//! Every number type as the host sees it.

use std::convert::identity;

#[macro_use]
#[path = "../../tests/support/host_scalar.rs"]
mod host_scalar;

pub use host_scalar::HostScalar;

host_float!(f32, f32, identity, identity);
host_float!(f64, f64, identity, identity);
host_float!(micromath::F32, f32, micromath::F32, |x: micromath::F32| x.0);
host_fixed!(fixed::types::I16F16, fixed::types::I12F20, fixed::types::I8F24);
