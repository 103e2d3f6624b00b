//! A step of the world, stage after stage.

use super::contacts::{Entry, Finder, Key, Kind, NO_FORMER};
use super::meet::{Meeting, near};
use super::slot::{Slot, State};
use super::wake::wake_island;
use super::{PLACES, World};
use crate::aabb::Aabb;
use crate::body::Body;
use crate::broad_phase::PairSink;
use crate::contact::Material;
use crate::math::{Pose, Vec3, min};
use crate::scalar::Scalar;
use crate::shape::{Collide, Shape};
use crate::solver::{Buffers, Constraints, Paused, Settings, Step, WarmStart, drive};

/// What a step has to say.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WorldReport {
    /// The points of contact that were solved.
    pub points: u16,
    /// The pairs of surfaces that they belong to, and those of sensors and sleeping bodies.
    pub manifolds: u16,
    /// Pairs of surfaces that were left out for lack of room: those bodies did not see each other in this step.
    pub dropped: u16,
    /// The bodies that sleep.
    pub asleep: u16,
    /// The bodies that took no part because a number in them is not finite.
    pub quarantined: u16,
    /// A position or velocity met the end of the format and stayed there.
    pub saturated: bool,
}

impl<S: Scalar, Sh: Collide<S, Sh>, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
    World<S, Sh, BODIES, MANIFOLDS, POINTS>
{
    /// Moves everything on by one step of `settings`.
    ///
    /// Never fails and never panics; the report says what could not be done. The order of pairs, and so every bit of the
    /// result, depends on the state of the world alone.
    pub fn step(&mut self, settings: &Settings<S>) -> WorldReport {
        let (paused, mut report) = self.begin(settings);
        self.finish(&paused, settings, &mut report);
        report
    }

    /// What comes before the sub-steps.
    pub(super) fn begin(&mut self, settings: &Settings<S>) -> (Paused<S>, WorldReport) {
        if self.gravity != settings.gravity {
            self.gravity = settings.gravity;
            self.wake_all();
        }
        let mut report = WorldReport::default();
        self.prepare(settings.dt, &mut report);
        (self.meet(settings, &mut report), report)
    }

    /// The sub-steps that are left, and what comes after them, in a frame of its own.
    #[inline(never)]
    pub(super) fn finish(&mut self, paused: &Paused<S>, settings: &Settings<S>, report: &mut WorldReport) {
        let buffers = Buffers { motions: &mut self.motions, manifolds: &mut self.manifolds, points: &mut self.points };
        let mut step = paused.resume(&mut self.bodies, buffers, settings);
        report.saturated = solve(&mut step, &mut self.warm, &mut self.contacts);
        end_others(&mut self.before, &self.contacts);
        self.drive(settings, report);
        if !self.sleepless {
            report.asleep = self.rest(settings);
        }
        report.manifolds = self.contacts.len() as u16;
    }

    /// Up to so many of the sub-steps that are left; how many are left then.
    pub(super) fn advance(&mut self, paused: &mut Paused<S>, settings: &Settings<S>, sub_steps: u8) -> u8 {
        let buffers = Buffers { motions: &mut self.motions, manifolds: &mut self.manifolds, points: &mut self.points };
        let mut step = paused.resume(&mut self.bodies, buffers, settings);
        let left = step.advance(sub_steps);
        *paused = step.pause();
        left
    }

    /// What comes before the solver, in a frame of its own.
    #[inline(never)]
    fn prepare(&mut self, dt: S::Unit, report: &mut WorldReport) {
        self.look(report);
        self.place(dt);
        if self.slots.iter().any(Slot::is_asleep) {
            self.rouse();
        }
        self.note_before();
        self.keep_sleeping();
    }

    /// What each body does in this step.
    fn look(&mut self, report: &mut WorldReport) {
        for (slot, body) in self.slots.iter_mut().zip(&self.bodies) {
            if matches!(slot.state, State::Vacant | State::Asleep) {
                continue;
            }
            slot.state = if body.check_motion().is_err() {
                report.quarantined = report.quarantined.wrapping_add(1);
                slot.touched = true;
                State::Quarantined
            } else if !body.is_immovable() {
                State::Awake
            } else if body.linear_velocity == Vec3::ZERO && body.angular_velocity == Vec3::ZERO {
                State::Fixed
            } else {
                State::Driven
            };
        }
    }

    /// Poses and boxes of what may have moved.
    fn place(&mut self, dt: S::Unit) {
        let parts = self.slots.iter_mut().zip(&self.bodies).zip(&self.shapes).zip(&mut self.poses).zip(&mut self.boxes);
        for ((((slot, body), shape), pose), bounds) in parts {
            if slot.is_active() || slot.touched {
                slot.touched = false;
                match slot.state {
                    State::Vacant => *bounds = Aabb::NOTHING,
                    State::Quarantined => (*bounds, slot.touched, slot.reach) = (Aabb::NOTHING, true, S::ZERO),
                    _ => place_body(slot, body, shape, dt, pose, bounds),
                }
            }
        }
    }

    /// Wakes what sleeps near something that moves.
    #[inline(never)]
    fn rouse(&mut self) {
        // A pass wakes an island at least.
        loop {
            let mut alarm = Alarm { slots: &mut self.slots, rang: false };
            self.sweep.sweep(&self.boxes, &mut alarm);
            if !alarm.rang {
                return;
            }
        }
    }

    fn note_before(&mut self) {
        self.before.clear();
        for entry in &self.contacts {
            // As many as there is room for in the other table. Field by field, or opt-level z calls `memmove` for each.
            let Key { a, b, part, first, points, touching } = entry.key;
            let _ = self.before.push(Key { a, b, part, first, points, touching });
        }
        self.contacts.clear();
    }

    /// Contacts of which neither body moves stay as they are, with their impulses, at the front of the table. What is in
    /// quarantine touches nothing.
    fn keep_sleeping(&mut self) {
        for key in &mut self.before {
            let (Some(a), Some(b)) = (self.slots.get(usize::from(key.a)), self.slots.get(usize::from(key.b))) else {
                continue;
            };
            if !(a.is_active() || b.is_active()) && a.meets(b) {
                let _ = self.contacts.push(Entry::new(*key, Kind::Kept, key.touching, NO_FORMER));
                key.touching = false;
            }
        }
    }

    fn drive(&mut self, settings: &Settings<S>, report: &mut WorldReport) {
        for (slot, body) in self.slots.iter().zip(&mut self.bodies) {
            if slot.is_driven() {
                report.saturated |= drive_body(body, settings);
            }
        }
    }

    /// From boxes to contacts, in a frame of its own.
    #[inline(never)]
    fn meet(&mut self, settings: &Settings<S>, report: &mut WorldReport) -> Paused<S> {
        let mut kept = 0usize;
        for entry in &self.contacts {
            kept = kept.wrapping_add(usize::from(entry.key.points));
        }
        let buffers = Buffers { motions: &mut self.motions, manifolds: &mut self.manifolds, points: &mut self.points };
        let mut step = begin(&mut self.bodies, buffers, settings, &self.slots);
        let mut meeting = Meeting {
            step: &mut step,
            slots: &mut self.slots,
            shapes: &self.shapes,
            materials: &self.materials,
            poses: &self.poses,
            before: &self.before,
            warm: &self.warm,
            dt: settings.dt,
            scouting: false,
            contacts: &mut self.contacts,
            finder: Finder::new(),
            points: kept,
            dropped: 0,
            pair: [0; 2],
            material: Material::DEAD,
            manifold: &mut self.manifold,
            senses: false,
            sensed: false,
            way: None,
        };
        if meeting.slots.iter().any(|slot| slot.reach > S::ZERO) {
            meeting.scouting = true;
            self.sweep.sweep(&self.boxes, &mut meeting);
            meeting.scouting = false;
        }
        self.sweep.sweep(&self.boxes, &mut meeting);
        report.dropped = meeting.dropped;
        report.points = meeting.points.wrapping_sub(kept) as u16;
        step.pause()
    }
}

