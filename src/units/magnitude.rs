//! Positive numbers of any size, in constants: 32 bits and an exponent, cut off.

/// `mantissa * 2^exponent` with the mantissa's top bit set, or zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Magnitude {
    mantissa: u32,
    exponent: i32,
}

/// Exponents beyond it are as good as infinite: far enough that sums of two of them stay in range.
const FAR: i32 = 1 << 24;

impl Magnitude {
    pub const ZERO: Self = Self { mantissa: 0, exponent: 0 };
    pub const ONE: Self = Self::power_of_two(0);

    /// `n * 2^exponent`.
    pub const fn new(n: u32, exponent: i32) -> Self {
        if n == 0 {
            return Self::ZERO;
        }
        let zeros = n.leading_zeros();
        Self { mantissa: n.wrapping_shl(zeros), exponent: exponent.wrapping_sub(zeros as i32) }.limited()
    }

    pub const fn power_of_two(exponent: i32) -> Self {
        Self { mantissa: 1 << 31, exponent: exponent.wrapping_sub(31) }.limited()
    }

    /// `self * 10^exponent`.
    pub const fn times_power_of_ten(self, exponent: i8) -> Self {
        let (mut power, mut left) = (Self::ONE, exponent.unsigned_abs());
        while left > 0 {
            power = power.times(Self::new(10, 0));
            left = left.wrapping_sub(1);
        }
        if exponent < 0 { self.over(power) } else { self.times(power) }
    }

    pub const fn times(self, other: Self) -> Self {
        let product = (self.mantissa as u64).wrapping_mul(other.mantissa as u64);
        if product == 0 {
            return Self::ZERO;
        }
        let up = product.leading_zeros();
        let mantissa = (product.wrapping_shl(up) >> 32) as u32;
        Self { mantissa, exponent: self.exponent.wrapping_add(other.exponent).wrapping_add(32).wrapping_sub(up as i32) }
            .limited()
    }

    /// The quotient; by zero as good as infinite.
    pub const fn over(self, other: Self) -> Self {
        if self.mantissa == 0 {
            return Self::ZERO;
        }
        match ((self.mantissa as u64) << 32).checked_div(other.mantissa as u64) {
            // Between 2^31 and 2^33.
            Some(quotient) => {
                let down = 32u32.wrapping_sub(quotient.leading_zeros());
                let exponent = self.exponent.wrapping_sub(other.exponent).wrapping_sub(32).wrapping_add(down as i32);
                Self { mantissa: quotient.wrapping_shr(down) as u32, exponent }.limited()
            }
            None => Self::power_of_two(FAR),
        }
    }

    const fn limited(self) -> Self {
        if self.exponent > FAR {
            Self { mantissa: self.mantissa, exponent: FAR }
        } else if self.exponent < -FAR {
            Self { mantissa: self.mantissa, exponent: -FAR }
        } else {
            self
        }
    }

    pub const fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    pub const fn is_below(self, other: Self) -> bool {
        if self.mantissa == 0 || other.mantissa == 0 {
            return self.mantissa == 0 && other.mantissa != 0;
        }
        self.exponent < other.exponent || (self.exponent == other.exponent && self.mantissa < other.mantissa)
    }

    pub const fn max(self, other: Self) -> Self {
        if self.is_below(other) { other } else { self }
    }

    pub const fn min(self, other: Self) -> Self {
        if self.is_below(other) { self } else { other }
    }

    /// The power of two that is not above the number; of zero the lowest of all.
    pub const fn binary_order(self) -> i32 {
        if self.mantissa == 0 { -FAR } else { self.exponent.wrapping_add(31) }
    }

    /// Three digits and a power of ten: `d * 10^e` with d in 100 to 999, cut off; zero as 0.
    pub const fn decimal(self) -> (u16, i32) {
        let (mut x, mut exponent) = (self, 0i32);
        let (low, high, ten) = (Self::new(100, 0), Self::new(1000, 0), Self::new(10, 0));
        // What is as good as infinite would take for ever.
        while !x.is_below(high) && exponent < 999 {
            x = x.over(ten);
            exponent = exponent.wrapping_add(1);
        }
        while x.is_below(low) && !x.is_zero() && exponent > -999 {
            x = x.times(ten);
            exponent = exponent.wrapping_sub(1);
        }
        let down = x.exponent.wrapping_neg();
        (if 0 < down && down < 32 { x.mantissa.wrapping_shr(down as u32) as u16 } else { 0 }, exponent)
    }
}
