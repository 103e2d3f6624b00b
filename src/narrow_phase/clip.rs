//! Clipping a face of one shape by the sides of a face of another, and choosing four points of what is left.

use crate::math::{Vec3, min};
use crate::scalar::Scalar;

/// A corner of a polygon that lies over a face: two coordinates in the face's plane, and the height above it.
#[derive(Clone, Copy)]
pub(super) struct Corner<S> {
    /// x and y in the plane, z the height.
    pub place: Vec3<S>,
    /// What leads on to the next corner: an edge of the polygon, or a side of the face.
    pub edge: u16,
}

/// A convex polygon of up to N corners.
#[derive(Clone, Copy)]
pub(super) struct Polygon<S, const N: usize> {
    corners: [Corner<S>; N],
    len: u8,
}

impl<S: Scalar, const N: usize> Polygon<S, N> {
    pub const EMPTY: Self = Self { corners: [Corner { place: Vec3::ZERO, edge: 0 }; N], len: 0 };

    /// Adds a corner. One more than there is room for is left out: each side that cuts a convex polygon adds one at most.
    #[inline]
    pub fn push(&mut self, place: Vec3<S>, edge: u16) {
        if let Some(free) = self.corners.get_mut(usize::from(self.len)) {
            *free = Corner { place, edge };
            self.len = self.len.wrapping_add(1);
        }
    }

    #[inline(always)]
    pub fn corners(&self) -> &[Corner<S>] {
        self.corners.get(..usize::from(self.len)).unwrap_or(&[])
    }

    /// Keeps what lies inside one side of the face (Sutherland and Hodgman, 1974), whose number is `side`.
    ///
    /// Where no corner is farther outside than `slack`, all is kept as it is: boxes that stand on each other edge over edge are
    /// not cut, nor their corners renamed, by the noise in their places.
    #[inline(never)]
    pub fn cut(&mut self, side: u16, inside: impl Inside<S>, slack: S) {
        let outermost = slack.negated();
        if self.corners().iter().all(|corner| inside.of(corner.place) >= outermost) {
            return;
        }
        // What is left is written from the front, and what there was is read from the end of the memory: no second polygon.
        let mut next = self.move_to_end();
        let Some(&(mut before)) = self.corners.last() else { return };
        let mut before_in = inside.of(before.place);
        self.len = 0;
        while let Some(&corner) = self.corners.get(next) {
            next = next.wrapping_add(1);
            let corner_in = inside.of(corner.place);
            match (before_in >= S::ZERO, corner_in >= S::ZERO) {
                (true, false) => self.push_below(next, between(&before, &corner, before_in, corner_in), side),
                (false, true) => self.push_below(next, between(&before, &corner, before_in, corner_in), before.edge),
                _ => {}
            }
            if corner_in >= S::ZERO {
                self.push_below(next, corner.place, corner.edge);
            }
            (before, before_in) = (corner, corner_in);
        }
    }

    /// Moves the corners to the end of the memory, and returns where they begin.
    fn move_to_end(&mut self) -> usize {
        let (mut from, mut to) = (usize::from(self.len), N);
        while let Some(&corner) = self.corners.get(from.wrapping_sub(1)) {
            (from, to) = (from.wrapping_sub(1), to.wrapping_sub(1));
            if let Some(place) = self.corners.get_mut(to) {
                *place = corner;
            }
        }
        to
    }

    /// Adds a corner where none is that has yet to be read: the more there were, the fewer a convex polygon leaves room to add.
    #[inline(always)]
    fn push_below(&mut self, next: usize, place: Vec3<S>, edge: u16) {
        if usize::from(self.len) < next {
            self.push(place, edge);
        }
    }
}

/// How far inside a side of the face a place is.
pub(super) trait Inside<S> {
    fn of(&self, place: Vec3<S>) -> S;
}

