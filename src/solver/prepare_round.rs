//! Contacts of balls: the normal goes through the centres of mass, and the inertia is the same about every axis.
//!
//! With r = rho n the levers need neither cross products nor the tensor: the normal has none, r x t1 = rho t2 and
//! r x t2 = -rho t1; and both tangents oppose 1/m + rho^2/I, independent of each other.

use super::constraint::PointConstraint;
use super::prepare::Frame;
use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::{Scalar, Scaled, StepArithmetic};

/// What a ball opposes.
struct Ball<S: Scalar> {
    inv_mass: S::Scaled,
    /// How far the contact is along the normal, away from the other body: rho.
    reach: S::Scaled,
    /// The spin for an impulse along a tangent: rho/I.
    turn: S::Scaled,
}

impl<S: Scalar> Ball<S> {
    #[inline(always)]
    fn new(body: &Body<S>, reach: S::Scaled) -> Self {
        let turn = reach * body.inv_inertia_world.xx.to_scaled().raised(body.exponent);
        Self { inv_mass: body.inv_mass, reach, turn }
    }

    /// 1/m + rho^2/I
    #[inline(always)]
    fn inverse_mass(&self) -> S::Scaled {
        self.inv_mass + self.reach * self.turn
    }
}

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
        let reach = |r: &Vec3<S>| S::scaled_dot3(r.to_array(), n.to_array());
        let (body_b, size_b) = self.b;
        let b = Ball::new(body_b, reach(r[1]));
        let a = self.a.map(|(body, size)| (Ball::new(body, -reach(r[0])), size));
        let (mut normal, mut tangent) = (b.inv_mass, b.inverse_mass());
        if let Some((a, _)) = &a {
            (normal, tangent) = (a.inv_mass + normal, a.inverse_mass() + tangent);
        }
        let (inv_normal, inv_tangent) = (S::Scaled::ONE / normal, S::Scaled::ONE / tangent);
        slot.central = true;
        slot.block = S::Step::EVEN;
        slot.friction = S::Step::ratio(self.friction.to_scaled() * tangent * inv_normal);
        let across = [self.tangents[0].get(), self.tangents[1].get()];
        let ([normal_a, normal_b], [[x_a, x_b], [y_a, y_b]]) = (&mut slot.normal, &mut slot.tangents);
        let share = |ball: &Ball<S>, inv_k| S::Unit::from_scaled(ball.inv_mass * inv_k).0;
        normal_b.share = share(&b, inv_normal);
        [x_b.share, y_b.share] = [share(&b, inv_tangent); 2];
        S::Step::round_columns(&across, [b.reach, b.turn * inv_tangent], size_b, [x_b, y_b]);
        if let Some((a, size)) = &a {
            normal_a.share = share(a, inv_normal);
            [x_a.share, y_a.share] = [share(a, inv_tangent); 2];
            S::Step::round_columns(&across, [a.reach, a.turn * inv_tangent], *size, [x_a, y_a]);
        }
    }
}
