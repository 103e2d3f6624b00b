//! Number types as the host's tools and tests see them: to and from f64, with the range of each format.
//!
//! Mounted through `mod host` of the crate's root, which implements the trait: `host.rs` beside this file for the types
//! of the features under test, the `validate` example for all.

#[path = "nearest.rs"]
mod nearest;

use carom::Scalar;
use nearest::nearest_scaled;

/// A scalar that can be read from and written to f64.
pub trait HostScalar: Scalar {
    /// The spacing of numbers near `magnitude`: constant in fixed point.
    fn spacing(magnitude: f64) -> f64;
    /// The nearest number, or `None` where `x` is beyond the range of the format.
    fn from_f64(x: f64) -> Option<Self>;
    /// The nearest component of a unit vector or quaternion, for |x| <= 1.
    fn unit(x: f64) -> Self::Unit;
    /// The nearest intermediate number, whatever its magnitude.
    fn scaled(x: f64) -> Self::Scaled {
        nearest_scaled(x)
    }
    /// The exact value.
    fn to_f64(self) -> f64;
    /// The exact value of a component.
    fn unit_to_f64(x: Self::Unit) -> f64;
    /// The exact value of an intermediate number.
    fn scaled_to_f64(x: Self::Scaled) -> f64;
}

/// Implements [`HostScalar`] for a float: the plain float in it, and the way there and back.
macro_rules! host_float {
    ($float:ty, $plain:ty, $wrap:expr, $unwrap:expr) => {
        impl $crate::host::HostScalar for $float {
            fn spacing(magnitude: f64) -> f64 {
                magnitude.abs() * f64::from(<$plain>::EPSILON)
            }
            fn from_f64(x: f64) -> Option<Self> {
                (x.abs() <= f64::from(<$plain>::MAX)).then(|| $wrap(x as $plain))
            }
            fn unit(x: f64) -> Self {
                $wrap(x as $plain)
            }
            fn scaled(x: f64) -> Self {
                $wrap(x as $plain)
            }
            fn to_f64(self) -> f64 {
                f64::from($unwrap(self))
            }
            fn unit_to_f64(x: Self) -> f64 {
                x.to_f64()
            }
            fn scaled_to_f64(x: Self) -> f64 {
                x.to_f64()
            }
        }
    };
}

/// Implements [`HostScalar`] for fixed-point formats.
macro_rules! host_fixed {
    ($($fixed:ty),+) => {$(
        impl $crate::host::HostScalar for $fixed {
            fn spacing(_: f64) -> f64 {
                Self::DELTA.to_num()
            }
            fn from_f64(x: f64) -> Option<Self> {
                x.is_finite().then(|| Self::checked_from_num(x)).flatten()
            }
            fn unit(x: f64) -> fixed::types::I2F30 {
                fixed::types::I2F30::from_num(x)
            }
            fn to_f64(self) -> f64 {
                self.to_num()
            }
            fn unit_to_f64(x: fixed::types::I2F30) -> f64 {
                x.to_num()
            }
            fn scaled_to_f64(x: carom::Scaled32) -> f64 {
                f64::from(x.mantissa()) * f64::from(x.exponent() - 30).exp2()
            }
        }
    )+};
}
