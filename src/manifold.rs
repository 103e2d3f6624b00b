//! Where two shapes touch, or are about to: a normal and up to four points.

use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;

/// Which features of two shapes make a contact point: the same number in the next step means the same point, so that its
/// impulse can be carried over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(transparent)]
pub struct FeatureId(pub u16);

/// One point of a [`Manifold`], halfway between the two surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct ManifoldPoint<S: Scalar> {
    /// From the origin of A's pose to the point, in the world's frame.
    pub r_a: Vec3<S>,
    /// From the origin of B's pose to the point, in the world's frame.
    pub r_b: Vec3<S>,
    /// The gap between the surfaces along the normal: negative where they overlap.
    pub separation: S,
    /// What makes the point.
    pub feature: FeatureId,
}

/// Up to four contact points with one normal, from A to B.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Manifold<S: Scalar> {
    /// From A to B.
    pub normal: UnitVec3<S>,
    points: [ManifoldPoint<S>; 4],
    len: u8,
}

impl<S: Scalar> Manifold<S> {
    /// No points.
    pub const fn empty(normal: UnitVec3<S>) -> Self {
        let point = ManifoldPoint { r_a: Vec3::ZERO, r_b: Vec3::ZERO, separation: S::ZERO, feature: FeatureId(0) };
        Self { normal, points: [point; 4], len: 0 }
    }

    /// The points.
    pub fn points(&self) -> &[ManifoldPoint<S>] {
        self.points.get(..usize::from(self.len)).unwrap_or(&[])
    }

    /// Adds a point; a fifth one is left out, and `false` returned.
    pub fn push(&mut self, point: ManifoldPoint<S>) -> bool {
        let Some(free) = self.points.get_mut(usize::from(self.len)) else { return false };
        *free = point;
        self.len += 1;
        true
    }

    /// The manifold, if it has a point.
    #[inline(always)]
    pub(crate) fn into_option(self) -> Option<Self> {
        if self.len == 0 { None } else { Some(self) }
    }

    /// The same with those bits set in the names of its points.
    pub(crate) fn renamed(mut self, bits: u16) -> Self {
        for point in &mut self.points {
            point.feature.0 |= bits;
        }
        self
    }

    /// The same with the shapes in the other order.
    #[must_use]
    pub fn swapped(&self) -> Self {
        let mut swapped = *self;
        swapped.normal = -self.normal;
        for point in &mut swapped.points {
            core::mem::swap(&mut point.r_a, &mut point.r_b);
        }
        swapped
    }

    /// The same for shapes that sit on bodies: the arms are those of the bodies, from whose origins the poses of the shapes
    /// are that far, in the world's axes.
    #[must_use]
    pub fn seen_from(&self, [a, b]: [Vec3<S>; 2]) -> Self {
        let mut seen = *self;
        for point in &mut seen.points {
            (point.r_a, point.r_b) = (point.r_a + a, point.r_b + b);
        }
        seen
    }
}
