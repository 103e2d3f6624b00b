//! Making a hull: the faces are the planes through three points that have all others on one side.

use super::{ConvexHull, Edge, Face, MAX_CORNERS, MAX_FACE_CORNERS};
use crate::error::HullError;
use crate::math::{Vec3, abs, max, min};
use crate::scalar::Scalar;
use crate::shape::at_most;

/// Points lie in a plane to within this share of the hull's size, as a power of two.
const FLAT: u32 = 11;
/// Directions with a sine below this power of two are one.
const STRAIGHT: u32 = 8;

/// Points by their bits.
type Points = u32;

pub(super) fn hull<S: Scalar, const N: usize>(points: &[Vec3<S>]) -> Result<ConvexHull<S, N>, HullError> {
    if points.len() > N || points.len() > MAX_CORNERS {
        return Err(HullError::TooMany);
    }
    if points.iter().any(|point| !point.is_finite()) {
        return Err(HullError::NotFinite);
    }
    let mut hull = attempt(points)?;
    if points.len() > 4 {
        // What is no corner is left out, and the rest done once more.
        let mut used: Points = 0;
        for face in hull.faces() {
            hull.ring(face).iter().for_each(|&corner| used |= 1 << corner);
        }
        if used.count_ones() < u32::from(hull.corner_count) {
            let mut kept = [Vec3::ZERO; N];
            let mut count = 0;
            for (index, &point) in points.iter().enumerate() {
                if used >> index & 1 == 1
                    && let Some(place) = kept.get_mut(count)
                {
                    *place = point;
                    count += 1;
                }
            }
            hull = attempt(kept.get(..count).unwrap_or(&[]))?;
        }
    }
    let (v, e, f) = (hull.corner_count, hull.edge_count, hull.face_count);
    if v + f == e + 2 { Ok(hull) } else { Err(HullError::Unclear) }
}

fn attempt<S: Scalar, const N: usize>(points: &[Vec3<S>]) -> Result<ConvexHull<S, N>, HullError> {
    if points.len() < 4 {
        return Err(HullError::TooFew);
    }
    let face = Face { normal: Vec3::ZERO, offset: S::ZERO, first: 0, len: 0 };
    let edge = Edge { direction: Vec3::ZERO, ends: [0; 2], sides: [0; 2] };
    let mut hull = ConvexHull {
        corners: [Vec3::ZERO; N],
        faces: [[face; 2]; N],
        edges: [[edge; 3]; N],
        rings: [[0; 6]; N],
        corner_count: points.len() as u8,
        face_count: 0,
        edge_count: 0,
        radii: [S::ZERO; 2],
    };
    hull.corners.iter_mut().zip(points).for_each(|(corner, point)| *corner = *point);
    let tolerance = size(points).lowered_by(FLAT);
    if tolerance <= S::ZERO {
        return Err(HullError::TooSmall);
    }
    // Which points the faces found so far hold.
    let mut held = [[0; 2]; N];
    for (i, &a) in points.iter().enumerate() {
        for (j, &b) in points.iter().enumerate().skip(i + 1) {
            for (k, &c) in points.iter().enumerate().skip(j + 1) {
                let three: Points = 1 << i | 1 << j | 1 << k;
                if held.as_flattened().iter().any(|held| held & three == three) {
                    continue;
                }
                let Some(normal) = across(b - a, c - a) else { continue };
                let Some((normal, flat)) = one_sided(points, a, normal, tolerance) else { continue };
                if flat.count_ones() as usize == points.len() {
                    return Err(HullError::Flat);
                }
                let held = held.as_flattened_mut().get_mut(usize::from(hull.face_count)).ok_or(HullError::Unclear)?;
                *held = flat;
                add_face(&mut hull, normal, flat)?;
            }
        }
    }
    add_edges(&mut hull)?;
    hull.radii = radii(&hull);
    Ok(hull)
}

/// Of balls around the origin: of one in the hull, zero where that is outside, and of one that holds it.
fn radii<S: Scalar, const N: usize>(hull: &ConvexHull<S, N>) -> [S; 2] {
    let (mut inner, mut outer) = (S::LARGEST, S::ZERO);
    for face in hull.faces() {
        inner = min(inner, face.offset);
    }
    for corner in hull.corners() {
        outer = max(outer, at_most(corner.magnitudes()));
    }
    [max(inner, S::ZERO), outer]
}

/// The largest extent along an axis.
fn size<S: Scalar>(points: &[Vec3<S>]) -> S {
    let mut size = S::ZERO;
    for &a in points {
        for &b in points {
            let way = (a - b).magnitudes();
            size = max(size, max(way.x, max(way.y, way.z)));
        }
    }
    size
}

/// The direction across two ways, if they are not along each other. Of their directions, so that short ways have all digits.
fn across<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> Option<Vec3<S::Unit>> {
    let (a, _) = S::direction3(a.to_array())?;
    let (b, _) = S::direction3(b.to_array())?;
    let (normal, sine) = S::Unit::direction3(Vec3::from_array(a).cross(Vec3::from_array(b)).to_array())?;
    if sine > S::Unit::ONE.lowered_by(STRAIGHT) { Some(Vec3::from_array(normal)) } else { None }
}

