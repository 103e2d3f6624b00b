//! The narrow phase: where two shapes touch, one file for each pair.
//!
//! A file has `manifold`, the contact points for a solver, and `closest`, the distance. Everything is computed relative to
//! one of the shapes: the positions are subtracted first, so that far from the origin nothing is lost but what the positions
//! themselves lack.

use crate::manifold::{FeatureId, ManifoldPoint};
use crate::math::{Pose, Vec3};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Closest, Collide, Cuboid, HalfSpace, ManifoldSink, Sphere};

mod capsule_capsule;
mod capsule_cuboid;
mod capsule_half_space;
mod clip;
mod cuboid_cuboid;
mod cuboid_half_space;
mod point_cuboid;
mod round;
mod segment;
mod segment_cuboid;
mod sphere_capsule;
mod sphere_cuboid;
mod sphere_half_space;
mod sphere_sphere;

/// The pair in both orders, by the functions of one file.
macro_rules! pair {
    ($a:ident, $b:ident: $file:ident) => {
        impl<S: Scalar> Collide<S, $b<S>> for $a<S> {
            #[inline]
            fn collide<K: ManifoldSink<S>>(
                &self,
                pose: &Pose<S>,
                other: &$b<S>,
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
            fn closest(&self, pose: &Pose<S>, other: &$b<S>, other_pose: &Pose<S>) -> Option<Closest<S>> {
                Some($file::closest((self, pose), (other, other_pose)))
            }
        }
    };
    ($a:ident, $b:ident: $file:ident, mirrored) => {
        pair!($a, $b: $file);

        impl<S: Scalar> Collide<S, $a<S>> for $b<S> {
            #[inline]
            fn collide<K: ManifoldSink<S>>(
                &self,
                pose: &Pose<S>,
                other: &$a<S>,
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
            fn closest(&self, pose: &Pose<S>, other: &$a<S>, other_pose: &Pose<S>) -> Option<Closest<S>> {
                Some($file::closest((other, other_pose), (self, pose)).swapped())
            }
        }
    };
}

/// Shapes that stand still and never meet.
macro_rules! never {
    ($a:ident, $b:ident) => {
        impl<S: Scalar> Collide<S, $b<S>> for $a<S> {
            #[inline(always)]
            fn collide<K: ManifoldSink<S>>(&self, _: &Pose<S>, _: &$b<S>, _: &Pose<S>, _: S, _: &mut K) {}

            #[inline(always)]
            fn closest(&self, _: &Pose<S>, _: &$b<S>, _: &Pose<S>) -> Option<Closest<S>> {
                None
            }
        }
    };
}

pair!(Sphere, Sphere: sphere_sphere);
pair!(Sphere, HalfSpace: sphere_half_space, mirrored);
pair!(Sphere, Cuboid: sphere_cuboid, mirrored);
pair!(Sphere, Capsule: sphere_capsule, mirrored);
pair!(Cuboid, Cuboid: cuboid_cuboid);
pair!(Cuboid, HalfSpace: cuboid_half_space, mirrored);
pair!(Capsule, Capsule: capsule_capsule);
pair!(Capsule, Cuboid: capsule_cuboid, mirrored);
pair!(Capsule, HalfSpace: capsule_half_space, mirrored);
never!(HalfSpace, HalfSpace);

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
