//! Two boxes: the axis that separates them best (15 of them, Gottschalk and others, 1996), then the part of one face over the
//! other, or the point where two edges cross.

use super::clip::{Corner, Inside, Polygon};
use super::segment::Segment;
use super::{Placed, closest_in_order, cycled, manifold_in_order, point, uncycled};
use crate::manifold::Manifold;
use crate::math::{Mat3, Pose, Vec3, abs, min};
use crate::scalar::Scalar;
use crate::shape::{Cuboid, Shape};

mod distance;

pub(super) use distance::closest;

/// By this share of the smallest half extent, as a power of two, an axis must be better to be taken before one that gives a
/// steadier contact: faces of A, faces of B, edges, in that order.
const STEADY: u32 = 10;

/// A corner's name: three bits each for the edges that meet there, 0 to 3 for the incident face's, 4 to 7 for the sides.
const LABEL_BITS: u32 = 3;

/// B seen from A and A from B.
struct Relative<S: Scalar> {
    /// The rows are A's axes in B's frame.
    rotation: Mat3<S::Unit>,
    /// From A's origin to B's: in A's frame, in B's, and in the world's axes.
    in_a: Vec3<S>,
    in_b: Vec3<S>,
    d: Vec3<S>,
}

impl<S: Scalar> Relative<S> {
    #[inline(never)]
    fn new(a: &Pose<S>, b: &Pose<S>) -> Self {
        let d = b.position - a.position;
        let rotation = a.rotation.transposed().times_mat3(&b.rotation);
        Self { rotation, in_a: a.unrotate(d), in_b: b.unrotate(d), d }
    }

    /// A seen from B and B from A.
    #[inline(always)]
    fn turn_round(&mut self) {
        self.rotation = self.rotation.transposed();
        (self.in_a, self.in_b) = (-self.in_b, -self.in_a);
        self.d = -self.d;
    }
}

/// Which axis separates best.
#[derive(Clone, Copy)]
enum Axis<S: Scalar> {
    FaceOfA(u8),
    FaceOfB(u8),
    /// Across an edge of each, in A's frame; towards B.
    Edges(u8, u8, Vec3<S::Unit>),
}

/// The axis along which the boxes are farthest apart, and how far. `None` where that is more than `margin`.
#[inline(never)]
fn separating_axis<S: Scalar>(
    [a, b]: [Vec3<S>; 2],
    relative: &Relative<S>,
    steady: S,
    margin: S,
) -> Option<(Axis<S>, S)> {
    let Relative { rotation, in_a, in_b, .. } = relative;
    let [x, y, z] = rotation.rows;
    let sizes = Mat3 { rows: [x.magnitudes(), y.magnitudes(), z.magnitudes()] };
    let (axis, mut best) = largest(in_a.magnitudes() - a - b.through(sizes.rows));
    let mut kind = Axis::FaceOfA(axis);
    if best > margin {
        return None;
    }
    let (axis, separation) = largest(in_b.magnitudes() - b - a.through(sizes.columns()));
    if separation > margin {
        return None;
    }
    if separation > best.plus(steady) {
        (kind, best) = (Axis::FaceOfB(axis), separation);
    }
    // Across each pair of edges: with the frames cycled so that the first axes are those of the edges.
    let (mut rows, mut sizes, mut d, mut h) = (rotation.rows, sizes.rows, *in_a, a);
    for i in 0..3 {
        let [x, y, z] = across_edges_at_most(&d, &h, b, &rows, &sizes);
        for &(j, short) in &[(0, x), (1, y), (2, z)] {
            let bound = if matches!(kind, Axis::Edges(..)) { best } else { best.plus(steady) };
            if short <= S::ZERO && short <= bound {
                continue;
            }
            let turned = [cycled(rows[0], j), cycled(rows[1], j), cycled(rows[2], j)];
            if let Some((across, separation)) = across_edges(d, [h, cycled(b, j)], turned, bound) {
                if separation > margin {
                    return None;
                }
                kind = Axis::Edges(i, j, uncycled(across, i));
                best = separation;
            }
        }
        (rows, sizes) = ([rows[1], rows[2], rows[0]], [sizes[1], sizes[2], sizes[0]]);
        (d, h) = (d.cycled(), h.cycled());
    }
    Some((kind, best))
}

