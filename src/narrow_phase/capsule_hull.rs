//! A capsule and a hull: a point, or two where the capsule lies along a face.

use super::polytope::{Plane, Polytope};
use super::segment::{Segment, between, cut};
use super::{Placed, point};
use crate::manifold::Manifold;
use crate::math::{UnitVec3, Vec3, abs};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Closest, ConvexHull};

/// A normal whose cosine with a face's lacks less than this power of two of one, 1.3 degrees, is taken for the face's.
const ALONG_FACE: u32 = 12;
/// A capsule whose axis leans less than this power of two out of a face, 3.6 degrees, lies along it.
const LYING: u32 = 4;

/// What is closest in the hull's frame: the direction from the hull to the core of the capsule, how far away that is (negative
/// where the core pierces the hull), and the point of the core.
#[derive(Clone, Copy)]
pub(super) struct Core<S: Scalar> {
    pub normal: Vec3<S::Unit>,
    pub height: S,
    pub place: Vec3<S>,
}

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
        if let Some(plane) = hull.face(face).filter(|_| height < best.height) {
            if hull.is_over(face, &plane, place) {
                best = Core { normal: plane.normal, height, place };
            }
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

/// The core in the hull's frame, and the way from the capsule's origin to the hull's.
#[inline(always)]
fn relative<S: Scalar, const N: usize>(
    (capsule, pose): Placed<'_, S, Capsule<S>>,
    (_, hull_pose): Placed<'_, S, &ConvexHull<S, N>>,
) -> (Segment<S>, Vec3<S>) {
    let d = hull_pose.position - pose.position;
    let [_, _, axis] = pose.rotation.columns();
    let axis = hull_pose.rotation.transposed().times(axis);
    (Segment { middle: -hull_pose.unrotate(d), axis, half: capsule.half_length() }, d)
}

pub(super) fn manifold<S: Scalar, const N: usize>(
    capsule: Placed<'_, S, Capsule<S>>,
    hull: Placed<'_, S, &ConvexHull<S, N>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    let (segment, d) = relative(capsule, hull);
    let (radius, (hull, pose)) = (capsule.0.radius(), hull);
    let Core { normal, height, place } = core(*hull, &segment);
    let separation = height.minus(radius);
    if separation > margin {
        return;
    }
    let push = |out: &mut Manifold<S>, place: Vec3<S>, separation: S, feature: u16| {
        let down = out.normal.get();
        let r = pose.rotate(place) + d + Vec3::of_length(radius.plus(separation.lowered_by(1)), down);
        out.push(point(r, d, separation, feature));
    };
    if let Some((plane, ends)) = part_along_face(*hull, &segment, normal) {
        out.begin(S::opposite(&pose.rotation.times(plane.normal)));
        for &(feature, s) in &[(1, ends[0]), (2, ends[1])] {
            let end = segment.at(s);
            let separation = end.along(plane.normal).minus(plane.offset).minus(radius);
            if separation <= margin {
                push(out, end, separation, feature);
            }
        }
    }
    if out.is_empty() {
        out.begin(S::opposite(&pose.rotation.times(normal)));
        push(out, place, separation, 0);
    }
}

/// The part of a segment over the face that it lies along, if `normal` is that of a face.
pub(super) fn part_along_face<S: Scalar>(
    hull: &impl Polytope<S>,
    segment: &Segment<S>,
    normal: Vec3<S::Unit>,
) -> Option<(Plane<S>, [S; 2])> {
    if abs(segment.axis.dot(normal)) > S::Unit::ONE.lowered_by(LYING) {
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
    hull: Placed<'_, S, &ConvexHull<S, N>>,
) -> Closest<S> {
    let (segment, d) = relative(capsule, hull);
    let Core { normal, height, place } = core(*hull.0, &segment);
    let down = S::opposite(&hull.1.rotation.times(normal));
    let from_a = hull.1.rotate(place) + d;
    Closest {
        normal: UnitVec3::from_unit(down),
        separation: height.minus(capsule.0.radius()),
        r_a: from_a + Vec3::of_length(capsule.0.radius(), down),
        r_b: from_a - d + Vec3::of_length(height, down),
    }
}
