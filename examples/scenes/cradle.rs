//! Newton's cradle: five steel balls on threads of one metre.
//!
//! Threads are not part of the kernel. A ball on two threads that swings a little moves to and fro along a line as if a spring
//! held it at its place, whatever its mass: v' = -(g/L) (x - x0). That is what the scene does to each ball before a step, by
//! hand; the blows are the world's. The places are a millimetre farther apart than the balls are thick, so that no two blows
//! fall into one step: what the ball of a cradle whose balls touch would do is decided by their elasticity, which a rigid
//! body does not have.

use carom::solver::Settings;
use carom::{BodyHandle, Scalar, Scaled, Sphere, Vec3, World};

use super::make::{ball, kernel_step, material, milli, per_mille, square, vector};

pub const BALLS: usize = 5;
/// Four seconds: two swings.
pub const RATE: u16 = 1000;
pub const SUB_STEPS: u8 = 1;
pub const STEPS: u32 = 4000;

/// Thousandths of a decimetre: the radius, the distance of the places, and how far the first ball is drawn aside.
const RADIUS: i32 = 200;
const PITCH: i32 = 2 * RADIUS + 10;
const ASIDE: i32 = 2000;
/// g/L, in thousandths of 1/s^2.
const STIFFNESS: i32 = 9810;

/// Room for the balls and one contact between neighbours.
pub type Room<S> = World<S, Sphere<S>, BALLS, { BALLS - 1 }, { BALLS - 1 }>;

/// A ball's handle, and its place.
type Place<S> = Option<(BodyHandle, S)>;

pub struct Cradle<'w, S: Scalar> {
    world: &'w mut Room<S>,
    settings: Settings<S>,
    balls: [Place<S>; BALLS],
    /// What a step of the threads is: g/L times the step.
    pull: S::Scaled,
    pub impacts: u32,
    /// The fastest that the first and the last ball have been so far, dm/s.
    pub fastest: [S; 2],
}

impl<'w, S: Scalar> Cradle<'w, S> {
    /// The first ball drawn aside, the others at rest.
    pub fn new(world: &'w mut Room<S>) -> Option<Self> {
        let steel = material(1000, 0)?;
        world.clear();
        let mut balls = [None; BALLS];
        for (index, slot) in (0i32..).zip(&mut balls) {
            let place = milli::<S>(PITCH * (index - 2))?;
            let (mut body, shape) = ball::<S>(RADIUS * 1000)?;
            let aside = if index == 0 { milli(ASIDE)? } else { S::ZERO };
            body.position.x = place.minus(aside);
            *slot = Some((world.insert(body, shape, steel).ok()?, place));
        }
        let settings = Settings::new(vector([0; 3])?, [1, RATE], SUB_STEPS).ok()?;
        let pull = S::Scaled::ratio(STIFFNESS, 1000 * i32::from(RATE));
        Some(Self { world, settings, balls, pull, impacts: 0, fastest: [S::ZERO; 2] })
    }

    pub fn step(&mut self) {
        for (handle, place) in self.balls.iter().flatten() {
            let Ok(body) = self.world.body_mut(*handle) else { continue };
            let back = place.minus(body.position.x).to_scaled() * self.pull;
            let speed = body.linear_velocity.x.to_scaled() + back;
            body.linear_velocity.x = S::from_scaled(speed).0;
        }
        kernel_step(self.world, &self.settings);
        self.impacts = self.impacts.wrapping_add(self.world.impacts().count() as u32);
        let speeds = [self.balls.first(), self.balls.last()].map(|place| {
            let body = place.copied().flatten().and_then(|(handle, _)| self.world.body(handle).ok());
            body.map_or(S::ZERO, |body| body.linear_velocity.x)
        });
        for (fastest, speed) in self.fastest.iter_mut().zip(speeds) {
            if speed > *fastest {
                *fastest = speed;
            }
        }
    }

    /// Where the balls are, and how fast.
    pub fn balls(&self) -> impl Iterator<Item = (S, S)> {
        let bodies = self.balls.iter().flatten().filter_map(|(handle, _)| self.world.body(*handle).ok());
        bodies.map(|body| (body.position.x, body.linear_velocity.x))
    }

    /// The momentum of all balls, in ball masses times dm/s.
    pub fn momentum(&self) -> S {
        self.balls().fold(S::ZERO, |sum, (_, speed)| sum.plus(speed))
    }

    /// The energy of motion and height, in thousandths of what the first ball was given.
    pub fn energy(&self) -> S {
        let stiffness = S::Scaled::ratio(STIFFNESS, 1000);
        let height = |aside: S| stiffness * square(Vec3::new(aside, S::ZERO, S::ZERO));
        let mut energy = S::Scaled::ZERO;
        for ((position, speed), place) in self.balls().zip(self.balls.iter().flatten()) {
            energy = energy + square(Vec3::new(speed, S::ZERO, S::ZERO)) + height(position.minus(place.1));
        }
        per_mille(energy, height(milli(ASIDE).unwrap_or(S::ONE)))
    }

    /// All that there is.
    pub fn world(&self) -> &Room<S> {
        self.world
    }

    pub fn settings(&self) -> &Settings<S> {
        &self.settings
    }

    pub fn hash(&self) -> u64 {
        self.world.hash()
    }
}

/// The hash after all steps.
pub fn hash<S: Scalar>() -> Option<u64> {
    let mut world = Room::<S>::new();
    let mut cradle = Cradle::new(&mut world)?;
    (0..STEPS).for_each(|_| cradle.step());
    Some(cradle.hash())
}
