//! Questions to a single shape: what a ray meets first, and which point of the surface is closest.

use crate::math::{Pose, UnitVec3, Vec3};
use crate::scalar::{Scalar, Scaled};
use crate::shape::{Collide, Sphere};

mod capsule;
mod convex_hull;
mod cuboid;
mod half_space;
mod height_field;
mod sphere;

/// A straight way in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<S: Scalar> {
    /// Where it begins, m.
    pub origin: Vec3<S>,
    /// Where it goes.
    pub direction: UnitVec3<S>,
    /// How far it goes, m.
    pub length: S,
}

/// Where a ray meets a shape first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit<S: Scalar> {
    /// From the ray's origin, m; zero where that lies in the shape.
    pub distance: S,
    /// Out of the shape; against the ray where that begins in the shape.
    pub normal: UnitVec3<S>,
}

/// The point of a surface that is closest to a given one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint<S: Scalar> {
    /// In the world, m.
    pub point: Vec3<S>,
    /// Out of the shape.
    pub normal: UnitVec3<S>,
    /// From the surface to the given point, m; negative where that lies in the shape.
    pub separation: S,
}

/// A ray in the frame of a shape.
#[derive(Clone, Copy)]
pub(crate) struct LocalRay<S: Scalar> {
    pub origin: Vec3<S>,
    pub direction: Vec3<S::Unit>,
    pub length: S,
}

impl<S: Scalar> LocalRay<S> {
    #[inline(always)]
    fn at(&self, distance: S) -> Vec3<S> {
        self.origin + Vec3::of_length(distance, self.direction)
    }

    /// A hit, with the normal in the shape's frame, if it is within the ray's length.
    #[inline(always)]
    fn hit(&self, distance: S, normal: Vec3<S::Unit>) -> Option<LocalHit<S>> {
        if distance <= self.length { Some(LocalHit { distance, normal }) } else { None }
    }

    /// For a ray that begins in the shape.
    #[inline(always)]
    fn inside(&self) -> Option<LocalHit<S>> {
        self.hit(S::ZERO, S::opposite(&self.direction))
    }
}

/// A hit in the frame of a shape.
#[derive(Clone, Copy)]
pub(crate) struct LocalHit<S: Scalar> {
    pub distance: S,
    pub normal: Vec3<S::Unit>,
}

/// A shape that answers rays in its own frame.
pub(crate) trait CastLocal<S: Scalar> {
    fn cast(&self, ray: &LocalRay<S>) -> Option<LocalHit<S>>;
}

/// What a ray meets of a shape in that pose.
#[inline]
pub(crate) fn cast<S: Scalar>(shape: &impl CastLocal<S>, pose: &Pose<S>, ray: &Ray<S>) -> Option<RayHit<S>> {
    let local = LocalRay {
        origin: pose.to_local(ray.origin),
        direction: pose.rotation.transposed().times(ray.direction.get()),
        length: ray.length,
    };
    let LocalHit { distance, normal } = shape.cast(&local)?;
    Some(RayHit { distance, normal: pose.rotate_direction(UnitVec3::from_unit(normal)) })
}

/// The point of a shape in that pose that is closest to a point: a sphere without radius.
#[inline]
pub(crate) fn closest_point<S: Scalar, T>(shape: &T, pose: &Pose<S>, point: Vec3<S>) -> Option<SurfacePoint<S>>
where
    Sphere<S>: Collide<S, T>,
{
    let closest = Sphere::POINT.closest(&Pose::at(point), shape, pose)?;
    Some(SurfacePoint { point: pose.position + closest.r_b, normal: -closest.normal, separation: closest.separation })
}

/// Where a ray enters a ball, or a circle in the plane: `way` leads from its centre to the ray's origin, `across` is what of
/// it is across the ray, and `along` what is along it. Half the chord is the root of (r - |across|)(r + |across|).
fn entry<S: Scalar>(radius: S, across: Vec3<S>, along: S) -> Option<S> {
    let across = across.length();
    if across > radius || along > S::ZERO {
        return None;
    }
    let square = radius.minus(across).to_scaled() * radius.plus(across).to_scaled();
    let (half, _) = S::from_scaled(square.sqrt());
    Some(along.negated().minus(half))
}
