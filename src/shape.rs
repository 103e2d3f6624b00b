//! Shapes: what a body looks like to others. Geometry knows neither velocities nor masses.
//!
//! Each shape is a type, and each pair of shapes a function of its own, found at compile time through [`Collide`]: what a
//! firmware does not use is not in it. Where bodies of one world have different shapes, [`shapes!`](crate::shapes) makes one
//! type of those that it names.

use crate::aabb::Aabb;
use crate::manifold::Manifold;
use crate::math::{Pose, UnitVec3, Vec3, max};
use crate::query::{Ray, RayHit, SurfacePoint};
use crate::scalar::Scalar;

mod capsule;
mod compound;
mod convex_hull;
mod cuboid;
mod half_space;
mod height_field;
mod outline;
mod set;
mod sphere;

pub use self::capsule::Capsule;
pub use self::compound::{Compound, Part};
pub use self::convex_hull::{ConvexHull, MAX_CORNERS, MAX_FACE_CORNERS};
pub use self::cuboid::Cuboid;
pub use self::half_space::HalfSpace;
pub use self::height_field::HeightField;
pub(crate) use self::height_field::Triangle;
pub use self::outline::OutlineSink;
pub use self::sphere::Sphere;

/// A shape in a frame of its own.
pub trait Shape<S: Scalar>: Copy {
    /// The box along the world's axes around the shape in that pose.
    fn aabb(&self, pose: &Pose<S>) -> Aabb<S>;

    /// The radius of a ball that fits into the shape: the size that tolerances are relative to. [`Scalar::LARGEST`] for what
    /// has no other side.
    fn inner_radius(&self) -> S;

    /// The radius of a ball around the origin of the frame that holds the shape, or somewhat more: what is farther away is not
    /// looked at. [`Scalar::LARGEST`] for what has no end.
    #[inline(always)]
    fn outer_radius(&self) -> S {
        S::LARGEST
    }

    /// Where a ray meets the shape first.
    fn cast_ray(&self, pose: &Pose<S>, ray: &Ray<S>) -> Option<RayHit<S>>;

    /// The point of the surface that is closest to that point of the world. `None` of a height field, beside it.
    fn closest_point(&self, pose: &Pose<S>, point: Vec3<S>) -> Option<SurfacePoint<S>>;

    /// Tells what the shape looks like in that pose, to be drawn. Nothing, unless the shape says otherwise.
    fn outline<K: OutlineSink<S>>(&self, pose: &Pose<S>, sink: &mut K) {
        let _ = (pose, sink);
    }
}

/// A shape that is not a set of shapes: what sets made by [`shapes!`](crate::shapes) meet besides their own kind.
pub trait Member: Copy {}

/// Where two shapes touch, or are about to. Implemented for every pair of shapes, in both orders, with the same result
/// mirrored.
///
/// Sizes and distances may go up to an eighth of the format's range (in floating point: of the range of its squares).
pub trait Collide<S: Scalar, B>: Shape<S> {
    /// Hands over a [`Manifold`] for each part of the surfaces that is nearer than `margin` (0 or more), or overlaps. A pair of
    /// convex shapes makes one at most.
    ///
    /// The normals suit a solver. Where polytopes are apart, corner to corner or corner to edge, the normal is that of the
    /// axis which separates them best, and the separation along it at most the distance: [`closest`](Self::closest) has that.
    fn collide<K: ManifoldSink<S>>(&self, pose: &Pose<S>, other: &B, other_pose: &Pose<S>, margin: S, sink: &mut K);

    /// The distance and its direction, exactly up to rounding; of shapes that overlap the least translation that parts them.
    /// `None` of shapes that never meet, such as two half-spaces.
    fn closest(&self, pose: &Pose<S>, other: &B, other_pose: &Pose<S>) -> Option<Closest<S>>;

    /// Whether the shapes have a point in common.
    #[inline]
    fn overlaps(&self, pose: &Pose<S>, other: &B, other_pose: &Pose<S>) -> bool {
        self.closest(pose, other, other_pose).is_some_and(|closest| closest.separation <= S::ZERO)
    }
}

/// The points of two shapes that are closest to each other, or, where they overlap, deepest in the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closest<S: Scalar> {
    /// From A to B.
    pub normal: UnitVec3<S>,
    /// The distance; negative where the shapes overlap.
    pub separation: S,
    /// From the origin of A's pose to the point of A, in the world's frame.
    pub r_a: Vec3<S>,
    /// From the origin of B's pose to the point of B, in the world's frame.
    pub r_b: Vec3<S>,
}

impl<S: Scalar> Closest<S> {
    /// The same with the shapes in the other order.
    #[inline]
    #[must_use]
    pub fn swapped(&self) -> Self {
        Self { normal: -self.normal, separation: self.separation, r_a: self.r_b, r_b: self.r_a }
    }
}

/// What takes the manifolds of a pair of shapes: a world's table of contacts. A [`Manifold`] itself keeps the last one, which
/// is enough for a pair of convex shapes.
pub trait ManifoldSink<S: Scalar> {
    /// Where the next manifold is to be made. What is there does not matter.
    fn place(&mut self) -> &mut Manifold<S>;

    /// There is a manifold in that place, with one point at least, between those parts of the two shapes. `part` is zero for a
    /// pair of convex shapes; otherwise it tells the parts apart, and is the same in the next step for the same ones.
    fn take(&mut self, part: u32);
}

impl<S: Scalar> ManifoldSink<S> for Manifold<S> {
    #[inline(always)]
    fn place(&mut self) -> &mut Self {
        self
    }

    #[inline(always)]
    fn take(&mut self, _: u32) {}
}

/// A dimension that a shape can have.
fn is_positive<S: Scalar>(dimension: S) -> bool {
    dimension.is_finite() && dimension > S::ZERO
}

/// An upper bound of the length of a vector whose components are not negative, at most 23 % above it: the mean of the sum of the
/// components and of that plus the largest, without a root.
#[inline(always)]
fn at_most<S: Scalar>(v: Vec3<S>) -> S {
    let largest = max(max(v.x, v.y), v.z);
    v.x.lowered_by(1)
        .plus(v.y.lowered_by(1))
        .plus(v.z.lowered_by(1))
        .plus(largest.lowered_by(1))
        .plus(S::STEP)
        .plus(S::STEP)
}
