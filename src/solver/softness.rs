//! Soft contacts: a damped spring in place of a rigid constraint, solved implicitly.

use crate::scalar::{Scalar, Scaled};

/// The coefficients of a soft contact in a sub-step.
///
/// A mass on a spring of angular frequency w with damping ratio z, implicit over h: with a = 2 z + h w and b = h w a, an
/// overlap s is undone at the speed (h w / a) s/h, with b/(1 + b) of the impulse that a rigid contact would take, while
/// 1/(1 + b) of the impulse so far is let go. All three depend on w h and z only: a world in centimetres has the same. For h w
/// to infinity the contact is rigid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Softness<S: Scalar> {
    /// The part of an overlap that is undone in a sub-step.
    pub bias: S::Unit,
    /// The part of a rigid contact's impulse.
    pub mass: S::Unit,
    /// The part of the impulse so far that is let go.
    pub relaxed: S::Unit,
}

impl<S: Scalar> Softness<S> {
    /// For a frequency in cycles a sub-step and a damping ratio.
    #[must_use]
    pub fn new(cycles: S::Scaled, damping_ratio: S::Scaled) -> Self {
        let one = S::Scaled::ONE;
        let angle = (one + one) * S::Scaled::PI * cycles;
        let a = (one + one) * damping_ratio + angle;
        let b = angle * a;
        let unit = |x: S::Scaled| S::Unit::from_scaled(x).0;
        Self { bias: unit(angle / a), mass: unit(b / (one + b)), relaxed: unit(one / (one + b)) }
    }
}