/// The separations across the first edge of A and each of B, where they are negative too small in magnitude. The rows are the
/// axes of A in B's frame, and their magnitudes.
///
/// For edges u and w, u x w has the components 0, -w_z, w_y and is no longer than one; here it is not made a direction, which
/// would take a root and a division.
#[inline(always)]
fn across_edges_at_most<S: Scalar>(
    d: &Vec3<S>,
    a: &Vec3<S>,
    b: Vec3<S>,
    [_, second, third]: &[Vec3<S::Unit>; 3],
    [first_size, second_size, third_size]: &[Vec3<S::Unit>; 3],
) -> [S; 3] {
    let (nil, zero) = (S::Unit::ZERO, S::ZERO);
    let short = |y: S::Unit, z: S::Unit, sizes: [S::Unit; 4], b: [S; 2]| {
        let distance = abs(S::dot3_unit([d.z, d.y, zero], [y, z.negated(), nil]));
        let reach = S::dot3_unit([a.z, a.y, b[0]], [sizes[0], sizes[1], sizes[2]]).plus(b[1].times_unit(sizes[3]));
        distance.minus(reach)
    };
    let (f, s, t) = (first_size, second_size, third_size);
    [
        short(second.x, third.x, [s.x, t.x, f.z, f.y], [b.y, b.z]),
        short(second.y, third.y, [s.y, t.y, f.x, f.z], [b.z, b.x]),
        short(second.z, third.z, [s.z, t.z, f.y, f.x], [b.x, b.y]),
    ]
}

/// The axis of the largest component, and that.
#[inline(always)]
fn largest<S: Scalar>(v: Vec3<S>) -> (u8, S) {
    if v.x >= v.y && v.x >= v.z {
        (0, v.x)
    } else if v.y >= v.z {
        (1, v.y)
    } else {
        (2, v.z)
    }
}

/// The separation across the first edge of each box, if it is more than `bound`, and the direction towards B. The rows are the
/// axes of A in B's frame.
#[inline(never)]
fn across_edges<S: Scalar>(
    d: Vec3<S>,
    [a, b]: [Vec3<S>; 2],
    [_, second, third]: [Vec3<S::Unit>; 3],
    bound: S,
) -> Option<(Vec3<S::Unit>, S)> {
    let (nil, zero) = (S::Unit::ZERO, S::ZERO);
    let (y, z) = (third.x.negated(), second.x);
    // Parallel edges: the axis is one of a face, or any.
    if S::Unit::dot3([y, z, nil], [y, z, nil]) <= S::Unit::ONE.lowered_by(20) {
        return None;
    }
    let ([_, y, z], _) = S::Unit::direction3([nil, y, z])?;
    let distance = S::dot3_unit([d.y, d.z, zero], [y, z, nil]);
    let of_b = |second: S::Unit, third: S::Unit| abs(S::Unit::dot3([second, third, nil], [y, z, nil]));
    let reach_a = S::dot3_unit([a.y, a.z, zero], [abs(y), abs(z), nil]);
    let reach_b = S::dot3_unit([b.y, b.z, zero], [of_b(second.y, third.y), of_b(second.z, third.z), nil]);
    let separation = abs(distance).minus(reach_a).minus(reach_b);
    if separation <= bound {
        return None;
    }
    let across = Vec3::new(nil, y, z);
    Some((if distance < zero { S::opposite(&across) } else { across }, separation))
}

pub(super) fn manifold<S: Scalar>(
    a: Placed<'_, S, Cuboid<S>>,
    b: Placed<'_, S, Cuboid<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    manifold_in_order(a, b, margin, out, ordered);
}

