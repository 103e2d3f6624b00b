//! The fixed-point kernel's intermediate number: 30 bits that carry their own power of two.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use fixed::types::I2F30;

use super::Scaled;
use super::integer::{quotient, round_shift, round_sqrt};

/// A number `mantissa * 2^(exponent - 30)` whose mantissa has 30 bits (2^29 <= |mantissa| < 2^30), or zero.
///
/// What lies between reading a body and writing it back (effective masses, approach speeds, impulses) spans more orders
/// of magnitude than any 32-bit fixed format holds. In this form it neither saturates nor loses digits: sum, product,
/// quotient and square root are correctly rounded to 30 bits (ties away from zero), a relative error of at most 2^-30.
/// The exponent is far from its ends in every use of the library: each step adds at most a few exponents of the inputs,
/// which are within +-64.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct Scaled32 {
    mantissa: i32,
    exponent: i32,
}

/// Bits of a mantissa.
const BITS: u32 = 30;
/// Exponents stay within `-LIMIT..=LIMIT`, so that adding two of them cannot overflow.
const LIMIT: i32 = 1 << 28;

impl Scaled32 {
    /// `x * 2^exponent`, rounded to 30 bits. |x| < 2^63 - 2^32.
    #[inline(always)]
    pub(crate) const fn new(x: i64, exponent: i32) -> Self {
        if x == 0 {
            return Self { mantissa: 0, exponent: 0 };
        }
        let width = 64u32.wrapping_sub(x.unsigned_abs().leading_zeros());
        let (mantissa, shift) = if width > BITS {
            let shift = width.wrapping_sub(BITS);
            (round_shift(x, shift) as i32, shift as i32)
        } else {
            let shift = BITS.wrapping_sub(width);
            ((x as i32).wrapping_shl(shift), (shift as i32).wrapping_neg())
        };
        let exponent = exponent.wrapping_add(shift).wrapping_add(BITS as i32);
        // Rounding can carry into bit 30; the mantissa is then a power of two and halves exactly.
        let carry = (mantissa.unsigned_abs() >> BITS) as i32;
        Self { mantissa: mantissa.wrapping_shr(carry as u32), exponent: exponent.wrapping_add(carry) }.limited()
    }

    #[inline(always)]
    const fn limited(self) -> Self {
        if self.exponent > LIMIT {
            Self { mantissa: self.mantissa, exponent: LIMIT }
        } else if self.exponent < -LIMIT {
            Self { mantissa: 0, exponent: 0 }
        } else {
            self
        }
    }

    /// The mantissa: zero, or 30 bits with a sign.
    #[inline(always)]
    pub const fn mantissa(self) -> i32 {
        self.mantissa
    }

    /// The exponent: the value is `mantissa * 2^(exponent - 30)`.
    #[inline(always)]
    pub const fn exponent(self) -> i32 {
        self.exponent
    }

    /// `value * 2^frac` rounded to an integer: the bits in a format with `frac` fraction bits, not yet clipped.
    /// Magnitudes beyond 2^61 come back as about 2^61.
    #[inline(always)]
    pub(crate) const fn to_bits(self, frac: i32) -> i64 {
        shift_product(self.mantissa as i64, 30i32.wrapping_sub(self.exponent).wrapping_sub(frac))
    }
}

/// `x / 2^down` rounded, for |x| <= 2^61 and any `down`; magnitudes beyond 2^61 come back as 2^61 with the sign of `x`.
#[inline(always)]
pub(crate) const fn shift_product(x: i64, down: i32) -> i64 {
    if down > 0 {
        if down > 61 { 0 } else { round_shift(x, down as u32) }
    } else {
        let up = down.unsigned_abs();
        let zeros = x.unsigned_abs().leading_zeros();
        if x == 0 {
            0
        } else if up.wrapping_add(2) >= zeros {
            if x < 0 { -(1 << 61) } else { 1 << 61 }
        } else {
            x.wrapping_shl(up)
        }
    }
}

impl Add for Scaled32 {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        if self.mantissa == 0 {
            return other;
        }
        if other.mantissa == 0 {
            return self;
        }
        let (high, low) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let gap = high.exponent.wrapping_sub(low.exponent).unsigned_abs();
        if gap > 31 {
            return high;
        }
        // 31 places to the left leave room to move the smaller one right by up to 31 without loss.
        let sum = ((high.mantissa as i64) << 31).wrapping_add(((low.mantissa as i64) << 31).wrapping_shr(gap));
        Self::new(sum, high.exponent.wrapping_sub(61))
    }
}

