//! Two hulls: as two polytopes, in one order for both ways to ask.

use super::{Placed, is_first, polytope_polytope};
use crate::manifold::Manifold;
use crate::scalar::Scalar;
use crate::shape::{Closest, ConvexHull};

pub(super) fn manifold<S: Scalar, const M: usize, const N: usize>(
    (a, pose_a): Placed<'_, S, &ConvexHull<S, M>>,
    (b, pose_b): Placed<'_, S, &ConvexHull<S, N>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    if polytope_polytope::are_apart((a, pose_a), (b, pose_b), margin) {
        return;
    }
    let size = polytope_polytope::smaller(a, b);
    if is_first(pose_b.position - pose_a.position) {
        polytope_polytope::manifold((*a, pose_a), (*b, pose_b), size, margin, out);
    } else {
        polytope_polytope::manifold((*b, pose_b), (*a, pose_a), size, margin, out);
        out.swap();
    }
}

pub(super) fn closest<S: Scalar, const M: usize, const N: usize>(
    (a, pose_a): Placed<'_, S, &ConvexHull<S, M>>,
    (b, pose_b): Placed<'_, S, &ConvexHull<S, N>>,
) -> Closest<S> {
    if is_first(pose_b.position - pose_a.position) {
        polytope_polytope::closest((*a, pose_a), (*b, pose_b))
    } else {
        polytope_polytope::closest((*b, pose_b), (*a, pose_a)).swapped()
    }
}
