//! Numbers m 2^e with an integer m of any length: sums and products of the bits of floats and fixed-point numbers, exact.

use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

/// `mantissa * 2^exponent`, exactly.
#[derive(Clone, Debug)]
pub struct Exact {
    mantissa: BigInt,
    exponent: i64,
}

impl Exact {
    pub fn new(mantissa: i64, exponent: i64) -> Self {
        Self { mantissa: BigInt::from(mantissa), exponent }
    }

    pub fn zero() -> Self {
        Self::new(0, 0)
    }

    pub fn one() -> Self {
        Self::new(1, 0)
    }

    /// The value of a finite float.
    pub fn from_f64(x: f64) -> Self {
        assert!(x.is_finite());
        let bits = x.to_bits();
        let exponent = (bits >> 52 & 0x7ff) as i64;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let (mantissa, exponent) =
            if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) };
        if mantissa == 0 {
            return Self::zero();
        }
        let zeros = mantissa.trailing_zeros();
        let mantissa = mantissa >> zeros;
        Self::new(if x < 0.0 { -mantissa } else { mantissa }, exponent + i64::from(zeros))
    }

    /// The value as a float, within a unit of its last place.
    pub fn to_f64(&self) -> f64 {
        let length = self.mantissa.bits() as i64;
        let drop = (length - 64).max(0);
        let top = (self.mantissa.magnitude() >> drop).to_u64().unwrap_or(0) as f64;
        // In steps that stay in the range while the result does.
        let mut value = if self.is_negative() { -top } else { top };
        let mut exponent = self.exponent + drop;
        while exponent != 0 && value != 0.0 && value.is_finite() {
            let step = exponent.clamp(-900, 900);
            value *= 2f64.powi(step as i32);
            exponent -= step;
        }
        value
    }

    /// `self / other` as a float.
    pub fn ratio(&self, other: &Self) -> f64 {
        // Both to 64 leading bits first, so that neither leaves the range of the float.
        let lead = |x: &Self| {
            let drop = x.mantissa.bits() as i64 - 64;
            let exact = Self { mantissa: x.mantissa.clone(), exponent: -drop };
            (exact.to_f64(), x.exponent + drop)
        };
        if self.is_zero() && !other.is_zero() {
            return 0.0;
        }
        let ((n, up), (d, down)) = (lead(self), lead(other));
        let shift = (up - down).clamp(-4000, 4000);
        let mut value = n / d;
        let mut left = shift;
        while left != 0 && value != 0.0 && value.is_finite() {
            let step = left.clamp(-900, 900);
            value *= 2f64.powi(step as i32);
            left -= step;
        }
        value
    }

    /// `self / other` as a float, rounded once (but for the last of 64 bits and more).
    pub fn quotient(&self, other: &Self) -> f64 {
        let up = 70 + other.mantissa.bits() as i64 - self.mantissa.bits() as i64;
        let numerator = if up >= 0 { &self.mantissa << up } else { &self.mantissa >> -up };
        let mantissa = numerator / &other.mantissa;
        Self { mantissa, exponent: self.exponent - other.exponent - up }.to_f64()
    }

    /// The value in the arithmetic of another author, to check this one.
    pub fn to_rational(&self) -> BigRational {
        let power = BigRational::from_integer(BigInt::from(1) << self.exponent.unsigned_abs());
        let mantissa = BigRational::from_integer(self.mantissa.clone());
        if self.exponent < 0 { mantissa / power } else { mantissa * power }
    }

    pub fn is_negative(&self) -> bool {
        self.mantissa.sign() == Sign::Minus
    }

    pub fn is_positive(&self) -> bool {
        self.mantissa.sign() == Sign::Plus
    }

    pub fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    pub fn square(&self) -> Self {
        self * self
    }

    /// `self * 2^places`.
    pub fn shifted(&self, places: i64) -> Self {
        Self { mantissa: self.mantissa.clone(), exponent: self.exponent + places }
    }

    fn sum(&self, other: &Self, negative: bool) -> Self {
        if other.is_zero() {
            return self.clone();
        }
        if self.is_zero() {
            return if negative { -other } else { other.clone() };
        }
        let exponent = self.exponent.min(other.exponent);
        let a = &self.mantissa << (self.exponent - exponent);
        let b = &other.mantissa << (other.exponent - exponent);
        Self { mantissa: if negative { a - b } else { a + b }, exponent }
    }
}

impl PartialEq for Exact {
    fn eq(&self, other: &Self) -> bool {
        (self - other).is_zero()
    }
}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some((self - other).mantissa.sign().cmp(&Sign::NoSign))
    }
}

