//! Restitution: what is noted when points meet, and the rebound at the end of the step.

use super::constraint::PointConstraint;
use super::motion::Pair;
use crate::math::Vec3;
use crate::scalar::{Scalar, StepArithmetic};

impl<S: Scalar> PointConstraint<S> {
    /// Before a sub-step: how fast the points approach, gravity not yet added.
    #[inline(always)]
    pub(super) fn note_approach(&mut self, pair: &Pair<S>, normal: &Vec3<S::Unit>) {
        if !self.struck {
            self.change = self.normal_speed(pair, normal);
        }
    }

    /// In the sub-step in which the points first push each other: how fast they meet, what gravity and other contacts had
    /// added in it, and how far there still was to go.
    #[inline(always)]
    pub(super) fn note_impact(&mut self, impulse: S, speed: S, gap: S) {
        if !self.struck && impulse > S::ZERO {
            self.struck = true;
            self.approach = speed;
            self.change = self.change.minus(speed);
            self.gap_struck = gap;
        }
    }

    /// The speed at which the points part after a perfect rebound, at the gap that is there now: that of a body which met
    /// the surface when it was there, not when a sub-step began.
    ///
    /// With the change d of the speed in a sub-step, v - d/2 is the speed half a sub-step before, for which symplectic Euler
    /// keeps (v - d/2)^2 / 2 + (d/h) s exactly. Zero where the points did not meet faster than `threshold`.
    #[inline(always)]
    pub(super) fn rebound_speed(&self, gap: S, threshold: S) -> S {
        let speed = self.approach.negated();
        if !self.struck || speed <= threshold {
            return S::ZERO;
        }
        let half = self.change.minus(S::Step::half(self.change));
        let fall = self.gap_struck.minus(gap);
        S::Step::speed_after(speed.minus(half), self.change, fall).plus(half)
    }

    /// Gives the points the speed `speed`, and returns the normal impulse of it and of the sub-step together.
    #[inline(always)]
    pub(super) fn rebound(&mut self, pair: &mut Pair<S>, normal: &Vec3<S::Unit>, speed: S) -> S {
        let before = self.impulse[0];
        let after = before.plus(speed.minus(self.normal_speed(pair, normal)));
        let after = if after > S::ZERO { after } else { S::ZERO };
        pair.push(normal, &self.normal, after.minus(before));
        after
    }
}
