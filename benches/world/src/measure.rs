//! The measurement in one number type: every scene to its end, then what a step is made of.

use crate::balls::Ball;
use crate::board;
use crate::bounds;
use crate::bricks::Brick;
use crate::harness::arena::Arena;
use crate::harness::scene::{self, Play};
use crate::harness::{Call, counter};
use crate::kernels::{OF_BALLS, OF_BRICKS, Stepped};
use crate::room::{MOST, Room, Scene, fill, settings};
use crate::stages::{self, Pieces};
use carom::solver::Settings;
use carom::world::WorldReport;
use carom::{Body, Scalar, World};

const BALLS: [(&str, Scene); 4] = [
    ("spheres_1", Scene { pieces: 1, speed: 0 }),
    ("spheres_4", Scene { pieces: 4, speed: 0 }),
    ("spheres_8", Scene { pieces: MOST, speed: 0 }),
    ("slide", Scene { pieces: 1, speed: 7 }),
];

const BRICKS: [(&str, Scene); 3] = [
    ("boxes_1", Scene { pieces: 1, speed: 0 }),
    ("boxes_4", Scene { pieces: 4, speed: 0 }),
    ("boxes_8", Scene { pieces: MOST, speed: 0 }),
];

/// A world at a time, or the pieces of one.
static ARENA: Arena<{ if cfg!(small) { 9_900 } else { 15_000 } }> = Arena::new();

/// The bodies of a world, the plane first.
pub type Bodies<S> = [Body<S>; MOST + 1];

/// Measures everything, and prints it line by line:
///
/// - `counter EMPTY TICKS`: what was subtracted; ticks of the counter for a thousand instructions
/// - `scene carom NAME MEAN MIN MAX WORST STACK RAM WORD`: instructions of a step, the step that took most, bytes of stack,
///   bytes of the smallest world that holds the scene, and the bits of what came of it: the height of the highest piece, or the
///   speed of the one that slid
/// - `bound ...`: see there
/// - `stages NAME BROAD NARROW PREPARE SOLVE INTEGRATE KEEP`: instructions of the step after the last
pub fn run<S: Scalar>() -> Result<(), &'static str>
where
    Ball<S>: Stepped<S, OF_BALLS>,
    Brick<S>: Stepped<S, OF_BRICKS>,
{
    board::println!("counter {} {}", counter::empty(), counter::ticks_per_thousand());
    let rams =
        [World::<S, Ball<S>, 2, 1, 1>::RAM, World::<S, Ball<S>, 5, 4, 4>::RAM, World::<S, Ball<S>, 9, 8, 8>::RAM];
    for (scene, ram) in BALLS.iter().zip(rams.iter().chain([&rams[0]])) {
        play::<S, Ball<S>, OF_BALLS>(scene, *ram)?;
    }
    let rams =
        [World::<S, Brick<S>, 2, 1, 4>::RAM, World::<S, Brick<S>, 5, 4, 16>::RAM, World::<S, Brick<S>, 9, 8, 32>::RAM];
    for (scene, ram) in BRICKS.iter().zip(rams).filter(|((_, scene), _)| 4 * scene.pieces <= OF_BRICKS) {
        play::<S, Brick<S>, OF_BRICKS>(scene, ram)?;
    }
    bound::<S, Ball<S>, OF_BALLS>("spheres")?;
    bound::<S, Brick<S>, OF_BRICKS>("boxes")?;
    // A stack that grew into the statics would show here.
    if counter::is_exact() { Ok(()) } else { Err("the counter does not count exactly any more") }
}

/// A world that is stepped.
pub struct Game<S: Scalar, Sh, const POINTS: usize> {
    pub room: Room<S, Sh, POINTS>,
    pub settings: Settings<S>,
    pub report: WorldReport,
    /// A step left something out, or ran against the end of the format.
    failed: bool,
}

impl<S: Scalar, Sh: Stepped<S, POINTS>, const POINTS: usize> Play for Game<S, Sh, POINTS> {
    fn prepare(&mut self) {
        let WorldReport { dropped, quarantined, saturated, .. } = self.report;
        self.failed |= dropped > 0 || quarantined > 0 || saturated;
    }

    fn step(&mut self) -> Call {
        let Self { room, settings, report, .. } = self;
        Call::new(Sh::step(), [(&raw mut *room).cast(), (&raw mut *settings).cast(), (&raw mut *report).cast()])
    }
}

/// Prints the scene's lines.
fn play<S: Scalar, Sh: Stepped<S, POINTS>, const POINTS: usize>(
    &(name, scene): &(&str, Scene),
    ram: usize,
) -> Result<(), &'static str> {
    // SAFETY: an empty world is all zero, and so may numbers be. What was there before is forgotten.
    let game = unsafe { ARENA.zeroed::<Game<S, Sh, POINTS>>() };
    game.settings = settings(4).ok_or(UNSET)?;
    fill(&mut game.room, &scene).ok_or(UNSET)?;
    let stack = scene::stack(game).ok_or("a step took more stack than is painted")?;
    let top = fill(&mut game.room, &scene).ok_or(UNSET)?;
    let found = scene::instructions(game).ok_or("a step took longer than the counter counts")?;
    game.prepare();
    if game.failed {
        return Err("a step left something out");
    }
    let body = game.room.body(top).map_err(|_| UNSET)?;
    let outcome = if scene.speed > 0 { body.linear_velocity.x } else { body.position.z };
    let scene::Instructions { mean, min, max, worst } = found;
    board::println!("scene carom {name} {mean} {min} {max} {worst} {stack} {ram} {}", outcome.bits() as u32);
    let [broad, narrow, prepare, solve, integrate, keep] = stages(game, &scene).ok_or("a stage took too long")?;
    board::println!("stages {name} {broad} {narrow} {prepare} {solve} {integrate} {keep}");
    Ok(())
}

/// Prints how the cost of a step grows.
#[inline(never)]
fn bound<S: Scalar, Sh: Stepped<S, POINTS>, const POINTS: usize>(kind: &str) -> Result<(), &'static str> {
    // As many boxes as there is room for their points.
    let most = if kind == "boxes" { POINTS / 4 } else { MOST };
    for sub_steps in [2, 4, 8] {
        // SAFETY: as in `play`.
        let game = unsafe { ARENA.zeroed::<Game<S, Sh, POINTS>>() };
        bounds::run(game, kind, most, sub_steps).ok_or("the scenes of the bound cannot be played")?;
    }
    Ok(())
}

/// What a step of the world's bodies is made of. A function of its own, so that its copies of the bodies are in nobody's way.
#[inline(never)]
fn stages<S: Scalar, Sh: Stepped<S, POINTS>, const POINTS: usize>(
    game: &mut Game<S, Sh, POINTS>,
    scene: &Scene,
) -> Option<[u32; 6]> {
    let mut bodies = [Body::immovable(); MOST + 1];
    bodies.iter_mut().zip(game.room.bodies()).for_each(|(place, (_, body))| *place = *body);
    // SAFETY: pieces are numbers, and enums and flags whose first value is zero. Nobody uses the world any more.
    let pieces = unsafe { ARENA.zeroed::<Pieces<S, Sh, POINTS>>() };
    pieces.take(&bodies, scene.pieces + 1)?;
    stages::measure(pieces)
}

const UNSET: &str = "a scene cannot be set";
