//! One step over the caller's bodies.

use super::constraint::{ManifoldConstraint, PointConstraint};
use super::energy::draw_back;
use super::integrate::{integrate_position, integrate_velocity, lift, store, store_velocity};
use super::motion::{Motion, Pair, Part};
use super::prepare::Frame;
use super::settings::Settings;
use super::touch::Touch;
use super::warm_start::{Kept, WarmStart};
use crate::body::Body;
use crate::contact::{Material, RestitutionLaw};
use crate::manifold::Manifold;
use crate::math::{Vec3, clamp, max};
use crate::scalar::{Scalar, Scaled, StepArithmetic};

type Places<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Places;

/// Places to spare above the fastest body, for the spin that friction gives it and for those that it strikes; above the fastest
/// spin; and above what gravity adds in a sub-step, for the impulses under a pile. Sums over sub-steps come on top.
const HEAD_OF_SPEEDS: u32 = 3;
const HEAD_OF_SPINS: u32 = 1;
const HEAD_OF_GRAVITY: u32 = 10;

/// Turns by which a point's normal impulse and friction, each of which changes the other's speed, are brought to agree.
const ROUNDS: u8 = 4;

/// The working space of a step: a motion for each body, and as many manifolds and points as there may be.
#[derive(Debug)]
pub struct Buffers<'a, S: Scalar> {
    /// One for each body.
    pub motions: &'a mut [Motion<S>],
    /// One for each pair that touches.
    pub manifolds: &'a mut [ManifoldConstraint<S>],
    /// One for each point.
    pub points: &'a mut [PointConstraint<S>],
}

/// A step in the making: contacts are added, then it is [finished](Self::finish).
#[derive(Debug)]
pub struct Step<'a, S: Scalar> {
    constraints: Constraints<'a, S>,
    settings: Settings<S>,
    report: StepReport,
}

