//! What balls and rods look like: rings around them, as the eye sees their edge.

use core::ops::Range;

use super::clip::Ring;
use super::view::{Seen, View};
use crate::math::Vec3;
use crate::scalar::{Scalar, Scaled};

/// Cosines of a quarter of a turn in six parts, in 2^-30.
const COSINES: [i32; 7] = [1 << 30, 1_037_154_959, 929_887_697, 759_250_125, 536_870_912, 277_904_834, 0];
const QUARTER: usize = 6;
const HALF: usize = 2 * QUARTER;
const TURN: usize = 4 * QUARTER;

impl<S: Scalar> View<S> {
    /// The edge of a rod; of a ball, where both ends are the same. Empty from inside.
    pub(super) fn edge(&self, ends: [Vec3<S>; 2], radius: S) -> Ring<S> {
        let mut ring = Ring::<S>::new();
        let [a, b] = ends.map(|end| self.seen(end));
        let radius = radius.to_scaled();
        if self.rod([&a, &b], radius, &mut ring).is_none() {
            // Seen along its axis, one end hides the other.
            let nearest = if b.z < a.z { b } else { a };
            if let Some(circle) = self.circle(&nearest, radius) {
                circle.arc(&circle.any_frame(), 0..TURN, |_| true, &mut ring);
            }
        }
        ring
    }

    /// Parts of the circles of both ends, and between them the lines in which planes through the eye touch the rod. `None` where it
    /// is seen along its axis.
    fn rod(&self, [a, b]: [&Seen<S>; 2], radius: S::Scaled, ring: &mut Ring<S>) -> Option<()> {
        let axis = direction(&minus(b, a))?;
        let [left, right] = self.tangent_planes(a, &axis, radius)?.map(|normal| times(&normal, radius));
        let [here, there] = [self.circle(a, radius)?, self.circle(b, radius)?];
        let (from_here, from_there) = (here.frame(&axis)?, there.frame(&axis)?);

        // There is room for a turn in all, and for these four.
        let touch = minus(a, &left);
        let bound = here.along(&from_here, &touch);
        let _ = ring.push(touch);
        here.arc(&from_here, 0..TURN, |along| along < bound, ring);
        let _ = ring.push(minus(a, &right));
        let touch = minus(b, &right);
        let bound = there.along(&from_there, &touch);
        let _ = ring.push(touch);
        there.arc(&from_there, HALF..HALF + TURN, |along| along > bound, ring);
        let _ = ring.push(minus(b, &left));
        Some(())
    }

    /// The directions into the rod across the two planes through the eye that touch it. `None` where there are none.
    fn tangent_planes(&self, a: &Seen<S>, axis: &Seen<S>, radius: S::Scaled) -> Option<[Seen<S>; 2]> {
        if !self.is_perspective() {
            let aside = Vec3::new(axis.y, -axis.x, S::Scaled::ZERO);
            // Within a few degrees of the sight it is as good as a ball.
            let square = dot(&aside, &aside);
            let aside = if square < S::Scaled::from_parts(1, -10) { None } else { direction(&aside) }?;
            return Some([aside, times(&aside, -S::Scaled::ONE)]);
        }
        let way = minus(a, &times(axis, dot(a, axis)));
        let square = dot(&way, &way);
        let part = radius * radius / square;
        let rest = S::Scaled::ONE - part;
        if !rest.is_positive() {
            return None;
        }
        let ahead = times(&way, radius / square);
        let aside = times(&direction(&cross(axis, &way))?, rest.sqrt());
        Some([plus(&ahead, &aside), minus(&ahead, &aside)])
    }

