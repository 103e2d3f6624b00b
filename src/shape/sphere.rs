//! The ball.

use crate::aabb::Aabb;
use crate::error::{ShapeError, SolidError};
use crate::mass::Solid;
use crate::math::{Pose, Vec3};
use crate::query::{self, Ray, RayHit, SurfacePoint};
use crate::scalar::Scalar;
use crate::shape::{OutlineSink, Shape, is_positive};

/// A ball around the origin of its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<S> {
    radius: S,
}

impl<S: Scalar> Sphere<S> {
    /// A point, for the library's own questions.
    pub(crate) const POINT: Self = Self { radius: S::ZERO };

    /// A ball of that radius, m.
    ///
    /// # Errors
    /// [`ShapeError::Radius`] where it is not positive and finite.
    pub fn new(radius: S) -> Result<Self, ShapeError> {
        if is_positive(radius) { Ok(Self { radius }) } else { Err(ShapeError::Radius) }
    }

    /// The radius, m.
    #[inline(always)]
    pub const fn radius(&self) -> S {
        self.radius
    }

    /// The same, for its mass.
    ///
    /// # Errors
    /// [`SolidError`] where a float cannot hold the moments of inertia.
    pub fn solid(&self) -> Result<Solid<S>, SolidError> {
        Solid::sphere(self.radius)
    }
}

impl<S: Scalar> Shape<S> for Sphere<S> {
    #[inline]
    fn aabb(&self, pose: &Pose<S>) -> Aabb<S> {
        Aabb::around(pose.position, Vec3::new(self.radius, self.radius, self.radius))
    }

    #[inline(always)]
    fn inner_radius(&self) -> S {
        self.radius
    }

    #[inline(always)]
    fn outer_radius(&self) -> S {
        self.radius
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
        sink.rod([pose.position; 2], self.radius);
    }
}