/// Reads the velocities; what sleeps stays as it is.
#[inline(never)]
fn begin<'a, S: Scalar>(
    bodies: &'a mut [Body<S>],
    buffers: Buffers<'a, S>,
    settings: &'a Settings<S>,
    slots: &[Slot<S>],
) -> Step<'a, S> {
    let mut step = Step::begin(bodies, buffers, settings);
    for (slot, index) in slots.iter().zip(PLACES) {
        if matches!(slot.state, State::Asleep | State::Quarantined | State::Vacant) {
            step.hold(usize::from(index));
        }
    }
    step
}

/// Solves and moves the bodies. Whether a number met the end of the format.
#[inline(never)]
fn solve<S: Scalar>(step: &mut Step<'_, S>, warm: &mut [WarmStart<S>], contacts: &mut [Entry<S>]) -> bool {
    let solved = step.run();
    keep(step.constraints(), warm, contacts);
    solved.saturated
}

/// What the next step and the caller want to know of the contacts.
#[inline(never)]
fn keep<S: Scalar>(constraints: &mut Constraints<'_, S>, warm: &mut [WarmStart<S>], contacts: &mut [Entry<S>]) {
    let mut free = keep_impulses(warm, contacts);
    constraints.each_impulse(|impulse| {
        if let Some(place) = warm.get_mut(free) {
            *place = impulse;
        }
        free = free.wrapping_add(1);
    });
    let mut entries = contacts.iter_mut().filter(|entry| entry.kind == Kind::Solved);
    constraints.touches(|_, touch| {
        if let Some(entry) = entries.next() {
            entry.key.touching = touch.pushed;
            entry.normal_impulse = touch.impulse;
            entry.approach_speed = touch.approach;
        }
    });
}

