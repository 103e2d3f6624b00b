//! Points that are pushed the same way, put together.

use super::{Gather, Touch};
use crate::manifold::{FeatureId, Manifold, ManifoldPoint};
use crate::math::{Pose, Vec3};
use crate::narrow_phase::clip::Polygon;
use crate::scalar::Scalar;
use crate::shape::ManifoldSink;

/// Ways in which parts of the surface push at once. With one more, the first of them is handed over before all its points may
/// have come.
const PATCHES: usize = 4;
/// Points of a patch; before there are more, four are chosen.
const POINTS: usize = 12;
/// Normals whose components differ by less than this power of two push the same way.
const SAME_WAY: u32 = 8;

#[derive(Clone, Copy)]
struct Patch<S: Scalar> {
    points: [Option<Touch<S>>; POINTS],
}

impl<S: Scalar> Patch<S> {
    const EMPTY: Self = Self { points: [None; POINTS] };

    fn normal(&self) -> Option<Vec3<S::Unit>> {
        self.points.first().copied().flatten().map(|touch| touch.normal)
    }

    fn pushes_like(&self, normal: Vec3<S::Unit>) -> bool {
        let least = S::Unit::ONE.lowered_by(SAME_WAY);
        self.normal().is_some_and(|own| {
            let Vec3 { x, y, z } = (own - normal).magnitudes();
            x < least && y < least && z < least
        })
    }

    fn add(&mut self, touch: Touch<S>) {
        // The same corner over a side of two triangles counts once.
        for point in self.points.iter_mut().flatten() {
            if point.feature == touch.feature && point.middle == touch.middle {
                return;
            }
        }
        if self.points.iter().all(Option::is_some) {
            self.choose();
        }
        if let Some(free) = self.points.iter_mut().find(|point| point.is_none()) {
            *free = Some(touch);
        }
    }

    /// Keeps up to four, at the front.
    fn choose(&mut self) {
        let mut polygon = Polygon::<S, POINTS>::EMPTY;
        for touch in self.points.iter().flatten() {
            polygon.push(Vec3::new(touch.middle.x, touch.middle.y, touch.separation), 0);
        }
        let chosen = polygon.four(S::STEP);
        let all = self.points;
        self.points = [None; POINTS];
        let mut bits = chosen;
        let mut free = self.points.iter_mut();
        for touch in all.iter().flatten() {
            if bits & 1 == 1 {
                if let Some(free) = free.next() {
                    *free = Some(*touch);
                }
            }
            bits >>= 1;
        }
    }
}

/// Where manifolds go, and what it takes to make them.
pub(super) struct Sink<'a, S: Scalar, K> {
    pub sink: &'a mut K,
    pub field_pose: &'a Pose<S>,
    /// Of the shape, in the field's frame.
    pub origin: Vec3<S>,
    /// From the shape's origin to the field's, in the world's axes.
    pub d: Vec3<S>,
    /// The field is A.
    pub mirrored: bool,
}

impl<S: Scalar, K: ManifoldSink<S>> Sink<'_, S, K> {
    fn hand_over(&mut self, patch: &mut Patch<S>) {
        let Some(normal) = patch.normal() else { return };
        patch.choose();
        let place: &mut Manifold<S> = self.sink.place();
        place.begin(S::opposite(&self.field_pose.rotation.times(normal)));
        for touch in patch.points.iter().flatten() {
            let r = self.field_pose.rotate(touch.middle - self.origin);
            let Touch { separation, feature, .. } = *touch;
            place.push(ManifoldPoint { r_a: r, r_b: r - self.d, separation, feature: FeatureId(feature) });
        }
        if self.mirrored {
            place.swap();
        }
        self.sink.take(part::<S>(normal));
        *patch = Patch::EMPTY;
    }
}

/// A name for what pushes in that direction: the horizontal components in 32nds.
fn part<S: Scalar>(normal: Vec3<S::Unit>) -> u32 {
    let steps = |d: S::Unit| {
        let half = S::ONE.lowered_by(1);
        S::ONE.times_unit(d).times_integer(32).plus(half).integer_below().wrapping_add(64) as u32 & 127
    };
    (steps(normal.x) << 7 | steps(normal.y)).wrapping_add(1)
}

/// The patches so far.
pub(super) struct Patches<'a, S: Scalar, K> {
    patches: [Patch<S>; PATCHES],
    sink: Sink<'a, S, K>,
}

impl<'a, S: Scalar, K: ManifoldSink<S>> Patches<'a, S, K> {
    pub fn new(sink: Sink<'a, S, K>) -> Self {
        Self { patches: [Patch::EMPTY; PATCHES], sink }
    }

    /// Hands over what there is.
    pub fn finish(mut self) {
        for patch in &mut self.patches {
            self.sink.hand_over(patch);
        }
    }
}

impl<S: Scalar, K: ManifoldSink<S>> Gather<S> for Patches<'_, S, K> {
    fn add(&mut self, touch: Touch<S>) {
        for patch in &mut self.patches {
            if patch.normal().is_none() || patch.pushes_like(touch.normal) {
                return patch.add(touch);
            }
        }
        let [first, ..] = &mut self.patches;
        self.sink.hand_over(first);
        first.add(touch);
    }
}
