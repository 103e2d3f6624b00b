//! Several shapes on one body, and any other shape: part by part.

use crate::manifold::Manifold;
use crate::math::{Pose, Vec3, max};
use crate::scalar::Scalar;
use crate::shape::{Closest, Collide, Compound, ManifoldSink, Part, Shape};

/// By this share of what is computed with, as a power of two, distances may be off.
const SLACK: u32 = 18;

impl<S: Scalar, P: Collide<S, B>, B: Shape<S>> Collide<S, B> for Compound<'_, S, P> {
    fn collide<K: ManifoldSink<S>>(&self, pose: &Pose<S>, other: &B, other_pose: &Pose<S>, margin: S, sink: &mut K) {
        let near = Near::new(pose, other, other_pose);
        let (count, mut number) = (self.parts().len() as u32, 0u32);
        for part in self.parts() {
            if near.gap(part) <= margin {
                let way = pose.rotate(part.pose.position);
                let at = pose.times_at(way, &part.pose);
                let mut of_part = OfPart { sink: &mut *sink, way, count, number };
                part.shape.collide(&at, other, other_pose, margin, &mut of_part);
            }
            number = number.wrapping_add(1);
        }
    }

    fn closest(&self, pose: &Pose<S>, other: &B, other_pose: &Pose<S>) -> Option<Closest<S>> {
        let near = Near::new(pose, other, other_pose);
        let mut best: Option<Closest<S>> = None;
        for part in self.parts() {
            if best.is_some_and(|best| near.gap(part) >= best.separation) {
                continue;
            }
            let way = pose.rotate(part.pose.position);
            let at = pose.times_at(way, &part.pose);
            if let Some(found) = part.shape.closest(&at, other, other_pose)
                && best.is_none_or(|best| found.separation < best.separation)
            {
                best = Some(Closest { r_a: found.r_a + way, ..found });
            }
        }
        best
    }
}

impl<S: Scalar, P> Compound<'_, S, P> {
    /// [`Collide::collide`] with the compound as the second of the two.
    pub(crate) fn collide_as_b<A, K: ManifoldSink<S>>(
        &self,
        pose: &Pose<S>,
        (a, a_pose): (&A, &Pose<S>),
        margin: S,
        sink: &mut K,
    ) where
        Self: Collide<S, A>,
    {
        self.collide(pose, a, a_pose, margin, &mut Swapped { sink });
    }
}

/// Where the other shape is, as far as it bounds the distance of a part: a box in the compound's frame.
struct Near<S> {
    /// The middle and the half extents; `None` of what has no end.
    bounds: Option<[Vec3<S>; 2]>,
}

impl<S: Scalar> Near<S> {
    fn new(pose: &Pose<S>, other: &impl Shape<S>, other_pose: &Pose<S>) -> Self {
        // From the compound's origin: far out nothing is lost.
        let relative = Pose { position: other_pose.position - pose.position, rotation: other_pose.rotation };
        let aabb = other.aabb(&relative);
        if !aabb.is_bounded() {
            return Self { bounds: None };
        }
        let [middle, half] = aabb.middle_and_half();
        let [x, y, z] = pose.rotation.columns();
        let half_extents = half.through([x.magnitudes(), y.magnitudes(), z.magnitudes()]);
        let size = middle.magnitudes() + half;
        let slack = size.x.plus(size.y).plus(size.z).lowered_by(SLACK).plus(S::STEP.times_integer(4));
        Self { bounds: Some([pose.unrotate(middle), half_extents + Vec3::new(slack, slack, slack)]) }
    }

    /// No more than the distance to a part.
    #[inline]
    fn gap<P: Shape<S>>(&self, part: &Part<S, P>) -> S {
        let Some([middle, half]) = self.bounds else { return S::LARGEST.negated() };
        let Vec3 { x, y, z } = (part.pose.position - middle).magnitudes() - half;
        max(max(x, y), z).minus(part.shape.outer_radius())
    }
}

/// Takes the manifolds of a compound's part.
struct OfPart<'a, S, K> {
    sink: &'a mut K,
    /// From the compound's origin to the part's, in the world's axes.
    way: Vec3<S>,
    /// Of how many parts, and which of them.
    count: u32,
    number: u32,
}

impl<S: Scalar, K: ManifoldSink<S>> ManifoldSink<S> for OfPart<'_, S, K> {
    #[inline(always)]
    fn place(&mut self) -> &mut Manifold<S> {
        self.sink.place()
    }

    fn take(&mut self, part: u32) {
        self.sink.place().move_origins([self.way, Vec3::ZERO]);
        let inner = part >> 24;
        let number = inner.wrapping_mul(self.count).wrapping_add(self.number);
        self.sink.take(number << 24 | part & 0x00ff_ffff);
    }
}

/// Takes manifolds of shapes in the other order.
struct Swapped<'a, K> {
    sink: &'a mut K,
}

impl<S: Scalar, K: ManifoldSink<S>> ManifoldSink<S> for Swapped<'_, K> {
    #[inline(always)]
    fn place(&mut self) -> &mut Manifold<S> {
        self.sink.place()
    }

    fn take(&mut self, part: u32) {
        self.sink.place().swap();
        let (a, b) = (part >> 24, part >> 16 & 255);
        self.sink.take(b << 24 | a << 16 | part & 0xffff);
    }
}
