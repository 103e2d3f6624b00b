//! How the cost of a step grows: scenes that cost much, each with two, four and eight sub-steps, every step with what there was to
//! do. `cargo xtask bench` finds the constants of a bound in them, all but the jam, and holds the bound against the jam.

use crate::board;
use crate::harness::counter;
use crate::harness::scene::Play;
use crate::kernels::Stepped;
use crate::measure::Game;
use crate::room::{MOST, settings};
use carom::{Aabb, Body, HalfSpace, Material, Pairs, Pose, Quat, Scalar, SweepAndPrune, UnitVec3, Vec3};

const STEPS: u32 = 48;

/// Numbers of thousandths.
type Milli = [i32; 3];

/// Where a piece begins: position, velocity, spin, and the components of a quaternion.
struct Start {
    position: Milli,
    velocity: Milli,
    spin: Milli,
    orientation: [i32; 4],
}

const UPRIGHT: [i32; 4] = [1000, 0, 0, 0];
const TILTED: [i32; 4] = [800, 360, -480, 0];

/// A name, friction and restitution in thousandths, and where each piece begins, by its number and the sub-steps.
type Costly = (&'static str, [i32; 2], fn(i32, i32) -> Start);

const SCENES: [Costly; 6] = [
    // Nothing touches or turns.
    ("calm", [500, 0], |i, _| Start {
        position: [3000 * i - 12_000, 0, 40_000],
        velocity: [0; 3],
        spin: [0; 3],
        orientation: TILTED,
    }),
    // Nothing touches. Spins just below a radian a sub-step take the most rounds.
    ("free", [500, 0], |i, sub_steps| Start {
        position: [3000 * i - 12_000, 0, 40_000],
        velocity: [0; 3],
        spin: [20_000 * sub_steps, 30_000 * sub_steps, 10_000 * sub_steps],
        orientation: TILTED,
    }),
    ("stack", [500, 0], |i, _| Start {
        position: [0, 0, 1000 * i + 500],
        velocity: [0; 3],
        spin: [0; 3],
        orientation: UPRIGHT,
    }),
    ("slide", [300, 0], |i, _| Start {
        position: [0, 2000 * i - 8000, 498],
        velocity: [7000, 300 * i, 0],
        spin: [0, 0, 1000],
        orientation: UPRIGHT,
    }),
    ("bounce", [500, 700], |i, _| Start {
        position: [2000 * i - 8000, 0, 560 + 20 * i],
        velocity: [1000, 0, -2000],
        spin: [2000, 1000, 3000],
        orientation: UPRIGHT,
    }),
    // Four are thrown together.
    ("jam", [600, 300], |i, _| Start {
        position: [600 * (i % 2) - 300, 500 * (i / 2) - 250, 900 + 650 * i],
        velocity: [2000 - 4000 * (i % 2), 1500 - 1000 * i, -4000],
        spin: [5000 * i - 6000, 4000, 7000 - 3000 * i],
        orientation: TILTED,
    }),
];

/// Prints `bound KIND SCENE SUB-STEPS BODIES PAIRS POINTS INSTRUCTIONS` for every step, from an empty world.
pub fn run<S: Scalar, Sh: Stepped<S, POINTS>, const POINTS: usize>(
    game: &mut Game<S, Sh, POINTS>,
    kind: &str,
    most: usize,
    sub_steps: u8,
) -> Option<()> {
    game.settings = settings(sub_steps)?;
    let empty = counter::instructions(&game.step())?;
    board::println!("bound {kind} empty {sub_steps} 0 0 0 {empty}");
    for (name, material, start) in &SCENES {
        let count = if *name == "jam" { 4 } else { most };
        fill(game, *material, |i| start(i, i32::from(sub_steps)), count)?;
        play(game, kind, name, sub_steps, count)?;
    }
    Some(())
}

fn fill<S: Scalar, Sh: Stepped<S, POINTS>, const POINTS: usize>(
    game: &mut Game<S, Sh, POINTS>,
    [friction, restitution]: [i32; 2],
    start: impl Fn(i32) -> Start,
    count: usize,
) -> Option<()> {
    let room = &mut game.room;
    room.clear();
    room.set_sleeping(false);
    let surface = Material::new(milli(restitution)?, milli(friction)?).ok()?;
    room.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), surface).ok()?;
    for (_, i) in (0..count).zip(0i32..) {
        let Start { position, velocity, spin, orientation } = start(i);
        let (body, shape) = Sh::odd()?;
        let mut body = body.at(vector(position)?).moving(vector(velocity)?);
        body.angular_velocity = vector(spin)?;
        let [w, x, y, z] = orientation.map(|n| S::Unit::from_ratio(n, 1000).ok());
        body.set_orientation(Quat::new(w?, x?, y?, z?).ok()?);
        room.insert(body, shape, surface).ok()?;
    }
    Some(())
}

fn play<S: Scalar, Sh: Stepped<S, POINTS>, const POINTS: usize>(
    game: &mut Game<S, Sh, POINTS>,
    kind: &str,
    name: &str,
    sub_steps: u8,
    count: usize,
) -> Option<()> {
    for _ in 0..STEPS {
        let pairs = pairs(game)?;
        let instructions = counter::instructions(&game.step())?;
        let points = game.report.points;
        board::println!("bound {kind} {name} {sub_steps} {count} {pairs} {points} {instructions}");
    }
    Some(())
}

/// The pairs of boxes that overlap: what the narrow phase is asked. Nothing is so fast here that the world widens its box for
/// that.
fn pairs<S: Scalar, Sh: Stepped<S, POINTS>, const POINTS: usize>(game: &Game<S, Sh, POINTS>) -> Option<usize> {
    let mut boxes = [Aabb::NOTHING; MOST + 1];
    let mut len = 0;
    for ((handle, body), place) in game.room.bodies().zip(&mut boxes) {
        let shape = game.room.shape(handle).ok()?;
        let near = shape.inner_radius().lowered_by(crate::stages::NEAR);
        *place = shape.aabb(&Pose::new(body.position, body.orientation())).expanded(near);
        len += 1;
    }
    let mut found = Pairs::new([[0; 2]; 40]);
    SweepAndPrune::new([0; MOST + 1]).sweep(&boxes[..len], &mut found);
    Some(found.found().len())
}

fn vector<S: Scalar>([x, y, z]: Milli) -> Option<Vec3<S>> {
    Some(Vec3::new(milli(x)?, milli(y)?, milli(z)?))
}

fn milli<S: Scalar>(n: i32) -> Option<S> {
    S::from_ratio(n, 1000).ok()
}
