//! Two polytopes, one of them a hull: the axis that separates them best, of all faces and of those pairs of edges that meet on
//! the difference of both (Gregorius, 2013); then the part of one face over the other, or the point where two edges cross.

use super::clip::{Inside, Polygon};
use super::polytope::{Edge, Polytope};
use super::{Placed, point};
use crate::manifold::Manifold;
use crate::math::{Mat3, Pose, Vec3, min};
use crate::scalar::Scalar;
use crate::shape::{MAX_FACE_CORNERS, Shape};

mod distance;

pub(super) use distance::closest;

/// By this share of the smaller shape, as a power of two, an axis must be better to be taken before one that gives a steadier
/// contact: faces of A, faces of B, edges, in that order.
const STEADY: u32 = 10;
/// Corners of a face cut by the sides of another.
const CORNERS: usize = 2 * MAX_FACE_CORNERS;
/// Bits of a number below `CORNERS`, for an edge or a side.
const LABEL_BITS: u32 = 5;

/// B seen from A and A from B.
struct Relative<S: Scalar> {
    /// The rows are A's axes in B's frame, and the other way round.
    rotation: Mat3<S::Unit>,
    back: Mat3<S::Unit>,
    /// From A's origin to B's: in A's frame, in B's, and in the world's axes.
    in_a: Vec3<S>,
    in_b: Vec3<S>,
    d: Vec3<S>,
}

impl<S: Scalar> Relative<S> {
    fn new(a: &Pose<S>, b: &Pose<S>) -> Self {
        let d = b.position - a.position;
        let rotation = a.rotation.transposed().times_mat3(&b.rotation);
        Self { rotation, back: rotation.transposed(), in_a: a.unrotate(d), in_b: b.unrotate(d), d }
    }

    fn reversed(&self) -> Self {
        Self { rotation: self.back, back: self.rotation, in_a: -self.in_b, in_b: -self.in_a, d: -self.d }
    }

    /// An edge of B in A's frame.
    fn edge(&self, edge: &Edge<S>) -> Edge<S> {
        let [left, right] = edge.sides;
        Edge {
            from: self.in_a + edge.from.through(self.rotation.rows),
            to: self.in_a + edge.to.through(self.rotation.rows),
            direction: self.rotation.times(edge.direction),
            sides: [self.rotation.times(left), self.rotation.times(right)],
        }
    }
}

#[derive(Clone, Copy)]
enum Axis<S: Scalar> {
    FaceOfA(u8),
    FaceOfB(u8),
    /// Across an edge of each, in A's frame; towards B.
    Edges(u8, u8, Vec3<S::Unit>),
}

/// The axis along which the polytopes are farthest apart, and how far. `None` where that is more than `margin`.
#[inline(never)]
fn separating_axis<S: Scalar>(
    a: &impl Polytope<S>,
    b: &impl Polytope<S>,
    relative: &Relative<S>,
    steady: S,
    margin: S,
) -> Option<(Axis<S>, S)> {
    let (face, mut best) = farthest_face(a, b, &relative.back, relative.in_a);
    let mut axis = Axis::FaceOfA(face);
    let (face, separation) = farthest_face(b, a, &relative.rotation, -relative.in_b);
    if best > margin || separation > margin {
        return None;
    }
    if separation > best.plus(steady) {
        (axis, best) = (Axis::FaceOfB(face), separation);
    }
    let mut j = 0;
    while let Some(of_b) = b.edge(j) {
        let of_b = relative.edge(&of_b);
        let mut i = 0;
        while let Some(of_a) = a.edge(i) {
            let bound = if matches!(axis, Axis::Edges(..)) { best } else { best.plus(steady) };
            if let Some((across, separation)) = across_edges(&of_a, &of_b, bound) {
                if separation > margin {
                    return None;
                }
                (axis, best) = (Axis::Edges(i, j, across), separation);
            }
            i = i.wrapping_add(1);
        }
        j = j.wrapping_add(1);
    }
    Some((axis, best))
}

