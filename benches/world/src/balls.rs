//! Balls on a plane.

use crate::room::Piece;
use carom::{Body, Scalar, Sphere};

carom::shapes! {
    /// A ball, or the ground.
    pub enum Ball<S> { Sphere, HalfSpace }
}

impl<S: Scalar> Piece<S> for Ball<S> {
    fn new() -> Option<(Body<S>, Self)> {
        let shape = Sphere::new(S::from_ratio(1, 2).ok()?).ok()?;
        Some((Body::dynamic(shape.solid().ok()?.with_mass(S::ONE).ok()?), shape.into()))
    }
}
