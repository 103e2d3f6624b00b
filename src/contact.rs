//! One contact point, and the surfaces that meet there.

use crate::error::{ContactError, MaterialError};
use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;

/// A point at which two bodies touch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "S: serde::Serialize, S::Unit: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de>, S::Unit: serde::Deserialize<'de>"
    ))
)]
#[repr(C)]
pub struct Contact<S: Scalar> {
    /// From body A to body B.
    pub normal: UnitVec3<S>,
    /// From the centre of mass of A to the point, in the world's frame, m.
    pub r_a: Vec3<S>,
    /// From the centre of mass of B to the point, in the world's frame, m.
    pub r_b: Vec3<S>,
}

impl<S: Scalar> Contact<S> {
    /// A contact whose arms are known to be finite. (A struct literal skips the check; the kernel then refuses to act on
    /// what is not finite.)
    ///
    /// # Errors
    /// [`ContactError`] names the arm with an infinity or NaN in it.
    pub fn new(normal: UnitVec3<S>, r_a: Vec3<S>, r_b: Vec3<S>) -> Result<Self, ContactError> {
        if !r_a.is_finite() {
            return Err(ContactError::ArmA);
        }
        if !r_b.is_finite() {
            return Err(ContactError::ArmB);
        }
        Ok(Self { normal, r_a, r_b })
    }

    /// The same contact with the bodies in the other order.
    #[must_use]
    pub fn swapped(&self) -> Self {
        Self { normal: -self.normal, r_a: self.r_b, r_b: self.r_a }
    }
}

/// Which law restitution follows where friction acts with it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RestitutionLaw {
    /// v_n' = -e v_n, always. With friction at an eccentric contact this may raise the kinetic energy: of random impacts
    /// of everyday bodies, in 0.44 %. In the solver several points that rebound at once may raise it without friction, too.
    #[default]
    Newton,
    /// Newton's law, except where it would raise the energy: there the impulse is drawn towards the one without rebound
    /// until the energy is just kept, so that v_n' = -s e v_n with the largest s in 0 to 1 for which it is. In the solver
    /// that is so of the normal impulses of a manifold, over a step.
    EnergySafe,
}

/// How two surfaces rebound and rub.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material<S> {
    restitution: S,
    friction: S,
    /// How restitution behaves together with friction.
    pub law: RestitutionLaw,
}

impl<S: Scalar> Material<S> {
    /// No rebound, no friction.
    pub const DEAD: Self = Self { restitution: S::ZERO, friction: S::ZERO, law: RestitutionLaw::Newton };

    /// A coefficient of restitution in 0 to 1, and a coefficient of friction of 0 or more.
    ///
    /// # Errors
    /// [`MaterialError`] names the coefficient that is out of range.
    pub fn new(restitution: S, friction: S) -> Result<Self, MaterialError> {
        if !(restitution >= S::ZERO && restitution <= S::ONE) {
            return Err(MaterialError::Restitution);
        }
        if !(friction.is_finite() && friction >= S::ZERO) {
            return Err(MaterialError::Friction);
        }
        Ok(Self { restitution, friction, law: RestitutionLaw::Newton })
    }

    /// Of coefficients that are within their ranges.
    pub(crate) const fn from_valid(restitution: S, friction: S) -> Self {
        Self { restitution, friction, law: RestitutionLaw::Newton }
    }

    /// The same material under another law of restitution.
    #[must_use]
    pub const fn with_law(self, law: RestitutionLaw) -> Self {
        Self { law, ..self }
    }

    /// The coefficient of restitution e.
    pub const fn restitution(&self) -> S {
        self.restitution
    }

    /// The coefficient of friction mu.
    pub const fn friction(&self) -> S {
        self.friction
    }
}