/// The face of the first that the second is farthest above. `back` turns into the second's frame; `way` leads to its origin, in
/// the first's.
#[inline(never)]
fn farthest_face<S: Scalar>(
    first: &impl Polytope<S>,
    second: &impl Polytope<S>,
    back: &Mat3<S::Unit>,
    way: Vec3<S>,
) -> (u8, S) {
    let mut best = (0, S::LARGEST.negated());
    let mut index = 0;
    while let Some(plane) = first.face(index) {
        let height = second.lowest(back.times(plane.normal)).plus(way.along(plane.normal)).minus(plane.offset);
        if height > best.1 {
            best = (index, height);
        }
        index = index.wrapping_add(1);
    }
    best
}

/// The separation across two edges, if they make a face of the difference of both polytopes and it is more than `bound`; and the
/// direction towards B.
///
/// Seen as arcs between the normals of their faces on the unit sphere, the edge of A and the mirrored one of B must cross.
#[inline(never)]
fn across_edges<S: Scalar>(a: &Edge<S>, b: &Edge<S>, bound: S) -> Option<(Vec3<S::Unit>, S)> {
    let nil = S::Unit::ZERO;
    let ([a_left, a_right], [b_left, b_right]) = (a.sides, b.sides);
    let (p, q) = (b_left.dot(a.direction) > nil, b_right.dot(a.direction) > nil);
    if p == q {
        return None;
    }
    let (r, s) = (a_left.dot(b.direction) > nil, a_right.dot(b.direction) > nil);
    if r == s || p == s {
        return None;
    }
    let (across, sine) = S::Unit::direction3(a.direction.cross(b.direction).to_array())?;
    if sine <= S::Unit::ONE.lowered_by(10) {
        return None;
    }
    let across = Vec3::from_array(across);
    // Out of A: between the normals of its faces.
    let out = across.dot(a_left).plus(across.dot(a_right)) > nil;
    let across = if out { across } else { S::opposite(&across) };
    let separation = (b.from - a.from).along(across);
    if separation > bound { Some((across, separation)) } else { None }
}

pub(super) fn manifold<S: Scalar, A: Polytope<S>, B: Polytope<S>>(
    (a, pose_a): Placed<'_, S, A>,
    (b, pose_b): Placed<'_, S, B>,
    size: S,
    margin: S,
    out: &mut Manifold<S>,
) {
    let relative = Relative::new(pose_a, pose_b);
    let steady = size.lowered_by(STEADY);
    let Some((axis, separation)) = separating_axis(a, b, &relative, steady, margin) else { return };
    match axis {
        Axis::FaceOfA(face) => over_face(a, pose_a, b, &relative, (face, 0), [steady, margin], out),
        Axis::FaceOfB(face) => {
            over_face(b, pose_b, a, &relative.reversed(), (face, 1 << 15), [steady, margin], out);
            out.swap();
        }
        Axis::Edges(i, j, across) => {
            let Some((of_a, of_b)) = a.edge(i).zip(b.edge(j)) else { return };
            let (of_a, of_b) = (of_a.segment(), relative.edge(&of_b).segment());
            let r = pose_a.rotate(of_a.crossing(&of_b));
            out.begin(pose_a.rotation.times(across));
            out.push(point(r, relative.d, separation, 1 << 14 | u16::from(i) << 7 | u16::from(j)));
        }
    }
}

/// The side of a face, in the face's plane.
struct Side<S: Scalar> {
    from: Vec3<S>,
    along: [S::Unit; 2],
}

impl<S: Scalar> Inside<S> for Side<S> {
    /// To the left.
    #[inline(always)]
    fn of(&self, place: Vec3<S>) -> S {
        let [x, y] = self.along;
        S::dot3_unit([place.y.minus(self.from.y), self.from.x.minus(place.x), S::ZERO], [x, y, S::Unit::ZERO])
    }
}

