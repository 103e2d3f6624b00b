//! Segments: the cores of capsules, the edges of boxes.

use crate::math::{Vec3, abs, clamp, max, min};
use crate::scalar::{Scalar, Scaled};

/// A segment by its middle, the direction of its axis and half its length.
#[derive(Clone, Copy)]
pub(super) struct Segment<S: Scalar> {
    pub middle: Vec3<S>,
    pub axis: Vec3<S::Unit>,
    pub half: S,
}

impl<S: Scalar> Segment<S> {
    /// The point that far from the middle.
    #[inline(always)]
    pub fn at(&self, s: S) -> Vec3<S> {
        self.middle + Vec3::of_length(s, self.axis)
    }

    /// Where on the segment it comes closest to a point.
    #[inline(always)]
    pub fn project(&self, point: Vec3<S>) -> S {
        clamp((point - self.middle).along(self.axis), self.half)
    }

    /// Where on each of two segments they come closest to each other.
    ///
    /// On the lines through them, s = r . (u - (u . w) w) / (1 - (u . w)^2) for the way r from one middle to the other and the
    /// axes u and w. Clamped, it gives the place on the other one, and that, clamped, the place on this one: the squared
    /// distance is convex, and one of the two ends of this walk is its minimum. Where the axes are parallel up to rounding, the
    /// walk begins in the middle.
    #[inline(never)]
    pub fn closest(&self, other: &Self) -> [S; 2] {
        let r = other.middle - self.middle;
        let (u, w) = (self.axis, other.axis);
        let cosine = u.dot(w);
        let across =
            Vec3::new(u.x.minus(cosine.times(w.x)), u.y.minus(cosine.times(w.y)), u.z.minus(cosine.times(w.z)));
        let sine_square = S::Unit::ONE.minus(cosine.times(cosine)).to_scaled();
        let mut s = S::ZERO;
        if sine_square > S::Scaled::EPSILON + S::Scaled::EPSILON {
            let (x, _) = S::from_scaled(S::scaled_dot3(r.to_array(), across.to_array()) / sine_square);
            s = clamp(x, self.half);
        }
        let t = other.project(self.at(s));
        [self.project(other.at(t)), t]
    }

    /// Halfway between two segments where they are closest, also where one of them ends before it meets the other.
    pub fn crossing(&self, other: &Self) -> Vec3<S> {
        let [s, t] = self.closest(other);
        let from = self.at(s);
        let Vec3 { x, y, z } = other.at(t) - from;
        from + Vec3::new(x.lowered_by(1), y.lowered_by(1), z.lowered_by(1))
    }
}

/// The direction from a place on the first segment to one on the second, and the distance. `None` where they are one.
///
/// Where both places lie between the ends, the direction is that across both segments: the distance may be tiny, and the vector
/// between the two points mostly rounding.
#[inline]
pub(super) fn between<S: Scalar>(a: &Segment<S>, b: &Segment<S>, [s, t]: [S; 2]) -> Option<(Vec3<S::Unit>, S)> {
    let gap = b.at(t) - a.at(s);
    let inside = abs(s) < a.half && abs(t) < b.half;
    match S::Unit::direction3(a.axis.cross(b.axis).to_array()) {
        Some((across, sine)) if inside && sine > S::Unit::ONE.lowered_by(10) => {
            let across = Vec3::from_array(across);
            let length = gap.along(across);
            Some(if length < S::ZERO { (S::opposite(&across), length.negated()) } else { (across, length) })
        }
        _ => S::direction3(gap.to_array()).map(|(direction, length)| (Vec3::from_array(direction), length)),
    }
}

/// The part of the range with s u <= way.
pub(super) fn cut<S: Scalar>([low, high]: [S; 2], way: S, u: S::Unit) -> Option<[S; 2]> {
    match (low.times_unit(u) <= way, high.times_unit(u) <= way) {
        (true, true) => Some([low, high]),
        (false, false) => None,
        (keeps_low, _) => {
            let (s, _) = S::from_scaled(way.to_scaled() / u.to_scaled());
            let s = max(low, min(s, high));
            Some(if keeps_low { [low, s] } else { [s, high] })
        }
    }
}
