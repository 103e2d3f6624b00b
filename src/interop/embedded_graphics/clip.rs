//! Lines and faces, cut to what the eye sees: before anything is divided by a distance.

use heapless::Vec;

use super::view::{PLANES, Plane, Seen, View};
use crate::math::Vec3;
use crate::scalar::{Scalar, Scaled};

/// Room for the corners of a face or outline, and one more for each plane that cuts it.
pub(super) const CORNERS: usize = 36;

/// Points in a ring.
pub(super) type Ring<S> = Vec<Seen<S>, CORNERS>;

impl<S: Scalar> View<S> {
    /// The part of a line that is seen.
    pub(super) fn cut_line(&self, [mut a, mut b]: [Seen<S>; 2]) -> Option<[Seen<S>; 2]> {
        for plane in PLANES {
            match [self.is_inside(&a, plane), self.is_inside(&b, plane)] {
                [true, true] => {}
                [true, false] => b = self.crossing(&a, &b, plane),
                [false, true] => a = self.crossing(&b, &a, plane),
                [false, false] => return None,
            }
        }
        Some([a, b])
    }

    /// Leaves of a convex ring what is seen: nothing, perhaps.
    pub(super) fn cut_ring(&self, ring: &mut Ring<S>) {
        let mut rest = Ring::<S>::new();
        for plane in PLANES {
            if ring.iter().all(|point| self.is_inside(point, plane)) {
                continue;
            }
            rest.clear();
            let mut before = ring.last().copied();
            for point in ring.iter() {
                if let Some(before) = before {
                    self.cut_side(&before, point, plane, &mut rest);
                }
                before = Some(*point);
            }
            core::mem::swap(ring, &mut rest);
        }
    }

    /// What a plane leaves of the way from a corner to the next one, without its beginning. A convex ring gains one corner at
    /// most, for which there is room.
    fn cut_side(&self, from: &Seen<S>, to: &Seen<S>, plane: Plane, rest: &mut Ring<S>) {
        match [self.is_inside(from, plane), self.is_inside(to, plane)] {
            [true, true] => _ = rest.push(*to),
            [true, false] => _ = rest.push(self.crossing(from, to, plane)),
            [false, true] => {
                let _ = rest.push(self.crossing(to, from, plane));
                let _ = rest.push(*to);
            }
            [false, false] => {}
        }
    }

    /// False of what is not finite, too.
    fn is_inside(&self, point: &Seen<S>, plane: Plane) -> bool {
        self.inside(point, plane) >= S::Scaled::ZERO
    }

    /// Where a line leaves a plane's side, always looked at from within: two faces see their common edge end at the same point.
    fn crossing(&self, within: &Seen<S>, outside: &Seen<S>, plane: Plane) -> Seen<S> {
        let here = self.inside(within, plane);
        let part = here / (here - self.inside(outside, plane));
        let at = |from: S::Scaled, to: S::Scaled| from + (to - from) * part;
        Vec3::new(at(within.x, outside.x), at(within.y, outside.y), at(within.z, outside.z))
    }
}
