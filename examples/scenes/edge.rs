//! A box of 10 cm on its edge, its centre of mass a little past it: it falls, however little that is.

use carom::solver::Settings;
use carom::{Body, BodyHandle, HalfSpace, Quat, Scalar, UnitVec3, Vec3, World};

use super::make::{cube, kernel_step, material, settings};

carom::shapes! {
    /// The box, or the ground.
    pub enum Piece<S> { Cuboid, HalfSpace }
}

/// A box that starts to fall.
#[derive(Clone, Copy)]
pub struct Start {
    /// Hundredths of a degree past the edge.
    pub past: i32,
    /// Half the angle of the box: its cosine and sine in units of 1e-9.
    turn: [i32; 2],
    /// The height of the centre of mass in units of 1e-9 dm.
    height: i32,
    /// The time until it lies on its side as this scene takes it in f64, ms: `tests/examples.rs` holds it.
    pub in_f64: u32,
}

/// The angles, from the steepest on.
pub const STARTS: [Start; 4] = [
    Start { past: 50, turn: [922_200_972, 386_710_962], height: 707_079_857, in_f64: 508 },
    Start { past: 10, turn: [923_545_226, 383_489_524], height: 707_105_704, in_f64: 666 },
    Start { past: 5, turn: [923_712_467, 383_086_514], height: 707_106_512, in_f64: 741 },
    Start { past: 1, turn: [923_846_134, 382_764_055], height: 707_106_770, in_f64: 900 },
];

/// Steps in a second, and the most that a box is given: five seconds.
pub const RATE: u16 = 120;
pub const STEPS: u32 = 600;

/// Half an edge, in thousandths of a decimetre.
const HALF: i32 = 500;

/// Room for the box and the ground.
pub type Room<S> = World<S, Piece<S>, 2, 1, 4>;

/// A box on its edge.
pub struct Toppling<'w, S: Scalar> {
    world: &'w mut Room<S>,
    settings: Settings<S>,
    cube: BodyHandle,
}

impl<'w, S: Scalar> Toppling<'w, S> {
    pub fn new(world: &'w mut Room<S>, start: &Start) -> Option<Self> {
        let surface = material(0, 500)?;
        world.clear();
        world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), surface).ok()?;
        let billionths = |n| S::Unit::from_ratio(n, 1_000_000_000).ok();
        let (mut body, shape) = cube::<S>(HALF)?;
        body.position = Vec3::new(S::ZERO, S::ZERO, S::from_ratio(start.height, 1_000_000_000).ok()?);
        let [cosine, sine] = start.turn;
        let zero = S::Unit::ZERO;
        body.set_orientation(Quat::normalize(billionths(cosine)?, zero, billionths(sine)?, zero).ok()?);
        let cube = world.insert(body, shape, surface).ok()?;
        Some(Self { world, settings: settings(RATE, 2)?, cube })
    }

    /// A step; whether the box is still on its way. It may sleep: that must not stop it on its edge.
    pub fn step(&mut self) -> bool {
        kernel_step(self.world, &self.settings);
        self.lean().is_some_and(|lean| S::Unit::from_ratio(999, 1000).is_ok_and(|flat| lean < flat))
    }

    /// The sine of the angle by which the box has turned: about 0.7 on the edge, 1 on the side.
    pub fn lean(&self) -> Option<S::Unit> {
        let [x, ..] = self.world.body(self.cube).ok()?.orientation().to_mat3().rows;
        Some(x.z)
    }

    pub fn hash(&self) -> u64 {
        self.world.hash()
    }
}

/// The time until the box lies on its side, ms, and the hash of its state then; no time where it never does.
pub fn fall<S: Scalar>(world: &mut Room<S>, start: &Start) -> Option<(Option<u32>, u64)> {
    let mut toppling = Toppling::new(world, start)?;
    let time = (1..=STEPS).find(|_| !toppling.step()).map(|step| step * 1000 / u32::from(RATE));
    Some((time, toppling.hash()))
}

/// One hash after another.
pub const fn chained(hash: u64, next: u64) -> u64 {
    (hash ^ next).wrapping_mul(0x0000_0100_0000_01b3)
}

/// The hash of all four.
pub fn hash<S: Scalar>() -> Option<u64> {
    let mut world = Room::<S>::new();
    let mut hash = 0;
    for start in &STARTS {
        hash = chained(hash, fall(&mut world, start)?.1);
    }
    Some(hash)
}