/// Impulses of sleeping contacts move to the front: places before their own. The first place that is free.
fn keep_impulses<S: Scalar>(warm: &mut [WarmStart<S>], contacts: &mut [Entry<S>]) -> usize {
    let mut free = 0usize;
    for entry in contacts.iter_mut().take_while(|entry| entry.kind == Kind::Kept) {
        let first = usize::from(entry.key.first);
        entry.key.first = free as u16;
        for offset in 0..usize::from(entry.key.points) {
            if shift(warm, first.wrapping_add(offset), free) {
                free = free.wrapping_add(1);
            }
        }
    }
    free
}

/// Moves one of them to a place before it; whether there is one.
fn shift<S: Scalar>(warm: &mut [WarmStart<S>], from: usize, to: usize) -> bool {
    let Some((front, [kept, ..])) = warm.split_at_mut_checked(from) else { return false };
    if let Some(place) = front.get_mut(to) {
        copy(place, kept);
    }
    true
}

/// By references that do not overlap: else a copy is a call of `memmove`, which links 1.5 KB.
#[inline(never)]
fn copy<S: Scalar>(to: &mut WarmStart<S>, from: &WarmStart<S>) {
    *to = *from;
}

/// Few bodies are driven: not in the frame of the step.
#[inline(never)]
fn drive_body<S: Scalar>(body: &mut Body<S>, settings: &Settings<S>) -> bool {
    drive(body, settings)
}

/// Takes the mark of touching from old keys whose pair still touches: those that keep it have ended.
fn end_others<S: Scalar>(before: &mut [Key], contacts: &[Entry<S>]) {
    for entry in contacts.iter().filter(|entry| entry.key.touching) {
        if let Some(key) = before.get_mut(usize::from(entry.former)) {
            key.touching = false;
        }
    }
}

/// Where a body's shape is, and what it may reach in the step.
#[inline(never)]
fn place_body<S: Scalar, Sh: Shape<S>>(
    slot: &mut Slot<S>,
    body: &Body<S>,
    shape: &Sh,
    dt: S::Unit,
    pose: &mut Pose<S>,
    bounds: &mut Aabb<S>,
) {
    let outer = shape.outer_radius();
    slot.ball = outer == slot.size && outer < S::LARGEST;
    pose.position = body.position;
    // A ball looks the same from everywhere.
    if !slot.ball {
        pose.rotation = body.orientation().to_mat3();
    }
    let tight = shape.aabb(pose);
    (slot.reach, slot.swing, slot.aside) = (S::ZERO, S::ZERO, S::Unit::ONE);
    if slot.is_active() {
        // No turn brings the surface farther out than the ball around the shape: that of a ball nowhere.
        let mut swing = S::ZERO;
        if outer != slot.size {
            swing = min(body.angular_velocity.taxicab().times_unit(dt).times(outer), outer.minus(slot.size));
        }
        let way = body.linear_velocity.taxicab().times_unit(dt).plus(swing);
        // Slower ones may sink in by as much, and are pushed out.
        if way > slot.size {
            (slot.reach, slot.swing) = (way, swing);
        }
    }
    *bounds = tight.expanded(near(slot.size).plus(slot.reach));
}

/// Wakes the sleeping one of a pair of boxes if the other is loud.
struct Alarm<'a, S: Scalar> {
    slots: &'a mut [Slot<S>],
    rang: bool,
}

impl<S: Scalar> PairSink for Alarm<'_, S> {
    fn pair(&mut self, a: u16, b: u16) {
        let (Some(first), Some(second)) = (self.slots.get(usize::from(a)), self.slots.get(usize::from(b))) else {
            return;
        };
        if !first.meets(second) || first.sensor || second.sensor {
            return;
        }
        let sleeper = match (first.is_loud(), second.is_loud()) {
            (true, false) => b,
            (false, true) => a,
            _ => return,
        };
        self.rang |= wake_island(self.slots, sleeper);
    }
}
