//! Ten boxes of 10 cm on each other. Nobody sleeps: they stand by themselves.

use carom::solver::Settings;
use carom::{Body, BodyHandle, HalfSpace, Scalar, UnitVec3, Vec3, World};

use super::make::{cube, kernel_step, material, milli, settings};

carom::shapes! {
    /// A box, or the ground.
    pub enum Piece<S> { Cuboid, HalfSpace }
}

pub const BOXES: usize = 10;
/// Ten seconds.
pub const RATE: u16 = 60;
pub const SUB_STEPS: u8 = 8;
pub const STEPS: u32 = 600;

/// Half an edge, in thousandths of a decimetre.
const HALF: i32 = 500;

/// Room for the boxes and the ground, and for each box on the one below.
pub type Room<S> = World<S, Piece<S>, { BOXES + 1 }, BOXES, { 4 * BOXES }>;

pub struct Stack<'w, S: Scalar> {
    world: &'w mut Room<S>,
    settings: Settings<S>,
    boxes: [Option<BodyHandle>; BOXES],
    pub dropped: u32,
}

impl<'w, S: Scalar> Stack<'w, S> {
    /// The boxes, one on the other without a gap.
    pub fn new(world: &'w mut Room<S>) -> Option<Self> {
        let surface = material(0, 500)?;
        world.clear();
        world.set_sleeping(false);
        world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), surface).ok()?;
        let mut boxes = [None; BOXES];
        for (index, slot) in (0i32..).zip(&mut boxes) {
            let (body, shape) = cube::<S>(HALF)?;
            let height = milli(HALF * (2 * index + 1))?;
            let body = body.at(Vec3::new(S::ZERO, S::ZERO, height));
            *slot = Some(world.insert(body, shape, surface).ok()?);
        }
        Some(Self { world, settings: settings(RATE, SUB_STEPS)?, boxes, dropped: 0 })
    }

    pub fn step(&mut self) {
        let report = kernel_step(self.world, &self.settings);
        self.dropped = self.dropped.wrapping_add(u32::from(report.dropped));
    }

    /// How far each box is below and beside the place that it was put in, from the lowest up.
    pub fn moved(&self) -> impl Iterator<Item = [S; 3]> {
        let bodies = self.boxes.iter().filter_map(|handle| self.world.body((*handle)?).ok());
        (0i32..).zip(bodies).map(|(index, body)| {
            let height = milli(HALF * (2 * index + 1)).unwrap_or(S::ZERO);
            [body.position.x, body.position.y, height.minus(body.position.z)]
        })
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
    let mut stack = Stack::new(&mut world)?;
    (0..STEPS).for_each(|_| stack.step());
    Some(stack.hash())
}
