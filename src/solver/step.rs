//! One step over the caller's bodies.

use super::integrate::{lift, store, store_velocity};
use super::motion::Part;
use super::prepare::Frame;
use super::settings::Settings;
use super::stages::{Buffers, Constraints};
use super::warm_start::{Kept, WarmStart};
use crate::body::Body;
use crate::contact::{Material, RestitutionLaw};
use crate::manifold::Manifold;
use crate::math::{Vec3, max};
use crate::scalar::{Scalar, Scaled, StepArithmetic};

type Places<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Places;

/// Places to spare above the fastest body, for the spin that friction gives it and for those that it strikes; above the fastest
/// spin; and above what gravity adds in a sub-step, for the impulses under a pile. Sums over sub-steps come on top.
const HEAD_OF_SPEEDS: u32 = 3;
const HEAD_OF_SPINS: u32 = 1;
const HEAD_OF_GRAVITY: u32 = 10;

/// A step in the making: contacts are added, then it is [finished](Self::finish), at once or [part](Self::advance) by part.
#[derive(Debug)]
pub struct Step<'a, S: Scalar> {
    constraints: Constraints<'a, S>,
    settings: &'a Settings<S>,
    report: StepReport,
    /// Sub-steps so far.
    done: u8,
}

/// A step between two of its parts, without the memory that it works in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Paused<S: Scalar> {
    manifolds: usize,
    points: usize,
    places: Places<S>,
    fall: Vec3<S>,
    noise: S,
    bounces: bool,
    report: StepReport,
    done: u8,
}

impl<S: Scalar> Paused<S> {
    /// Goes on, with the same bodies, memory and settings.
    pub(crate) fn resume<'a>(
        &self,
        bodies: &'a mut [Body<S>],
        buffers: Buffers<'a, S>,
        settings: &'a Settings<S>,
    ) -> Step<'a, S> {
        let Self { manifolds, points, places, fall, noise, bounces, report, done } = *self;
        let constraints = Constraints { bodies, buffers, manifolds, points, places, fall, noise, bounces };
        Step { constraints, settings, report, done }
    }
}

/// What a step has to say.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StepReport {
    /// A position or velocity met the end of the format.
    pub saturated: bool,
    /// Bodies with an infinity or NaN in their state: they stayed as they are and touched nothing.
    pub not_finite: u16,
}

impl<'a, S: Scalar> Step<'a, S> {
    /// Reads the velocities of the bodies. Bodies beyond the motions stay where they are.
    pub fn begin(bodies: &'a mut [Body<S>], buffers: Buffers<'a, S>, settings: &'a Settings<S>) -> Self {
        let gain = |g, places| S::Step::gain(g, settings.h, places);
        let g = settings.gravity;
        let fall =
            Vec3::new(gain(g.x, S::Step::NO_PLACES), gain(g.y, S::Step::NO_PLACES), gain(g.z, S::Step::NO_PLACES));
        let sum = u32::from(settings.sub_steps).next_power_of_two().trailing_zeros();
        let mut report = StepReport::default();
        let mut places = S::Step::fit(S::Step::MOST_PLACES, &fall, S::Step::NO_PLACES, HEAD_OF_GRAVITY);
        let mut motions = buffers.motions.iter_mut();
        for body in bodies.iter() {
            let Some(motion) = motions.next() else { break };
            motion.take_up(body);
            if motion.part == Part::Lost {
                report.not_finite = report.not_finite.saturating_add(1);
                continue;
            }
            places = S::Step::fit(places, &body.linear_velocity, S::Step::NO_PLACES, sum.wrapping_add(HEAD_OF_SPEEDS));
            if motion.moves() {
                places = S::Step::fit(places, &body.angular_velocity, motion.size, sum.wrapping_add(HEAD_OF_SPINS));
            } else if body.angular_velocity != Vec3::ZERO {
                let speed = Vec3::new(surface_speed(body, bodies), S::ZERO, S::ZERO);
                places = S::Step::fit(places, &speed, S::Step::NO_PLACES, sum.wrapping_add(HEAD_OF_SPEEDS));
            }
        }
        let mut motions = buffers.motions.iter_mut();
        for body in bodies.iter() {
            let Some(motion) = motions.next() else { break };
            if motion.moves() {
                lift(body, motion, places);
            }
        }
        let fall = Vec3::new(gain(g.x, places), gain(g.y, places), gain(g.z, places));
        let push_out_speed = S::Step::lift(settings.push_out_speed, S::Step::NO_REST, places);
        let noise = S::Step::times(push_out_speed, S::Unit::from_scaled(S::Scaled::ratio(1, 1000)).0);
        let constraints = Constraints { bodies, buffers, manifolds: 0, points: 0, places, fall, noise, bounces: false };
        Self { constraints, settings, report, done: 0 }
    }