impl Sub for Scaled32 {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Scaled32 {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self { mantissa: self.mantissa.wrapping_neg(), exponent: self.exponent }
    }
}

impl Mul for Scaled32 {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let product = (self.mantissa as i64).wrapping_mul(other.mantissa as i64);
        Self::new(product, self.exponent.wrapping_add(other.exponent).wrapping_sub(60))
    }
}

impl Div for Scaled32 {
    type Output = Self;

    /// The quotient; by zero it is the largest value with the sign of the dividend, and 0/0 is zero.
    #[inline]
    fn div(self, other: Self) -> Self {
        if self.mantissa == 0 {
            return self;
        }
        let negative = (self.mantissa ^ other.mantissa) < 0;
        let (n, d) = (self.mantissa.unsigned_abs(), other.mantissa.unsigned_abs());
        if d == 0 {
            return Self { mantissa: if negative { -MAX_MANTISSA } else { MAX_MANTISSA }, exponent: LIMIT };
        }
        // The quotient of the mantissas lies in (1/2, 2): choose the scale that leaves it 30 bits.
        let up = if n < d { 30 } else { 29 };
        let q = quotient(n, d, up) as i64;
        let exponent = self.exponent.wrapping_sub(other.exponent).wrapping_sub(up as i32);
        Self::new(if negative { q.wrapping_neg() } else { q }, exponent)
    }
}

const MAX_MANTISSA: i32 = (1 << 30) - 1;

impl PartialOrd for Scaled32 {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        // Normalised mantissas order by sign, then exponent, then mantissa.
        let (a, b) = (self.mantissa, other.mantissa);
        if a.signum() != b.signum() {
            return Some(a.cmp(&b));
        }
        let exponents = if a < 0 { other.exponent.cmp(&self.exponent) } else { self.exponent.cmp(&other.exponent) };
        Some(if a == 0 { Ordering::Equal } else { exponents.then(a.cmp(&b)) })
    }
}

impl Scaled for Scaled32 {
    type Unit = I2F30;
    type Exponent = i32;

    const ZERO: Self = Self { mantissa: 0, exponent: 0 };
    const ONE: Self = Self { mantissa: 1 << 29, exponent: 1 };
    /// 843314857 / 2^28.
    const PI: Self = Self { mantissa: 843_314_857, exponent: 2 };
    const EPSILON: Self = Self { mantissa: 1 << 29, exponent: -28 };

    #[inline]
    fn from_parts(mantissa: i32, exponent: i32) -> Self {
        // Far beyond any format, and so far from the limit that no impulse leads there.
        Self::new(mantissa as i64, exponent.clamp(-(LIMIT >> 8), LIMIT >> 8))
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        self.exponent < LIMIT
    }

    #[inline]
    fn sqrt(self) -> Self {
        if self.mantissa <= 0 {
            return Self::ZERO;
        }
        // An even power of two comes out of the root; 30 or 31 more places give it 30 bits.
        let places = 30i32.wrapping_add(self.exponent & 1);
        let root = round_sqrt((self.mantissa as u64).wrapping_shl(places as u32));
        Self::new(root as i64, self.exponent.wrapping_sub(places).wrapping_sub(30) >> 1)
    }

    #[inline(always)]
    fn raised(self, exponent: i32) -> Self {
        if self.mantissa == 0 {
            return self;
        }
        Self { mantissa: self.mantissa, exponent: self.exponent.wrapping_add(exponent) }.limited()
    }

    #[inline]
    fn align3(v: [Self; 3]) -> ([I2F30; 3], i32) {
        let exponent_of = |x: Self| if x.mantissa == 0 { -LIMIT } else { x.exponent };
        // One place of headroom: components within 1/2.
        let exponent = exponent_of(v[0]).max(exponent_of(v[1])).max(exponent_of(v[2])).wrapping_add(1);
        let align = |x: Self| {
            let down = exponent.wrapping_sub(x.exponent);
            I2F30::from_bits(shift_product(x.mantissa as i64, down) as i32)
        };
        ([align(v[0]), align(v[1]), align(v[2])], exponent.max(-LIMIT))
    }
}
