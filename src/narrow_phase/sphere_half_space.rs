//! A sphere and a half-space.

use super::{Placed, above, point};
use crate::manifold::Manifold;
use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;
use crate::shape::{Closest, HalfSpace, Sphere};

#[inline]
pub(super) fn manifold<S: Scalar>(
    (sphere, pose): Placed<'_, S, Sphere<S>>,
    plane: Placed<'_, S, HalfSpace<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    let (up, height, d) = above(pose, plane);
    let separation = height.minus(sphere.radius());
    if separation > margin {
        return;
    }
    let down = S::opposite(&up);
    let r = Vec3::of_length(sphere.radius().plus(separation.lowered_by(1)), down);
    out.begin(down);
    out.push(point(r, d, separation, 0));
}

pub(super) fn closest<S: Scalar>(
    (sphere, pose): Placed<'_, S, Sphere<S>>,
    plane: Placed<'_, S, HalfSpace<S>>,
) -> Closest<S> {
    let (up, height, d) = above(pose, plane);
    let down = S::opposite(&up);
    Closest {
        normal: UnitVec3::from_unit(down),
        separation: height.minus(sphere.radius()),
        r_a: Vec3::of_length(sphere.radius(), down),
        r_b: Vec3::of_length(height, down) - d,
    }
}