    /// Keeps a body as it is in this step: it counts as one that nothing moves, and as if it had no velocity. To be called
    /// before contacts are added.
    pub fn hold(&mut self, index: usize) {
        if let Some(motion) = self.constraints.buffers.motions.get_mut(index)
            && motion.part != Part::Lost
        {
            motion.part = Part::Held;
        }
    }

    /// The bodies as they were before the step.
    pub fn bodies(&self) -> &[Body<S>] {
        self.constraints.bodies
    }

    /// Adds the manifold between the bodies `a` and `b`. Points with the feature of one in `warm`, or near one whose
    /// feature is gone, start with its impulses.
    ///
    /// False where nothing was added for lack of room. (Nor is anything added, or missed, where neither body moves, or for bodies
    /// that are not there or not finite.)
    pub fn add(
        &mut self,
        [a, b]: [u16; 2],
        manifold: &Manifold<S>,
        material: &Material<S>,
        warm: &[WarmStart<S>],
    ) -> bool {
        let Constraints { bodies, buffers, manifolds, points, places, bounces, .. } = &mut self.constraints;
        let find = |i: u16| {
            let body = bodies.get(usize::from(i))?;
            buffers.motions.get(usize::from(i)).map(|motion| (body, motion.size, motion.part, motion.uneven))
        };
        let (Some((body_a, size_a, part_a, uneven_a)), Some((body_b, size_b, part_b, uneven_b))) = (find(a), find(b))
        else {
            return true;
        };
        if part_a == Part::Lost || part_b == Part::Lost {
            return true;
        }
        let (a_moves, b_moves) = (part_a == Part::Moves, part_b == Part::Moves);
        let count = manifold.points().len();
        if count == 0 || a == b || !(a_moves || b_moves) {
            return true;
        }
        let Ok(first) = u16::try_from(*points) else { return false };
        let free = buffers.points.get_mut(*points..points.wrapping_add(count));
        let (Some(slots), Some(slot)) = (free, buffers.manifolds.get_mut(*manifolds)) else { return false };
        // The second body is one that moves.
        let swapped = !b_moves;
        let normal = if swapped { -manifold.normal } else { manifold.normal };
        let tangents: [_; 2] = normal.tangents().into();
        let frame = Frame {
            a: (a_moves && b_moves).then_some((body_a, size_a)),
            b: if swapped { (body_a, size_a) } else { (body_b, size_b) },
            driven: match (part_a, part_b) {
                (Part::Immovable, _) => Some(body_a),
                (_, Part::Immovable) => Some(body_b),
                _ => None,
            },
            normal,
            tangents,
            friction: material.friction(),
            inv_h: self.settings.inv_h,
            places: *places,
            even: !(a_moves && uneven_a || b_moves && uneven_b),
        };
        let mut kept = Kept::new(warm, manifold.points());
        let mut slots = slots.iter_mut();
        for point in manifold.points() {
            let Some(slot) = slots.next() else { break };
            let r = if swapped { [&point.r_b, &point.r_a] } else { [&point.r_a, &point.r_b] };
            frame.prepare(slot, point, r, &mut kept);
        }
        slot.a = (a_moves && b_moves).then_some(a);
        slot.b = if swapped { a } else { b };
        slot.first = first;
        slot.points = count as u8;
        slot.hard = !(a_moves && b_moves);
        slot.normal = S::Step::direction(&normal.get());
        slot.tangents = [S::Step::direction(&tangents[0].get()), S::Step::direction(&tangents[1].get())];
        slot.bounces = material.restitution() > S::ZERO;
        slot.work = match material.law {
            RestitutionLaw::EnergySafe if slot.bounces => Some(S::Scaled::ZERO),
            _ => None,
        };
        if slot.bounces {
            slot.restitution = S::Unit::from_scaled(material.restitution().to_scaled()).0;
            *bounces = true;
        }
        *manifolds = manifolds.wrapping_add(1);
        *points = points.wrapping_add(count);
        true
    }