/// The part of B's face that looks at a face of A, over it.
#[inline(never)]
fn over_face<S: Scalar>(
    a: &impl Polytope<S>,
    pose_a: &Pose<S>,
    b: &impl Polytope<S>,
    relative: &Relative<S>,
    (face, name): (u8, u16),
    [steady, margin]: [S; 2],
    out: &mut Manifold<S>,
) {
    let Some((plane, origin)) = a.face(face).zip(a.face_corner(face, 0)) else { return };
    let Some(next) = a.face_corner(face, 1) else { return };
    let Some((x, _)) = S::direction3((next - origin).to_array()) else { return };
    let x = Vec3::from_array(x);
    let frame = Mat3 { rows: [x, plane.normal.cross(x), plane.normal] };
    // In the face's plane, and the height above it.
    let incident = against(b, relative.back.times(plane.normal));
    let mut polygon = Polygon::<S, CORNERS>::EMPTY;
    let mut index = 0;
    while let Some(corner) = b.face_corner(incident, index) {
        let place = relative.in_a + corner.through(relative.rotation.rows) - origin;
        let place = place.through(frame.rows);
        // Against the normal, its corners go round the other way.
        polygon.push(place, u16::from(index));
        index = index.wrapping_add(1);
    }
    let (mut from, mut side) = (Vec3::ZERO, 1);
    loop {
        let next = a.face_corner(face, side);
        let to = next.map_or(Vec3::ZERO, |corner| (corner - origin).through(frame.rows));
        if let Some(([x, y, _], _)) = S::direction3([to.x.minus(from.x), to.y.minus(from.y), S::ZERO]) {
            polygon.cut(
                (MAX_FACE_CORNERS as u16).wrapping_add(u16::from(side)).wrapping_sub(1),
                Side { from, along: [x, y] },
                steady,
            );
        }
        if next.is_none() {
            break;
        }
        from = to;
        side = side.wrapping_add(1);
    }
    polygon.name(LABEL_BITS, margin);
    let mut chosen = polygon.four(steady);
    out.begin(pose_a.rotation.times(plane.normal));
    // Faces are told apart by what is added to the names of ten bits.
    let name = name ^ u16::from(face) << 10 ^ u16::from(incident).wrapping_mul(0x0421);
    for corner in polygon.corners() {
        if chosen & 1 == 1 {
            let separation = corner.place.z;
            let place = Vec3::new(corner.place.x, corner.place.y, separation.lowered_by(1));
            let r = pose_a.rotate(origin + place.through(frame.columns()));
            out.push(point(r, relative.d, separation, name ^ corner.edge));
        }
        chosen >>= 1;
    }
}

/// The face that looks most against a direction.
#[inline(never)]
fn against<S: Scalar>(polytope: &impl Polytope<S>, direction: Vec3<S::Unit>) -> u8 {
    let mut best = (0, S::Unit::LARGEST);
    let mut index = 0;
    while let Some(plane) = polytope.face(index) {
        let along = plane.normal.dot(direction);
        if along < best.1 {
            best = (index, along);
        }
        index = index.wrapping_add(1);
    }
    best.0
}

/// Whether even the balls around two shapes are farther apart than `margin`.
#[inline(always)]
pub(super) fn are_apart<S: Scalar, A: Shape<S>, B: Shape<S>>(
    (a, pose_a): Placed<'_, S, A>,
    (b, pose_b): Placed<'_, S, B>,
    margin: S,
) -> bool {
    let way = (pose_b.position - pose_a.position).to_array();
    let reach = a.outer_radius().plus(b.outer_radius()).plus(margin);
    S::wide_dot3(way, way) > S::wide_product(reach, reach)
}

/// The size of the smaller of two shapes.
pub(super) fn smaller<S: Scalar>(a: &impl Shape<S>, b: &impl Shape<S>) -> S {
    min(a.inner_radius(), b.inner_radius())
}
