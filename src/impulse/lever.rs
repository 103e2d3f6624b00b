//! How an impulse along a direction acts on the two bodies: the columns c = r x d and u = I^-1 (r x d).

use super::Outcome;
use crate::body::Body;
use crate::contact::Contact;
use crate::math::{UnitVec3, Vec3};
use crate::scalar::{Scalar, Scaled};

/// What one body opposes to impulses at the end of an arm.
#[derive(Clone, Copy)]
struct Lever<'a, S: Scalar> {
    body: &'a Body<S>,
    arm: Vec3<S::Unit>,
    arm_exponent: S::Exponent,
}

/// The two bodies of a contact.
pub(super) struct Pair<'a, S: Scalar> {
    a: Lever<'a, S>,
    b: Lever<'a, S>,
}

/// The columns of one body along one direction, as blocks that share the powers of two of its arm and its tensor.
#[derive(Clone, Copy)]
pub(super) struct HalfColumn<S: Scalar> {
    /// r x d
    pub cross: Vec3<S::Unit>,
    /// I^-1 (r x d)
    pub turn: Vec3<S::Unit>,
    arm_exponent: S::Exponent,
    inertia_exponent: S::Exponent,
}

/// The columns of both bodies along one direction.
#[derive(Clone, Copy)]
pub(super) struct Column<S: Scalar> {
    /// The direction d.
    pub direction: UnitVec3<S>,
    pub a: HalfColumn<S>,
    pub b: HalfColumn<S>,
}

impl<'a, S: Scalar> Lever<'a, S> {
    #[inline(always)]
    fn new(body: &'a Body<S>, arm: Vec3<S>) -> Self {
        let (arm, arm_exponent) = S::align3(arm.to_array());
        Self { body, arm: Vec3::from_array(arm), arm_exponent }
    }

    #[inline(always)]
    fn column(&self, direction: UnitVec3<S>) -> HalfColumn<S> {
        let cross = self.arm.cross(direction.get());
        let turn = self.body.inv_inertia_world.times(cross);
        HalfColumn { cross, turn, arm_exponent: self.arm_exponent, inertia_exponent: self.body.exponent }
    }
}

impl<'a, S: Scalar> Pair<'a, S> {
    #[inline(always)]
    pub fn new(a: &'a Body<S>, b: &'a Body<S>, contact: &Contact<S>) -> Self {
        Self { a: Lever::new(a, contact.r_a), b: Lever::new(b, contact.r_b) }
    }

    #[inline(always)]
    pub fn column(&self, direction: UnitVec3<S>) -> Column<S> {
        Column { direction, a: self.a.column(direction), b: self.b.column(direction) }
    }
}

impl<S: Scalar> HalfColumn<S> {
    /// w . (r x d) = (w x r) . d
    #[inline(always)]
    fn speed(&self, body: &Body<S>) -> S::Scaled {
        S::scaled_dot3(body.angular_velocity.to_array(), self.cross.to_array()).raised(self.arm_exponent)
    }

    /// (r x d) . I^-1 (r x d') for the column of another direction d'.
    #[inline(always)]
    fn product(&self, other: &Self) -> S::Scaled {
        let product = S::Unit::scaled_dot3(self.cross.to_array(), other.turn.to_array()).raised(self.arm_exponent);
        self.with_turn_exponent(product)
    }

    /// `x` in the powers of two of [`turn`](Self::turn).
    #[inline(always)]
    pub fn with_turn_exponent(&self, x: S::Scaled) -> S::Scaled {
        x.raised(self.arm_exponent).raised(self.inertia_exponent)
    }
}

impl<S: Scalar> Column<S> {
    /// v_r . d
    #[inline(always)]
    pub fn speed(&self, a: &Body<S>, b: &Body<S>) -> S::Scaled {
        let (v_a, v_b) = (a.linear_velocity.to_array(), b.linear_velocity.to_array());
        let linear = S::relative_dot3(v_a, v_b, self.direction.get().to_array());
        // The pairing keeps the bits when A and B are swapped.
        linear + (self.b.speed(b) - self.a.speed(a))
    }

    /// The denominator of (10), along d. What a body's rotation adds is never negative, and rounding must not make it so.
    #[inline(always)]
    pub fn inverse_mass(&self, a: &Body<S>, b: &Body<S>) -> S::Scaled {
        let zero = S::Scaled::ZERO;
        (a.inv_mass + b.inv_mass) + (self.a.product(&self.a).max(zero) + self.b.product(&self.b).max(zero))
    }

    /// What the rotations add to the inverse mass between this direction and another.
    #[inline(always)]
    pub fn coupling(&self, other: &Self) -> S::Scaled {
        self.a.product(&other.a) + self.b.product(&other.b)
    }

    /// The impulse of (10); an error where there is none.
    #[inline(always)]
    pub fn impulse(&self, a: &Body<S>, b: &Body<S>, restitution: S) -> Result<S::Scaled, Outcome> {
        let speed = self.speed(a, b);
        let k = self.inverse_mass(a, b);
        if k == S::Scaled::ZERO {
            return Err(Outcome::Immovable);
        }
        let j = -((S::Scaled::ONE + restitution.to_scaled()) * speed) / k;
        if speed.is_finite() && k.is_finite() && j.is_finite() { Ok(j) } else { Err(Outcome::NotFinite) }
    }
}
