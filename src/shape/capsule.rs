//! The capsule: a rod with round ends.

use crate::aabb::Aabb;
use crate::error::{ShapeError, SolidError};
use crate::mass::Solid;
use crate::math::{Pose, Vec3, abs};
use crate::query::{self, Ray, RayHit, SurfacePoint};
use crate::scalar::Scalar;
use crate::shape::{OutlineSink, Shape, is_positive};

/// All within a radius of a segment along the z axis of its frame, which the origin halves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule<S> {
    radius: S,
    half_length: S,
}

impl<S: Scalar> Capsule<S> {
    /// A capsule of that radius around a segment of twice that half length, m.
    ///
    /// # Errors
    /// [`ShapeError::Radius`] and [`ShapeError::HalfLength`] where they are not positive and finite.
    pub fn new(radius: S, half_length: S) -> Result<Self, ShapeError> {
        if !is_positive(radius) {
            return Err(ShapeError::Radius);
        }
        if is_positive(half_length) { Ok(Self { radius, half_length }) } else { Err(ShapeError::HalfLength) }
    }

    /// The radius, m.
    #[inline(always)]
    pub const fn radius(&self) -> S {
        self.radius
    }

    /// Half the length of the segment, without the round ends, m.
    #[inline(always)]
    pub const fn half_length(&self) -> S {
        self.half_length
    }

    /// The same, for its mass.
    ///
    /// # Errors
    /// [`SolidError`] where a float cannot hold the moments of inertia.
    pub fn solid(&self) -> Result<Solid<S>, SolidError> {
        Solid::capsule(self.radius, self.half_length)
    }
}

impl<S: Scalar> Shape<S> for Capsule<S> {
    #[inline]
    fn aabb(&self, pose: &Pose<S>) -> Aabb<S> {
        let [_, _, axis] = pose.rotation.columns();
        let reach = |d| abs(self.half_length.times_unit(d)).plus(self.radius);
        Aabb::around(pose.position, Vec3::new(reach(axis.x), reach(axis.y), reach(axis.z)))
    }

    #[inline(always)]
    fn inner_radius(&self) -> S {
        self.radius
    }

    #[inline(always)]
    fn outer_radius(&self) -> S {
        self.radius.plus(self.half_length)
    }

    #[inline]
    fn cast_ray(&self, pose: &Pose<S>, ray: &Ray<S>) -> Option<RayHit<S>> {
        query::cast(self, pose, ray)
    }

    #[inline]
    fn closest_point(&self, pose: &Pose<S>, point: Vec3<S>) -> Option<SurfacePoint<S>> {
        query::closest_point(self, pose, point)
    }

    fn outline<K: OutlineSink<S>>(&self, pose: &Pose<S>, sink: &mut K) {
        let reach = pose.rotate(Vec3::new(S::ZERO, S::ZERO, self.half_length));
        sink.rod([pose.position - reach, pose.position + reach], self.radius);
    }
}
