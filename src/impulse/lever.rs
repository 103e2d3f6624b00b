//! How an impulse along a direction acts on the two bodies of a contact.

use super::Outcome;
use crate::body::Body;
use crate::contact::Contact;
use crate::math::{UnitVec3, Vec3};
use crate::scalar::{Scalar, Scaled};

/// What the two bodies oppose to impulses along one direction.
///
/// Each body has the direction and the lever as it sees them: away from the other body. Then swapping the bodies swaps
/// numbers and changes none.
#[derive(Clone, Copy)]
pub(super) struct Column<S: Scalar> {
    /// From A to B, as B sees it.
    pub direction: Vec3<S::Unit>,
    /// The same as A sees it.
    pub opposite: Vec3<S::Unit>,
    pub a: S::Lever,
    pub b: S::Lever,
}

impl<S: Scalar> Column<S> {
    #[inline(always)]
    pub fn new(a: &Body<S>, b: &Body<S>, contact: &Contact<S>, direction: UnitVec3<S>) -> Self {
        let direction = direction.get();
        let opposite = S::opposite(&direction);
        Self {
            a: S::lever([&contact.r_a, &a.angular_velocity], &opposite, &a.inv_inertia_world, a.exponent),
            b: S::lever([&contact.r_b, &b.angular_velocity], &direction, &b.inv_inertia_world, b.exponent),
            direction,
            opposite,
        }
    }

    #[inline(always)]
    fn levers(&self) -> [&S::Lever; 2] {
        [&self.a, &self.b]
    }

    /// v_r . d
    #[inline(always)]
    pub fn speed(&self, a: &Body<S>, b: &Body<S>) -> S::Scaled {
        let v = [&a.linear_velocity, &b.linear_velocity];
        S::parting_speed(v, [&self.opposite, &self.direction], self.levers())
    }

    /// The denominator of (10), along d.
    #[inline(always)]
    pub fn inverse_mass(&self, a: &Body<S>, b: &Body<S>) -> S::Scaled {
        S::inverse_mass([a.inv_mass, b.inv_mass], self.levers())
    }

    /// The impulse of (10) for approaching bodies; the outcome where there is none.
    #[inline(always)]
    pub fn impulse(&self, a: &Body<S>, b: &Body<S>, restitution: S) -> Result<S::Scaled, Outcome> {
        let v = [&a.linear_velocity, &b.linear_velocity];
        let d = [&self.opposite, &self.direction];
        match S::approach_impulse(restitution, v, d, [a.inv_mass, b.inv_mass], self.levers()) {
            Ok(j) => Ok(j),
            Err((speed, k)) => Err(without_impulse(speed, k)),
        }
    }
}

/// Why there is no impulse, for the speed at which the points part and the denominator of (10).
#[cold]
#[inline(never)]
pub(super) fn without_impulse<T: Scaled>(speed: T, k: T) -> Outcome {
    if !(speed.is_finite() && k.is_finite()) {
        Outcome::NotFinite
    } else if speed >= T::ZERO {
        Outcome::Separating
    } else if k <= T::ZERO {
        Outcome::Immovable
    } else {
        Outcome::NotFinite
    }
}