/// Where the way between two corners on different sides crosses the line.
#[inline(never)]
fn between<S: Scalar>(a: &Corner<S>, b: &Corner<S>, a_in: S, b_in: S) -> Vec3<S> {
    let (part, rest) = if a_in < S::ZERO { (a_in.negated(), b_in) } else { (a_in, b_in.negated()) };
    let share = S::fraction(part, part.plus(rest));
    let way = b.place - a.place;
    a.place + Vec3::new(way.x.times_unit(share), way.y.times_unit(share), way.z.times_unit(share))
}

impl<S: Scalar, const N: usize> Polygon<S, N> {
    /// Keeps the corners no higher than `margin`, each with the name of the edges that meet there: `bits` bits for each of the
    /// two.
    pub fn name(&mut self, bits: u32, margin: S) {
        let Some(mut before) = self.corners().last().map(|corner| corner.edge) else { return };
        let mut kept = 0usize;
        for index in 0..usize::from(self.len) {
            let Some(&Corner { place, edge }) = self.corners.get(index) else { continue };
            if place.z <= margin {
                if let Some(free) = self.corners.get_mut(kept) {
                    *free = Corner { place, edge: before.wrapping_shl(bits) | edge };
                }
                kept = kept.wrapping_add(1);
            }
            before = edge;
        }
        self.len = kept as u8;
    }

    /// A bit for each of up to four corners that hold the others best: the deepest (of those as deep to within `tolerance` the
    /// first), the one farthest from it, the one farthest from the line through both, and the one farthest outside the
    /// triangle of the three.
    pub fn four(&self, tolerance: S) -> u32 {
        let corners = self.corners();
        if corners.len() <= 4 {
            return 15;
        }
        let mut lowest = S::LARGEST;
        for corner in corners {
            lowest = min(lowest, corner.place.z);
        }
        let bound = lowest.plus(tolerance);
        let (first, a) = first_below(corners, bound);
        let (second, b) = largest(corners, |p| square(a, p));
        let (left, c) = largest(corners, |p| area(a, b, p));
        let (right, e) = largest(corners, |p| area(b, a, p));
        // Counter-clockwise.
        let (third, [a, b, c]) = if area(a, b, c) >= area(b, a, e) { (left, [a, b, c]) } else { (right, [b, a, e]) };
        let (fourth, _) = largest(corners, |p| {
            let (ab, bc, ca) = (area(b, a, p), area(c, b, p), area(a, c, p));
            let larger = if ab < bc { bc } else { ab };
            if larger < ca { ca } else { larger }
        });
        first | second | third | fourth
    }
}

/// The first corner no higher than that: its bit and its place. There is one, unless a height is a NaN.
fn first_below<S: Scalar>(corners: &[Corner<S>], bound: S) -> (u32, Vec3<S>) {
    let mut bit = 1u32;
    for corner in corners {
        if corner.place.z <= bound {
            return (bit, corner.place);
        }
        bit = bit.wrapping_shl(1);
    }
    (1, Vec3::ZERO)
}

/// The corner with the largest measure, the first of them: its bit and its place. There is one.
#[inline(always)]
fn largest<S: Scalar>(corners: &[Corner<S>], measure: impl Fn(Vec3<S>) -> S::Wide) -> (u32, Vec3<S>) {
    let mut best = (1, Vec3::ZERO);
    let mut largest = None;
    let mut bit = 1u32;
    for corner in corners {
        let measured = measure(corner.place);
        if largest.is_none_or(|largest| measured > largest) {
            largest = Some(measured);
            best = (bit, corner.place);
        }
        bit = bit.wrapping_shl(1);
    }
    best
}

/// The squared distance of two places in the plane.
#[inline(never)]
fn square<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> S::Wide {
    let way = [b.x.minus(a.x), b.y.minus(a.y), S::ZERO];
    S::wide_dot3(way, way)
}

/// Twice the area of a triangle in the plane, positive where it is counter-clockwise.
#[inline(never)]
fn area<S: Scalar>(a: Vec3<S>, b: Vec3<S>, c: Vec3<S>) -> S::Wide {
    S::wide_det2(b.x.minus(a.x), b.y.minus(a.y), c.x.minus(a.x), c.y.minus(a.y))
}
