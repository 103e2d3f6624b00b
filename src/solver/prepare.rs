//! From a manifold's point to what the sub-steps work with.

use super::constraint::PointConstraint;
use super::warm_start::Kept;
use crate::body::Body;
use crate::manifold::ManifoldPoint;
use crate::math::{UnitVec3, Vec3};
use crate::scalar::{Scalar, StepArithmetic};

type Places<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Places;

/// Two bodies, of which the first may be one that does not move, and the directions between them.
pub(super) struct Frame<'a, S: Scalar> {
    pub a: Option<(&'a Body<S>, Places<S>)>,
    pub b: (&'a Body<S>, Places<S>),
    /// The body whose surface only the caller moves, if there is one.
    pub driven: Option<&'a Body<S>>,
    pub normal: UnitVec3<S>,
    pub tangents: [UnitVec3<S>; 2],
    pub friction: S,
    pub inv_h: S::Scaled,
    pub places: Places<S>,
    /// The inertia of either is the same about every axis.
    pub even: bool,
}

impl<S: Scalar> Frame<'_, S> {
    /// Prepares the point, with the impulses of the step before.
    pub fn prepare(
        &self,
        slot: &mut PointConstraint<S>,
        point: &ManifoldPoint<S>,
        r: [&Vec3<S>; 2],
        kept: &mut Kept<'_, S>,
    ) {
        if !is_finite(point) {
            *slot = PointConstraint { feature: point.feature, ..PointConstraint::NEW };
            return;
        }
        if self.even && self.is_through_centres(r) {
            self.prepare_round(slot, r);
        } else {
            self.prepare_levers(slot, r);
        }
        slot.gap = S::Step::gap(point.separation, self.inv_h, self.places);
        slot.drive = self.drive(r[0]);
        slot.feature = point.feature;
        slot.bearing = S::Step::bearing(&point.r_b);
        let warm = kept.find(point.feature, slot.bearing);
        let [along, aside_x, aside_y] = warm.impulse;
        let moved = |impulse| S::Step::moved(impulse, warm.places, self.places);
        slot.impulse = [moved(along), moved(aside_x), moved(aside_y)];
        slot.lasting = along != S::ZERO;
        (slot.total, slot.approach, slot.change, slot.gap_struck) = (S::ZERO, S::ZERO, S::ZERO, S::ZERO);
        (slot.struck, slot.apart) = (false, false);
    }

    /// What the rows do to the bodies. In a frame of its own, which balls do without.
    #[inline(never)]
    fn prepare_levers(&self, slot: &mut PointConstraint<S>, r: [&Vec3<S>; 2]) {
        let [n, x, y] = [self.normal.get(), self.tangents[0].get(), self.tangents[1].get()];
        let levers = |body: &Body<S>, r, d| S::Step::levers(r, d, &body.inv_inertia_world, body.exponent);
        let (body_b, size_b) = self.b;
        let levers_b = levers(body_b, r[1], [&n, &x, &y]);
        // Each body has its own directions, away from the other: so a swap exchanges numbers and changes none.
        let away = [S::opposite(&n), S::opposite(&x), S::opposite(&y)];
        let levers_a = self.a.map(|(body, _)| levers(body, r[0], [&away[0], &away[1], &away[2]]));
        let side_a = match (&self.a, &levers_a) {
            (Some((body, _)), Some(levers)) => Some((levers, body.inv_mass)),
            _ => None,
        };
        let weights = S::Step::weights([side_a, Some((&levers_b, body_b.inv_mass))], self.friction);
        let central_a = levers_a.as_ref().is_none_or(|levers| S::Step::is_central(levers, r[0]));
        slot.central = central_a && S::Step::is_central(&levers_b, r[1]);
        let ([normal_a, normal_b], [[x_a, x_b], [y_a, y_b]]) = (&mut slot.normal, &mut slot.tangents);
        S::Step::columns(&levers_b, body_b.inv_mass, &weights, size_b, slot.central, [normal_b, x_b, y_b]);
        if let (Some((body, size)), Some(levers)) = (&self.a, &levers_a) {
            S::Step::columns(levers, body.inv_mass, &weights, *size, slot.central, [normal_a, x_a, y_a]);
        }
        slot.block = weights.block;
        slot.friction = weights.friction;
    }

    /// The speed at which the surface of a body that only the caller moves goes by.
    fn drive(&self, r: &Vec3<S>) -> [S; 3] {
        let Some(Body { linear_velocity: v, angular_velocity: w, .. }) = self.driven else { return [S::ZERO; 3] };
        if *v == Vec3::ZERO && *w == Vec3::ZERO {
            return [S::ZERO; 3];
        }
        let v = (*v + w.cross(*r)).to_array();
        let along = |d: UnitVec3<S>| {
            S::Step::lift(S::dot3_unit(v, d.get().to_array()).negated(), S::Step::NO_REST, self.places)
        };
        [along(self.normal), along(self.tangents[0]), along(self.tangents[1])]
    }
}

/// What is not finite makes no contact.
#[inline(always)]
fn is_finite<S: Scalar>(point: &ManifoldPoint<S>) -> bool {
    point.separation.is_finite() && point.r_a.is_finite() && point.r_b.is_finite()
}
