//! How an impulse along a direction acts on the two bodies of a contact.

use super::Outcome;
use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::{Scalar, Scaled};

/// What one body opposes to impulses along a direction, as the body sees it: away from the other body. Then swapping the
/// bodies swaps numbers and changes none.
#[inline(always)]
pub(super) fn lever<S: Scalar>(body: &Body<S>, r: &Vec3<S>, direction: &Vec3<S::Unit>) -> S::Lever {
    S::lever(body, r, direction)
}

/// What the two bodies of a contact oppose to impulses along a direction. (References: the compiler would copy levers.)
pub(super) struct Column<'a, S: Scalar> {
    /// From A to B as A sees it, and as B sees it.
    pub directions: [&'a Vec3<S::Unit>; 2],
    pub levers: [&'a S::Lever; 2],
}

impl<S: Scalar> Column<'_, S> {
    /// v_r . d
    #[inline(always)]
    pub fn speed(&self, a: &Body<S>, b: &Body<S>) -> S::Scaled {
        let v = [&a.linear_velocity, &b.linear_velocity];
        S::parting_speed(v, self.directions, self.levers)
    }

    /// The denominator of (10), along d.
    #[inline(always)]
    pub fn inverse_mass(&self, a: &Body<S>, b: &Body<S>) -> S::Scaled {
        S::inverse_mass([a.inv_mass, b.inv_mass], self.levers)
    }

    /// The impulse of (10) for approaching bodies; the outcome where there is none.
    #[inline(always)]
    pub fn impulse(&self, a: &Body<S>, b: &Body<S>, restitution: S) -> Result<S::Scaled, Outcome> {
        let v = [&a.linear_velocity, &b.linear_velocity];
        match S::approach_impulse(restitution, v, self.directions, [a.inv_mass, b.inv_mass], self.levers) {
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
