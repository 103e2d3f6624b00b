//! What the checks know of a number type.

use super::magnitude::Magnitude;
use crate::scalar::Scalar;

/// The range and the precision of a number type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 32 bits, so many of them after the point.
    Fixed {
        /// Fraction bits.
        fraction_bits: u32,
    },
    /// A floating-point number.
    Float {
        /// Bits of the mantissa, the hidden one included.
        digits: u32,
        /// The largest power of two.
        exponents: u32,
    },
}

/// A number type whose limits are known to constants.
pub trait NumberFormat: Scalar {
    /// Its range and precision.
    const FORMAT: Format;
}

#[cfg(feature = "f32")]
impl NumberFormat for f32 {
    const FORMAT: Format = Format::SINGLE;
}

#[cfg(feature = "f64")]
impl NumberFormat for f64 {
    const FORMAT: Format = Format::Float { digits: 53, exponents: 1023 };
}

#[cfg(feature = "micromath")]
impl NumberFormat for micromath::F32 {
    const FORMAT: Format = Format::SINGLE;
}

#[cfg(feature = "fixed")]
impl<Frac> NumberFormat for fixed::FixedI32<Frac>
where
    Frac: fixed::types::extra::LeEqU32
        + fixed::types::extra::IsLessOrEqual<fixed::types::extra::U30, Output = fixed::types::extra::True>
        + Send
        + Sync
        + 'static,
{
    const FORMAT: Format = Format::Fixed { fraction_bits: Frac::U32 };
}

impl Format {
    #[cfg(any(feature = "f32", feature = "micromath"))]
    const SINGLE: Self = Self::Float { digits: 24, exponents: 127 };

    /// The largest number; in floating point the largest whose third power, a volume or a moment of inertia, is one.
    pub(super) const fn largest(self) -> Magnitude {
        match self {
            // Of 30 bits, as conversions have.
            Self::Fixed { fraction_bits } => Magnitude::new(i32::MAX as u32 - 1, (fraction_bits as i32).wrapping_neg()),
            Self::Float { exponents, .. } => Magnitude::power_of_two((exponents as i32 / 3).wrapping_sub(1)),
        }
    }

    /// The spacing of numbers of that size, at most.
    pub(super) const fn spacing(self, near: Magnitude) -> Magnitude {
        match self {
            Self::Fixed { fraction_bits } => Magnitude::power_of_two((fraction_bits as i32).wrapping_neg()),
            Self::Float { digits, .. } => near.times(Magnitude::power_of_two(1i32.wrapping_sub(digits as i32))),
        }
    }

    /// The smallest number of which `units` units of the last place are no more than the whole.
    pub(super) const fn finest(self, units: u32) -> Magnitude {
        match self {
            Self::Fixed { .. } => Magnitude::new(units, 0).times(self.spacing(Magnitude::ONE)),
            Self::Float { exponents, .. } => Magnitude::power_of_two(1i32.wrapping_sub(exponents as i32 / 3)),
        }
    }

    /// By how much the length of a sub-step is rounded, at most.
    pub(super) const fn clock_rounding(self, h: Magnitude) -> Magnitude {
        match self {
            Self::Fixed { .. } => Magnitude::power_of_two(-32),
            Self::Float { digits, .. } => h.times(Magnitude::power_of_two((digits as i32).wrapping_neg())),
        }
    }
}
