//! Where two shapes touch, or are about to: a normal and up to four points.

use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;

/// Which features of two shapes make a contact point: the same number in the next step means the same point, so that its
/// impulse can be carried over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(transparent)]
pub struct FeatureId(pub u16);

/// One point of a [`Manifold`], halfway between the two surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
#[derive(Clone, Copy, Debug)]
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
    #[inline(always)]
    pub fn points(&self) -> &[ManifoldPoint<S>] {
        self.points.get(..usize::from(self.len)).unwrap_or(&[])
    }

    /// Without points.
    #[inline(always)]
    pub const fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Takes the points away.
    #[inline(always)]
    pub const fn clear(&mut self) {
        self.len = 0;
    }

    /// Adds a point; a fifth one is left out, and `false` returned.
    #[inline]
    pub fn push(&mut self, point: ManifoldPoint<S>) -> bool {
        let Some(free) = self.points.get_mut(usize::from(self.len)) else { return false };
        *free = point;
        self.len = self.len.wrapping_add(1);
        true
    }

    /// With the shapes in the other order.
    #[inline]
    pub fn swap(&mut self) {
        self.normal = UnitVec3::from_unit(S::opposite(&self.normal.get()));
        for point in self.points_mut() {
            core::mem::swap(&mut point.r_a, &mut point.r_b);
        }
    }

    /// Moves the origins of the arms: for shapes that sit on bodies, from whose origins those of the shapes are that far, in
    /// the world's axes.
    #[inline]
    pub fn move_origins(&mut self, [a, b]: [Vec3<S>; 2]) {
        for point in self.points_mut() {
            (point.r_a, point.r_b) = (point.r_a + a, point.r_b + b);
        }
    }

    #[inline(always)]
    pub(crate) fn points_mut(&mut self) -> &mut [ManifoldPoint<S>] {
        self.points.get_mut(..usize::from(self.len)).unwrap_or_default()
    }

    /// Begins anew, with another normal.
    #[inline(always)]
    pub(crate) fn begin(&mut self, normal: Vec3<S::Unit>) {
        self.normal = UnitVec3::from_unit(normal);
        self.len = 0;
    }
}

impl<S: Scalar> PartialEq for Manifold<S> {
    fn eq(&self, other: &Self) -> bool {
        self.normal == other.normal && self.points() == other.points()
    }
}
