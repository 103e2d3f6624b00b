//! A measured quantity in integers, and what it measures.

use super::magnitude::Magnitude;

/// A quantity in SI units, as a ratio of integers and a power of ten: no float, so that fixed-only firmware can have it, and
/// constants can compute with it.
///
/// ```
/// use carom::units::Quantity;
/// let radius = Quantity::milli(8);           // 8 mm
/// let mass = Quantity::milli(5);             // 5 g: kilograms are the unit
/// let step = Quantity::ratio(1, 60);         // 1/60 s
/// let gravity = Quantity::new(981, -2);      // 9.81 m/s^2
/// assert!(radius != mass && step != gravity);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    pub(super) numerator: i32,
    pub(super) denominator: u32,
    pub(super) exponent: i8,
}

impl Quantity {
    /// One.
    pub const ONE: Self = Self::new(1, 0);

    /// `n * 10^exponent`.
    pub const fn new(n: i32, exponent: i8) -> Self {
        Self { numerator: n, denominator: 1, exponent }
    }

    /// `n`.
    pub const fn whole(n: i32) -> Self {
        Self::new(n, 0)
    }

    /// `n` hundredths.
    pub const fn centi(n: i32) -> Self {
        Self::new(n, -2)
    }

    /// `n` thousandths.
    pub const fn milli(n: i32) -> Self {
        Self::new(n, -3)
    }

    /// `n` millionths.
    pub const fn micro(n: i32) -> Self {
        Self::new(n, -6)
    }

    /// `n` thousands.
    pub const fn kilo(n: i32) -> Self {
        Self::new(n, 3)
    }

    /// `numerator / denominator`. By zero it is beyond every format.
    pub const fn ratio(numerator: i32, denominator: u32) -> Self {
        Self { numerator, denominator, exponent: 0 }
    }

    /// Without its sign.
    pub(super) const fn magnitude(&self) -> Magnitude {
        let (n, d) = (Magnitude::new(self.numerator.unsigned_abs(), 0), Magnitude::new(self.denominator, 0));
        n.over(d).times_power_of_ten(self.exponent)
    }
}

/// What a quantity measures: powers of length, mass and time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    /// The power of length.
    pub length: i8,
    /// The power of mass.
    pub mass: i8,
    /// The power of time.
    pub time: i8,
}

impl Dimension {
    /// m
    pub const LENGTH: Self = Self::new(1, 0, 0);
    /// kg
    pub const MASS: Self = Self::new(0, 1, 0);
    /// s
    pub const TIME: Self = Self::new(0, 0, 1);
    /// m/s
    pub const SPEED: Self = Self::new(1, 0, -1);
    /// m/s^2
    pub const ACCELERATION: Self = Self::new(1, 0, -2);
    /// rad/s; decay rates, too
    pub const SPIN: Self = Self::new(0, 0, -1);
    /// kg m/s
    pub const IMPULSE: Self = Self::new(1, 1, -1);
    /// kg m/s^2
    pub const FORCE: Self = Self::new(1, 1, -2);
    /// kg/m^3
    pub const DENSITY: Self = Self::new(-3, 1, 0);
    /// kg m^2
    pub const INERTIA: Self = Self::new(2, 1, 0);

    /// Any other.
    pub const fn new(length: i8, mass: i8, time: i8) -> Self {
        Self { length, mass, time }
    }
}
