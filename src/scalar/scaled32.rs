//! The fixed-point kernel's intermediate number: 30 bits that carry their own power of two.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use fixed::types::I2F30;

use super::Scaled;
use super::integer::{high_product, leading_zeros, leading_zeros64, long_quotient, quotient, round_shift, round_sqrt};
use super::machine::filled;

/// A number `mantissa * 2^(exponent - 30)` whose mantissa has 30 bits (2^29 <= |mantissa| < 2^30), or zero.
///
/// What lies between reading a body and writing it back (effective masses, approach speeds, impulses) spans more orders
/// of magnitude than any 32-bit fixed format holds. In this form it neither saturates nor loses digits: sum, product,
/// quotient and square root are correctly rounded to 30 bits (ties away from zero), a relative error of at most 2^-30.
/// The exponent is far from its ends in every use of the library: each step adds at most a few exponents of the inputs,
/// which are within +-64.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Scaled32 {
    mantissa: i32,
    exponent: i32,
}

/// Bits of a mantissa.
const BITS: u32 = 30;
/// Exponents stay within `-LIMIT..=LIMIT`, so that adding two of them cannot overflow.
const LIMIT: i32 = 1 << 28;

impl Default for Scaled32 {
    fn default() -> Self {
        <Self as Scaled>::ZERO
    }
}

impl Scaled32 {
    /// The exponent of zero: below all others, so that zero never counts where exponents are compared.
    pub(super) const LOWEST: i32 = -LIMIT;

    pub(super) const ZERO: Self = <Self as Scaled>::ZERO;

    /// `x factor / 2^30 / d` for a factor in `[2^30, 2^31]` and `d >= 0`, to 2^-28; zero for `d = 0`.
    #[inline(always)]
    pub(super) fn quotient_of_product(x: Self, factor: u32, d: Self) -> Self {
        let sign = x.mantissa >> 31;
        let n = high_product(((x.mantissa ^ sign).wrapping_sub(sign) as u32) << 2, factor);
        if n == 0 || d.mantissa == 0 {
            return Self::ZERO;
        }
        let q = Self::leading_quotient((n, x.exponent), (d.mantissa as u32, d.exponent));
        Self { mantissa: (q.mantissa ^ sign).wrapping_sub(sign), exponent: q.exponent }
    }

    /// `x / d` for `d > 0`, to 2^-28.
    #[inline(always)]
    pub(super) fn near_quotient(x: Self, d: Self) -> Self {
        if x.mantissa == 0 {
            return x;
        }
        let sign = x.mantissa >> 31;
        let q = Self::leading_quotient((x.mantissa.unsigned_abs(), x.exponent), (d.mantissa as u32, d.exponent));
        Self { mantissa: (q.mantissa ^ sign).wrapping_sub(sign), exponent: q.exponent }
    }

    /// The quotient of two numbers above zero with exponents, `m 2^(e - 30)` each, to 2^-28.
    #[inline(always)]
    pub(super) fn leading_quotient((n, n_exponent): (u32, i32), (d, d_exponent): (u32, i32)) -> Self {
        let ((n, n_zeros), (d, d_zeros)) = (filled(n), filled(d));
        let (q, places) = filled(long_quotient(n, d));
        let mantissa = (q >> 2) as i32;
        let shift = 2i32.wrapping_sub(n_zeros as i32).wrapping_add(d_zeros as i32).wrapping_sub(places as i32);
        Self { mantissa, exponent: n_exponent.wrapping_sub(d_exponent).wrapping_add(shift) }
    }

    /// `x * 2^exponent`, rounded to 30 bits.
    #[inline(never)]
    pub(crate) fn new(x: i64, exponent: i32) -> Self {
        Self::rounded(x, exponent)
    }

    /// The same inside the caller.
    #[inline(always)]
    pub(super) fn rounded(x: i64, exponent: i32) -> Self {
        let (top, exponent, sign) = Self::leading(x, exponent);
        // Two places less, rounded; a carry into bit 30 leaves a power of two, which halves exactly.
        let rounded = (top >> 2).wrapping_add((top >> 1) & 1);
        let carry = rounded >> BITS;
        let mantissa = (rounded >> carry) as i32;
        Self { mantissa: (mantissa ^ sign).wrapping_sub(sign), exponent: exponent.wrapping_add(carry as i32) }
    }

    /// The leading 32 bits of |x|, the exponent of `x * 2^exponent`, and the sign, 0 or -1.
    #[inline(always)]
    fn leading(x: i64, exponent: i32) -> (u32, i32, i32) {
        let sign = (x >> 63) as i32;
        let magnitude = x.unsigned_abs();
        let (mut high, mut low, mut exponent) = ((magnitude >> 32) as u32, magnitude as u32, exponent.wrapping_add(64));
        if high == 0 {
            (high, low, exponent) = (low, 0, exponent.wrapping_sub(32));
            if high == 0 {
                return (0, Self::LOWEST, 0);
            }
        }
        let zeros = leading_zeros(high | 1);
        let top = high.wrapping_shl(zeros) | (low >> 1).wrapping_shr(31 ^ zeros);
        (top, exponent.wrapping_sub(zeros as i32), sign)
    }

    /// `x * 2^exponent`, cut off towards zero to 30 bits.
    #[inline(always)]
    pub(super) fn cut(x: i64, exponent: i32) -> Self {
        let (top, exponent, sign) = Self::leading(x, exponent);
        Self { mantissa: ((top >> 2) as i32 ^ sign).wrapping_sub(sign), exponent }
    }