#[inline(never)]
fn ordered<S: Scalar>(
    (a, pose_a): Placed<'_, S, Cuboid<S>>,
    (b, pose_b): Placed<'_, S, Cuboid<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    let mut relative = Relative::new(pose_a, pose_b);
    let steady = min(a.inner_radius(), b.inner_radius()).lowered_by(STEADY);
    let half = [a.half_extents(), b.half_extents()];
    let Some((kind, separation)) = separating_axis(half, &relative, steady, margin) else { return };
    match kind {
        Axis::FaceOfA(axis) => {
            Faces { half, relative: &relative, axis, name: 0 }.manifold(pose_a, steady, margin, out);
        }
        Axis::FaceOfB(axis) => {
            relative.turn_round();
            let half = [half[1], half[0]];
            Faces { half, relative: &relative, axis, name: 1 << 12 }.manifold(pose_b, steady, margin, out);
            out.swap();
        }
        Axis::Edges(i, j, across) => crossing(half, pose_a, &relative, (i, j, across, separation), out),
    }
}

/// A face of one box, and the face of the other that looks at it.
struct Faces<'a, S: Scalar> {
    /// Of the box with the face, and of the other.
    half: [Vec3<S>; 2],
    /// The other seen from the first.
    relative: &'a Relative<S>,
    /// Of the face.
    axis: u8,
    /// Of which box it is.
    name: u16,
}

/// A side of a rectangle around the origin, of the x or the y axis.
struct Side<S> {
    along_x: bool,
    negative: bool,
    half: S,
}

impl<S: Scalar> Inside<S> for Side<S> {
    #[inline(always)]
    fn of(&self, place: Vec3<S>) -> S {
        let x = if self.along_x { place.x } else { place.y };
        if self.negative { self.half.plus(x) } else { self.half.minus(x) }
    }
}

impl<S: Scalar> Faces<'_, S> {
    /// `pose` is the first box's.
    #[inline(never)]
    fn manifold(&self, pose: &Pose<S>, steady: S, margin: S, out: &mut Manifold<S>) {
        let half = cycled(self.half[0], self.axis);
        let way = cycled(self.relative.in_a, self.axis);
        let below = way.x < S::ZERO;
        let mut polygon = Polygon::EMPTY;
        let incident = self.incident(way, half.x, below, &mut polygon);
        clip(&mut polygon, half, steady);
        polygon.name(LABEL_BITS, margin);
        let chosen = polygon.four(steady);
        let name = self.name | u16::from(self.axis) << 10 | u16::from(below) << 9 | incident << 6;
        self.put(pose, below, polygon.corners(), (chosen, name), out);
    }

    /// The chosen corners as points, in the world's axes.
    #[inline(never)]
    fn put(
        &self,
        pose: &Pose<S>,
        below: bool,
        corners: &[Corner<S>],
        (mut chosen, name): (u32, u16),
        out: &mut Manifold<S>,
    ) {
        let half = cycled(self.half[0], self.axis).x;
        // The normal, and the plane's axes.
        let [x, y, z] = turned(pose.rotation.columns(), self.axis);
        let normal = if below { S::opposite(&x) } else { x };
        out.begin(normal);
        let axes = Mat3 { rows: [normal, y, z] }.columns();
        for corner in corners {
            if chosen & 1 == 1 {
                let Vec3 { x: u, y: v, z: separation } = corner.place;
                let r = Vec3::new(half.plus(separation.lowered_by(1)), u, v).through(axes);
                out.push(point(r, self.relative.d, separation, name | corner.edge));
            }
            chosen >>= 1;
        }
    }

    /// The other's face that looks at this one, its corners by their places in this one's plane and heights above it; its name in
    /// three bits. `way` is to the other box, with the component along the axis of the face first.
    #[inline(never)]
    fn incident(&self, way: Vec3<S>, half: S, below: bool, polygon: &mut Polygon<S, 8>) -> u16 {
        let [x, y, z] = turned(self.relative.rotation.rows, self.axis);
        let (other, _) = largest(x.magnitudes());
        let [x, y, z] = [cycled(x, other), cycled(y, other), cycled(z, other)];
        let h = cycled(self.half[1], other);
        // Its axis on the side that looks against the normal.
        let towards = (x.x < S::Unit::ZERO) == below;
        let depth = if towards { h.x.negated() } else { h.x };
        // Height, then the plane's two.
        let edge = |h: S, x: S::Unit, y: S::Unit, z: S::Unit| {
            let height = h.times_unit(x);
            Vec3::new(h.times_unit(y), h.times_unit(z), if below { height.negated() } else { height })
        };
        let middle = Vec3::new(way.y, way.z, abs(way.x).minus(half)) + edge(depth, x.x, y.x, z.x);
        let (e, f) = (edge(h.y, x.y, y.y, z.y), edge(h.z, x.z, y.z, z.z));
        polygon.push(middle + e + f, 0);
        polygon.push(middle - e + f, 1);
        polygon.push(middle - e - f, 2);
        polygon.push(middle + e - f, 3);
        u16::from(other) << 1 | u16::from(towards)
    }
}

