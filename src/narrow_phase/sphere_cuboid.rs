//! A sphere and a box.

use super::point_cuboid::{direction, nearest_face, outside};
use super::{Placed, point};
use crate::manifold::Manifold;
use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;
use crate::shape::{Closest, Cuboid, Sphere};

/// In the box's frame: the direction from the box to the sphere's centre, and how far that is from the surface.
#[inline(always)]
fn centre<S: Scalar>(p: Vec3<S>, half: Vec3<S>) -> (Vec3<S::Unit>, S) {
    direction(outside(p, half)).unwrap_or_else(|| nearest_face(p, half))
}

pub(super) fn manifold<S: Scalar>(
    (sphere, pose): Placed<'_, S, Sphere<S>>,
    (cuboid, cuboid_pose): Placed<'_, S, Cuboid<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    let d = cuboid_pose.position - pose.position;
    let (p, half) = (-cuboid_pose.unrotate(d), cuboid.half_extents());
    let away = outside(p, half).to_array();
    let reach = sphere.radius().plus(margin);
    if S::wide_dot3(away, away) > S::wide_product(reach, reach) {
        return;
    }
    let (normal, height) = centre(p, half);
    let separation = height.minus(sphere.radius());
    let normal = S::opposite(&cuboid_pose.rotation.times(normal));
    let r = Vec3::of_length(sphere.radius().plus(separation.lowered_by(1)), normal);
    out.begin(normal);
    out.push(point(r, d, separation, 0));
}

pub(super) fn closest<S: Scalar>(
    (sphere, pose): Placed<'_, S, Sphere<S>>,
    (cuboid, cuboid_pose): Placed<'_, S, Cuboid<S>>,
) -> Closest<S> {
    let d = cuboid_pose.position - pose.position;
    let (normal, height) = centre(-cuboid_pose.unrotate(d), cuboid.half_extents());
    let normal = S::opposite(&cuboid_pose.rotation.times(normal));
    Closest {
        normal: UnitVec3::from_unit(normal),
        separation: height.minus(sphere.radius()),
        r_a: Vec3::of_length(sphere.radius(), normal),
        r_b: Vec3::of_length(height, normal) - d,
    }
}
