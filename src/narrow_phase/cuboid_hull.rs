//! A box and a hull: as two polytopes.

use super::{Placed, polytope_polytope};
use crate::manifold::Manifold;
use crate::scalar::Scalar;
use crate::shape::{Closest, ConvexHull, Cuboid};

pub(super) fn manifold<S: Scalar, const N: usize>(
    (cuboid, pose): Placed<'_, S, Cuboid<S>>,
    (hull, hull_pose): Placed<'_, S, &ConvexHull<S, N>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    if polytope_polytope::are_apart((cuboid, pose), (hull, hull_pose), margin) {
        return;
    }
    let size = polytope_polytope::smaller(cuboid, hull);
    polytope_polytope::manifold((cuboid, pose), (*hull, hull_pose), size, margin, out);
}

pub(super) fn closest<S: Scalar, const N: usize>(
    (cuboid, pose): Placed<'_, S, Cuboid<S>>,
    (hull, hull_pose): Placed<'_, S, &ConvexHull<S, N>>,
) -> Closest<S> {
    polytope_polytope::closest((cuboid, pose), (*hull, hull_pose))
}