/// The contacts of a step.
#[derive(Debug)]
pub struct Constraints<'a, S: Scalar> {
    bodies: &'a mut [Body<S>],
    buffers: Buffers<'a, S>,
    manifolds: usize,
    points: usize,
    places: Places<S>,
    fall: Vec3<S>,
    /// Bodies at rest are as fast as that.
    noise: S,
    /// A manifold has points that rebound.
    bounces: bool,
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
    pub fn begin(bodies: &'a mut [Body<S>], buffers: Buffers<'a, S>, settings: &Settings<S>) -> Self {
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
        Self { constraints, settings: *settings, report }
    }

    /// Keeps a body as it is in this step: it counts as one that nothing moves, and as if it had no velocity. To be called
    /// before contacts are added.
    pub fn hold(&mut self, index: usize) {
        if let Some(motion) = self.constraints.buffers.motions.get_mut(index) {
            if motion.part != Part::Lost {
                motion.part = Part::Held;
            }
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
            buffers.motions.get(usize::from(i)).map(|motion| (body, motion.size, motion.part))
        };
        let (Some((body_a, size_a, part_a)), Some((body_b, size_b, part_b))) = (find(a), find(b)) else {
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

    /// Solves the contacts and moves the bodies.
    pub fn finish(mut self) -> (Constraints<'a, S>, StepReport) {
        let mut sub_step = 0;
        while sub_step < self.settings.sub_steps {
            self.sub_step(sub_step == 0);
            sub_step = sub_step.wrapping_add(1);
        }
        self.constraints.apply_restitution();
        let places = self.constraints.places;
        let mut motions = self.constraints.buffers.motions.iter_mut();
        for body in self.constraints.bodies.iter_mut() {
            let Some(motion) = motions.next() else { break };
            if motion.moves() {
                self.report.saturated |= store(body, motion, &self.settings, places);
            }
        }
        (self.constraints, self.report)
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
        self.constraints.integrate_velocities(&self.settings);
        if first {
            self.constraints.warm_start();
        }
        self.constraints.solve(&self.settings);
        self.constraints.integrate_positions(&self.settings);
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

impl<S: Scalar> Constraints<'_, S> {
    fn integrate_velocities(&mut self, settings: &Settings<S>) {
        let mut motions = self.buffers.motions.iter_mut();
        for body in self.bodies.iter() {
            let Some(motion) = motions.next() else { return };
            if motion.moves() {
                integrate_velocity(body, motion, &self.fall, settings.inv_h);
            }
        }
    }

    #[inline(never)]
    fn integrate_positions(&mut self, settings: &Settings<S>) {
        let mut motions = self.buffers.motions.iter_mut();
        for body in self.bodies.iter_mut() {
            let Some(motion) = motions.next() else { return };
            if motion.moves() {
                integrate_position(body, motion, settings.h, self.places);
            }
        }
    }

    fn note_approaches(&mut self, first: bool) {
        if !self.bounces {
            return;
        }
        let Buffers { motions, manifolds, points } = &mut self.buffers;
        for manifold in manifolds.iter_mut().take(self.manifolds) {
            if !manifold.bounces {
                continue;
            }
            let Some(points) = points.get_mut(manifold.range()) else { return };
            let Some(pair) = Pair::of(motions, manifold) else { return };
            for point in points {
                let speed = point.normal_speed(&pair, &manifold.normal);
                point.note_approach(speed);
                match &mut manifold.work {
                    // The impulse is still that of the step before.
                    Some(_) if first => point.speed = speed,
                    Some(work) => *work = point.count_work(*work, speed),
                    None => {}
                }
            }
        }
    }

    #[inline(never)]
    fn warm_start(&mut self) {
        let Buffers { motions, manifolds, points } = &mut self.buffers;
        for manifold in manifolds.iter().take(self.manifolds) {
            let Some(points) = points.get_mut(manifold.range()) else { return };
            let Some(mut pair) = Pair::of(motions, manifold) else { return };
            for point in points {
                point.warm_start(&mut pair, &manifold.normal, &manifold.tangents);
            }
        }
    }

    #[inline(never)]
    fn solve(&mut self, settings: &Settings<S>) {
        let push_out_speed = S::Step::lift(settings.push_out_speed, S::Step::NO_REST, self.places);
        let Buffers { motions, manifolds, points } = &mut self.buffers;
        for manifold in manifolds.iter().take(self.manifolds) {
            let Some(points) = points.get_mut(manifold.range()) else { return };
            let Some(mut pair) = Pair::of(motions, manifold) else { return };
            let softness = if manifold.hard { &settings.hard } else { &settings.soft };
            for point in points {
                let before = point.impulse[0];
                point.solve_normal(&mut pair, &manifold.normal, softness, push_out_speed);
                let blow = before > push_out_speed;
                if blow && point.impulse[0] < S::Step::half(before) {
                    point.let_go(&mut pair, &manifold.tangents);
                }
            }
        }
    }

    #[inline(never)]
    fn relax(&mut self) {
        let Buffers { motions, manifolds, points } = &mut self.buffers;
        for manifold in manifolds.iter().take(self.manifolds) {
            let Some(points) = points.get_mut(manifold.range()) else { return };
            let Some(mut pair) = Pair::of(motions, manifold) else { return };
            for point in points.iter_mut() {
                point.relax_normal(&mut pair, &manifold.normal);
            }
            for point in points {
                point.solve_friction(&mut pair, &manifold.tangents, point.impulse[0]);
                point.gap = point.gap.plus(point.drive[0]);
                point.total = point.total.plus(point.impulse[0]);
            }
        }
    }

    fn sweep(&mut self) {
        let Buffers { motions, manifolds, points } = &mut self.buffers;
        for manifold in manifolds.iter().take(self.manifolds) {
            let Some(points) = points.get_mut(manifold.range()) else { return };
            let Some(mut pair) = Pair::of(motions, manifold) else { return };
            for point in points {
                let mut round = 0;
                while round < ROUNDS {
                    point.relax_normal(&mut pair, &manifold.normal);
                    point.solve_friction(&mut pair, &manifold.tangents, point.impulse[0]);
                    round = round.wrapping_add(1);
                }
                point.total = point.impulse[0];
            }
        }
    }

    #[inline(never)]
    fn apply_restitution(&mut self) {
        if !self.bounces {
            return;
        }
        self.note_approaches(false);
        let threshold = self.fall.length();
        let Buffers { motions, manifolds, points } = &mut self.buffers;
        for manifold in manifolds.iter().take(self.manifolds) {
            if !manifold.bounces {
                continue;
            }
            let Some(points) = points.get_mut(manifold.range()) else { return };
            let Some(mut pair) = Pair::of(motions, manifold) else { return };
            let mut rebounds = [None; 4];
            let mut free = rebounds.iter_mut();
            if manifold.work.is_some() {
                for point in points.iter_mut() {
                    point.speed = point.normal_speed(&pair, &manifold.normal);
                }
            }
            for point in points.iter_mut() {
                let Some(rebound) = free.next() else { break };
                if point.struck && point.approach.plus(threshold) < S::ZERO {
                    // What else the sub-step added is no acceleration that lasts.
                    point.change = clamp(point.change, threshold.plus(threshold));
                    let gap = point.gap(&pair, &manifold.normal);
                    let speed = point.rebound_speed(gap, manifold.restitution);
                    *rebound = Some(point.rebound(&mut pair, &manifold.normal, speed));
                }
            }
            if let Some(work) = manifold.work {
                draw_back(points, &mut pair, &manifold.normal, &mut rebounds, work);
            }
            let mut rebounds = rebounds.iter();
            for point in points.iter_mut() {
                let Some(rebound) = rebounds.next() else { break };
                if let Some(change) = rebound {
                    let kept = point.impulse;
                    point.solve_friction(&mut pair, &manifold.tangents, kept[0].plus(*change));
                    point.impulse = kept;
                }
            }
        }
    }

    /// How each manifold pushed in this step: calls `note` with its index, in the order added.
    pub fn touches(&mut self, mut note: impl FnMut(usize, &Touch<S>)) {
        let threshold = self.fall.length();
        let noise = if threshold > self.noise { threshold } else { self.noise };
        let (bodies, manifolds) = (&*self.bodies, &*self.buffers.manifolds);
        let mut index = 0usize;
        for manifold in manifolds.iter().take(self.manifolds) {
            let Some(points) = self.buffers.points.get(manifold.range()) else { return };
            let Some(body) = bodies.get(usize::from(manifold.b)) else { return };
            let fall = manifold.fall(&self.fall, body, manifold.a.and_then(|a| bodies.get(usize::from(a))));
            let mut touch = Touch::NONE;
            for point in points {
                touch.add(point, body.inv_mass, fall, noise, self.places);
            }
            note(index, &touch);
            index = index.wrapping_add(1);
        }
    }

    /// What to start the next step from: calls `keep` for each manifold with its index, in the order added, and its points.
    pub fn impulses(&mut self, mut keep: impl FnMut(usize, &[WarmStart<S>])) {
        let (mut index, places) = (0usize, self.places);
        for manifold in self.buffers.manifolds.iter().take(self.manifolds) {
            let Some(points) = self.buffers.points.get(manifold.range()) else { return };
            let mut warm = [WarmStart::NONE; 4];
            let mut free = warm.iter_mut();
            for PointConstraint { feature, bearing, impulse, .. } in points {
                let Some(warm) = free.next() else { break };
                *warm = WarmStart { feature: *feature, bearing: *bearing, impulse: *impulse, places };
            }
            keep(index, warm.get(..points.len()).unwrap_or(&[]));
            index = index.wrapping_add(1);
        }
    }
}
