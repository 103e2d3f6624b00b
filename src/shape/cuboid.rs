//! The box.

use crate::aabb::Aabb;
use crate::error::{ShapeError, SolidError};
use crate::mass::Solid;
use crate::math::{Pose, Vec3, min};
use crate::query::{self, Ray, RayHit, SurfacePoint};
use crate::scalar::Scalar;
use crate::shape::{OutlineSink, Shape, at_most, is_positive};

/// The corners of each face, counter-clockwise seen from outside: a bit of the number is the side along an axis.
const RINGS: [[u8; 4]; 6] = [[1, 3, 7, 5], [0, 4, 6, 2], [2, 6, 7, 3], [0, 1, 5, 4], [4, 5, 7, 6], [0, 2, 3, 1]];

/// A box around the origin of its frame, its edges along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid<S> {
    half_extents: Vec3<S>,
}

impl<S: Scalar> Cuboid<S> {
    /// A box with those halves of its edges, m.
    ///
    /// # Errors
    /// [`ShapeError::HalfExtent`] where one is not positive and finite.
    pub fn new(half_extents: Vec3<S>) -> Result<Self, ShapeError> {
        let Vec3 { x, y, z } = half_extents;
        let good = is_positive(x) && is_positive(y) && is_positive(z);
        if good { Ok(Self { half_extents }) } else { Err(ShapeError::HalfExtent) }
    }

    /// Half of each edge, m.
    #[inline(always)]
    pub const fn half_extents(&self) -> Vec3<S> {
        self.half_extents
    }

    /// The same, for its mass.
    ///
    /// # Errors
    /// [`SolidError`] where a float cannot hold the moments of inertia.
    pub fn solid(&self) -> Result<Solid<S>, SolidError> {
        Solid::cuboid(self.half_extents)
    }
}

impl<S: Scalar> Shape<S> for Cuboid<S> {
    #[inline]
    fn aabb(&self, pose: &Pose<S>) -> Aabb<S> {
        Aabb::of_box(pose.position, self.half_extents, &pose.rotation)
    }

    #[inline(always)]
    fn inner_radius(&self) -> S {
        let Vec3 { x, y, z } = self.half_extents;
        min(min(x, y), z)
    }

    #[inline(always)]
    fn outer_radius(&self) -> S {
        at_most(self.half_extents)
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
        let Vec3 { x, y, z } = self.half_extents;
        let [along_x, along_y, along_z] = pose.rotation.columns();
        let [x, y, z] = [Vec3::of_length(x, along_x), Vec3::of_length(y, along_y), Vec3::of_length(z, along_z)];
        for ring in RINGS {
            sink.face(&ring.map(|corner| {
                let side = |bit: u8, half: Vec3<S>| if corner & bit == 0 { -half } else { half };
                pose.position + side(1, x) + side(2, y) + side(4, z)
            }));
        }
    }
}
