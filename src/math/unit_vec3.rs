//! The direction: a vector that is known to be of unit length.

use core::ops::Neg;

use super::Vec3;
use crate::error::DirectionError;
use crate::scalar::{Scalar, Scaled};

/// A vector of unit length, its components in the format [`Scalar::Unit`] (Q2.30 in fixed point).
///
/// The length is one to within 2^-17 where the caller gave the components ([`new`](Self::new)), and to within the last
/// places where the library computed it ([`normalize`](Self::normalize)).
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct UnitVec3<S: Scalar>(Vec3<S::Unit>);

impl<S: Scalar> UnitVec3<S> {
    /// The first axis.
    pub const X: Self = Self(Vec3::new(S::Unit::ONE, S::Unit::ZERO, S::Unit::ZERO));
    /// The second axis.
    pub const Y: Self = Self(Vec3::new(S::Unit::ZERO, S::Unit::ONE, S::Unit::ZERO));
    /// The third axis.
    pub const Z: Self = Self(Vec3::new(S::Unit::ZERO, S::Unit::ZERO, S::Unit::ONE));

    /// A direction from components whose squares add up to one within 2^-16.
    ///
    /// They are taken as they are: a length off by `d` puts an impulse off by about `d` in relative terms.
    ///
    /// # Errors
    /// [`DirectionError`]: not finite, zero, or not of unit length.
    pub fn new(components: Vec3<S::Unit>) -> Result<Self, DirectionError> {
        if !components.is_finite() {
            return Err(DirectionError::NotFinite);
        }
        if components == Vec3::ZERO {
            return Err(DirectionError::Zero);
        }
        let v = components.to_array();
        let square = S::Unit::scaled_dot3(v, v);
        if is_near_one(square) { Ok(Self(components)) } else { Err(DirectionError::NotUnit) }
    }

    /// The direction of any vector that is not zero.
    ///
    /// # Errors
    /// [`DirectionError`]: not finite, or zero.
    pub fn normalize(vector: Vec3<S>) -> Result<Self, DirectionError> {
        match S::normalize3(vector.to_array()) {
            Some(unit) => Ok(Self(Vec3::from_array(unit))),
            None if vector.is_finite() => Err(DirectionError::Zero),
            None => Err(DirectionError::NotFinite),
        }
    }

    /// Of components that are known to be of unit length, such as those of a direction that was turned.
    #[inline(always)]
    pub(crate) const fn from_unit(components: Vec3<S::Unit>) -> Self {
        Self(components)
    }

    /// The components.
    #[inline(always)]
    pub const fn get(self) -> Vec3<S::Unit> {
        self.0
    }

    #[inline(always)]
    pub(crate) const fn as_vec3(&self) -> &Vec3<S::Unit> {
        &self.0
    }

    /// The vector of that length along the direction; of a negative length, the other way. In fixed point within 0.51 units
    /// of the last place a component, and at the end of the range where that is left.
    #[must_use]
    pub fn times(self, length: S) -> Vec3<S> {
        let length = length.to_scaled();
        let along = |d: S::Unit| S::from_scaled(d.to_scaled() * length).0;
        Vec3::new(along(self.0.x), along(self.0.y), along(self.0.z))
    }

    /// Two directions that form a right-handed orthonormal frame with this one as the third axis: inner products and
    /// squares of the lengths are within 4 units of the last place of [`Scalar::Unit`], and of what this direction itself
    /// lacks of unit length, from 0 and 1.
    ///
    /// Duff and others, "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017: one division, no root. The opposite
    /// direction has the same first tangent and the opposite second one, bit for bit.
    #[inline]
    pub fn tangents(self) -> (Self, Self) {
        let mirrored = self.is_mirrored();
        let Vec3 { x, y, z } = if mirrored { -self.0 } else { self.0 };
        let (a, _) = S::Unit::from_scaled(S::Scaled::ONE / (S::Scaled::ONE + z.to_scaled()));
        let one = S::Unit::ONE;
        let b = x.times(y).times(a).negated();
        let first = Self(Vec3::new(one.minus(x.times(x).times(a)), b, x.negated()));
        let second = Self(Vec3::new(b, one.minus(y.times(y).times(a)), y.negated()));
        (first, if mirrored { -second } else { second })
    }

    /// The direction or its opposite: one of the two, decided by the last component that is not zero.
    #[inline(always)]
    pub(crate) fn is_mirrored(self) -> bool {
        let Vec3 { x, y, z } = self.0;
        let zero = S::Unit::ZERO;
        z < zero || (z == zero && (y < zero || (y == zero && x < zero)))
    }
}

/// Within 2^-16 of one.
pub(super) fn is_near_one<T: Scaled>(square: T) -> bool {
    let tolerance = T::from_parts(1, -16);
    let excess = square - T::ONE;
    -tolerance <= excess && excess <= tolerance
}

impl<S: Scalar> Neg for UnitVec3<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}
