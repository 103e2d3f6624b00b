//! The distance of two boxes.
//!
//! Apart, two convex polytopes are closest at an edge of one, or at a corner of the other. So the twelve edges of A against
//! the solid B, and the eight corners of B against the solid A, find it.

use super::super::point_cuboid::{direction, outside};
use super::super::segment_cuboid::{Near, nearest};
use super::{Axis, Placed, Relative, Segment, closest_in_order, crossing_edges, cycled, separating_axis, uncycled};
use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;
use crate::shape::{Closest, Cuboid};

/// The signs of two half edges.
const SIGNS: [(bool, bool); 4] = [(false, false), (true, false), (true, true), (false, true)];

pub fn closest<S: Scalar>(a: Placed<'_, S, Cuboid<S>>, b: Placed<'_, S, Cuboid<S>>) -> Closest<S> {
    closest_in_order(a, b, ordered)
}

fn ordered<S: Scalar>((a, pose_a): Placed<'_, S, Cuboid<S>>, (b, pose_b): Placed<'_, S, Cuboid<S>>) -> Closest<S> {
    let relative = Relative::new(pose_a, pose_b);
    let half = [a.half_extents(), b.half_extents()];
    let overlap = separating_axis(half, &relative, S::ZERO, S::ZERO);
    let found = match overlap {
        Some((axis, separation)) => overlapping(half, &relative, axis, separation),
        None => apart(half, &relative),
    };
    let (normal, r_a) = (pose_a.rotation.times(found.normal), pose_a.rotate(found.from_a));
    Closest {
        normal: UnitVec3::from_unit(normal),
        separation: found.separation,
        r_a,
        r_b: r_a + Vec3::of_length(found.separation, normal) - relative.d,
    }
}

/// In A's frame: the normal, the separation, and the point of A.
struct Found<S: Scalar> {
    normal: Vec3<S::Unit>,
    separation: S,
    from_a: Vec3<S>,
}

/// The direction of an axis with the sign of that component.
fn signed_axis<S: Scalar>(axis: u8, along: S) -> Vec3<S::Unit> {
    let one = if along < S::ZERO { S::Unit::ONE.negated() } else { S::Unit::ONE };
    uncycled(Vec3::new(one, S::Unit::ZERO, S::Unit::ZERO), axis)
}

/// The corner of a box that goes farthest in a direction.
fn corner<S: Scalar>(half: Vec3<S>, towards: Vec3<S::Unit>) -> Vec3<S> {
    let signed = |h: S, d: S::Unit| if d < S::Unit::ZERO { h.negated() } else { h };
    Vec3::new(signed(half.x, towards.x), signed(half.y, towards.y), signed(half.z, towards.z))
}

fn overlapping<S: Scalar>(half: [Vec3<S>; 2], relative: &Relative<S>, axis: Axis<S>, separation: S) -> Found<S> {
    let [a, b] = half;
    let rotation = &relative.rotation;
    match axis {
        Axis::FaceOfA(axis) => {
            let normal = signed_axis(axis, cycled(relative.in_a, axis).x);
            let of_b = corner(b, S::opposite(&rotation.transposed().times(normal))).through(rotation.rows);
            let from_a = relative.in_a + of_b - Vec3::of_length(separation, normal);
            Found { normal, separation, from_a }
        }
        Axis::FaceOfB(axis) => {
            let normal = rotation.times(signed_axis(axis, cycled(relative.in_b, axis).x));
            Found { normal, separation, from_a: corner(a, normal) }
        }
        Axis::Edges(i, j, normal) => {
            let ([of_a, of_b], _) = crossing_edges(half, relative, (i, j, normal));
            let [s, _] = of_a.closest(&of_b);
            Found { normal, separation, from_a: of_a.at(s) }
        }
    }
}

fn apart<S: Scalar>(half: [Vec3<S>; 2], relative: &Relative<S>) -> Found<S> {
    let mut best = of_corners(half, relative);
    let [a, b] = half;
    let mut rows = relative.rotation.rows;
    let mut h = a;
    for _ in 0..3 {
        let [x, y, z] = rows;
        let (e, f) = (Vec3::of_length(h.y, y), Vec3::of_length(h.z, z));
        for &(minus_e, minus_f) in &SIGNS {
            let middle = (if minus_e { -e } else { e }) + (if minus_f { -f } else { f }) - relative.in_b;
            let edge = Segment { middle, axis: x, half: h.x };
            best = best.nearer(Candidate::of_edge(&edge, b));
        }
        rows = [y, z, x];
        h = h.cycled();
    }
    best.found(relative)
}

/// A pair of points that may be the closest.
#[derive(Clone, Copy)]
struct Candidate<S: Scalar> {
    square: S::Wide,
    kind: Kind<S>,
}

#[derive(Clone, Copy)]
enum Kind<S: Scalar> {
    /// A corner of B, and the way to it from A, in A's frame.
    Corner { point: Vec3<S>, outside: Vec3<S> },
    /// A point of an edge of A, in B's frame.
    Edge { near: Near<S>, axis: Vec3<S::Unit> },
}

/// The eight corners of B against A.
fn of_corners<S: Scalar>([a, b]: [Vec3<S>; 2], relative: &Relative<S>) -> Candidate<S> {
    let [x, y, z] = relative.rotation.columns();
    let [e, f, g] = [Vec3::of_length(b.x, x), Vec3::of_length(b.y, y), Vec3::of_length(b.z, z)];
    let mut best = Candidate::of_corner(relative.in_a + e + f + g, a);
    for &(minus_e, minus_f) in &SIGNS {
        let middle = relative.in_a + (if minus_e { -e } else { e }) + (if minus_f { -f } else { f });
        best = best.nearer(Candidate::of_corner(middle + g, a));
        best = best.nearer(Candidate::of_corner(middle - g, a));
    }
    best
}

impl<S: Scalar> Candidate<S> {
    fn new(way: Vec3<S>, kind: Kind<S>) -> Self {
        let way = way.to_array();
        Self { square: S::wide_dot3(way, way), kind }
    }

    fn of_corner(point: Vec3<S>, half: Vec3<S>) -> Self {
        let outside = outside(point, half);
        Self::new(outside, Kind::Corner { point, outside })
    }

    fn of_edge(edge: &Segment<S>, half: Vec3<S>) -> Self {
        let near = nearest(edge, half);
        Self::new(near.outside, Kind::Edge { near, axis: edge.axis })
    }

    fn nearer(self, other: Self) -> Self {
        if other.square < self.square { other } else { self }
    }

    /// Where they touch within rounding, no direction is better than another.
    fn found(&self, relative: &Relative<S>) -> Found<S> {
        match self.kind {
            Kind::Corner { point, outside } => {
                let (normal, separation) = direction(outside).unwrap_or((UnitVec3::<S>::Z.get(), S::ZERO));
                Found { normal, separation, from_a: point - outside }
            }
            Kind::Edge { near, axis } => {
                let (normal, separation) = near.direction(axis).unwrap_or((UnitVec3::<S>::Z.get(), S::ZERO));
                let normal = S::opposite(&relative.rotation.times(normal));
                Found { normal, separation, from_a: relative.in_a + near.point.through(relative.rotation.rows) }
            }
        }
    }
}
