//! Boxes on a plane.

use crate::room::Piece;
use carom::{Body, Cuboid, Scalar, Vec3};

carom::shapes! {
    /// A box, or the ground.
    pub enum Brick<S> { Cuboid, HalfSpace }
}

impl<S: Scalar> Piece<S> for Brick<S> {
    fn new() -> Option<(Body<S>, Self)> {
        of([10, 10, 10])
    }

    fn odd() -> Option<(Body<S>, Self)> {
        of([12, 8, 10])
    }
}

/// A box with these half edges in twentieths of a metre.
fn of<S: Scalar>(halves: [i32; 3]) -> Option<(Body<S>, Brick<S>)> {
    let [x, y, z] = halves.map(|n| S::from_ratio(n, 20).ok());
    let shape = Cuboid::new(Vec3::new(x?, y?, z?)).ok()?;
    Some((Body::dynamic(shape.solid().ok()?.with_mass(S::ONE).ok()?), shape.into()))
}
