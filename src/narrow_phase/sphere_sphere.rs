//! Two spheres.

use super::Placed;
use super::round::Cores;
use crate::manifold::Manifold;
use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::shape::{Closest, Sphere};

#[inline]
pub(super) fn manifold<S: Scalar>(
    a: Placed<'_, S, Sphere<S>>,
    b: Placed<'_, S, Sphere<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    cores(a, b).manifold(margin, out);
}

pub(super) fn closest<S: Scalar>(a: Placed<'_, S, Sphere<S>>, b: Placed<'_, S, Sphere<S>>) -> Closest<S> {
    cores(a, b).closest()
}

#[inline(always)]
fn cores<S: Scalar>((a, pose_a): Placed<'_, S, Sphere<S>>, (b, pose_b): Placed<'_, S, Sphere<S>>) -> Cores<S> {
    let d = pose_b.position - pose_a.position;
    Cores { d, from_a: Vec3::ZERO, gap: d, radii: [a.radius(), b.radius()] }
}
