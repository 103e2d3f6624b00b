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
    points: [Touch<S>; POINTS],
    len: usize,
}

impl<S: Scalar> Patch<S> {
    const EMPTY: Self = Self { points: [Touch::NONE; POINTS], len: 0 };

    #[inline(always)]
    fn points(&self) -> &[Touch<S>] {
        self.points.get(..self.len).unwrap_or(&[])
    }

    #[inline(always)]
    fn normal(&self) -> Option<Vec3<S::Unit>> {
        self.points().first().map(|touch| touch.normal)
    }

    fn pushes_like(&self, normal: Vec3<S::Unit>) -> bool {
        let least = S::Unit::ONE.lowered_by(SAME_WAY);
        self.normal().is_some_and(|own| {
            let Vec3 { x, y, z } = (own - normal).magnitudes();
            x < least && y < least && z < least
        })
    }

    #[inline(never)]
    fn add(&mut self, touch: &Touch<S>) {
        // The same corner over a side of two triangles counts once.
        for point in self.points() {
            if point.feature == touch.feature && point.middle == touch.middle {
                return;
            }
        }
        if self.len == POINTS {
            self.choose();
        }
        if let Some(free) = self.points.get_mut(self.len) {
            *free = *touch;
            self.len = self.len.wrapping_add(1);
        }
    }

    /// Keeps up to four, at the front.
    #[inline(never)]
    fn choose(&mut self) {
        let mut polygon = Polygon::<S, POINTS>::EMPTY;
        for touch in self.points() {
            polygon.push(Vec3::new(touch.middle.x, touch.middle.y, touch.separation), 0);
        }
        let mut chosen = polygon.four(S::STEP);
        let mut kept = 0usize;
        for index in 0..self.len {
            let Some(&touch) = self.points.get(index) else { continue };
            if chosen & 1 == 1
                && let Some(place) = self.points.get_mut(kept)
            {
                *place = touch;
                kept = kept.wrapping_add(1);
            }
            chosen >>= 1;
        }
        self.len = kept;
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
    /// The patch, and empties it.
    #[inline(never)]
    fn hand_over(&mut self, patch: &mut Patch<S>) {
        let Some(normal) = patch.normal() else { return };
        patch.choose();
        let place: &mut Manifold<S> = self.sink.place();
        place.begin(S::opposite(&self.field_pose.rotation.times(normal)));
        for touch in patch.points() {
            let r = self.field_pose.rotate(touch.middle - self.origin);
            let Touch { separation, feature, .. } = *touch;
            place.push(ManifoldPoint { r_a: r, r_b: r - self.d, separation, feature: FeatureId(feature) });
        }
        if self.mirrored {
            place.swap();
        }
        self.sink.take(part::<S>(normal));
        patch.len = 0;
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
    #[inline(always)]
    pub fn new(sink: Sink<'a, S, K>) -> Self {
        Self { patches: [Patch::EMPTY; PATCHES], sink }
    }

    /// Hands over what there is.
    #[inline(always)]
    pub fn finish(&mut self) {
        for patch in &mut self.patches {
            self.sink.hand_over(patch);
        }
    }
}

impl<S: Scalar, K: ManifoldSink<S>> Gather<S> for Patches<'_, S, K> {
    #[inline(never)]
    fn add(&mut self, touch: &Touch<S>) {
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
