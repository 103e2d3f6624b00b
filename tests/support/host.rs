//! Number types as the host's tools and tests see them: to and from f64, with the range of each format.

use carom::{Scalar, Scaled};

/// A scalar that can be read from and written to f64.
pub trait HostScalar: Scalar {
    /// The name on the command line and in tables.
    const NAME: &'static str;
    /// The spacing of numbers near `magnitude`: constant in fixed point.
    fn spacing(magnitude: f64) -> f64;
    /// The nearest number, or `None` where `x` is beyond the range of the format.
    fn from_f64(x: f64) -> Option<Self>;
    /// The nearest component of a unit vector or quaternion, for |x| <= 1.
    fn unit(x: f64) -> Self::Unit;
    /// The nearest intermediate number, whatever its magnitude.
    fn scaled(x: f64) -> Self::Scaled {
        if x == 0.0 {
            return Self::Scaled::ZERO;
        }
        let exponent = x.abs().log2().floor() as i32 - 29;
        Self::Scaled::from_parts((x / f64::from(exponent).exp2()).round() as i32, exponent)
    }
    /// The exact value.
    fn to_f64(self) -> f64;
    /// The exact value of a component.
    fn unit_to_f64(x: Self::Unit) -> f64;
}

#[cfg(any(feature = "f32", feature = "f64", feature = "micromath"))]
macro_rules! host_float {
    ($float:ty, $name:literal, $max:expr, $epsilon:expr, $from:expr, $to:expr) => {
        impl HostScalar for $float {
            const NAME: &'static str = $name;
            fn spacing(magnitude: f64) -> f64 {
                magnitude.abs() * $epsilon
            }
            fn from_f64(x: f64) -> Option<Self> {
                (x.abs() <= $max).then(|| $from(x))
            }
            fn unit(x: f64) -> Self {
                $from(x)
            }
            fn scaled(x: f64) -> Self {
                $from(x)
            }
            fn to_f64(self) -> f64 {
                $to(self)
            }
            fn unit_to_f64(x: Self) -> f64 {
                $to(x)
            }
        }
    };
}

#[cfg(feature = "f32")]
host_float!(f32, "f32", f64::from(f32::MAX), f64::from(f32::EPSILON), |x: f64| x as f32, f64::from);
#[cfg(feature = "f64")]
host_float!(f64, "f64", f64::MAX, f64::EPSILON, |x: f64| x, |x: f64| x);
#[cfg(feature = "micromath")]
host_float!(
    micromath::F32,
    "micromath",
    f64::from(f32::MAX),
    f64::from(f32::EPSILON),
    |x: f64| micromath::F32(x as f32),
    |x: micromath::F32| f64::from(x.0)
);

#[cfg(feature = "fixed")]
macro_rules! host_fixed {
    ($($fixed:ty, $name:literal;)+) => {$(
        impl HostScalar for $fixed {
            const NAME: &'static str = $name;
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
        }
    )+};
}

#[cfg(feature = "fixed")]
host_fixed! {
    fixed::types::I16F16, "i16f16";
    fixed::types::I12F20, "i12f20";
    fixed::types::I8F24, "i8f24";
}
