//! Two capsules: a point where they cross, two where they lie along each other.

use super::round::Cores;
use super::segment::Segment;
use super::{Placed, closest_in_order, manifold_in_order, point};
use crate::manifold::Manifold;
use crate::math::{Vec3, max, min};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Closest};

/// Up to this sine squared, as a power of two, capsules lie along each other: 7 degrees. What is farther than the margin
/// then is no contact anyway.
const ALONG: u32 = 6;
/// A point between the two ends counts where it is deeper by this share of the smaller radius, as a power of two.
const DEEPER: u32 = 7;

pub(super) fn manifold<S: Scalar>(
    a: Placed<'_, S, Capsule<S>>,
    b: Placed<'_, S, Capsule<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    manifold_in_order(a, b, margin, out, ordered);
}

pub(super) fn closest<S: Scalar>(a: Placed<'_, S, Capsule<S>>, b: Placed<'_, S, Capsule<S>>) -> Closest<S> {
    closest_in_order(a, b, |a, b| Rods::new(a, b).cores().closest())
}

/// The cores of both, from the origin of the first.
struct Rods<S: Scalar> {
    a: Segment<S>,
    b: Segment<S>,
    radii: [S; 2],
}

impl<S: Scalar> Rods<S> {
    fn new((a, pose_a): Placed<'_, S, Capsule<S>>, (b, pose_b): Placed<'_, S, Capsule<S>>) -> Self {
        let ([_, _, u], [_, _, w]) = (pose_a.rotation.columns(), pose_b.rotation.columns());
        Self {
            a: Segment { middle: Vec3::ZERO, axis: u, half: a.half_length() },
            b: Segment { middle: pose_b.position - pose_a.position, axis: w, half: b.half_length() },
            radii: [a.radius(), b.radius()],
        }
    }

    fn cores(&self) -> Cores<S> {
        let [s, t] = self.a.closest(&self.b);
        let from_a = self.a.at(s);
        Cores { d: self.b.middle, from_a, gap: self.b.at(t) - from_a, radii: self.radii }
    }

    /// Where the part of A's core that lies beside B's begins and ends, if they lie along each other.
    fn shared(&self) -> Option<[S; 2]> {
        let cosine = self.a.axis.dot(self.b.axis);
        let one = S::Unit::ONE;
        if one.minus(cosine.times(cosine)) > one.lowered_by(ALONG) {
            return None;
        }
        let ends = [self.a.project(self.b.at(self.b.half)), self.a.project(self.b.at(self.b.half.negated()))];
        let [low, high] = [min(ends[0], ends[1]), max(ends[0], ends[1])];
        if low < high { Some([low, high]) } else { None }
    }
}

fn ordered<S: Scalar>(a: Placed<'_, S, Capsule<S>>, b: Placed<'_, S, Capsule<S>>, margin: S, out: &mut Manifold<S>) {
    let rods = Rods::new(a, b);
    rods.cores().manifold(margin, out);
    let Some(&crossing) = out.points().first() else { return };
    let Some(ends) = rods.shared() else { return };
    let normal = out.normal.get();
    let [radius_a, radius_b] = rods.radii;
    let mut deepest = S::LARGEST;
    out.clear();
    for &(feature, s) in &[(1, ends[0]), (2, ends[1])] {
        let from_a = rods.a.at(s);
        let gap = rods.b.at(rods.b.project(from_a)) - from_a;
        let separation = gap.along(normal).minus(radius_a).minus(radius_b);
        if separation <= margin {
            let r = from_a + Vec3::of_length(radius_a.plus(separation.lowered_by(1)), normal);
            out.push(point(r, rods.b.middle, separation, feature));
            deepest = min(deepest, separation);
        }
    }
    // Crossing at a small angle, they are deepest in between.
    if crossing.separation.plus(min(radius_a, radius_b).lowered_by(DEEPER)) < deepest {
        out.push(crossing);
    }
}
