//! Restitution: what is noted when points meet, and the rebound at the end of the step.

use super::constraint::PointConstraint;
use super::motion::Pair;
use crate::math::Vec3;
use crate::scalar::{Scalar, StepArithmetic};

impl<S: Scalar> PointConstraint<S> {
    /// Before a sub-step: how fast the points approach, gravity not yet added.
    #[inline(always)]
    pub(super) fn note_approach(&mut self, speed: S) {
        if !self.struck {
            self.change = speed;
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

    /// The speed at which the points part at the gap that is there now, as if they had met the surface where it is, not
    /// when a sub-step began.
    ///
    /// With the change d of the speed in a sub-step, v - d/2 is the speed half a sub-step before, for which symplectic Euler
    /// keeps (v - d/2)^2 / 2 + (d/h) s exactly: so fast were the points where s = 0, and with e times that they leave.
    #[inline(always)]
    pub(super) fn rebound_speed(&self, gap: S, restitution: S::Unit) -> S {
        let half = S::Step::half(self.change);
        let met = S::Step::speed_after(self.approach.plus(half), self.change, self.gap_struck);
        S::Step::speed_after(S::Step::times(met, restitution), self.change, gap.negated()).plus(half)
    }

    /// Gives the points the speed `speed`, and returns the normal impulse that it takes beside that of the sub-step.
    #[inline(always)]
    pub(super) fn rebound(&mut self, pair: &mut Pair<'_, S>, normal: &Vec3<S::Unit>, speed: S) -> S {
        let before = self.impulse[0];
        let after = before.plus(speed.minus(self.normal_speed(pair, normal)));
        let after = if after > S::ZERO { after } else { S::ZERO };
        let change = after.minus(before);
        self.total = self.total.plus(change);
        self.push_normal(pair, normal, change);
        change
    }
}
