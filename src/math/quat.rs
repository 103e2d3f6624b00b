//! The unit quaternion: an orientation.

use core::ops::Mul;

use super::unit_vec3::is_near_one;
use super::{Mat3, Vec3};
use crate::error::OrientationError;
use crate::scalar::{Scalar, Scaled, StepArithmetic};

/// A rotation from the body's frame to the world's, as a quaternion of unit length with components in the format
/// [`Scalar::Unit`] (Q2.30 in fixed point).
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Quat<S: Scalar> {
    w: S::Unit,
    x: S::Unit,
    y: S::Unit,
    z: S::Unit,
}

impl<S: Scalar> Quat<S> {
    /// No rotation.
    pub const IDENTITY: Self = Self { w: S::Unit::ONE, x: S::Unit::ZERO, y: S::Unit::ZERO, z: S::Unit::ZERO };

    /// A rotation from components w (scalar part), x, y, z whose squares add up to one within 2^-16.
    ///
    /// # Errors
    /// [`OrientationError`]: not finite, zero, or not of unit length.
    pub fn new(w: S::Unit, x: S::Unit, y: S::Unit, z: S::Unit) -> Result<Self, OrientationError> {
        let q = Self { w, x, y, z };
        q.check()?;
        if is_near_one(q.square()) { Ok(q) } else { Err(OrientationError::NotUnit) }
    }

    /// The rotation of a quaternion of any length but zero; within 3 units of the last place of [`Scalar::Unit`]
    /// (`micromath::F32`: 1.6e-6 more, from its root).
    ///
    /// # Errors
    /// [`OrientationError`]: not finite, or zero.
    pub fn normalize(w: S::Unit, x: S::Unit, y: S::Unit, z: S::Unit) -> Result<Self, OrientationError> {
        let q = Self { w, x, y, z };
        q.check()?;
        let q = q.reduced();
        Ok(q.divided(q.square().sqrt()))
    }

    /// The same direction, with a square that neither leaves 64 bits nor the range of a float.
    fn reduced(self) -> Self {
        let [w, x, y, z] = self.to_array().map(|c| c.to_scaled().max(-c.to_scaled()));
        let largest = w.max(x).max(y).max(z);
        let ordinary = S::Scaled::from_parts(1, -30) <= largest && largest <= S::Scaled::ONE;
        if ordinary { self } else { self.divided(largest) }
    }

    fn divided(self, divisor: S::Scaled) -> Self {
        let [w, x, y, z] = self.to_array().map(|c| S::Unit::from_scaled(c.to_scaled() / divisor).0);
        Self { w, x, y, z }
    }

    #[inline(always)]
    pub(crate) fn is_finite(self) -> bool {
        self.w.is_finite() && self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }

    fn check(self) -> Result<(), OrientationError> {
        if !self.is_finite() {
            return Err(OrientationError::NotFinite);
        }
        if self.to_array() == [S::Unit::ZERO; 4] {
            return Err(OrientationError::Zero);
        }
        Ok(())
    }

    fn square(self) -> S::Scaled {
        let vector = [self.x, self.y, self.z];
        let zero = S::Unit::ZERO;
        S::Unit::scaled_dot3([self.w, zero, zero], [self.w, zero, zero]) + S::Unit::scaled_dot3(vector, vector)
    }

    /// The components w, x, y, z.
    #[inline(always)]
    pub const fn to_array(self) -> [S::Unit; 4] {
        [self.w, self.x, self.y, self.z]
    }

    /// The inverse rotation.
    #[inline(always)]
    #[must_use]
    pub fn conjugate(self) -> Self {
        Self { w: self.w, x: self.x.negated(), y: self.y.negated(), z: self.z.negated() }
    }

    /// The rotation matrix, within 2 units of the last place of [`Scalar::Unit`] a component.
    #[must_use]
    pub fn to_mat3(self) -> Mat3<S::Unit> {
        let Self { w, x, y, z } = self;
        Mat3 {
            rows: [
                Vec3::new(diagonal(y, z), twice_difference(x, y, w, z), twice_sum(x, z, w, y)),
                Vec3::new(twice_sum(x, y, w, z), diagonal(x, z), twice_difference(y, z, w, x)),
                Vec3::new(twice_difference(x, z, w, y), twice_sum(y, z, w, x), diagonal(x, y)),
            ],
        }
    }

    /// The orientation after a rotation about the world's axis along `u` by twice its length, in radians.
    #[inline(always)]
    #[must_use]
    pub(crate) fn turned(self, u: Vec3<S::Unit>) -> Self {
        let [w, x, y, z] = S::Step::turned(self.to_array(), u);
        Self { w, x, y, z }
    }

    /// A vector of the body's frame in the world's frame.
    ///
    /// Each component is within 1.5 (p + u |v|), for the spacing p of numbers of the size of |v| and the spacing u of
    /// [`Scalar::Unit`] just above one: 2^-30 in fixed point. In fixed point a component beyond the format takes the end
    /// of its range.
    #[must_use]
    pub fn rotate(self, v: Vec3<S>) -> Vec3<S> {
        let [x, y, z] = self.to_mat3().rows;
        let v = v.to_array();
        Vec3::new(S::dot3_unit(v, x.to_array()), S::dot3_unit(v, y.to_array()), S::dot3_unit(v, z.to_array()))
    }
}

/// `1 - 2 (a^2 + b^2)`, with the doubling as two subtractions: twice a unit does not fit the format.
#[inline(always)]
fn diagonal<U: Scalar>(a: U, b: U) -> U {
    let square = U::dot3([a, b, U::ZERO], [a, b, U::ZERO]);
    U::ONE.minus(square).minus(square)
}

/// `2 (a b + c d)`
#[inline(always)]
fn twice_sum<U: Scalar>(a: U, b: U, c: U, d: U) -> U {
    let sum = U::dot3([a, c, U::ZERO], [b, d, U::ZERO]);
    sum.plus(sum)
}

/// `2 (a b - c d)`
#[inline(always)]
fn twice_difference<U: Scalar>(a: U, b: U, c: U, d: U) -> U {
    let difference = U::det2(a, c, d, b);
    difference.plus(difference)
}

impl<S: Scalar> Mul for Quat<S> {
    type Output = Self;

    /// The rotation `other` followed by the rotation `self`, within 2 units of the last place.
    fn mul(self, other: Self) -> Self {
        let [a, b, c, d] = self.to_array();
        let [e, f, g, h] = other.to_array();
        let vector = [b, c, d];
        Self {
            w: a.times(e).minus(S::Unit::dot3(vector, [f, g, h])),
            x: S::Unit::dot3([a, b, c], [f, e, h]).minus(d.times(g)),
            y: S::Unit::dot3([a, c, d], [g, e, f]).minus(b.times(h)),
            z: S::Unit::dot3([a, d, b], [h, e, g]).minus(c.times(f)),
        }
    }
}
