//! Number types as the proof sees them: their bits as exact numbers, and their precision as the bounds use it.

use carom::Scalar;

use super::number::Exact;

/// A scalar whose bits can be read as exact numbers.
pub trait Format: Scalar {
    /// The name in tables.
    fn name() -> String;
    /// Relative rounding error of one operation of the kernel on intermediate results.
    fn precision() -> f64;
    /// The ends between which random magnitudes are drawn.
    fn magnitudes() -> (f64, f64);
    /// The largest number.
    fn largest() -> f64;
    /// The spacing of numbers of that magnitude.
    fn ulp(magnitude: f64) -> f64;
    /// Results beyond the range take the end of it.
    fn saturates() -> bool;

    fn value(self) -> Exact;
    fn unit_value(unit: Self::Unit) -> Exact;
    fn scaled_value(scaled: Self::Scaled) -> Exact;

    /// The nearest number; the end of the range beyond it.
    fn nearest(x: f64) -> Self;
    fn nearest_unit(x: f64) -> Self::Unit;
    fn nearest_scaled(x: f64) -> Self::Scaled;

    /// Any bits at all.
    fn from_raw(bits: u64) -> Self;
    fn unit_from_raw(bits: u64) -> Self::Unit;
    fn raw(self) -> u64;
}

#[cfg(any(feature = "f32", feature = "f64", feature = "micromath"))]
macro_rules! float_format {
    ($float:ty, $name:literal, $plain:ty, $bits:ty, $make:expr, $get:expr) => {
        impl Format for $float {
            fn name() -> String {
                $name.into()
            }
            fn precision() -> f64 {
                f64::from(<$plain>::EPSILON) / 2.0
            }
            fn magnitudes() -> (f64, f64) {
                (2f64.powi(-20), 2f64.powi(20))
            }
            fn largest() -> f64 {
                f64::from(<$plain>::MAX)
            }
            fn ulp(magnitude: f64) -> f64 {
                let exponent = magnitude.abs().max(f64::from(<$plain>::MIN_POSITIVE)).log2().floor();
                f64::from(<$plain>::EPSILON) * exponent.exp2()
            }
            fn saturates() -> bool {
                false
            }
            fn value(self) -> Exact {
                Exact::from_f64(f64::from($get(self)))
            }
            fn unit_value(unit: Self) -> Exact {
                unit.value()
            }
            fn scaled_value(scaled: Self) -> Exact {
                scaled.value()
            }
            fn nearest(x: f64) -> Self {
                $make(x as $plain)
            }
            fn nearest_unit(x: f64) -> Self {
                Self::nearest(x)
            }
            fn nearest_scaled(x: f64) -> Self {
                Self::nearest(x)
            }
            fn from_raw(bits: u64) -> Self {
                $make(<$plain>::from_bits(bits as $bits))
            }
            fn unit_from_raw(bits: u64) -> Self {
                Self::from_raw(bits)
            }
            fn raw(self) -> u64 {
                self.bits()
            }
        }
    };
}

#[cfg(feature = "f32")]
float_format!(f32, "f32", f32, u32, |x| x, |x| x);
#[cfg(feature = "f64")]
float_format!(f64, "f64", f64, u64, |x| x, |x| x);
#[cfg(feature = "micromath")]
float_format!(micromath::F32, "micromath", f32, u32, micromath::F32, |x: micromath::F32| x.0);

#[cfg(feature = "fixed")]
mod fixed_point {
    use carom::{Scalar, Scaled32};
    use fixed::FixedI32;
    use fixed::types::I2F30;
    use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U30};

    use super::super::nearest::nearest_scaled;
    use super::{Exact, Format};

    impl<Frac> Format for FixedI32<Frac>
    where
        Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
    {
        fn name() -> String {
            format!("I{}F{}", 32 - Frac::U32, Frac::U32)
        }
        fn precision() -> f64 {
            2f64.powi(-30)
        }
        fn magnitudes() -> (f64, f64) {
            (Self::ulp(1.0), Self::largest())
        }
        fn largest() -> f64 {
            2f64.powi(31 - Frac::I32)
        }
        fn ulp(_: f64) -> f64 {
            2f64.powi(-Frac::I32)
        }
        fn saturates() -> bool {
            true
        }
        fn value(self) -> Exact {
            Exact::new(i64::from(self.to_bits()), -i64::from(Frac::I32))
        }
        fn unit_value(unit: I2F30) -> Exact {
            Exact::new(i64::from(unit.to_bits()), -30)
        }
        fn scaled_value(scaled: Scaled32) -> Exact {
            Exact::new(i64::from(scaled.mantissa()), i64::from(scaled.exponent()) - 30)
        }
        fn nearest(x: f64) -> Self {
            Self::from_bits((x * 2f64.powi(Frac::I32)).round() as i32)
        }
        fn nearest_unit(x: f64) -> I2F30 {
            I2F30::from_bits((x * 2f64.powi(30)).round() as i32)
        }
        fn nearest_scaled(x: f64) -> Scaled32 {
            nearest_scaled(x)
        }
        fn from_raw(bits: u64) -> Self {
            Self::from_bits(bits as i32)
        }
        fn unit_from_raw(bits: u64) -> I2F30 {
            I2F30::from_bits(bits as i32)
        }
        fn raw(self) -> u64 {
            Scalar::bits(self)
        }
    }
}
