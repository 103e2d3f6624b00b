//! Why a scene does not fit, and what would.

use core::error::Error;
use core::fmt::{Display, Formatter, Result};

use super::check::{Demand, Misfit, Property};
use super::magnitude::Magnitude;
use super::quantity::Quantity;
use super::system::Units;

/// A property of a scene that a number format does not hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnitsError {
    /// Which.
    pub property: Property,
    /// On which side of the limit it is.
    pub misfit: Misfit,
    /// The units in which it is.
    pub units: Units,
    /// Units in which everything fits, if there are any.
    pub remedy: Option<Units>,
    value: Magnitude,
    limit: Magnitude,
}

impl UnitsError {
    pub(super) const fn new(demand: Demand, units: &Units, remedy: Option<Units>) -> Self {
        let Demand { property, misfit, value, limit, .. } = demand;
        Self { property, misfit, units: *units, remedy, value, limit }
    }

    /// The property in its units: three digits and a power of ten.
    pub const fn value(&self) -> (u16, i32) {
        self.value.decimal()
    }

    /// The largest value that fits, or the smallest.
    pub const fn limit(&self) -> (u16, i32) {
        self.limit.decimal()
    }

    /// What to change where no units do.
    const fn advice(&self) -> &'static str {
        match (self.property, self.misfit) {
            (Property::Distance | Property::Size, _) => {
                "the largest distance is too many times the smallest size: take a smaller scene, larger bodies or more digits"
            }
            (Property::LightestMass | Property::HeaviestMass | Property::Impulse, _) => {
                "the masses, with the highest speed, are too far apart: bring them closer, or take more digits"
            }
            (Property::Speed | Property::Spin, _) => {
                "too fast for bodies as small beside distances as large: take lower speeds, larger bodies or more digits"
            }
            (Property::Gravity | Property::Fall | Property::Drop, _) => {
                "gravity is too weak for so short a step: take a longer one, fewer sub-steps, lower speeds or more digits"
            }
            (Property::SubStep, Misfit::TooLarge) => "the step is too long",
            (Property::SubStep, Misfit::TooSmall) => "the step is too short: take longer ones, or fewer sub-steps",
            (Property::Clock, _) => "the clock would be a step off: take another length of step, or a shorter time",
            (Property::PushOutSpeed, _) => "the format has too few integer bits",
        }
    }
}

impl Display for UnitsError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{}: {}", self.property.name(), Decimal(self.value))?;
        match self.misfit {
            Misfit::TooLarge => write!(f, " is more than the {} that fit", Decimal(self.limit))?,
            Misfit::TooSmall => write!(f, " is less than the {} that it takes", Decimal(self.limit))?,
        }
        write!(f, " (units: {})", self.units)?;
        match &self.remedy {
            Some(units) => write!(f, "; take units of {units}"),
            None => write!(f, "; {}", self.advice()),
        }
    }
}

impl Error for UnitsError {}

impl Property {
    const fn name(self) -> &'static str {
        match self {
            Self::Distance => "largest distance",
            Self::Size => "smallest size",
            Self::LightestMass => "mass of the lightest body",
            Self::HeaviestMass => "mass of the heaviest body",
            Self::Speed => "highest speed",
            Self::Spin => "spin (highest speed by smallest size)",
            Self::Impulse => "impulse (twice the highest speed by the largest mass)",
            Self::Gravity => "gravity",
            Self::Fall => "gravity times sub-step",
            Self::Drop => "gravity times the square of the sub-step",
            Self::SubStep => "sub-step",
            Self::Clock => "drift of the clock over the duration",
            Self::PushOutSpeed => "push-out speed",
        }
    }
}

/// Three digits and a power of ten.
struct Decimal(Magnitude);

impl Display for Decimal {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let (digits, exponent) = self.0.decimal();
        let digits = u32::from(digits);
        let places = exponent + 2;
        write!(f, "{}.{:02}", digits / 100, digits % 100)?;
        if places == 0 { Ok(()) } else { write!(f, "e{places}") }
    }
}

impl Display for Units {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{} m, {} kg, {} s", self.length, self.mass, self.time)
    }
}

impl Display for Quantity {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{}", self.numerator)?;
        if self.exponent != 0 {
            write!(f, "e{}", self.exponent)?;
        }
        if self.denominator == 1 { Ok(()) } else { write!(f, "/{}", self.denominator) }
    }
}
