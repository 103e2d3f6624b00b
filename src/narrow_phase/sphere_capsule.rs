//! A sphere and a capsule.

use super::Placed;
use super::round::Cores;
use super::segment::Segment;
use crate::manifold::Manifold;
use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::shape::{Capsule, Closest, Sphere};

pub(super) fn manifold<S: Scalar>(
    a: Placed<'_, S, Sphere<S>>,
    b: Placed<'_, S, Capsule<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    cores(a, b).manifold(margin, out);
}

pub(super) fn closest<S: Scalar>(a: Placed<'_, S, Sphere<S>>, b: Placed<'_, S, Capsule<S>>) -> Closest<S> {
    cores(a, b).closest()
}

#[inline(always)]
fn cores<S: Scalar>((a, pose_a): Placed<'_, S, Sphere<S>>, (b, pose_b): Placed<'_, S, Capsule<S>>) -> Cores<S> {
    let d = pose_b.position - pose_a.position;
    let [_, _, axis] = pose_b.rotation.columns();
    let core = Segment { middle: d, axis, half: b.half_length() };
    let gap = core.at(core.project(Vec3::ZERO));
    Cores { d, from_a: Vec3::ZERO, gap, radii: [a.radius(), b.radius()] }
}
