//! A segment and a box, in the box's frame.

use super::point_cuboid::{direction, outside};
use super::segment::Segment;
use crate::math::{Vec3, abs};
use crate::scalar::{Scalar, Scaled};

/// Where a segment comes closest to a box.
#[derive(Clone, Copy)]
pub(super) struct Near<S: Scalar> {
    /// The point of the segment.
    pub point: Vec3<S>,
    /// From the box to it; zero where the segment meets the box.
    pub outside: Vec3<S>,
    /// The point lies between the ends of the segment.
    pub between: bool,
}

/// The least distance, exactly: half its square is convex along the segment, and its slope there, u . outside(p(s)), is a
/// straight line between the places where the segment crosses the planes of the faces. Six such places narrow down where
/// the slope crosses zero, and one division finds it.
#[inline(never)]
pub(super) fn nearest<S: Scalar>(segment: &Segment<S>, half: Vec3<S>) -> Near<S> {
    let (c, u) = (segment.middle, segment.axis);
    let mut range = [segment.half.negated(), segment.half];
    for &(c, u, h) in &[(c.x, u.x, half.x), (c.y, u.y, half.y), (c.z, u.z, half.z)] {
        narrow(&mut range, segment, half, (h.minus(c), u));
        narrow(&mut range, segment, half, (h.negated().minus(c), u));
    }
    // Between the two places, what is outside stays outside, and beyond the same faces.
    let [low, high] = range;
    let middle = low.lowered_by(1).plus(high.lowered_by(1));
    let out = outside(segment.at(middle), half);
    let active = |out: S, u: S::Unit| if out == S::ZERO { S::Unit::ZERO } else { u };
    let slopes = [active(out.x, u.x), active(out.y, u.y), active(out.z, u.z)];
    let square = S::Unit::dot3(slopes, slopes).to_scaled();
    let mut s = middle;
    if square > S::Scaled::ZERO {
        // The face's plane, on the side where the segment is.
        let plane = |out: S, h: S, c: S| (if out < S::ZERO { h.negated() } else { h }).minus(c);
        let way = [plane(out.x, half.x, c.x), plane(out.y, half.y, c.y), plane(out.z, half.z, c.z)];
        let (x, _) = S::from_scaled(S::scaled_dot3(way, slopes) / square);
        s = if x < low {
            low
        } else if x > high {
            high
        } else {
            x
        };
    }
    let point = segment.at(s);
    Near { point, outside: outside(point, half), between: abs(s) < segment.half }
}

/// Moves one end of the range to the place where c + s u = 0, if it lies within.
#[inline(never)]
fn narrow<S: Scalar>(range: &mut [S; 2], segment: &Segment<S>, half: Vec3<S>, (way, u): (S, S::Unit)) {
    let [low, high] = *range;
    if abs(way) >= segment.half.times_unit(abs(u)) {
        return;
    }
    let (s, _) = S::from_scaled(way.to_scaled() / u.to_scaled());
    if low < s && s < high {
        let rises = outside(segment.at(s), half).along(segment.axis) > S::ZERO;
        *range = if rises { [low, s] } else { [s, high] };
    }
}

impl<S: Scalar> Near<S> {
    /// The direction from the box to the segment, and the distance. `None` where they meet.
    ///
    /// Where a segment passes an edge, the direction is that across both: the distance may be tiny, and the vector between the
    /// two points mostly rounding.
    #[inline]
    pub fn direction(&self, axis: Vec3<S::Unit>) -> Option<(Vec3<S::Unit>, S)> {
        let v = self.outside;
        let nil = S::Unit::ZERO;
        let across = match (v.x == S::ZERO, v.y == S::ZERO, v.z == S::ZERO) {
            (true, false, false) => [nil, axis.z.negated(), axis.y],
            (false, true, false) => [axis.z, nil, axis.x.negated()],
            (false, false, true) => [axis.y.negated(), axis.x, nil],
            _ => [nil; 3],
        };
        // From 2^-10 on, a sine is good to more digits than the ratio of short ways.
        let wide = S::Unit::dot3(across, across) > S::Unit::ONE.lowered_by(20);
        match S::Unit::direction3(across) {
            Some((d, _)) if self.between && wide => {
                let d = Vec3::from_array(d);
                let length = v.along(d);
                Some(if length < S::ZERO { (S::opposite(&d), length.negated()) } else { (d, length) })
            }
            _ => direction(v),
        }
    }
}
