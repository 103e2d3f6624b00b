//! The narrow phase: where two shapes touch, one file for each pair.
//!
//! A file has `manifold`, the contact points for a solver, and `closest`, the distance. Everything is computed relative to
//! one of the shapes: the positions are subtracted first, so that far from the origin nothing is lost but what the positions
//! themselves lack.

use crate::manifold::{FeatureId, Manifold, ManifoldPoint};
use crate::math::{Pose, Vec3};
use crate::scalar::Scalar;
use crate::shape::{
    Capsule, Closest, Collide, Compound, ConvexHull, Cuboid, HalfSpace, HeightField, ManifoldSink, Member, Sphere,
};

mod capsule_capsule;
mod capsule_cuboid;
mod capsule_half_space;
mod capsule_hull;
mod clip;
mod compound;
mod cuboid_cuboid;
mod cuboid_half_space;
mod cuboid_hull;
mod height_field;
mod hull_half_space;
mod hull_hull;
mod point_cuboid;
mod polytope;
mod polytope_polytope;
mod rod;
mod round;
mod segment;
mod segment_cuboid;
mod sphere_capsule;
mod sphere_cuboid;
mod sphere_half_space;
mod sphere_hull;
mod sphere_sphere;

/// The pair, by the functions of one file; `mirrored` in the other order, too. The brackets hold the parameters of the types.
macro_rules! pair {
    ([$($of:tt)*] $a:ty, $b:ty: $file:ident) => {
        impl<$($of)* S: Scalar> Collide<S, $b> for $a {
            #[inline]
            fn collide<K: ManifoldSink<S>>(
                &self,
                pose: &Pose<S>,
                other: &$b,
                other_pose: &Pose<S>,
                margin: S,
                sink: &mut K,
            ) {
                let place = sink.place();
                place.clear();
                $file::manifold((self, pose), (other, other_pose), margin, place);
                if !place.is_empty() {
                    sink.take(0);
                }
            }

            #[inline]
            fn closest(&self, pose: &Pose<S>, other: &$b, other_pose: &Pose<S>) -> Option<Closest<S>> {
                Some($file::closest((self, pose), (other, other_pose)))
            }
        }
    };
    ([$($of:tt)*] $a:ty, $b:ty: $file:ident, mirrored) => {
        pair!([$($of)*] $a, $b: $file);

        impl<$($of)* S: Scalar> Collide<S, $a> for $b {
            #[inline]
            fn collide<K: ManifoldSink<S>>(
                &self,
                pose: &Pose<S>,
                other: &$a,
                other_pose: &Pose<S>,
                margin: S,
                sink: &mut K,
            ) {
                let place = sink.place();
                place.clear();
                $file::manifold((other, other_pose), (self, pose), margin, place);
                if !place.is_empty() {
                    place.swap();
                    sink.take(0);
                }
            }

            #[inline]
            fn closest(&self, pose: &Pose<S>, other: &$a, other_pose: &Pose<S>) -> Option<Closest<S>> {
                Some($file::closest((other, other_pose), (self, pose)).swapped())
            }
        }
    };
}

/// Shapes that stand still and never meet.
macro_rules! never {
    ([$($of:tt)*] $a:ty, $b:ty) => {
        impl<$($of)* S: Scalar> Collide<S, $b> for $a {
            #[inline(always)]
            fn collide<K: ManifoldSink<S>>(&self, _: &Pose<S>, _: &$b, _: &Pose<S>, _: S, _: &mut K) {}

            #[inline(always)]
            fn closest(&self, _: &Pose<S>, _: &$b, _: &Pose<S>) -> Option<Closest<S>> {
                None
            }
        }
    };
}

