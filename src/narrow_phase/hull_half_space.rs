//! A hull and a half-space: the corners that hold it best, of those that are low.

use super::clip::Polygon;
use super::{Placed, above, point};
use crate::manifold::Manifold;
use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;
use crate::shape::{Closest, ConvexHull, HalfSpace, MAX_CORNERS, Shape};

/// Corners as deep as the deepest to within this share of the size, as a power of two, are one as good as the other.
const STEADY: u32 = 10;

pub(super) fn manifold<S: Scalar, const N: usize>(
    (hull, pose): Placed<'_, S, &ConvexHull<S, N>>,
    plane: Placed<'_, S, HalfSpace<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    let (up, height, d) = above(pose, plane);
    if height.minus(hull.outer_radius()) > margin {
        return;
    }
    let local_up = pose.rotation.transposed().times(up);
    // In the plane, and above it.
    let (x, y) = UnitVec3::<S>::from_unit(local_up).tangents();
    let rows = [x.get(), y.get(), local_up];
    let mut polygon = Polygon::<S, MAX_CORNERS>::EMPTY;
    let mut index = 0u16;
    for corner in hull.corners() {
        let rise = corner.along(local_up).plus(height);
        if rise <= margin {
            let place = corner.through(rows);
            polygon.push(Vec3::new(place.x, place.y, rise), index);
        }
        index = index.wrapping_add(1);
    }
    let mut chosen = polygon.four(hull.inner_radius().lowered_by(STEADY));
    let down = S::opposite(&up);
    out.begin(down);
    for corner in polygon.corners() {
        if chosen & 1 == 1 {
            let separation = corner.place.z;
            if let Some(&place) = hull.corners().get(usize::from(corner.edge)) {
                let r = pose.rotate(place) + Vec3::of_length(separation.lowered_by(1), down);
                out.push(point(r, d, separation, corner.edge));
            }
        }
        chosen >>= 1;
    }
}

pub(super) fn closest<S: Scalar, const N: usize>(
    (hull, pose): Placed<'_, S, &ConvexHull<S, N>>,
    plane: Placed<'_, S, HalfSpace<S>>,
) -> Closest<S> {
    let (up, height, d) = above(pose, plane);
    let local_up = pose.rotation.transposed().times(up);
    let (mut lowest, mut deepest) = (S::LARGEST, Vec3::ZERO);
    for &corner in hull.corners() {
        let rise = corner.along(local_up);
        if rise < lowest {
            (lowest, deepest) = (rise, corner);
        }
    }
    let (separation, down) = (height.plus(lowest), S::opposite(&up));
    let r_a = pose.rotate(deepest);
    let r_b = r_a + Vec3::of_length(separation, down) - d;
    Closest { normal: UnitVec3::from_unit(down), separation, r_a, r_b }
}
