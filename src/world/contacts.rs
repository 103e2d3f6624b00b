//! What touches what, from step to step.

use super::World;
use super::handle::BodyHandle;
use super::slot::Slot;
use crate::scalar::{Scalar, Scaled};

/// A part of two surfaces, and where its impulses are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Key {
    pub a: u16,
    pub b: u16,
    /// Which part of the surfaces.
    pub part: u32,
    /// Where its impulses begin.
    pub first: u16,
    /// How many there are.
    pub points: u8,
    pub touching: bool,
}

impl Key {
    #[inline(always)]
    pub fn is_of(&self, a: u16, b: u16, part: u32) -> bool {
        self.a == a && self.b == b && self.part == part
    }

    #[inline(always)]
    pub fn holds(&self, index: u16) -> bool {
        self.a == index || self.b == index
    }

    /// The other body.
    #[inline(always)]
    pub fn partner(&self, index: u16) -> Option<u16> {
        if self.a == index {
            Some(self.b)
        } else if self.b == index {
            Some(self.a)
        } else {
            None
        }
    }
}

/// How a pair got into the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// The solver had it.
    Solved,
    /// One of the two notices, and stops nothing.
    Sensed,
    /// Neither moves: it is as it was.
    Kept,
}

/// A pair of surfaces that touch or are near.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry<S: Scalar> {
    pub key: Key,
    pub kind: Kind,
    pub touched_before: bool,
    /// Its place in the table of the step before, or `NO_FORMER`.
    pub former: u16,
    pub normal_impulse: S::Scaled,
    pub approach_speed: S,
}

/// A place that there is not: a table has 65,535 at most.
pub(super) const NO_FORMER: u16 = u16::MAX;

impl<S: Scalar> Entry<S> {
    pub const fn new(key: Key, kind: Kind, touched_before: bool, former: u16) -> Self {
        Self { key, kind, touched_before, former, normal_impulse: S::Scaled::ZERO, approach_speed: S::ZERO }
    }
}

/// What a contact does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Phase {
    /// The bodies did not touch before this step.
    Began,
    /// They did, and do.
    Persists,
    /// They do not any more.
    Ended,
}

/// Two bodies that touch, or did until this step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "S: serde::Serialize, S::Scaled: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de>, S::Scaled: serde::Deserialize<'de>"
    ))
)]
pub struct Touching<S: Scalar> {
    /// The bodies; the first has the lower place.
    pub bodies: [BodyHandle; 2],
    /// Which part of the surfaces: zero for convex shapes.
    pub part: u32,
    /// Whether it is new.
    pub phase: Phase,
    /// One of the two is a sensor.
    pub sensor: bool,
    /// The normal impulse in this step, N s.
    pub normal_impulse: S::Scaled,
    /// How fast the surfaces met in this step, m/s; zero where they did not meet in it, or no faster than bodies at rest do
    /// ([`Touch::approach`](crate::solver::Touch::approach)).
    pub approach_speed: S,
}

/// Looks for keys in the table of the step before, in whose order most of them come.
#[derive(Debug)]
pub(super) struct Finder {
    /// After where the last one was.
    next: usize,
}

impl Finder {
    pub const fn new() -> Self {
        Self { next: 0 }
    }

    /// Its place in the table, and the key. At most as many comparisons as there are keys; mostly one.
    pub fn find<'k>(&mut self, before: &'k [Key], a: u16, b: u16, part: u32) -> Option<(usize, &'k Key)> {
        let mut index = self.next;
        for _ in 0..before.len() {
            if index >= before.len() {
                index = 0;
            }
            let key = before.get(index)?;
            if key.is_of(a, b, part) {
                self.next = index.wrapping_add(1);
                return Some((index, key));
            }
            index = index.wrapping_add(1);
        }
        None
    }
}

fn touching<S: Scalar>(slots: &[Slot<S>], key: &Key, phase: Phase) -> Option<Touching<S>> {
    let (a, b) = (slots.get(usize::from(key.a))?, slots.get(usize::from(key.b))?);
    Some(Touching {
        bodies: [a.handle(key.a), b.handle(key.b)],
        part: key.part,
        phase,
        sensor: a.sensor || b.sensor,
        normal_impulse: S::Scaled::ZERO,
        approach_speed: S::ZERO,
    })
}

impl<S: Scalar, Sh, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
    World<S, Sh, BODIES, MANIFOLDS, POINTS>
{
    /// Everything that touches after the last step, in the order of the solver, then what does not any more.
    ///
    /// What has taken an impulse in the step touches, and a sensor what overlaps it.
    pub fn contacts(&self) -> impl Iterator<Item = Touching<S>> {
        let now = self.contacts.iter().filter(|entry| entry.key.touching).filter_map(|entry| {
            let phase = if entry.touched_before { Phase::Persists } else { Phase::Began };
            let touching = touching(&self.slots, &entry.key, phase)?;
            let Entry { normal_impulse, approach_speed, .. } = *entry;
            Some(Touching { normal_impulse, approach_speed, ..touching })
        });
        // A key that is left in the old table with that mark has found no successor that touches.
        let ended = self.before.iter().filter(|key| key.touching);
        now.chain(ended.filter_map(|key| touching(&self.slots, key, Phase::Ended)))
    }

    /// The contacts whose surfaces met in the last step: who hit whom, how fast and how hard.
    pub fn impacts(&self) -> impl Iterator<Item = Touching<S>> {
        self.contacts().filter(|contact| contact.approach_speed > S::ZERO)
    }
}