/// The normal away from all points, and which of them lie in the plane. `None` where there are points on both sides.
fn one_sided<S: Scalar>(
    points: &[Vec3<S>],
    origin: Vec3<S>,
    normal: Vec3<S::Unit>,
    tolerance: S,
) -> Option<(Vec3<S::Unit>, Points)> {
    let (mut above, mut below, mut flat) = (false, false, 0);
    for (index, &point) in points.iter().enumerate() {
        let height = (point - origin).along(normal);
        if abs(height) <= tolerance {
            flat |= 1 << index;
        } else if height > S::ZERO {
            above = true;
        } else {
            below = true;
        }
    }
    match (above, below) {
        (true, true) => None,
        (true, false) => Some((S::opposite(&normal), flat)),
        _ => Some((normal, flat)),
    }
}

/// Goes round the points of a plane, counter-clockwise (Jarvis, 1973): from each to the one that has all others on its left.
fn add_face<S: Scalar, const N: usize>(
    hull: &mut ConvexHull<S, N>,
    normal: Vec3<S::Unit>,
    flat: Points,
) -> Result<(), HullError> {
    let corners = hull.corners;
    let in_plane = || corners.iter().enumerate().filter(|(index, _)| *index < MAX_CORNERS && flat >> index & 1 == 1);
    let used = hull.faces().last().map_or(0, |face| usize::from(face.first) + usize::from(face.len));
    let Some((_, &any)) = in_plane().next() else { return Err(HullError::Unclear) };
    // The farthest of them from any is a corner.
    let Some((start, _)) = farthest(in_plane(), any) else { return Err(HullError::Unclear) };
    let (mut current, mut len, mut offset) = (start, 0, S::LARGEST.negated());
    loop {
        let from = *corners.get(current).ok_or(HullError::Unclear)?;
        offset = max(offset, from.along(normal));
        *hull.rings.as_flattened_mut().get_mut(used + len).ok_or(HullError::Unclear)? = current as u8;
        len += 1;
        let mut next: Option<(usize, Vec3<S>)> = None;
        for (index, &point) in in_plane().filter(|(index, _)| *index != current) {
            if next.is_none_or(|(_, best)| is_right_of(point - from, best - from, normal)) {
                next = Some((index, point));
            }
        }
        (current, _) = next.ok_or(HullError::Unclear)?;
        if current == start {
            break;
        }
        if len == MAX_FACE_CORNERS {
            return Err(HullError::FaceCorners);
        }
    }
    let face = Face { normal, offset, first: used as u8, len: len as u8 };
    *hull.faces.as_flattened_mut().get_mut(usize::from(hull.face_count)).ok_or(HullError::Unclear)? = face;
    hull.face_count += 1;
    Ok(())
}

fn farthest<'a, S: Scalar>(
    points: impl Iterator<Item = (usize, &'a Vec3<S>)>,
    origin: Vec3<S>,
) -> Option<(usize, &'a Vec3<S>)> {
    let square = |point: &Vec3<S>| {
        let way = (*point - origin).to_array();
        S::wide_dot3(way, way)
    };
    points.reduce(|best, other| if square(other.1) > square(best.1) { other } else { best })
}

/// Whether a way leads to the right of another, or farther along it.
fn is_right_of<S: Scalar>(way: Vec3<S>, other: Vec3<S>, normal: Vec3<S::Unit>) -> bool {
    let (Some((a, length)), Some((b, other_length))) = (S::direction3(way.to_array()), S::direction3(other.to_array()))
    else {
        return false;
    };
    let turn = Vec3::from_array(b).cross(Vec3::from_array(a)).dot(normal);
    let straight = abs(turn) <= S::Unit::ONE.lowered_by(STRAIGHT);
    if straight { length > other_length } else { turn < S::Unit::ZERO }
}

/// Each side of a ring is that of another ring, the other way round.
fn add_edges<S: Scalar, const N: usize>(hull: &mut ConvexHull<S, N>) -> Result<(), HullError> {
    for left in 0..hull.face_count {
        let Some(face) = hull.faces().get(usize::from(left)).copied() else { continue };
        for index in 0..face.len {
            let (a, b) = side(hull, &face, index);
            if a > b {
                continue;
            }
            let right = (0..hull.face_count).find(|&right| {
                let Some(face) = hull.faces().get(usize::from(right)) else { return false };
                (0..face.len).any(|index| side(hull, face, index) == (b, a))
            });
            let right = right.ok_or(HullError::Unclear)?;
            let [from, to] = [a, b].map(|end| hull.corners.get(usize::from(end)).copied().unwrap_or_default());
            let (direction, _) = S::direction3((to - from).to_array()).ok_or(HullError::Unclear)?;
            let edge = Edge { direction: Vec3::from_array(direction), ends: [a, b], sides: [left, right] };
            *hull.edges.as_flattened_mut().get_mut(usize::from(hull.edge_count)).ok_or(HullError::Unclear)? = edge;
            hull.edge_count += 1;
        }
    }
    Ok(())
}

/// The two corners at the ends of a side of a ring.
fn side<S: Scalar, const N: usize>(hull: &ConvexHull<S, N>, face: &Face<S>, index: u8) -> (u8, u8) {
    let ring = hull.ring(face);
    let at = |index: u8| ring.get(usize::from(index)).copied().unwrap_or_default();
    (at(index), at(if index + 1 == face.len { 0 } else { index + 1 }))
}
