//! Boxes on a plane.

use crate::room::Piece;
use carom::{Body, Cuboid, Scalar, Vec3};

carom::shapes! {
    /// A box, or the ground.
    pub enum Brick<S> { Cuboid, HalfSpace }
}

impl<S: Scalar> Piece<S> for Brick<S> {
    fn new() -> Option<(Body<S>, Self)> {
        let half = S::from_ratio(1, 2).ok()?;
        let shape = Cuboid::new(Vec3::new(half, half, half)).ok()?;
        Some((Body::dynamic(shape.solid().ok()?.with_mass(S::ONE).ok()?), shape.into()))
    }
}
