//! Units of length, mass and time, and quantities in them.

use super::magnitude::Magnitude;
use super::quantity::{Dimension, Quantity};
use crate::error::RangeError;
use crate::scalar::{Scalar, Scaled};

/// The units that numbers are in, each in the SI's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Units {
    /// In metres.
    pub length: Quantity,
    /// In kilograms.
    pub mass: Quantity,
    /// In seconds.
    pub time: Quantity,
}

impl Units {
    /// Metres, kilograms and seconds.
    pub const SI: Self = Self { length: Quantity::ONE, mass: Quantity::ONE, time: Quantity::ONE };

    /// A quantity in these units, rounded once to the format where its integers, with the units' powers of ten, have no
    /// more bits than a mantissa of [`Scaled`].
    ///
    /// # Errors
    /// [`RangeError`] where it is beyond the format.
    pub fn convert<S: Scalar>(&self, quantity: Quantity, dimension: Dimension) -> Result<S, RangeError> {
        let ratio = Ratio::<S>::of(quantity).over(Ratio::unit(self, dimension));
        let (x, clipped) = S::from_scaled(ratio.value());
        if clipped || !x.is_finite() { Err(RangeError) } else { Ok(x) }
    }

    /// A length, [converted](Self::convert).
    ///
    /// # Errors
    /// [`RangeError`] where it is beyond the format.
    pub fn length<S: Scalar>(&self, quantity: Quantity) -> Result<S, RangeError> {
        self.convert(quantity, Dimension::LENGTH)
    }

    /// A mass, [converted](Self::convert).
    ///
    /// # Errors
    /// [`RangeError`] where it is beyond the format.
    pub fn mass<S: Scalar>(&self, quantity: Quantity) -> Result<S, RangeError> {
        self.convert(quantity, Dimension::MASS)
    }

    /// A speed, [converted](Self::convert).
    ///
    /// # Errors
    /// [`RangeError`] where it is beyond the format.
    pub fn speed<S: Scalar>(&self, quantity: Quantity) -> Result<S, RangeError> {
        self.convert(quantity, Dimension::SPEED)
    }

    /// An angular velocity, [converted](Self::convert).
    ///
    /// # Errors
    /// [`RangeError`] where it is beyond the format.
    pub fn spin<S: Scalar>(&self, quantity: Quantity) -> Result<S, RangeError> {
        self.convert(quantity, Dimension::SPIN)
    }

    /// An acceleration, [converted](Self::convert).
    ///
    /// # Errors
    /// [`RangeError`] where it is beyond the format.
    pub fn acceleration<S: Scalar>(&self, quantity: Quantity) -> Result<S, RangeError> {
        self.convert(quantity, Dimension::ACCELERATION)
    }

    /// The length of a step as [`Settings::new`](crate::solver::Settings::new) takes it.
    ///
    /// # Errors
    /// [`RangeError`] where the reduced fraction has a part beyond 16 bits, or there is no time in it.
    pub const fn step(&self, seconds: Quantity) -> Result<[u16; 2], RangeError> {
        let (n, d) = (seconds.numerator.unsigned_abs(), seconds.denominator);
        let mut numerator = (n as u64).wrapping_mul(self.time.denominator as u64);
        let mut denominator = (d as u64).wrapping_mul(self.time.numerator.unsigned_abs() as u64);
        let mut exponent = (seconds.exponent as i32).wrapping_sub(self.time.exponent as i32);
        while exponent != 0 {
            let common = common_divisor(numerator, denominator);
            (numerator, denominator) = (divided(numerator, common), divided(denominator, common));
            if numerator >= 1 << 60 || denominator >= 1 << 60 {
                return Err(RangeError);
            }
            if exponent > 0 {
                numerator = numerator.wrapping_mul(10);
                exponent = exponent.wrapping_sub(1);
            } else {
                denominator = denominator.wrapping_mul(10);
                exponent = exponent.wrapping_add(1);
            }
        }
        let common = common_divisor(numerator, denominator);
        (numerator, denominator) = (divided(numerator, common), divided(denominator, common));
        let positive = numerator > 0 && denominator > 0;
        if positive && numerator <= u16::MAX as u64 && denominator <= u16::MAX as u64 {
            Ok([numerator as u16, denominator as u16])
        } else {
            Err(RangeError)
        }
    }

