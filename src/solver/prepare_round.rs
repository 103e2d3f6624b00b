//! Contacts of balls: the normal goes through the centres of mass, and the inertia is the same about every axis.
//!
//! With r = rho n the levers need neither cross products nor the tensor: the normal has none, r x t1 = rho t2 and
//! r x t2 = -rho t1; and both tangents oppose 1/m + rho^2/I, independent of each other.

use super::constraint::PointConstraint;
use super::prepare::Frame;
use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::{Scalar, StepArithmetic};

impl<S: Scalar> Frame<'_, S> {
    /// Whether the normal goes through the centres, but for what rounding makes of that.
    #[inline(always)]
    pub(super) fn is_through_centres(&self, r: [&Vec3<S>; 2]) -> bool {
        let n = self.normal.get();
        S::Step::is_along(r[1], &n) && (self.a.is_none() || S::Step::is_along(r[0], &n))
    }

    /// What the rows do to balls.
    #[inline(never)]
    pub(super) fn prepare_round(&self, slot: &mut PointConstraint<S>, r: [&Vec3<S>; 2]) {
        let n = self.normal.get();
        // Away from the other, as in `prepare_levers`.
        let away = S::opposite(&n);
        let ball = |body: &Body<S>, r, d| S::Step::ball(r, d, body.inv_inertia_world.xx, body.exponent);
        let (body_b, size_b) = self.b;
        let ball_b = ball(body_b, r[1], &n);
        let ball_a = self.a.map(|(body, size)| (ball(body, r[0], &away), body.inv_mass, size));
        let side_a = ball_a.as_ref().map(|(ball, inv_mass, _)| (ball, *inv_mass));
        let weights = S::Step::ball_weights([side_a, Some((&ball_b, body_b.inv_mass))], self.friction);
        let across = [self.tangents[0].get(), self.tangents[1].get()];
        let ([normal_a, normal_b], [[x_a, x_b], [y_a, y_b]]) = (&mut slot.normal, &mut slot.tangents);
        S::Step::ball_columns(&ball_b, body_b.inv_mass, &weights, size_b, &across, [normal_b, x_b, y_b]);
        if let Some((ball, inv_mass, size)) = &ball_a {
            S::Step::ball_columns(ball, *inv_mass, &weights, *size, &across, [normal_a, x_a, y_a]);
        }
        slot.central = true;
        slot.block = weights.block;
        slot.friction = weights.friction;
    }
}
