//! From boxes that overlap to contacts in the solver.

use heapless::Vec;

use super::contacts::{Entry, Finder, Key, Kind, NO_FORMER};
use super::slot::Slot;
use crate::broad_phase::PairSink;
use crate::contact::{Material, RestitutionLaw};
use crate::manifold::Manifold;
use crate::math::{Pose, min};
use crate::scalar::Scalar;
use crate::shape::{Collide, ManifoldSink};
use crate::solver::{Step, WarmStart};

/// The part of a size within which surfaces count as near, as a power of two: 0.4 %.
const NEAR: u32 = 8;

/// How far around a shape of that size others count, before its motion.
#[inline(always)]
pub(super) fn near<S: Scalar>(size: S) -> S {
    size.lowered_by(NEAR)
}

/// Takes pairs of boxes, and adds what their shapes come to.
pub(super) struct Meeting<'w, 's, S: Scalar, Sh, const MANIFOLDS: usize> {
    pub step: &'w mut Step<'s, S>,
    pub slots: &'w [Slot<S>],
    pub shapes: &'w [Sh],
    pub materials: &'w [Material<S>],
    pub poses: &'w [Pose<S>],
    pub before: &'w [Key],
    pub warm: &'w [WarmStart<S>],
    pub contacts: &'w mut Vec<Entry<S>, MANIFOLDS, u16>,
    pub finder: Finder,
    /// The impulses kept so far.
    pub points: usize,
    pub dropped: u16,
    /// The pair at hand, and what is made of it.
    pub pair: [u16; 2],
    pub material: Material<S>,
    pub manifold: &'w mut Manifold<S>,
    /// One of the two is a sensor, and what it overlaps.
    pub senses: bool,
    pub sensed: bool,
}

impl<'w, S: Scalar, Sh: Collide<S, Sh>, const MANIFOLDS: usize> Meeting<'w, '_, S, Sh, MANIFOLDS> {
    #[inline(never)]
    fn meet(&mut self, a: u16, b: u16) -> Option<()> {
        let (i, j) = (usize::from(a), usize::from(b));
        let (slot_a, slot_b) = (self.slots.get(i)?, self.slots.get(j)?);
        if !(slot_a.is_active() || slot_b.is_active()) || !slot_a.meets(slot_b) {
            return None;
        }
        let (shape_a, shape_b) = (self.shapes.get(i)?, self.shapes.get(j)?);
        let (pose_a, pose_b) = (self.poses.get(i)?, self.poses.get(j)?);
        self.pair = [a, b];
        let mut margin = near(min(slot_a.size, slot_b.size));
        (self.senses, self.sensed) = (slot_a.sensor || slot_b.sensor, false);
        if !self.senses {
            if !(slot_a.is_awake() || slot_b.is_awake()) {
                return None;
            }
            self.material = mixed(self.materials.get(i)?, self.materials.get(j)?);
            margin = margin.plus(slot_a.reach).plus(slot_b.reach);
        }
        shape_a.collide(pose_a, shape_b, pose_b, margin, self);
        if self.sensed {
            let former = self.former(0);
            self.enter(0, 0, Kind::Sensed, former);
        }
        None
    }

    /// The pair in the step before.
    fn former(&mut self, part: u32) -> Option<(usize, &'w Key)> {
        let [a, b] = self.pair;
        self.finder.find(self.before, a, b, part)
    }

    /// Puts the pair into the table.
    fn enter(&mut self, part: u32, points: u8, kind: Kind, former: Option<(usize, &Key)>) {
        let [a, b] = self.pair;
        let (touched_before, former) = match former {
            Some((index, former)) => (former.touching, index as u16),
            None => (false, NO_FORMER),
        };
        let key = Key { a, b, part, first: self.points as u16, points, touching: kind == Kind::Sensed };
        if self.contacts.push(Entry::new(key, kind, touched_before, former)).is_err() {
            self.dropped = self.dropped.saturating_add(1);
        }
        self.points = self.points.wrapping_add(usize::from(points));
    }
}

impl<S: Scalar, Sh: Collide<S, Sh>, const MANIFOLDS: usize> PairSink for Meeting<'_, '_, S, Sh, MANIFOLDS> {
    fn pair(&mut self, a: u16, b: u16) {
        // Nothing to tell: what is left out does not meet.
        let _ = self.meet(a, b);
    }
}

impl<S: Scalar, Sh: Collide<S, Sh>, const MANIFOLDS: usize> ManifoldSink<S> for Meeting<'_, '_, S, Sh, MANIFOLDS> {
    #[inline(always)]
    fn place(&mut self) -> &mut Manifold<S> {
        self.manifold
    }

    #[inline(never)]
    fn take(&mut self, part: u32) {
        if self.senses {
            self.sensed |= self.manifold.points().iter().any(|point| point.separation <= S::ZERO);
            return;
        }
        let former = self.former(part);
        let warm = former.and_then(|(_, key)| {
            let first = usize::from(key.first);
            self.warm.get(first..first.saturating_add(usize::from(key.points)))
        });
        if self.contacts.is_full() || !self.step.add(self.pair, self.manifold, &self.material, warm.unwrap_or(&[])) {
            self.dropped = self.dropped.saturating_add(1);
            return;
        }
        self.enter(part, self.manifold.points().len() as u8, Kind::Solved, former);
    }
}

/// What two surfaces come to: the geometric means of their coefficients.
#[inline(always)]
fn mixed<S: Scalar>(a: &Material<S>, b: &Material<S>) -> Material<S> {
    let mix = |a, b| if a == b { a } else { mean(a, b) };
    let law = if a.law == RestitutionLaw::EnergySafe { a.law } else { b.law };
    Material::from_valid(mix(a.restitution(), b.restitution()), mix(a.friction(), b.friction())).with_law(law)
}

/// The root of a product.
#[inline(never)]
fn mean<S: Scalar>(a: S, b: S) -> S {
    S::from_scaled(crate::scalar::Scaled::sqrt(a.to_scaled() * b.to_scaled())).0
}
