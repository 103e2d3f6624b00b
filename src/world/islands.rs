//! Islands of bodies that touch, and their sleep.
//!
//! A body is still while it is slower than an eighth of its size a second and does not gain speed: what tips over an edge gains,
//! however slow it is. An island sleeps when all of it has been still for half a second and none of it lies on a driven body.

use super::contacts::{Entry, Kind};
use super::slot::Slot;
use super::{PLACES, World};
use crate::body::Body;
use crate::math::max;
use crate::scalar::Scalar;
use crate::solver::Settings;

/// Sizes a second, as a power of two.
const STILL: u32 = 3;
/// What of a speed is noise: units of the last place, and the part of the bound on it.
const NOISE: i32 = 16;
const PART: u32 = 10;

impl<S: Scalar, Sh, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
    World<S, Sh, BODIES, MANIFOLDS, POINTS>
{
    /// Puts to sleep what has been still for long enough, and returns how many bodies sleep.
    #[inline(never)]
    pub(super) fn rest(&mut self, settings: &Settings<S>) -> u16 {
        self.keep_carried_awake();
        let enough = settings.half_second;
        let (mut any, mut asleep) = (false, 0u16);
        for (slot, body) in self.slots.iter_mut().zip(&self.bodies) {
            if slot.is_awake() {
                count(slot, body, enough);
                any |= slot.still >= enough;
            }
            asleep = asleep.wrapping_add(u16::from(slot.is_asleep()));
        }
        if !any {
            return asleep;
        }
        self.join();
        // An island is as restless as its most restless body: its first one takes the least of them.
        for index in 0..self.slots.len() {
            let root = find(&self.slots, index as u16);
            let Some(slot) = self.slots.get_mut(index) else { continue };
            slot.island = root;
            let still = if slot.is_awake() { slot.still } else { u8::MAX };
            if let Some(first) = self.slots.get_mut(usize::from(root)) {
                first.still_together = first.still_together.min(still);
            }
        }
        for index in 0..self.slots.len() {
            let Some(slot) = self.slots.get(index) else { continue };
            let together = self.slots.get(usize::from(slot.island)).map_or(0, |first| first.still_together);
            if slot.is_awake() && together >= enough {
                self.lull(index);
                asleep = asleep.wrapping_add(1);
            }
        }
        asleep
    }

    /// What lies on a driven body goes along with it, however slowly.
    fn keep_carried_awake(&mut self) {
        for Entry { key, .. } in self.contacts.iter().filter(|entry| entry.key.touching && entry.kind == Kind::Solved) {
            let driven = |index: u16| self.slots.get(usize::from(index)).is_some_and(Slot::is_driven);
            let carried = match (driven(key.a), driven(key.b)) {
                (true, false) => key.b,
                (false, true) => key.a,
                _ => continue,
            };
            if let Some(slot) = self.slots.get_mut(usize::from(carried)) {
                slot.still = 0;
            }
        }
    }

    /// Every awake body finds the one with the lowest number that it touches, over others too.
    fn join(&mut self) {
        for (slot, index) in self.slots.iter_mut().zip(PLACES) {
            slot.still_together = u8::MAX;
            if !slot.is_asleep() {
                slot.island = index;
            }
        }
        for Entry { key, .. } in self.contacts.iter().filter(|entry| entry.key.touching) {
            let awake = |index: u16| self.slots.get(usize::from(index)).is_some_and(Slot::is_awake);
            if awake(key.a) && awake(key.b) {
                let (a, b) = (find(&self.slots, key.a), find(&self.slots, key.b));
                if let Some(slot) = self.slots.get_mut(usize::from(a.max(b))) {
                    slot.island = a.min(b);
                }
            }
        }
    }

    fn lull(&mut self, index: usize) {
        if let (Some(slot), Some(body)) = (self.slots.get_mut(index), self.bodies.get_mut(index)) {
            slot.fall_asleep();
            body.halt();
        }
    }
}

/// The lowest of the bodies that it hangs on: each link leads to a lower number, so that there are fewer than bodies.
fn find<S: Scalar>(slots: &[Slot<S>], index: u16) -> u16 {
    let mut at = index;
    while let Some(slot) = slots.get(usize::from(at)) {
        if slot.island >= at {
            break;
        }
        at = slot.island;
    }
    at
}

/// Counts the steps for which a body has been still. The first third of the time is for settling, in the second the speed is
/// watched, and in the last it must not be higher.
fn count<S: Scalar>(slot: &mut Slot<S>, body: &Body<S>, enough: u8) {
    let speed = body.linear_velocity.taxicab().plus(body.angular_velocity.taxicab().times(slot.size));
    let noise = S::STEP.times_integer(NOISE);
    let bound = slot.size.lowered_by(STILL).plus(noise);
    let (watched, judged) = (enough / 3, enough - enough / 3);
    if speed > bound {
        (slot.still, slot.fastest) = (0, S::ZERO);
        return;
    }
    if slot.still >= judged && speed > slot.fastest.plus(noise).plus(bound.lowered_by(PART)) {
        (slot.still, slot.fastest) = (watched, S::ZERO);
    }
    if slot.still >= watched && slot.still < judged {
        slot.fastest = max(slot.fastest, speed);
    }
    slot.still = slot.still.saturating_add(1);
}
