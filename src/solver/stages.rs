//! The stages of a sub-step, each over all bodies or all contacts, and what is told of the contacts in the end.

use super::constraint::{ManifoldConstraint, PointConstraint};
use super::energy::draw_back;
use super::integrate::{integrate_position, integrate_velocity};
use super::motion::{Motion, Pair};
use super::settings::Settings;
use super::touch::Touch;
use super::warm_start::WarmStart;
use crate::body::Body;
use crate::math::{Vec3, clamp};
use crate::scalar::{Scalar, StepArithmetic};

type Places<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Places;

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

/// The contacts of a step.
#[derive(Debug)]
pub struct Constraints<'a, S: Scalar> {
    pub(super) bodies: &'a mut [Body<S>],
    pub(super) buffers: Buffers<'a, S>,
    pub(super) manifolds: usize,
    pub(super) points: usize,
    pub(super) places: Places<S>,
    pub(super) fall: Vec3<S>,
    /// Bodies at rest are as fast as that.
    pub(super) noise: S,
    /// A manifold has points that rebound.
    pub(super) bounces: bool,
}

impl<S: Scalar> Constraints<'_, S> {
    pub(super) fn integrate_velocities(&mut self, settings: &Settings<S>) {
        let mut motions = self.buffers.motions.iter_mut();
        for body in self.bodies.iter() {
            let Some(motion) = motions.next() else { return };
            if motion.moves() {
                integrate_velocity(body, motion, &self.fall, settings.inv_h);
            }
        }
    }

    #[inline(never)]
    pub(super) fn integrate_positions(&mut self, settings: &Settings<S>) {
        let mut motions = self.buffers.motions.iter_mut();
        for body in self.bodies.iter_mut() {
            let Some(motion) = motions.next() else { return };
            if motion.moves() {
                integrate_position(body, motion, settings.h, self.places);
            }
        }
    }

    pub(super) fn note_approaches(&mut self, first: bool) {
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
    pub(super) fn warm_start(&mut self) {
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
    pub(super) fn solve(&mut self, settings: &Settings<S>) {
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
    pub(super) fn relax(&mut self) {
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

    pub(super) fn sweep(&mut self) {
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
    pub(super) fn apply_restitution(&mut self) {
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
            for point in points {
                let Some(warm) = free.next() else { break };
                *warm = point.kept_impulses(places);
            }
            keep(index, warm.get(..points.len()).unwrap_or(&[]));
            index = index.wrapping_add(1);
        }
    }

    /// The same point by point.
    pub(crate) fn each_impulse(&mut self, mut keep: impl FnMut(WarmStart<S>)) {
        for manifold in self.buffers.manifolds.iter().take(self.manifolds) {
            let Some(points) = self.buffers.points.get(manifold.range()) else { return };
            for point in points {
                keep(point.kept_impulses(self.places));
            }
        }
    }
}
