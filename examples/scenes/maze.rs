//! A marble in a maze that somebody tilts: walls from a table in flash, gravity from an accelerometer's trace.

use carom::solver::Settings;
use carom::world::Phase;
use carom::{Body, BodyHandle, Cuboid, HalfSpace, Scalar, UnitVec3, Vec3, World};

use super::make::{GRAVITY, ball, kernel_step, material, settings, vector};
use super::tilt::{self, TRACE};

carom::shapes! {
    /// The marble and the goal, a wall inside, the floor or a wall outside.
    pub enum Piece<S> { Sphere, Cuboid, HalfSpace }
}

/// The maze in centimetres from one outer wall to the other, from the middle of one to the middle of the other.
pub const SIZE: [i32; 2] = [20, 16];
/// Where the walls inside begin and end, in centimetres from the lower left corner.
pub const WALLS: [[[i32; 2]; 2]; 6] = [
    [[0, 12], [12, 12]],
    [[12, 8], [12, 12]],
    [[8, 8], [12, 8]],
    [[4, 4], [4, 8]],
    [[4, 4], [16, 4]],
    [[16, 4], [16, 16]],
];
/// Where the marble starts, and where it has to go.
const START: [i32; 2] = [2, 14];
pub const GOAL: [i32; 2] = [18, 14];
/// The goal's place among the bodies: behind the floor and all walls.
pub const GOAL_PLACE: usize = 5 + WALLS.len();

/// Steps a second, and to a sample of the trace.
pub const RATE: u16 = 120;
pub const SUB_STEPS: u8 = 2;
pub const STEPS: u32 = TRACE.len() as u32 * STEPS_OF_SAMPLE;
const STEPS_OF_SAMPLE: u32 = (RATE / tilt::RATE) as u32;

/// Thousandths of a decimetre: the marble's radius, half the thickness of a wall, half its height.
const RADIUS: i32 = 120;
const THICKNESS: i32 = 50;
const HEIGHT: i32 = 100;

/// Room for floor, four walls outside, those inside, the goal and the marble, and for the marble on the floor in a corner.
pub type Room<S> = World<S, Piece<S>, { 7 + WALLS.len() }, 6, 6>;

/// A place in centimetres from the corner, in thousandths of a decimetre from the middle.
fn place([x, y]: [i32; 2], height: i32) -> [i32; 3] {
    [100 * x - 50 * SIZE[0], 100 * y - 50 * SIZE[1], height]
}

pub struct Maze<'w, S: Scalar> {
    world: &'w mut Room<S>,
    settings: Settings<S>,
    marble: BodyHandle,
    steps: u32,
    /// The step in which the marble reached the goal.
    pub reached: Option<u32>,
    pub dropped: u32,
}

impl<'w, S: Scalar> Maze<'w, S> {
    pub fn new(world: &'w mut Room<S>) -> Option<Self> {
        let glass = material(300, 250)?;
        world.clear();
        world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), glass).ok()?;
        let [x, y] = SIZE.map(|size| 50 * size - THICKNESS);
        for (at, inwards) in
            [([-x, 0, 0], UnitVec3::X), ([x, 0, 0], -UnitVec3::X), ([0, -y, 0], UnitVec3::Y), ([0, y, 0], -UnitVec3::Y)]
        {
            world.insert(Body::immovable().at(vector(at)?), HalfSpace::new(inwards), glass).ok()?;
        }
        for [from, to] in WALLS {
            let ([left, lower], [right, upper]) = (from, to);
            let middle = place([(left + right) / 2, (lower + upper) / 2], HEIGHT);
            let half = [50 * (right - left) + THICKNESS, 50 * (upper - lower) + THICKNESS, HEIGHT];
            let wall = Cuboid::new(vector(half)?).ok()?;
            world.insert(Body::immovable().at(vector(middle)?), wall, glass).ok()?;
        }
        let (marble, shape) = ball::<S>(RADIUS * 1000)?;
        let goal = world.insert(Body::immovable().at(vector(place(GOAL, RADIUS))?), shape, glass).ok()?;
        world.set_sensor(goal, true).ok()?;
        let marble = world.insert(marble.at(vector(place(START, RADIUS))?), shape, glass).ok()?;
        Some(Self { world, settings: settings(RATE, SUB_STEPS)?, marble, steps: 0, reached: None, dropped: 0 })
    }

    /// A step under the hand of the trace.
    pub fn step(&mut self) {
        if let Some(sample) = TRACE.get((self.steps / STEPS_OF_SAMPLE) as usize) {
            self.tilt(*sample);
        }
        self.advance();
    }

    /// Gravity as a sensor in the maze's frame shows it, in thousandths of the acceleration of free fall.
    pub fn tilt(&mut self, sample: [i16; 3]) {
        // The opposite of what a sensor at rest shows.
        let [x, y, z] = sample.map(|part| S::from_ratio(i32::from(part) * -(GRAVITY / 100), 10_000));
        if let (Ok(x), Ok(y), Ok(z)) = (x, y, z) {
            self.settings.gravity = Vec3::new(x, y, z);
        }
    }

    /// A step under gravity as it is.
    pub fn advance(&mut self) {
        let report = kernel_step(self.world, &self.settings);
        self.steps = self.steps.wrapping_add(1);
        self.dropped = self.dropped.wrapping_add(u32::from(report.dropped));
        let in_goal = self.world.contacts().any(|contact| contact.sensor && contact.phase == Phase::Began);
        if in_goal && self.reached.is_none() {
            self.reached = Some(self.steps);
        }
    }

    /// Where the marble is.
    pub fn marble(&self) -> Option<Vec3<S>> {
        self.world.body(self.marble).ok().map(|body| body.position)
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

/// The hash at the end of the trace.
pub fn hash<S: Scalar>() -> Option<u64> {
    let mut world = Room::<S>::new();
    let mut maze = Maze::new(&mut world)?;
    (0..STEPS).for_each(|_| maze.step());
    Some(maze.hash())
}