/// The three with that one first.
#[inline(always)]
fn turned<T: Copy>([x, y, z]: [T; 3], first: u8) -> [T; 3] {
    match first {
        0 => [x, y, z],
        1 => [y, z, x],
        _ => [z, x, y],
    }
}

/// Leaves the part of the polygon over the rectangle, whose half extents are the second and third.
fn clip<S: Scalar>(polygon: &mut Polygon<S, 8>, half: Vec3<S>, slack: S) {
    for &(label, along_x, negative) in &[(4, true, false), (5, true, true), (6, false, false), (7, false, true)] {
        polygon.cut(label, Side { along_x, negative, half: if along_x { half.y } else { half.z } }, slack);
    }
}

/// The edge of a box that goes farthest in a direction, of those along an axis; and which of the four it is.
fn edge<S: Scalar>(axis: u8, towards: Vec3<S::Unit>, half: Vec3<S>) -> (Vec3<S>, u16) {
    let (d, h) = (cycled(towards, axis), cycled(half, axis));
    let (y, z) = (d.y < S::Unit::ZERO, d.z < S::Unit::ZERO);
    let middle = Vec3::new(S::ZERO, if y { h.y.negated() } else { h.y }, if z { h.z.negated() } else { h.z });
    (uncycled(middle, axis), u16::from(y) << 1 | u16::from(z))
}

/// The two edges that cross, in A's frame, and their name.
fn crossing_edges<S: Scalar>(
    [a, b]: [Vec3<S>; 2],
    relative: &Relative<S>,
    (i, j, across): (u8, u8, Vec3<S::Unit>),
) -> ([Segment<S>; 2], u16) {
    let (one, nil) = (S::Unit::ONE, S::Unit::ZERO);
    let (middle_a, name_a) = edge(i, across, a);
    let of_a = Segment { middle: middle_a, axis: uncycled(Vec3::new(one, nil, nil), i), half: cycled(a, i).x };
    let (middle_b, name_b) = edge(j, S::opposite(&relative.rotation.transposed().times(across)), b);
    let axis = cycled(Vec3::from_array(relative.rotation.columns()), j).x;
    let middle = relative.in_a + middle_b.through(relative.rotation.rows);
    let of_b = Segment { middle, axis, half: cycled(b, j).x };
    ([of_a, of_b], 1 << 15 | u16::from(i) << 6 | u16::from(j) << 4 | name_a << 2 | name_b)
}

#[inline(never)]
fn crossing<S: Scalar>(
    half: [Vec3<S>; 2],
    pose_a: &Pose<S>,
    relative: &Relative<S>,
    (i, j, across, separation): (u8, u8, Vec3<S::Unit>, S),
    out: &mut Manifold<S>,
) {
    let ([a, b], name) = crossing_edges(half, relative, (i, j, across));
    out.begin(pose_a.rotation.times(across));
    out.push(point(pose_a.rotate(a.crossing(&b)), relative.d, separation, name));
}