impl Neg for &Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact { mantissa: -&self.mantissa, exponent: self.exponent }
    }
}

impl Neg for Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        -&self
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $a:ident, $b:ident, $body:expr) => {
        impl $trait<&Exact> for &Exact {
            type Output = Exact;
            fn $method(self, other: &Exact) -> Exact {
                let ($a, $b) = (self, other);
                $body
            }
        }
        impl $trait<Exact> for Exact {
            type Output = Exact;
            fn $method(self, other: Exact) -> Exact {
                $trait::$method(&self, &other)
            }
        }
        impl $trait<&Exact> for Exact {
            type Output = Exact;
            fn $method(self, other: &Exact) -> Exact {
                $trait::$method(&self, other)
            }
        }
        impl $trait<Exact> for &Exact {
            type Output = Exact;
            fn $method(self, other: Exact) -> Exact {
                $trait::$method(self, &other)
            }
        }
    };
}

operator!(Add, add, a, b, a.sum(b, false));
operator!(Sub, sub, a, b, a.sum(b, true));
operator!(Mul, mul, a, b, Exact { mantissa: &a.mantissa * &b.mantissa, exponent: a.exponent + b.exponent });

/// Three exact components.
#[derive(Clone, Debug, PartialEq)]
pub struct Vector(pub [Exact; 3]);

impl Vector {
    pub fn zero() -> Self {
        Self([Exact::zero(), Exact::zero(), Exact::zero()])
    }

    pub fn dot(&self, other: &Self) -> Exact {
        let [a, b, c] = &self.0;
        let [x, y, z] = &other.0;
        a * x + b * y + c * z
    }

    pub fn cross(&self, other: &Self) -> Self {
        let [a, b, c] = &self.0;
        let [x, y, z] = &other.0;
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    pub fn times(&self, factor: &Exact) -> Self {
        Self(std::array::from_fn(|i| &self.0[i] * factor))
    }

    pub fn to_f64(&self) -> [f64; 3] {
        std::array::from_fn(|i| self.0[i].to_f64())
    }

    /// The length as a float; fit for a scale or a bound.
    pub fn length(&self) -> f64 {
        let [x, y, z] = self.to_f64();
        let largest = x.abs().max(y.abs()).max(z.abs());
        if largest == 0.0 {
            0.0
        } else {
            largest * ((x / largest).powi(2) + (y / largest).powi(2) + (z / largest).powi(2)).sqrt()
        }
    }
}

impl Add for &Vector {
    type Output = Vector;
    fn add(self, other: &Vector) -> Vector {
        Vector(std::array::from_fn(|i| &self.0[i] + &other.0[i]))
    }
}

impl Sub for &Vector {
    type Output = Vector;
    fn sub(self, other: &Vector) -> Vector {
        Vector(std::array::from_fn(|i| &self.0[i] - &other.0[i]))
    }
}

impl Neg for &Vector {
    type Output = Vector;
    fn neg(self) -> Vector {
        Vector(std::array::from_fn(|i| -&self.0[i]))
    }
}

/// A symmetric tensor: xx, xy, xz, yy, yz, zz.
#[derive(Clone, Debug)]
pub struct Tensor(pub [Exact; 6]);

impl Tensor {
    pub fn rows(&self) -> [Vector; 3] {
        let [xx, xy, xz, yy, yz, zz] = self.0.clone();
        [Vector([xx, xy.clone(), xz.clone()]), Vector([xy, yy, yz.clone()]), Vector([xz, yz, zz])]
    }

    pub fn times(&self, v: &Vector) -> Vector {
        let [x, y, z] = self.rows();
        Vector([x.dot(v), y.dot(v), z.dot(v)])
    }

    pub fn trace(&self) -> Exact {
        &self.0[0] + &self.0[3] + &self.0[5]
    }

    pub fn is_zero(&self) -> bool {
        self.0.iter().all(Exact::is_zero)
    }
}

/// x with M x = y, as a numerator and the common denominator det M, by Cramer's rule. M by rows.
pub fn cramer(m: &[Vector; 3], y: &Vector) -> (Vector, Exact) {
    let [a, b, c] = m;
    // Cofactors: the inverse is [b x c, c x a, a x b] by columns, over a . (b x c).
    let (bc, ca, ab) = (b.cross(c), c.cross(a), a.cross(b));
    let x = &(&bc.times(&y.0[0]) + &ca.times(&y.0[1])) + &ab.times(&y.0[2]);
    (x, a.dot(&bc))
}
