//! A capsule beside a shape with flat faces: what its pairs with boxes and hulls share.

use super::polytope::Plane;
use super::segment::Segment;
use super::{Placed, point};
use crate::manifold::Manifold;
use crate::math::{Pose, UnitVec3, Vec3, abs};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Closest};

/// A normal whose cosine with a face's lacks less than this power of two of one, 1.3 degrees, is taken for the face's.
pub(super) const ALONG_FACE: u32 = 12;
/// A capsule whose axis leans less than this power of two out of a face, 3.6 degrees, lies along it.
const LYING: u32 = 4;

/// What is closest in the other shape's frame: the direction from that to the core of the capsule, how far away the core is
/// (negative where it pierces the shape), and the point of the core.
#[derive(Clone, Copy)]
pub(super) struct Core<S: Scalar> {
    pub normal: Vec3<S::Unit>,
    pub height: S,
    pub place: Vec3<S>,
}

/// A capsule in the frame of the other shape.
pub(super) struct Rod<'a, S: Scalar> {
    pub segment: Segment<S>,
    radius: S,
    /// Of the other shape.
    pose: &'a Pose<S>,
    /// From the capsule's origin to the other's, in the world's axes.
    d: Vec3<S>,
}

impl<'a, S: Scalar> Rod<'a, S> {
    #[inline(always)]
    pub fn new((capsule, capsule_pose): Placed<'_, S, Capsule<S>>, pose: &'a Pose<S>) -> Self {
        let d = pose.position - capsule_pose.position;
        let [_, _, axis] = capsule_pose.rotation.columns();
        let axis = pose.rotation.transposed().times(axis);
        let segment = Segment { middle: -pose.unrotate(d), axis, half: capsule.half_length() };
        Self { segment, radius: capsule.radius(), pose, d }
    }

    /// One point, or those of the part that lies over a face: `over_face` tells which part that is, if `core.normal` is a face's.
    pub fn manifold(
        &self,
        core: Core<S>,
        over_face: impl FnOnce(Vec3<S::Unit>) -> Option<(Plane<S>, [S; 2])>,
        margin: S,
        out: &mut Manifold<S>,
    ) {
        let separation = core.height.minus(self.radius);
        if separation > margin {
            return;
        }
        if lies_along(&self.segment, core.normal)
            && let Some((Plane { normal, offset }, ends)) = over_face(core.normal)
        {
            out.begin(self.down(normal));
            for &(feature, s) in &[(1, ends[0]), (2, ends[1])] {
                let end = self.segment.at(s);
                let separation = end.along(normal).minus(offset).minus(self.radius);
                if separation <= margin {
                    self.push(end, separation, feature, out);
                }
            }
        }
        if out.is_empty() {
            out.begin(self.down(core.normal));
            self.push(core.place, separation, 0, out);
        }
    }

    pub fn closest(&self, Core { normal, height, place }: Core<S>) -> Closest<S> {
        let down = self.down(normal);
        let from_a = self.pose.rotate(place) + self.d;
        Closest {
            normal: UnitVec3::from_unit(down),
            separation: height.minus(self.radius),
            r_a: from_a + Vec3::of_length(self.radius, down),
            r_b: from_a - self.d + Vec3::of_length(height, down),
        }
    }

    /// From the capsule to the other shape, in the world's axes.
    #[inline(always)]
    fn down(&self, normal: Vec3<S::Unit>) -> Vec3<S::Unit> {
        S::opposite(&self.pose.rotation.times(normal))
    }

    #[inline(never)]
    fn push(&self, place: Vec3<S>, separation: S, feature: u16, out: &mut Manifold<S>) {
        let down = out.normal.get();
        let r = self.pose.rotate(place) + self.d + Vec3::of_length(self.radius.plus(separation.lowered_by(1)), down);
        out.push(point(r, self.d, separation, feature));
    }
}

/// Whether a segment leans so little out of a plane that it lies along it.
#[inline(always)]
pub(super) fn lies_along<S: Scalar>(segment: &Segment<S>, normal: Vec3<S::Unit>) -> bool {
    abs(segment.axis.dot(normal)) <= S::Unit::ONE.lowered_by(LYING)
}
