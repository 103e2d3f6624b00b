//! The 3-vector.

use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use super::abs;
use crate::scalar::Scalar;

/// A vector of three components, in metres, m/s, rad/s or whatever the caller's units are.
///
/// In fixed point every operation takes the end of the range where a component leaves it, and [`dot`](Self::dot),
/// [`cross`](Self::cross) and [`length`](Self::length) round once, from an exact 64-bit sum.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct Vec3<S> {
    /// Along the first axis.
    pub x: S,
    /// Along the second axis.
    pub y: S,
    /// Along the third axis.
    pub z: S,
}

impl<S> Vec3<S> {
    /// A vector from its components.
    #[inline(always)]
    pub const fn new(x: S, y: S, z: S) -> Self {
        Self { x, y, z }
    }
}

impl<S: Copy> Vec3<S> {
    /// The components in the order x, y, z.
    #[inline(always)]
    pub const fn to_array(self) -> [S; 3] {
        [self.x, self.y, self.z]
    }

    /// A vector from its components in the order x, y, z.
    #[inline(always)]
    pub const fn from_array(v: [S; 3]) -> Self {
        Self { x: v[0], y: v[1], z: v[2] }
    }
}

impl<S: Scalar> Vec3<S> {
    /// The zero vector.
    pub const ZERO: Self = Self::new(S::ZERO, S::ZERO, S::ZERO);

    /// The inner product.
    #[inline(always)]
    #[must_use]
    pub fn dot(self, other: Self) -> S {
        S::dot3(self.to_array(), other.to_array())
    }

    /// The cross product `self x other`.
    #[inline(always)]
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            S::det2(self.y, self.z, other.y, other.z),
            S::det2(self.z, self.x, other.z, other.x),
            S::det2(self.x, self.y, other.x, other.y),
        )
    }

    /// The length: in fixed point exact until it is rounded, once.
    ///
    /// In floating point the squares must stay in its range: f32 keeps all digits of lengths from 1.1e-19 to 1.8e19, f64
    /// from 1.5e-154 to 1.3e154. Farther out the length loses digits, and is in the end zero or infinite.
    #[inline(always)]
    #[must_use]
    pub fn length(self) -> S {
        S::length3(self.to_array())
    }

    /// No component is an infinity or NaN; always true in fixed point.
    #[inline(always)]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl<S: Scalar> Vec3<S> {
    /// The component along a direction.
    #[inline(always)]
    #[must_use]
    pub(crate) fn along(self, d: Vec3<S::Unit>) -> S {
        S::dot3_unit(self.to_array(), d.to_array())
    }

    /// The vector times a matrix of those rows.
    #[inline(always)]
    #[must_use]
    pub(crate) fn through(self, [x, y, z]: [Vec3<S::Unit>; 3]) -> Self {
        Self::new(self.along(x), self.along(y), self.along(z))
    }

    /// The vector of that length along a direction; negative, the other way. Rounded once a component.
    #[inline(always)]
    #[must_use]
    pub(crate) fn of_length(length: S, d: Vec3<S::Unit>) -> Self {
        Self::new(length.times_unit(d.x), length.times_unit(d.y), length.times_unit(d.z))
    }

    /// |x| + |y| + |z|: no less than the length.
    #[inline(always)]
    #[must_use]
    pub(crate) fn taxicab(self) -> S {
        let Self { x, y, z } = self.magnitudes();
        x.plus(y).plus(z)
    }

    /// Half the vector, in fixed point rounded.
    #[inline(always)]
    #[must_use]
    pub(crate) fn halved(self) -> Self {
        Self::new(self.x.lowered_by(1), self.y.lowered_by(1), self.z.lowered_by(1))
    }

    /// The magnitudes of the components.
    #[inline(always)]
    #[must_use]
    pub(crate) fn magnitudes(self) -> Self {
        Self::new(abs(self.x), abs(self.y), abs(self.z))
    }
}

impl<S: Copy> Vec3<S> {
    /// With the second axis first: a rotation of the frame that keeps its handedness.
    #[inline(always)]
    pub(crate) const fn cycled(self) -> Self {
        Self { x: self.y, y: self.z, z: self.x }
    }
}

impl<S: Scalar> Add for Vec3<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x.plus(other.x), self.y.plus(other.y), self.z.plus(other.z))
    }
}

impl<S: Scalar> Sub for Vec3<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x.minus(other.x), self.y.minus(other.y), self.z.minus(other.z))
    }
}

impl<S: Scalar> Neg for Vec3<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(self.x.negated(), self.y.negated(), self.z.negated())
    }
}

impl<S: Scalar> Mul<S> for Vec3<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: S) -> Self {
        Self::new(self.x.times(factor), self.y.times(factor), self.z.times(factor))
    }
}

impl<S: Scalar> AddAssign for Vec3<S> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<S: Scalar> SubAssign for Vec3<S> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}
