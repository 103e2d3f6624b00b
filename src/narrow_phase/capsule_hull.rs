//! A capsule and a hull: a point, or two where the capsule lies along a face.

use super::Placed;
use super::polytope::{Plane, Polytope};
use super::rod::{ALONG_FACE, Core, Rod, lies_along};
use super::segment::{Segment, between, cut};
use crate::manifold::Manifold;
use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::shape::{Capsule, Closest, ConvexHull};

pub(super) fn core<S: Scalar>(hull: &impl Polytope<S>, core: &Segment<S>) -> Core<S> {
    let inside = least_translation(hull, core);
    if inside.height <= S::ZERO {
        return inside;
    }
    let mut best = Core { height: S::LARGEST, ..inside };
    // An end over a face, or an edge beside the core.
    for &s in &[core.half, core.half.negated()] {
        let place = core.at(s);
        let (face, height) = hull.highest_above(place);
        if let Some(plane) = hull.face(face).filter(|_| height < best.height)
            && hull.is_over(face, &plane, place)
        {
            best = Core { normal: plane.normal, height, place };
        }
    }
    let mut index = 0;
    while let Some(edge) = hull.edge(index) {
        let edge = edge.segment();
        let places = edge.closest(core);
        if let Some((normal, height)) = between(&edge, core, places).filter(|(_, height)| *height < best.height) {
            best = Core { normal, height, place: core.at(places[1]) };
        }
        index = index.wrapping_add(1);
    }
    best
}

/// The axis along which hull and core are farthest apart, of the faces and across edges and core.
fn least_translation<S: Scalar>(hull: &impl Polytope<S>, core: &Segment<S>) -> Core<S> {
    let lower_end = |normal: Vec3<S::Unit>| {
        let rises = core.axis.dot(normal) > S::Unit::ZERO;
        core.at(if rises { core.half.negated() } else { core.half })
    };
    let mut best = Core { normal: core.axis, height: S::LARGEST.negated(), place: core.middle };
    let mut index = 0;
    while let Some(Plane { normal, offset }) = hull.face(index) {
        let place = lower_end(normal);
        let height = place.along(normal).minus(offset);
        if height > best.height {
            best = Core { normal, height, place };
        }
        index = index.wrapping_add(1);
    }
    index = 0;
    while let Some(edge) = hull.edge(index) {
        index = index.wrapping_add(1);
        let Some((across, sine)) = S::Unit::direction3(edge.direction.cross(core.axis).to_array()) else { continue };
        if sine <= S::Unit::ONE.lowered_by(10) {
            continue;
        }
        // Out of the hull: between the normals of the edge's faces, else it is no side of the sum of hull and core.
        let across = Vec3::from_array(across);
        let [left, right] = edge.sides;
        let (p, q) = (left.dot(core.axis) > S::Unit::ZERO, right.dot(core.axis) > S::Unit::ZERO);
        if p == q {
            continue;
        }
        let out = across.dot(left).plus(across.dot(right)) > S::Unit::ZERO;
        let across = if out { across } else { S::opposite(&across) };
        let height = (core.middle - edge.from).along(across);
        if height > best.height {
            let edge = edge.segment();
            best = Core { normal: across, height, place: core.at(edge.closest(core)[1]) };
        }
    }
    best
}

pub(super) fn manifold<S: Scalar, const N: usize>(
    capsule: Placed<'_, S, Capsule<S>>,
    (hull, pose): Placed<'_, S, &ConvexHull<S, N>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    let rod = Rod::new(capsule, pose);
    let over_face = |normal| part_along_face(*hull, &rod.segment, normal);
    rod.manifold(core(*hull, &rod.segment), over_face, margin, out);
}

/// The part of a segment over the face that it lies along, if `normal` is that of a face.
pub(super) fn part_along_face<S: Scalar>(
    hull: &impl Polytope<S>,
    segment: &Segment<S>,
    normal: Vec3<S::Unit>,
) -> Option<(Plane<S>, [S; 2])> {
    if !lies_along(segment, normal) {
        return None;
    }
    let (face, plane) = along_face(hull, normal)?;
    let [low, high] = over(hull, face, &plane, segment)?;
    if low < high { Some((plane, [low, high])) } else { None }
}

/// The face whose normal that direction is, or nearly.
fn along_face<S: Scalar>(hull: &impl Polytope<S>, normal: Vec3<S::Unit>) -> Option<(u8, Plane<S>)> {
    let least = S::Unit::ONE.minus(S::Unit::ONE.lowered_by(ALONG_FACE));
    let mut index = 0;
    while let Some(plane) = hull.face(index) {
        if plane.normal.dot(normal) >= least {
            return Some((index, plane));
        }
        index = index.wrapping_add(1);
    }
    None
}

/// The part of a segment over a face.
fn over<S: Scalar>(hull: &impl Polytope<S>, face: u8, plane: &Plane<S>, segment: &Segment<S>) -> Option<[S; 2]> {
    let first = hull.face_corner(face, 0)?;
    let mut range = [segment.half.negated(), segment.half];
    let (mut from, mut index) = (first, 1);
    loop {
        let next = hull.face_corner(face, index);
        let to = next.unwrap_or(first);
        let (along, _) = S::direction3((to - from).to_array())?;
        let right = Vec3::from_array(along).cross(plane.normal);
        range = cut(range, (from - segment.middle).along(right), segment.axis.dot(right))?;
        if next.is_none() {
            return Some(range);
        }
        from = to;
        index = index.wrapping_add(1);
    }
}

pub(super) fn closest<S: Scalar, const N: usize>(
    capsule: Placed<'_, S, Capsule<S>>,
    (hull, pose): Placed<'_, S, &ConvexHull<S, N>>,
) -> Closest<S> {
    let rod = Rod::new(capsule, pose);
    rod.closest(core(*hull, &rod.segment))
}
