//! The axis-aligned bounding box.

use crate::math::{Mat3, Vec3, max, min};
use crate::scalar::Scalar;

/// A box along the world's axes that holds a shape, up to a rounding: what is near it is to be found with a margin.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct Aabb<S> {
    /// The corner with the smallest coordinates.
    pub min: Vec3<S>,
    /// The corner with the largest ones.
    pub max: Vec3<S>,
}

impl<S: Scalar> Aabb<S> {
    /// No space: overlaps nothing.
    pub const NOTHING: Self = {
        let nowhere = Vec3::new(S::LARGEST, S::LARGEST, S::LARGEST);
        Self { min: nowhere, max: Vec3::ZERO }
    };

    /// All space.
    #[inline]
    pub fn unbounded() -> Self {
        let far = Vec3::new(S::LARGEST, S::LARGEST, S::LARGEST);
        Self { min: -far, max: far }
    }

    /// The box around `centre` that goes as far as `extents` on each side.
    #[inline]
    pub fn around(centre: Vec3<S>, extents: Vec3<S>) -> Self {
        Self { min: centre - extents, max: centre + extents }
    }

    /// Around a box of those half extents, turned, with its middle in that place.
    #[inline]
    pub(crate) fn of_box(centre: Vec3<S>, half_extents: Vec3<S>, rotation: &Mat3<S::Unit>) -> Self {
        let [x, y, z] = rotation.rows;
        Self::around(centre, half_extents.through([x.magnitudes(), y.magnitudes(), z.magnitudes()]))
    }

    /// The middle, and the half extents rounded up.
    #[inline]
    pub(crate) fn middle_and_half(&self) -> [Vec3<S>; 2] {
        let (low, high) = (self.min.halved(), self.max.halved());
        let Vec3 { x, y, z } = high - low;
        [low + high, Vec3::new(x.plus(S::STEP), y.plus(S::STEP), z.plus(S::STEP))]
    }

    /// Whether it ends within the format's range on every side.
    #[inline]
    pub fn is_bounded(&self) -> bool {
        let (low, high) = (self.min, self.max);
        let (least, most) = (S::LARGEST.negated(), S::LARGEST);
        low.x > least && low.y > least && low.z > least && high.x < most && high.y < most && high.z < most
    }

    /// The box with `margin` more on every side.
    #[inline]
    #[must_use]
    pub fn expanded(&self, margin: S) -> Self {
        let margin = Vec3::new(margin, margin, margin);
        Self { min: self.min - margin, max: self.max + margin }
    }

    /// The smallest box that holds both.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        let (a, b) = (self, other);
        Self {
            min: Vec3::new(min(a.min.x, b.min.x), min(a.min.y, b.min.y), min(a.min.z, b.min.z)),
            max: Vec3::new(max(a.max.x, b.max.x), max(a.max.y, b.max.y), max(a.max.z, b.max.z)),
        }
    }

    /// Whether the boxes have a point in common; with a NaN in one of them they do.
    #[inline]
    pub fn overlaps(&self, other: &Self) -> bool {
        let apart = |a_max: S, b_min: S| a_max < b_min;
        let (a, b) = (self, other);
        !(apart(a.max.x, b.min.x)
            || apart(b.max.x, a.min.x)
            || apart(a.max.y, b.min.y)
            || apart(b.max.y, a.min.y)
            || apart(a.max.z, b.min.z)
            || apart(b.max.z, a.min.z))
    }
}
