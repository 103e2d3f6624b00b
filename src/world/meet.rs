//! From boxes that overlap to contacts in the solver.

use heapless::Vec;

use super::contacts::{Entry, Finder, Key, Kind, NO_FORMER};
use super::slot::Slot;
use super::way::{Found, LOOKS, Way};
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
    pub slots: &'w mut [Slot<S>],
    pub shapes: &'w [Sh],
    pub materials: &'w [Material<S>],
    pub poses: &'w [Pose<S>],
    pub before: &'w [Key],
    pub warm: &'w [WarmStart<S>],
    /// The length of the step.
    pub dt: S::Unit,
    /// Only the ways of fast bodies are looked at.
    pub scouting: bool,
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
    /// Of a fast pair.
    pub way: Option<Way<S>>,
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
        let poses = [self.poses.get(i)?, self.poses.get(j)?];
        let reach = slot_a.reach.plus(slot_b.reach);
        if self.scouting && reach == S::ZERO {
            return None;
        }
        self.pair = [a, b];
        self.senses = slot_a.sensor || slot_b.sensor;
        let size = min(slot_a.size, slot_b.size);
        if self.senses {
            return self.sense([shape_a, shape_b], poses, size);
        }
        if !(slot_a.is_awake() || slot_b.is_awake()) {
            return None;
        }
        if reach > S::ZERO {
            return self.meet_ahead([shape_a, shape_b], poses, size, reach);
        }
        self.material = mixed(self.materials.get(i)?, self.materials.get(j)?);
        shape_a.collide(poses[0], shape_b, poses[1], near(size), self);
        None
    }

    /// The same for a pair of which one is a sensor.
    #[inline(never)]
    fn sense(&mut self, [shape_a, shape_b]: [&Sh; 2], poses: [&Pose<S>; 2], size: S) -> Option<()> {
        self.sensed = false;
        if !self.scouting {
            shape_a.collide(poses[0], shape_b, poses[1], near(size), self);
        }
        if self.sensed {
            let former = self.former(0);
            self.enter(0, 0, Kind::Sensed, former);
        }
        None
    }

    /// The same for a pair of which one is fast: contacts are made where on their way the surfaces meet, and lengthened by the way
    /// there. After a body has been turned aside, its way is not known: what it may reach then has contacts as it is at the start of
    /// the step. They may hold it up beside a surface, but it does not pass through.
    #[inline(never)]
    fn meet_ahead(&mut self, [shape_a, shape_b]: [&Sh; 2], poses: [&Pose<S>; 2], size: S, reach: S) -> Option<()> {
        let [i, j] = [usize::from(self.pair[0]), usize::from(self.pair[1])];
        let velocity = |i: usize| self.step.bodies().get(i).map(|body| body.linear_velocity);
        let (slot_a, slot_b) = (self.slots.get(i)?, self.slots.get(j)?);
        let aside = min(slot_a.aside, slot_b.aside);
        let swing = slot_a.swing.plus(slot_b.swing);
        let exact = slot_a.ball || slot_b.ball;
        let mut way = Way::new([velocity(i)?, velocity(j)?], self.dt, [near(size).plus(swing), size], exact);
        let margin = near(size).plus(reach);
        let (mut found, mut looks) = (Found::Way, LOOKS);
        while found == Found::Way && looks > 0 {
            looks = looks.wrapping_sub(1);
            way.look();
            let [pose_a, pose_b] = way.poses(poses);
            self.way = Some(way);
            shape_a.collide(&pose_a, shape_b, &pose_b, margin, self);
            way = self.way.take()?;
            found = way.go_on();
        }
        if self.scouting {
            // What is only grazed, as the ground by a ball that rolls, turns nothing aside.
            if found == Found::Way || found == Found::Touch && way.blow() > size {
                for i in [i, j] {
                    let slot = self.slots.get_mut(i)?;
                    if slot.is_awake() {
                        slot.aside = min(slot.aside, way.at());
                    }
                }
            }
            return None;
        }
        if found == Found::Nothing && aside == S::Unit::ONE {
            return None;
        }
        way.stop(found != Found::Nothing && way.at() <= aside);
        self.material = mixed(self.materials.get(i)?, self.materials.get(j)?);
        let [pose_a, pose_b] = way.poses(poses);
        self.way = Some(way);
        shape_a.collide(&pose_a, shape_b, &pose_b, margin, self);
        self.way = None;
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
        if self.way.as_mut().is_some_and(|way| !way.take(self.manifold, part)) {
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