    /// Where a ball is seen to end: all points whose tangents go through the eye. `None` from inside.
    fn circle(&self, centre: &Seen<S>, radius: S::Scaled) -> Option<Circle<S>> {
        if !self.is_perspective() {
            let ahead = Vec3::new(S::Scaled::ZERO, S::Scaled::ZERO, S::Scaled::ONE);
            return Some(Circle { centre: *centre, normal: ahead, radius });
        }
        let part = radius * radius / dot(centre, centre);
        let rest = S::Scaled::ONE - part;
        if !rest.is_positive() {
            return None;
        }
        let normal = direction(centre)?;
        Some(Circle { centre: times(centre, rest), normal, radius: radius * rest.sqrt() })
    }
}

/// A circle, and the direction across it.
struct Circle<S: Scalar> {
    centre: Seen<S>,
    normal: Seen<S>,
    radius: S::Scaled,
}

impl<S: Scalar> Circle<S> {
    /// Two directions in it: one as near as can be to that one, and the next one round.
    fn frame(&self, near: &Seen<S>) -> Option<[Seen<S>; 2]> {
        let across = direction(&cross(&self.normal, near))?;
        Some([cross(&across, &self.normal), across])
    }

    fn any_frame(&self) -> [Seen<S>; 2] {
        let (zero, one) = (S::Scaled::ZERO, S::Scaled::ONE);
        let square = self.normal.x * self.normal.x;
        let near = if square + square > one { Vec3::new(zero, one, zero) } else { Vec3::new(one, zero, zero) };
        // One axis or the other is not across the circle.
        self.frame(&near).unwrap_or([near, near])
    }

    /// How far a point is along the first direction of a frame, in radii.
    fn along(&self, [along, _]: &[Seen<S>; 2], point: &Seen<S>) -> S::Scaled {
        dot(&minus(point, &self.centre), along) / self.radius
    }

    /// Points of the circle in a frame, by their numbers, and by how far along they are.
    fn arc(
        &self,
        [along, across]: &[Seen<S>; 2],
        numbers: Range<usize>,
        keep: impl Fn(S::Scaled) -> bool,
        ring: &mut Ring<S>,
    ) {
        for number in numbers {
            let (cosine, sine) = turn::<S::Scaled>(number);
            if keep(cosine) {
                let way = plus(&times(along, cosine), &times(across, sine));
                let _ = ring.push(plus(&self.centre, &times(&way, self.radius)));
            }
        }
    }
}

/// Cosine and sine of a twenty-fourth of a turn, so many times.
fn turn<T: Scaled>(number: usize) -> (T, T) {
    let quarter = number % QUARTER;
    let part = |number: usize| T::from_parts(COSINES.get(number).copied().unwrap_or(0), -30);
    let (cosine, sine) = (part(quarter), part(QUARTER.wrapping_sub(quarter)));
    match number / QUARTER % 4 {
        0 => (cosine, sine),
        1 => (-sine, cosine),
        2 => (-cosine, -sine),
        _ => (sine, -cosine),
    }
}

fn plus<T: Scaled>(a: &Vec3<T>, b: &Vec3<T>) -> Vec3<T> {
    Vec3::new(a.x + b.x, a.y + b.y, a.z + b.z)
}

fn minus<T: Scaled>(a: &Vec3<T>, b: &Vec3<T>) -> Vec3<T> {
    Vec3::new(a.x - b.x, a.y - b.y, a.z - b.z)
}

fn times<T: Scaled>(a: &Vec3<T>, factor: T) -> Vec3<T> {
    Vec3::new(a.x * factor, a.y * factor, a.z * factor)
}

fn dot<T: Scaled>(a: &Vec3<T>, b: &Vec3<T>) -> T {
    a.x * b.x + a.y * b.y + a.z * b.z
}

fn cross<T: Scaled>(a: &Vec3<T>, b: &Vec3<T>) -> Vec3<T> {
    Vec3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}

/// `None` of zero.
fn direction<T: Scaled>(a: &Vec3<T>) -> Option<Vec3<T>> {
    let length = dot(a, a).sqrt();
    length.is_positive().then(|| Vec3::new(a.x / length, a.y / length, a.z / length))
}
