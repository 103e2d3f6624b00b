//! The half-space: all that lies behind a plane.

use crate::aabb::Aabb;
use crate::math::{Pose, UnitVec3, Vec3};
use crate::query::{self, Ray, RayHit, SurfacePoint};
use crate::scalar::Scalar;
use crate::shape::{OutlineSink, Shape};

/// Everything behind the plane through the origin of its frame: the ground, a wall. It belongs on an immovable body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace<S: Scalar> {
    normal: UnitVec3<S>,
}

impl<S: Scalar> HalfSpace<S> {
    /// What lies behind a plane with that normal, which points out of it: [`UnitVec3::Z`] for ground where z is up.
    pub const fn new(normal: UnitVec3<S>) -> Self {
        Self { normal }
    }

    /// The direction out of it, in its own frame.
    #[inline(always)]
    pub const fn normal(&self) -> UnitVec3<S> {
        self.normal
    }
}

impl<S: Scalar> Shape<S> for HalfSpace<S> {
    #[inline]
    fn aabb(&self, _: &Pose<S>) -> Aabb<S> {
        Aabb::unbounded()
    }

    #[inline(always)]
    fn inner_radius(&self) -> S {
        S::LARGEST
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
        sink.plane(pose.position, pose.rotate_direction(self.normal));
    }
}
