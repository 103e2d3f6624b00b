//! Convex polytopes as the narrow phase sees them: boxes and hulls.

use super::segment::Segment;
use super::{cycled, uncycled};
use crate::math::{Vec3, min};
use crate::scalar::Scalar;
use crate::shape::{ConvexHull, Cuboid};

/// A face's plane: the normal out of the polytope, and how far it is from the origin along it.
#[derive(Clone, Copy)]
pub(super) struct Plane<S: Scalar> {
    pub normal: Vec3<S::Unit>,
    pub offset: S,
}

/// An edge, with the normals of the faces on its left and its right seen from outside: its direction is that across them.
#[derive(Clone, Copy)]
pub(super) struct Edge<S: Scalar> {
    pub from: Vec3<S>,
    pub to: Vec3<S>,
    pub direction: Vec3<S::Unit>,
    pub sides: [Vec3<S::Unit>; 2],
}

impl<S: Scalar> Edge<S> {
    #[inline]
    pub fn segment(&self) -> Segment<S> {
        let half = (self.to - self.from).along(self.direction).lowered_by(1);
        Segment { middle: self.from + Vec3::of_length(half, self.direction), axis: self.direction, half }
    }
}

/// Corners, faces and edges, each by number from 0 on; `None` from where there are no more.
pub(super) trait Polytope<S: Scalar> {
    fn corner(&self, index: u8) -> Option<Vec3<S>>;
    fn face(&self, index: u8) -> Option<Plane<S>>;
    /// Counter-clockwise seen from outside.
    fn face_corner(&self, face: u8, index: u8) -> Option<Vec3<S>>;
    fn edge(&self, index: u8) -> Option<Edge<S>>;

    /// The least that a corner is along a direction.
    #[inline(never)]
    fn lowest(&self, direction: Vec3<S::Unit>) -> S {
        let mut lowest = S::LARGEST;
        let mut index = 0;
        while let Some(corner) = self.corner(index) {
            lowest = min(lowest, corner.along(direction));
            index = index.wrapping_add(1);
        }
        lowest
    }

    /// The face whose plane a point is highest above, and how high.
    #[inline(never)]
    fn highest_above(&self, point: Vec3<S>) -> (u8, S) {
        let mut best = (0, S::LARGEST.negated());
        let mut index = 0;
        while let Some(plane) = self.face(index) {
            let height = point.along(plane.normal).minus(plane.offset);
            if height > best.1 {
                best = (index, height);
            }
            index = index.wrapping_add(1);
        }
        best
    }

    /// Whether a point is over a face: to the left of all its sides.
    #[inline(never)]
    fn is_over(&self, face: u8, plane: &Plane<S>, point: Vec3<S>) -> bool {
        let Some(first) = self.face_corner(face, 0) else { return false };
        let (mut from, mut index) = (first, 1);
        loop {
            let next = self.face_corner(face, index);
            let to = next.unwrap_or(first);
            if let Some((along, _)) = S::direction3((to - from).to_array()) {
                let left = plane.normal.cross(Vec3::from_array(along));
                if (point - from).along(left) < S::ZERO {
                    return false;
                }
            }
            if next.is_none() {
                return true;
            }
            from = to;
            index = index.wrapping_add(1);
        }
    }
}

impl<S: Scalar, const N: usize> Polytope<S> for ConvexHull<S, N> {
    #[inline]
    fn corner(&self, index: u8) -> Option<Vec3<S>> {
        self.corners().get(usize::from(index)).copied()
    }

    #[inline]
    fn face(&self, index: u8) -> Option<Plane<S>> {
        let face = self.faces().get(usize::from(index))?;
        Some(Plane { normal: face.normal, offset: face.offset })
    }

    #[inline]
    fn face_corner(&self, face: u8, index: u8) -> Option<Vec3<S>> {
        let face = self.faces().get(usize::from(face))?;
        self.corner(*self.ring(face).get(usize::from(index))?)
    }

    #[inline]
    fn edge(&self, index: u8) -> Option<Edge<S>> {
        let edge = self.edges().get(usize::from(index))?;
        let ([from, to], [left, right]) = (edge.ends, edge.sides);
        Some(Edge {
            from: self.corner(from)?,
            to: self.corner(to)?,
            direction: edge.direction,
            sides: [self.face(left)?.normal, self.face(right)?.normal],
        })
    }
}

/// The direction of an axis, or its opposite.
fn axis<S: Scalar>(number: u8, negative: bool) -> Vec3<S::Unit> {
    let one = if negative { S::Unit::ONE.negated() } else { S::Unit::ONE };
    uncycled(Vec3::new(one, S::Unit::ZERO, S::Unit::ZERO), number)
}

fn signed<S: Scalar>(x: S, negative: bool) -> S {
    if negative { x.negated() } else { x }
}

/// The signs of the other two axes, counter-clockwise round the first.
fn around(index: u8) -> Option<(bool, bool)> {
    [(false, false), (true, false), (true, true), (false, true)].get(usize::from(index)).copied()
}

impl<S: Scalar> Polytope<S> for Cuboid<S> {
    #[inline]
    fn corner(&self, index: u8) -> Option<Vec3<S>> {
        let half = self.half_extents();
        let corner =
            Vec3::new(signed(half.x, index & 1 != 0), signed(half.y, index & 2 != 0), signed(half.z, index & 4 != 0));
        if index < 8 { Some(corner) } else { None }
    }

    #[inline]
    fn face(&self, index: u8) -> Option<Plane<S>> {
        let number = index >> 1;
        let plane = Plane { normal: axis::<S>(number, index & 1 != 0), offset: cycled(self.half_extents(), number).x };
        if index < 6 { Some(plane) } else { None }
    }

    #[inline]
    fn face_corner(&self, face: u8, index: u8) -> Option<Vec3<S>> {
        let (number, negative) = (face >> 1, face & 1 != 0);
        let half = cycled(self.half_extents(), number);
        // Seen from the other side, the other way round.
        let (y, z) = around(if negative { 3u8.wrapping_sub(index) } else { index })?;
        Some(uncycled(Vec3::new(signed(half.x, negative), signed(half.y, y), signed(half.z, z)), number))
    }

    #[inline]
    fn edge(&self, index: u8) -> Option<Edge<S>> {
        let (number, place) = (index >> 2, index & 3);
        let (y, z) = around(place).filter(|_| index < 12)?;
        let half = cycled(self.half_extents(), number);
        let end =
            |negative| uncycled(Vec3::new(signed(half.x, negative), signed(half.y, y), signed(half.z, z)), number);
        let [second, third] = [axis::<S>(next(number), y), axis::<S>(next(next(number)), z)];
        Some(Edge {
            from: end(true),
            to: end(false),
            direction: axis::<S>(number, false),
            sides: if y == z { [second, third] } else { [third, second] },
        })
    }
}

#[inline(always)]
fn next(axis: u8) -> u8 {
    if axis == 2 { 0 } else { axis.wrapping_add(1) }
}