    /// `x * 2^(exponent - 32)`, cut off to 30 bits.
    #[inline(always)]
    pub(super) fn cut32(x: u32, exponent: i32) -> Self {
        if x == 0 {
            return Self::ZERO;
        }
        let zeros = leading_zeros(x | 1);
        Self { mantissa: (x.wrapping_shl(zeros) >> 2) as i32, exponent: exponent.wrapping_sub(zeros as i32) }
    }

    #[inline(always)]
    const fn limited(self) -> Self {
        if self.exponent > LIMIT {
            Self { mantissa: self.mantissa, exponent: LIMIT }
        } else if self.exponent < -LIMIT {
            Self::ZERO
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
}

/// `x / 0`: the largest value with the sign of `x`, or zero.
#[cold]
#[inline(never)]
const fn quotient_by_zero(x: Scaled32) -> Scaled32 {
    match x.mantissa {
        0 => Scaled32::ZERO,
        1.. => Scaled32 { mantissa: MAX_MANTISSA, exponent: LIMIT },
        _ => Scaled32 { mantissa: -MAX_MANTISSA, exponent: LIMIT },
    }
}

/// `x / 2^down` rounded, for |x| <= 2^61 and any `down`; magnitudes beyond 2^61 come back as 2^61 with the sign of `x`.
#[inline(always)]
pub(crate) fn shift_product(x: i64, down: i32) -> i64 {
    if down > 0 {
        if down > 61 { 0 } else { round_shift(x, down as u32) }
    } else {
        let up = down.unsigned_abs();
        let zeros = leading_zeros64(x.unsigned_abs());
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

    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let (high, low) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        // Zero, too, with the lowest exponent of all.
        let gap = high.exponent.wrapping_sub(low.exponent) as u32;
        if gap > 31 {
            return high;
        }
        let kept = high.mantissa.wrapping_add(low.mantissa.wrapping_shr(gap));
        let rest = ((low.mantissa as u32) << 1).wrapping_shl(31 ^ gap);
        Self::rounded((kept as i64) << 32 | rest as i64, high.exponent.wrapping_sub(62))
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

    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let sign = (self.mantissa ^ other.mantissa) >> 31;
        // 31 or 32 bits, the bit that rounds among them.
        let product = high_product(self.mantissa.unsigned_abs() << 2, other.mantissa.unsigned_abs() << 2);
        if product == 0 {
            return Self::ZERO;
        }
        // What rounding carries into the 32nd belongs there.
        let rounded = product.wrapping_add(1);
        let (mantissa, exponent) =
            if rounded >> 31 == 0 { ((rounded >> 1) as i32, -1) } else { ((rounded.wrapping_add(1) >> 2) as i32, 0) };
        let exponent = self.exponent.wrapping_add(other.exponent).wrapping_add(exponent);
        Self { mantissa: (mantissa ^ sign).wrapping_sub(sign), exponent }.limited()
    }
}

impl Div for Scaled32 {
    type Output = Self;

    /// The quotient; by zero it is the largest value with the sign of the dividend, and 0/0 is zero.
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        if self.mantissa == 0 || other.mantissa == 0 {
            return quotient_by_zero(self);
        }
        let sign = (self.mantissa ^ other.mantissa) >> 31;
        let (n, d) = (self.mantissa.unsigned_abs(), other.mantissa.unsigned_abs());
        // The quotient of the mantissas lies in (1/2, 2): choose the scale that leaves it 30 bits.
        let up = if n < d { 30 } else { 29 };
        let q = quotient(n, d, up);
        // Rounded up to a power of two, it halves exactly.
        let carry = q >> BITS;
        let mantissa = (q >> carry) as i32;
        let exponent = self.exponent.wrapping_sub(other.exponent).wrapping_add((BITS.wrapping_sub(up)) as i32);
        Self { mantissa: (mantissa ^ sign).wrapping_sub(sign), exponent: exponent.wrapping_add(carry as i32) }
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

    const ZERO: Self = Self { mantissa: 0, exponent: Self::LOWEST };
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

    #[inline(always)]
    fn is_positive(self) -> bool {
        self.mantissa > 0
    }

    #[inline]
    fn sqrt(self) -> Self {
        if self.mantissa <= 0 {
            return Self::ZERO;
        }
        // An even power of two comes out of the root; 29 or 30 more places give it 30 bits.
        let places = 30i32.wrapping_sub(self.exponent & 1);
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
    fn lowered(self, exponent: i32) -> I2F30 {
        I2F30::from_bits(shift_product(self.mantissa as i64, exponent.wrapping_sub(self.exponent)) as i32)
    }

    #[inline]
    fn integer_below(self) -> i32 {
        // At least 2^30.
        if self.exponent > 30 {
            return self.mantissa.signum() << 30;
        }
        self.mantissa >> 30i32.wrapping_sub(self.exponent).min(31) as u32
    }

    #[inline]
    fn align3(v: [Self; 3]) -> ([I2F30; 3], i32) {
        let exponent_of = |x: Self| if x.mantissa == 0 { -LIMIT } else { x.exponent };
        // One place of headroom: components within 1/2.
        let exponent = exponent_of(v[0]).max(exponent_of(v[1])).max(exponent_of(v[2])).wrapping_add(1);
        ([v[0].lowered(exponent), v[1].lowered(exponent), v[2].lowered(exponent)], exponent.max(-LIMIT))
    }
}
