//! From a manifold's point to what the sub-steps work with.

use super::constraint::{PointConstraint, WarmStart};
use crate::body::Body;
use crate::manifold::ManifoldPoint;
use crate::math::{UnitVec3, Vec3};
use crate::scalar::{Column, Scalar, Scaled, StepArithmetic};

type Places<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Places;
type Ratio<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Ratio;
type Lever<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Lever;

/// A body at its end of a contact point.
struct Side<'a, S: Scalar> {
    body: &'a Body<S>,
    size: Places<S>,
    levers: [Lever<S>; 3],
}

impl<'a, S: Scalar> Side<'a, S> {
    #[inline(always)]
    fn new((body, size): (&'a Body<S>, Places<S>), r: &Vec3<S>, directions: [&Vec3<S::Unit>; 3]) -> Self {
        let lever = |d| S::Step::lever(r, d, &body.inv_inertia_world, body.exponent);
        Self { body, size, levers: [lever(directions[0]), lever(directions[1]), lever(directions[2])] }
    }

    /// The part of K in two directions, which are the same or at right angles.
    #[inline(always)]
    fn inverse_mass(&self, d: usize, other: usize) -> S::Scaled {
        let (Some(lever), Some(second)) = (self.levers.get(d), self.levers.get(other)) else { return S::Scaled::ZERO };
        let turn = S::Step::coupling(lever, second);
        if d == other { self.body.inv_mass + turn } else { turn }
    }
}

/// Two bodies, of which the first may be one that does not move, and the directions between them.
pub(super) struct Frame<'a, S: Scalar> {
    pub a: Option<(&'a Body<S>, Places<S>)>,
    pub b: (&'a Body<S>, Places<S>),
    /// The surface of the body that does not move.
    pub immovable: &'a Body<S>,
    pub normal: UnitVec3<S>,
    pub tangents: [UnitVec3<S>; 2],
    pub friction: S,
    pub inv_h: S::Scaled,
    pub places: Places<S>,
}

impl<S: Scalar> Frame<'_, S> {
    /// The point prepared, with the impulses of the step before.
    pub fn point(&self, point: &ManifoldPoint<S>, r: [&Vec3<S>; 2], warm: &WarmStart<S>) -> PointConstraint<S> {
        let directions = [&self.normal.get(), &self.tangents[0].get(), &self.tangents[1].get()];
        let a = self.a.map(|a| Side::new(a, r[0], directions));
        let b = Side::new(self.b, r[1], directions);
        let k = |d, other| {
            let k_b = b.inverse_mass(d, other);
            a.as_ref().map_or(k_b, |a| a.inverse_mass(d, other) + k_b)
        };
        let (k_n, k_xx, k_xy, k_yy) = (k(0, 0), k(1, 1), k(1, 2), k(2, 2));
        let k_t = k_xx.max(k_yy) + k_xy.max(-k_xy);
        let one = S::Scaled::ONE;
        let (inv_n, inv_t) = (one / k_n, one / k_t);
        let columns = |lever: usize, inv_k| {
            let side = |side: &Side<S>, column: fn(&Lever<S>, S::Scaled, S::Scaled, Places<S>) -> Column<S>| {
                side.levers
                    .get(lever)
                    .map_or(Column::NONE, |lever| column(lever, side.body.inv_mass, inv_k, side.size))
            };
            [
                a.as_ref().map_or(Column::NONE, |a| side(a, S::Step::opposite_column)),
                side(&b, S::Step::column),
            ]
        };
        PointConstraint {
            normal: columns(0, inv_n),
            tangents: [columns(1, inv_t), columns(2, inv_t)],
            block: block::<S>([k_xx, k_xy, k_yy], k_t),
            friction: S::Step::ratio(self.friction.to_scaled() * k_t * inv_n),
            gap: S::Step::gap(point.separation, self.inv_h, self.places),
            drive: self.drive(r[0], directions),
            impulse: warm.impulse.map(|x| S::Step::moved(x, warm.places, self.places)),
            feature: point.feature,
            ..PointConstraint::NEW
        }
    }

    /// The speed at which the surface of a body that only the caller moves goes by.
    fn drive(&self, r: &Vec3<S>, directions: [&Vec3<S::Unit>; 3]) -> [S; 3] {
        let Body { linear_velocity: v, angular_velocity: w, .. } = self.immovable;
        if self.a.is_some() || (*v == Vec3::ZERO && *w == Vec3::ZERO) {
            return [S::ZERO; 3];
        }
        let v = (*v + w.cross(*r)).to_array();
        let along = |d: &Vec3<S::Unit>| S::Step::lift(S::dot3_unit(v, d.to_array()).negated(), S::Step::NO_REST, self.places);
        directions.map(along)
    }
}

/// `k_t` times the inverse of a symmetric 2x2 matrix (xx, xy, yy).
fn block<S: Scalar>([xx, xy, yy]: [S::Scaled; 3], k_t: S::Scaled) -> [Ratio<S>; 3] {
    let determinant = xx * yy - xy * xy;
    if !(determinant > S::Scaled::EPSILON * k_t * k_t) {
        let one = S::Step::ratio(S::Scaled::ONE);
        return [one, S::Step::NO_RATIO, one];
    }
    let factor = k_t / determinant;
    [S::Step::ratio(yy * factor), S::Step::ratio(-(xy * factor)), S::Step::ratio(xx * factor)]
}
