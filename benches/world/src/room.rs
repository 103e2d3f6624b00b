//! Worlds with something in them: `k` pieces stacked at rest on a plane, or one that slides there.

use carom::solver::Settings;
use carom::{Body, BodyHandle, Collide, HalfSpace, Material, Scalar, UnitVec3, Vec3, World};

/// The highest stack.
pub const MOST: usize = 8;

/// Room for the highest stack and the plane.
pub type Room<S, Sh, const POINTS: usize> = World<S, Sh, { MOST + 1 }, MOST, POINTS>;

/// What is stacked: a metre high, of one kilogram.
pub trait Piece<S: Scalar>: Collide<S, Self> + From<HalfSpace<S>> {
    /// At the origin.
    fn new() -> Option<(Body<S>, Self)>;

    /// One that is not the same about every axis, if there is one.
    #[allow(dead_code)]
    fn odd() -> Option<(Body<S>, Self)> {
        Self::new()
    }
}

/// What is in a world.
#[derive(Clone, Copy)]
pub struct Scene {
    pub pieces: usize,
    /// Of the first piece, m/s.
    pub speed: i32,
}

/// Steps of 1/60 s.
pub fn settings<S: Scalar>(sub_steps: u8) -> Option<Settings<S>> {
    Settings::new(Vec3::new(S::ZERO, S::ZERO, S::from_ratio(-981, 100).ok()?), [1, 60], sub_steps).ok()
}

/// Of everything: friction of a half, no rebound.
pub fn surface<S: Scalar>() -> Option<Material<S>> {
    Material::new(S::ZERO, S::from_ratio(1, 2).ok()?).ok()
}

/// Sets the scene in an empty world; returns the highest piece.
pub fn fill<S: Scalar, Sh: Piece<S>, const POINTS: usize>(
    room: &mut Room<S, Sh, POINTS>,
    scene: &Scene,
) -> Option<BodyHandle> {
    room.clear();
    room.set_sleeping(false);
    let surface = surface()?;
    let mut top = room.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), surface).ok()?;
    let speed = Vec3::new(S::from_ratio(scene.speed, 1).ok()?, S::ZERO, S::ZERO);
    for (_, height) in (0..scene.pieces).zip(0i32..) {
        let (body, shape) = Sh::new()?;
        let place = Vec3::new(S::ZERO, S::ZERO, S::from_ratio(2 * height + 1, 2).ok()?);
        top = room.insert(body.at(place).moving(speed), shape, surface).ok()?;
    }
    Some(top)
}