    /// Solves up to `sub_steps` of the sub-steps that are left, and says how many are left then: a step in parts, for those who have
    /// other things to do in between. All contacts have been added. [`finish`](Self::finish) does what remains; every bit of the
    /// result is that of one call.
    pub fn advance(&mut self, sub_steps: u8) -> u8 {
        let mut turns = sub_steps.min(self.settings.sub_steps.wrapping_sub(self.done));
        while turns > 0 {
            self.sub_step(self.done == 0);
            self.done = self.done.wrapping_add(1);
            turns = turns.wrapping_sub(1);
        }
        self.settings.sub_steps.wrapping_sub(self.done)
    }

    /// Solves the contacts and moves the bodies.
    pub fn finish(mut self) -> (Constraints<'a, S>, StepReport) {
        let report = self.run();
        (self.constraints, report)
    }

    /// The same where the step is: moving it would copy it.
    pub(crate) fn run(&mut self) -> StepReport {
        self.advance(u8::MAX);
        self.constraints.apply_restitution();
        let places = self.constraints.places;
        let mut motions = self.constraints.buffers.motions.iter_mut();
        for body in self.constraints.bodies.iter_mut() {
            let Some(motion) = motions.next() else { break };
            if motion.moves() {
                self.report.saturated |= store(body, motion, self.settings, places);
            }
        }
        self.report
    }

    /// Lets go of the memory that it works in.
    pub(crate) fn pause(&self) -> Paused<S> {
        let Constraints { manifolds, points, places, fall, noise, bounces, .. } = self.constraints;
        Paused { manifolds, points, places, fall, noise, bounces, report: self.report, done: self.done }
    }

    /// The contacts.
    pub(crate) fn constraints(&mut self) -> &mut Constraints<'a, S> {
        &mut self.constraints
    }

    /// Solves the contacts as rigid ones, at one moment: velocities change and nothing moves. Each of the `sweeps` takes the
    /// points in their order and finds the normal impulse that stops the approach and the friction within its disc, in four
    /// turns. Gaps count as closed; neither gravity nor restitution acts.
    pub fn finish_rigid(mut self, sweeps: u16) -> (Constraints<'a, S>, StepReport) {
        self.constraints.warm_start();
        let mut sweep = 0;
        while sweep < sweeps {
            self.constraints.sweep();
            sweep = sweep.wrapping_add(1);
        }
        let places = self.constraints.places;
        let mut motions = self.constraints.buffers.motions.iter_mut();
        for body in self.constraints.bodies.iter_mut() {
            let Some(motion) = motions.next() else { break };
            if motion.moves() {
                self.report.saturated |= store_velocity(body, motion, places);
            }
        }
        (self.constraints, self.report)
    }

    /// Its stages have frames of their own, and share the stack.
    fn sub_step(&mut self, first: bool) {
        self.constraints.note_approaches(first);
        self.constraints.integrate_velocities(self.settings);
        if first {
            self.constraints.warm_start();
        }
        self.constraints.solve(self.settings);
        self.constraints.integrate_positions(self.settings);
        self.constraints.relax();
    }
}

/// The speed of the surface of a body that the caller turns, as far out as the centre of any body that may touch it. (A body far
/// away costs precision, for as long as that turns.)
#[cold]
#[inline(never)]
fn surface_speed<S: Scalar>(turned: &Body<S>, bodies: &[Body<S>]) -> S {
    let mut farthest = S::ZERO;
    for body in bodies {
        if !body.is_immovable() && body.position.is_finite() {
            farthest = max(farthest, (body.position - turned.position).taxicab());
        }
    }
    turned.angular_velocity.taxicab().times(farthest)
}