pair!([] Sphere<S>, Sphere<S>: sphere_sphere);
pair!([] Sphere<S>, HalfSpace<S>: sphere_half_space, mirrored);
pair!([] Sphere<S>, Cuboid<S>: sphere_cuboid, mirrored);
pair!([] Sphere<S>, Capsule<S>: sphere_capsule, mirrored);
pair!(['a, const N: usize,] Sphere<S>, &'a ConvexHull<S, N>: sphere_hull, mirrored);
pair!([] Cuboid<S>, Cuboid<S>: cuboid_cuboid);
pair!([] Cuboid<S>, HalfSpace<S>: cuboid_half_space, mirrored);
pair!(['a, const N: usize,] Cuboid<S>, &'a ConvexHull<S, N>: cuboid_hull, mirrored);
pair!([] Capsule<S>, Capsule<S>: capsule_capsule);
pair!([] Capsule<S>, HalfSpace<S>: capsule_half_space, mirrored);
pair!([] Capsule<S>, Cuboid<S>: capsule_cuboid, mirrored);
pair!(['a, const N: usize,] Capsule<S>, &'a ConvexHull<S, N>: capsule_hull, mirrored);
pair!(['a, 'b, const M: usize, const N: usize,] &'a ConvexHull<S, M>, &'b ConvexHull<S, N>: hull_hull);
pair!(['a, const N: usize,] &'a ConvexHull<S, N>, HalfSpace<S>: hull_half_space, mirrored);
never!([] HalfSpace<S>, HalfSpace<S>);
never!(['a,] HalfSpace<S>, HeightField<'a, S>);
never!(['a,] HeightField<'a, S>, HalfSpace<S>);
never!(['a, 'b,] HeightField<'a, S>, HeightField<'b, S>);

/// Any shape and a height field, in both orders.
macro_rules! over_field {
    ([$($of:tt)*] $a:ty) => {
        impl<$($of)* S: Scalar> Collide<S, HeightField<'f, S>> for $a {
            #[inline]
            fn collide<K: ManifoldSink<S>>(
                &self,
                pose: &Pose<S>,
                other: &HeightField<'f, S>,
                other_pose: &Pose<S>,
                margin: S,
                sink: &mut K,
            ) {
                height_field::collide((self, pose), (other, other_pose), margin, false, sink);
            }

            #[inline]
            fn closest(&self, pose: &Pose<S>, other: &HeightField<'f, S>, other_pose: &Pose<S>) -> Option<Closest<S>> {
                height_field::closest((self, pose), (other, other_pose))
            }
        }

        impl<$($of)* S: Scalar> Collide<S, $a> for HeightField<'f, S> {
            #[inline]
            fn collide<K: ManifoldSink<S>>(
                &self,
                pose: &Pose<S>,
                other: &$a,
                other_pose: &Pose<S>,
                margin: S,
                sink: &mut K,
            ) {
                height_field::collide((other, other_pose), (self, pose), margin, true, sink);
            }

            #[inline]
            fn closest(&self, pose: &Pose<S>, other: &$a, other_pose: &Pose<S>) -> Option<Closest<S>> {
                height_field::closest((other, other_pose), (self, pose)).map(|closest| closest.swapped())
            }
        }
    };
}

over_field!(['f,] Sphere<S>);
over_field!(['f,] Cuboid<S>);
over_field!(['f,] Capsule<S>);
over_field!(['f, 'a, const N: usize,] &'a ConvexHull<S, N>);

/// A shape that may be in a set, and a compound as the second of the two.
macro_rules! member {
    ([$($of:tt)*] $a:ty) => {
        impl<$($of)* S: Scalar> Member for $a {}

        impl<$($of)* S: Scalar, P: Collide<S, $a>> Collide<S, Compound<'_, S, P>> for $a {
            #[inline]
            fn collide<K: ManifoldSink<S>>(
                &self,
                pose: &Pose<S>,
                other: &Compound<'_, S, P>,
                other_pose: &Pose<S>,
                margin: S,
                sink: &mut K,
            ) {
                other.collide_as_b(other_pose, (self, pose), margin, sink);
            }

            #[inline]
            fn closest(&self, pose: &Pose<S>, other: &Compound<'_, S, P>, other_pose: &Pose<S>) -> Option<Closest<S>> {
                other.closest(other_pose, self, pose).map(|closest| closest.swapped())
            }
        }
    };
}

member!([] Sphere<S>);
member!([] HalfSpace<S>);
member!([] Cuboid<S>);
member!([] Capsule<S>);
member!(['a, const N: usize,] &'a ConvexHull<S, N>);
member!(['f,] HeightField<'f, S>);

/// A shape where it is.
type Placed<'a, S, T> = (&'a T, &'a Pose<S>);

/// Half-spaces, seen from a shape: the plane's normal in the world's axes, and the height of the shape's origin above it.
#[inline(always)]
fn above<S: Scalar>(pose: &Pose<S>, (plane, plane_pose): Placed<'_, S, HalfSpace<S>>) -> (Vec3<S::Unit>, S, Vec3<S>) {
    let d = plane_pose.position - pose.position;
    let normal = plane_pose.rotation.times(plane.normal().get());
    (normal, d.along(normal).negated(), d)
}

/// A point of a manifold, at `r` from A's origin, for the way `d` from A's origin to B's.
#[inline(always)]
fn point<S: Scalar>(r: Vec3<S>, d: Vec3<S>, separation: S, feature: u16) -> ManifoldPoint<S> {
    ManifoldPoint { r_a: r, r_b: r - d, separation, feature: FeatureId(feature) }
}

/// The components with that axis first: a rotation of the frame that keeps its handedness.
#[inline(always)]
fn cycled<T: Copy>(v: Vec3<T>, axis: u8) -> Vec3<T> {
    match axis {
        0 => v,
        1 => v.cycled(),
        _ => v.cycled().cycled(),
    }
}

/// The components with the first at that axis: the way back from `cycled`.
#[inline(always)]
fn uncycled<T: Copy>(v: Vec3<T>, axis: u8) -> Vec3<T> {
    match axis {
        0 => v,
        1 => v.cycled().cycled(),
        _ => v.cycled(),
    }
}

/// Which of two shapes of a kind is taken first, by the way to the other: one order for both ways to ask, so that the answers
/// mirror each other to the last bit.
///
/// The sign of x + y/4 + z/16 changes nowhere near the places that piles and rows of boxes take, so that noise does not.
#[inline(always)]
fn is_first<S: Scalar>(d: Vec3<S>) -> bool {
    let side = d.x.plus(d.y.plus(d.z.lowered_by(2)).lowered_by(2));
    let zero = S::ZERO;
    side > zero || (side == zero && (d.z > zero || (d.z == zero && d.y >= zero)))
}

/// The manifold of two shapes of a kind, from a function that takes them in the order of [`is_first`].
#[inline(always)]
fn manifold_in_order<S: Scalar, T>(
    a: Placed<'_, S, T>,
    b: Placed<'_, S, T>,
    margin: S,
    out: &mut Manifold<S>,
    ordered: impl FnOnce(Placed<'_, S, T>, Placed<'_, S, T>, S, &mut Manifold<S>),
) {
    if is_first(b.1.position - a.1.position) {
        ordered(a, b, margin, out);
    } else {
        ordered(b, a, margin, out);
        out.swap();
    }
}

/// The distance of two shapes of a kind, likewise.
#[inline(always)]
fn closest_in_order<S: Scalar, T>(
    a: Placed<'_, S, T>,
    b: Placed<'_, S, T>,
    ordered: impl FnOnce(Placed<'_, S, T>, Placed<'_, S, T>) -> Closest<S>,
) -> Closest<S> {
    if is_first(b.1.position - a.1.position) { ordered(a, b) } else { ordered(b, a).swapped() }
}

/// Up to this, distances that were computed in different ways may be the same.
#[inline(always)]
fn noise<S: Scalar>(distance: S) -> S {
    distance.lowered_by(22).plus(S::STEP).plus(S::STEP)
}
