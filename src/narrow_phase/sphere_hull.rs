//! A sphere and a hull.

use super::polytope::Polytope;
use super::{Placed, noise, point};
use crate::manifold::Manifold;
use crate::math::{UnitVec3, Vec3, abs};
use crate::scalar::Scalar;
use crate::shape::{Closest, ConvexHull, Sphere};

/// In the hull's frame: the direction from the hull to a point, and how far that is from the surface.
pub(super) fn nearest<S: Scalar>(hull: &impl Polytope<S>, p: Vec3<S>) -> (Vec3<S::Unit>, S) {
    let (face, height) = hull.highest_above(p);
    let Some(plane) = hull.face(face) else { return (UnitVec3::<S>::Z.get(), S::LARGEST) };
    if height <= S::ZERO || hull.is_over(face, &plane, p) {
        return (plane.normal, height);
    }
    // Beside an edge, and beside a corner: near the end of an edge both are equally far to all digits, and the edge is right.
    let [mut edge_best, mut corner_best] = [(plane.normal, S::LARGEST); 2];
    let mut index = 0;
    while let Some(edge) = hull.edge(index) {
        let segment = edge.segment();
        let place = segment.project(p);
        let gap = p - segment.at(place);
        if let Some((direction, length)) = S::direction3(gap.to_array()) {
            let best = if abs(place) < segment.half { &mut edge_best } else { &mut corner_best };
            if length < best.1 {
                *best = (Vec3::from_array(direction), length);
            }
        }
        index = index.wrapping_add(1);
    }
    if edge_best.1 <= corner_best.1.plus(noise(corner_best.1)) { edge_best } else { corner_best }
}

pub(super) fn manifold<S: Scalar, const N: usize>(
    (sphere, pose): Placed<'_, S, Sphere<S>>,
    (hull, hull_pose): Placed<'_, S, &ConvexHull<S, N>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    let d = hull_pose.position - pose.position;
    let p = -hull_pose.unrotate(d);
    // Most are farther above a plane than they reach.
    if hull.highest_above(p).1 > sphere.radius().plus(margin) {
        return;
    }
    let (normal, height) = nearest(*hull, p);
    let separation = height.minus(sphere.radius());
    if separation > margin {
        return;
    }
    let down = S::opposite(&hull_pose.rotation.times(normal));
    let r = Vec3::of_length(sphere.radius().plus(separation.lowered_by(1)), down);
    out.begin(down);
    out.push(point(r, d, separation, 0));
}

pub(super) fn closest<S: Scalar, const N: usize>(
    (sphere, pose): Placed<'_, S, Sphere<S>>,
    (hull, hull_pose): Placed<'_, S, &ConvexHull<S, N>>,
) -> Closest<S> {
    let d = hull_pose.position - pose.position;
    let (normal, height) = nearest(*hull, -hull_pose.unrotate(d));
    let down = S::opposite(&hull_pose.rotation.times(normal));
    Closest {
        normal: UnitVec3::from_unit(down),
        separation: height.minus(sphere.radius()),
        r_a: Vec3::of_length(sphere.radius(), down),
        r_b: Vec3::of_length(height, down) - d,
    }
}
