//! Two dice of 16 mm on a table: thrown from a seed, they roll until they sleep.

use carom::solver::Settings;
use carom::{Body, BodyHandle, HalfSpace, Scalar, UnitVec3, Vec3, World};

use super::make::{cube, kernel_step, material, settings, vector};
use super::random::Random;

carom::shapes! {
    /// What is on the table, and the table.
    pub enum Piece<S> { Cuboid, HalfSpace }
}

/// Dice in a throw.
pub const DICE: usize = 2;
/// Steps in a second, and the most that a throw is given: five seconds.
pub const RATE: u16 = 120;
pub const SUB_STEPS: u8 = 4;
pub const STEPS: u32 = 600;

/// Half an edge, in thousandths of a decimetre.
pub const HALF: i32 = 80;

/// Room for the table and the dice, for each on the table and one against the other.
pub type Room<S> = World<S, Piece<S>, { DICE + 1 }, 3, 12>;

/// A throw.
pub struct Throw<'w, S: Scalar> {
    world: &'w mut Room<S>,
    settings: Settings<S>,
    dice: [Option<BodyHandle>; DICE],
    /// Points that found no room, over all steps.
    pub dropped: u32,
    /// How often a die struck the table or another one.
    pub impacts: u32,
}

impl<'w, S: Scalar> Throw<'w, S> {
    /// The dice as they leave the hand. `None` would mean that a number does not fit the format.
    pub fn new(world: &'w mut Room<S>, seed: u32) -> Option<Self> {
        world.clear();
        let surface = material(400, 300)?;
        world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), surface).ok()?;
        let mut random = Random::new(seed);
        // The first numbers of seeds that are close to each other are, too.
        (0..8).for_each(|_| _ = random.next());
        let mut dice = [None; DICE];
        for (index, die) in (0i32..).zip(&mut dice) {
            let (mut body, shape) = cube::<S>(HALF)?;
            body.position = vector([random.integer(-3200, -2800), 500 * index - 250, 1200])?;
            body.linear_velocity = vector([random.integer(9_000, 15_000), random.integer(-2_000, 2_000), 0])?;
            body.angular_velocity = random.vector(-20 * 1024, 20 * 1024);
            body.set_orientation(random.fair_orientation());
            *die = Some(world.insert(body, shape, surface).ok()?);
        }
        Some(Self { world, settings: settings(RATE, SUB_STEPS)?, dice, dropped: 0, impacts: 0 })
    }

    /// A step; whether a die still rolls.
    pub fn step(&mut self) -> bool {
        let report = kernel_step(self.world, &self.settings);
        self.dropped = self.dropped.wrapping_add(u32::from(report.dropped));
        self.impacts = self.impacts.wrapping_add(self.world.impacts().count() as u32);
        usize::from(report.asleep) < DICE
    }

    fn bodies(&self) -> impl Iterator<Item = &Body<S>> {
        self.dice.iter().filter_map(|die| self.world.body((*die)?).ok())
    }

    /// Where the dice are, and which face is closest to the top of each.
    pub fn dice(&self) -> impl Iterator<Item = (Vec3<S>, u8)> {
        self.bodies().map(|body| (body.position, top(body).0))
    }

    /// The faces on top once the dice lie; `None` of one that leans against another.
    pub fn faces(&self) -> impl Iterator<Item = Option<u8>> {
        self.bodies().map(|body| {
            let (face, cosine) = top(body);
            let level = S::Unit::from_ratio(99, 100).is_ok_and(|level| cosine > level);
            level.then_some(face)
        })
    }

    /// All that there is.
    pub fn world(&self) -> &Room<S> {
        self.world
    }

    pub fn settings(&self) -> &Settings<S> {
        &self.settings
    }

    /// The state of all bodies.
    pub fn hash(&self) -> u64 {
        self.world.hash()
    }
}

/// The face that looks up most, and the cosine of its angle to the vertical. Opposite faces add up to seven.
fn top<S: Scalar>(body: &Body<S>) -> (u8, S::Unit) {
    // The third row turns the world's vertical into the body's frame.
    let [_, _, up] = body.orientation().to_mat3().rows;
    let faces = [(1, up.x), (2, up.y), (3, up.z), (6, up.x.negated()), (5, up.y.negated()), (4, up.z.negated())];
    faces.into_iter().fold((0, S::Unit::ZERO), |best, face| if face.1 > best.1 { face } else { best })
}

/// The hash after the throw of [`SEED`].
pub fn hash<S: Scalar>() -> Option<u64> {
    let mut world = Room::<S>::new();
    let mut throw = Throw::new(&mut world, SEED)?;
    for _ in 0..STEPS {
        if !throw.step() {
            break;
        }
    }
    Some(throw.hash())
}

/// Which throw is shown and pinned.
pub const SEED: u32 = 20_261_122;
