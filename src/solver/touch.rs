//! What a manifold did in a step, for those who want to hear of impacts.

use super::constraint::{ManifoldConstraint, PointConstraint};
use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::{Scalar, Scaled, StepArithmetic};

/// How two bodies pushed each other in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch<S: Scalar> {
    /// A point took an impulse.
    pub pushed: bool,
    /// The normal impulse over the whole step, rebound included: the sum over points and sub-steps, N s.
    pub impulse: S::Scaled,
    /// The highest speed at which points met that did not push in the step before, m/s; zero where there are none, or none
    /// faster than what gravity adds in a sub-step or a thousandth of the push-out speed: a body at rest drifts off and back
    /// as fast as that. As it was before the gravity of the sub-step in which they met.
    pub approach: S,
}

impl<S: Scalar> Touch<S> {
    pub(super) const NONE: Self = Self { pushed: false, impulse: S::Scaled::ZERO, approach: S::ZERO };

    /// Takes a point into account, on a body with that inverse mass; `fall` is what gravity alone adds to the relative speed, where
    /// the point has not noted what was added. What is no faster than `noise` does not count.
    #[inline(always)]
    pub(super) fn add(
        &mut self,
        point: &PointConstraint<S>,
        inv_mass: S::Scaled,
        fall: Option<S>,
        noise: S,
        places: <S::Step as StepArithmetic<S>>::Places,
    ) {
        if point.total > S::ZERO {
            self.pushed = true;
            let [_, column] = &point.normal;
            self.impulse = self.impulse + S::Step::impulse(point.total, places, column.share, inv_mass);
        }
        if !point.lasting && point.struck {
            let change = fall.map_or(point.change, S::negated);
            let speed = point.approach.plus(change).negated();
            if speed > noise {
                let (speed, _, _) = S::Step::lower(speed, places);
                self.approach = if speed > self.approach { speed } else { self.approach };
            }
        }
    }
}

impl<S: Scalar> ManifoldConstraint<S> {
    /// What gravity adds to the speed of B relative to A in a sub-step: nothing where both fall alike. Where points bounce they
    /// have noted more than that.
    #[inline(always)]
    pub(super) fn fall(&self, fall: &Vec3<S>, b: &Body<S>, a: Option<&Body<S>>) -> Option<S> {
        if self.bounces {
            return None;
        }
        let scale = b.gravity_scale.minus(a.map_or(S::ZERO, |a| a.gravity_scale));
        Some(S::Step::along(&(*fall * scale), &self.normal))
    }
}