    /// The number `x` in SI units divided by `of`, as an integer, rounded to the nearest, ties away from zero; at the end
    /// of the range beyond it. How many millimetres a length is: `units.count(x, Dimension::LENGTH, Quantity::milli(1))`.
    pub fn count<S: Scalar>(&self, x: S, dimension: Dimension, of: Quantity) -> i32 {
        nearest_integer(x.to_scaled() * Ratio::<S>::unit(self, dimension).over(Ratio::of(of)).value())
    }

    /// An SI quantity of that dimension in these units.
    pub(super) const fn measured(&self, quantity: Magnitude, dimension: Dimension) -> Magnitude {
        let x = over_power(quantity, self.length.magnitude(), dimension.length);
        let x = over_power(x, self.mass.magnitude(), dimension.mass);
        over_power(x, self.time.magnitude(), dimension.time)
    }
}

/// `x / unit^power`.
const fn over_power(x: Magnitude, unit: Magnitude, power: i8) -> Magnitude {
    let (mut x, mut left) = (x, power.unsigned_abs());
    while left > 0 {
        x = if power > 0 { x.over(unit) } else { x.times(unit) };
        left = left.wrapping_sub(1);
    }
    x
}

const fn divided(n: u64, d: u64) -> u64 {
    match n.checked_div(d) {
        Some(quotient) => quotient,
        None => 0,
    }
}

const fn common_divisor(a: u64, b: u64) -> u64 {
    let (mut a, mut b) = (a, b);
    while b != 0 {
        let rest = match a.checked_rem(b) {
            Some(rest) => rest,
            None => 0,
        };
        (a, b) = (b, rest);
    }
    a
}

/// A quotient that is not yet divided, and a power of ten.
struct Ratio<S: Scalar> {
    numerator: S::Scaled,
    denominator: S::Scaled,
    exponent: i32,
}

impl<S: Scalar> Ratio<S> {
    fn of(quantity: Quantity) -> Self {
        Self {
            numerator: S::Scaled::from_parts(quantity.numerator, 0),
            denominator: unsigned::<S::Scaled>(quantity.denominator),
            exponent: i32::from(quantity.exponent),
        }
    }

    /// The unit of a dimension.
    fn unit(units: &Units, dimension: Dimension) -> Self {
        let one = || Self::of(Quantity::ONE);
        let length = one().times_power(units.length, dimension.length);
        let mass = length.times_power(units.mass, dimension.mass);
        mass.times_power(units.time, dimension.time)
    }

    fn times_power(self, unit: Quantity, power: i8) -> Self {
        let (mut x, mut left) = (self, power.unsigned_abs());
        while left > 0 {
            let unit = Self::of(unit);
            x = if power > 0 { x.over(unit.inverted()) } else { x.over(unit) };
            left = left.wrapping_sub(1);
        }
        x
    }

    fn inverted(self) -> Self {
        Self { numerator: self.denominator, denominator: self.numerator, exponent: self.exponent.wrapping_neg() }
    }

    fn over(self, other: Self) -> Self {
        Self {
            numerator: self.numerator * other.denominator,
            denominator: self.denominator * other.numerator,
            exponent: self.exponent.wrapping_sub(other.exponent),
        }
    }

    fn value(self) -> S::Scaled {
        let (mut power, mut left) = (S::Scaled::ONE, self.exponent.unsigned_abs());
        while left > 0 {
            power = power * S::Scaled::from_parts(10, 0);
            left = left.wrapping_sub(1);
        }
        if self.exponent < 0 {
            self.numerator / (self.denominator * power)
        } else {
            self.numerator * power / self.denominator
        }
    }
}

fn unsigned<T: Scaled>(n: u32) -> T {
    T::from_parts((n >> 1) as i32, 1) + T::from_parts((n & 1) as i32, 0)
}

/// Bit by bit: reports are rare, and no number type has to know it.
fn nearest_integer<T: Scaled>(x: T) -> i32 {
    let negative = x < T::ZERO;
    let x = if negative { T::ZERO - x } else { x };
    let mut left = x + T::from_parts(1, -1);
    let (mut n, mut bit) = (0i32, 30u32);
    loop {
        let power = T::from_parts(1, bit as i32);
        if left >= power {
            n |= 1i32.wrapping_shl(bit);
            left = left - power;
        }
        if bit == 0 {
            break;
        }
        bit = bit.wrapping_sub(1);
    }
    if negative { n.wrapping_neg() } else { n }
}
