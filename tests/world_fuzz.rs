//! Ten thousand random worlds of three hundred steps: nothing panics, everything stays finite, in its arena, and within its energy.
//!
//! A closed room with up to eight bodies of four shapes, masses from grams to kilograms, speeds up to 20 m/s, spins up to 30 rad/s, any
//! restitution, friction up to 2, gravity in any direction, sometimes all in one spot, sometimes too little room for the contacts.
//! `CAROM_LONG=1` runs ten times as many.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed"))]

#[path = "support/host.rs"]
mod host;
#[path = "support/random.rs"]
mod random;
#[path = "support/scene.rs"]
mod scene;

use carom::solver::Settings;
use carom::{Body, BodyHandle, Capsule, Material, World};
use host::HostScalar;
use random::Random;
use scene::{Shape, floats, number, quat, solid, vector};

/// Half the width of the room, m.
const ROOM: f64 = 3.0;
/// How far beyond a wall a centre of mass may get where no contact was left out: half a metre, and the way of two steps at its
/// highest speed so far. What turns by a radian a sub-step can show the wall corners that are on their way out, step after step.
const BEYOND: f64 = 0.5;
const STEPS_BEYOND: f64 = 2.0;
/// The highest kinetic and potential energy, in parts of the highest that could be there at the start: that of the bodies and
/// a fall through the room.
const ENERGY: f64 = 1.1;
/// What the highest may be in the few worlds that gain more: a thing of some grams between walls that give back nearly everything,
/// which turns by radians a sub-step. One in five thousand, and one more.
const RARELY: f64 = 3.0;
const RARE: u64 = 5000;

carom::shapes! {
    /// What is thrown.
    enum Thing<S> { Sphere, Cuboid, HalfSpace, Capsule }
}

type Arena<S> = World<S, Thing<S>, 14, 24, 64>;

struct Worst {
    beyond: f64,
    energy: f64,
    gained: u64,
    dropped: u64,
    steps: u64,
    contacts: u64,
    asleep: u64,
}

fn shape<S: HostScalar>(random: &mut Random) -> (Shape, Thing<S>) {
    let mut size = || random.spread(0.05, 0.4);
    let (x, y, z) = (size(), size(), size());
    match random.below(3) {
        0 => (Shape::Sphere(x), carom::Sphere::new(number(x)).expect("a radius").into()),
        1 => {
            let half = [x, y.clamp(x / 4.0, 4.0 * x), z.clamp(x / 4.0, 4.0 * x)];
            (Shape::Cuboid(half), carom::Cuboid::new(vector(half)).expect("half edges").into())
        }
        _ => {
            let capsule = Capsule::new(number(y), number(x)).expect("a capsule");
            (Shape::Cuboid([x, x, y + x]), capsule.into())
        }
    }
}

fn energy<S: HostScalar>(world: &Arena<S>, bodies: &[(BodyHandle, f64)], gravity: [f64; 3]) -> f64 {
    let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(&b).map(|(a, b)| a * b).sum::<f64>();
    bodies
        .iter()
        .map(|(handle, mass)| {
            let body = world.body(*handle).expect("it is there");
            let [v, x] = [body.linear_velocity, body.position].map(floats);
            mass * (0.5 * dot(v, v) - dot(gravity, x))
        })
        .sum()
}

fn world<S: HostScalar>(name: &str, seed: u64, worst: &mut Worst) {
    let mut random = Random::new(seed);
    let mut world = Arena::<S>::new();
    let material =
        Material::new(number(random.between(0.0, 1.0)), number(random.between(0.0, 2.0))).expect("a material");
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            let (mut normal, mut at) = ([0.0; 3], [0.0; 3]);
            (normal[axis], at[axis]) = (-side, side * ROOM);
            let wall = Shape::HalfSpace(normal);
            let wall: Thing<S> = match wall.build::<S>() {
                scene::Piece::HalfSpace(plane) => plane.into(),
                _ => unreachable!(),
            };
            world.insert(Body::immovable().at(vector(at)), wall, material).expect("room");
        }
    }
    let strength = if random.one_in(8) { 0.0 } else { random.spread(0.5, 20.0) };
    let gravity = random.direction().map(|d| d * strength);
    let one_spot = random.one_in(10);
    let mut bodies = vec![];
    let (mut start, mut fall) = (0.0, 0.0);
    for _ in 0..=random.below(7) {
        let (outline, thing) = shape::<S>(&mut random);
        let mass = random.spread(0.01, 10.0);
        let mut place = || if one_spot { 0.0 } else { random.between(-0.75 * ROOM, 0.75 * ROOM) };
        let mut body = Body::dynamic(solid(mass, outline)).at(vector([place(), place(), place()]));
        let mut signed = |limit: f64| random.between(-limit, limit);
        body.set_orientation(quat([signed(1.0), signed(1.0), signed(1.0), 0.3]));
        let velocity = [signed(11.0), signed(11.0), signed(11.0)];
        let spin = [signed(17.0), signed(17.0), signed(17.0)];
        body.linear_velocity = vector(velocity);
        body.angular_velocity = vector(spin);
        bodies.push((world.insert(body, thing, material).expect("room"), mass));
        let square = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>();
        start += 0.5 * mass * square(velocity) + mass * 0.4 * square(spin);
        fall += mass * strength * 3f64.sqrt() * ROOM;
    }
    let settings = Settings::new(vector(gravity), [1, 60], 4).expect("settings");
    let mut left_out = false;
    let mut fastest = vec![0f64; bodies.len()];
    for step in 0..300 {
        let report = world.step(&settings);
        let at = format!("{name}, world {seed}, step {step}");
        assert_eq!(report.quarantined, 0, "{at}");
        worst.dropped += u64::from(report.dropped);
        worst.contacts += u64::from(report.points);
        worst.asleep += u64::from(report.asleep);
        worst.steps += 1;
        for ((handle, _), fastest) in bodies.iter().zip(&mut fastest) {
            let body = world.body(*handle).expect("it is there");
            assert!(body.check().is_ok(), "{at}: {body:?}");
            let far = floats(body.position).into_iter().map(f64::abs).fold(0.0, f64::max) - ROOM;
            left_out |= report.dropped > 0;
            if !left_out {
                let speed = floats(body.linear_velocity).iter().map(|v| v * v).sum::<f64>().sqrt();
                *fastest = fastest.max(speed);
                worst.beyond = worst.beyond.max(far);
                assert!(far <= BEYOND + STEPS_BEYOND * *fastest / 60.0, "{at}: {far} beyond a wall at up to {fastest}");
            }
        }
        let part = (energy(&world, &bodies, gravity) + fall) / (start + 2.0 * fall);
        worst.energy = worst.energy.max(part);
        assert!(part <= RARELY, "{at}: {part} of the energy that there was");
        if part > ENERGY {
            println!("{at}: {part:.2} of the energy that there was");
            worst.gained += 1;
            return;
        }
    }
}

fn worlds<S: HostScalar>(name: &str, share: u64) {
    let long = std::env::var_os("CAROM_LONG").is_some();
    let count = if long { 10 * share } else { share };
    let mut worst = Worst { beyond: 0.0, energy: 0.0, gained: 0, dropped: 0, steps: 0, contacts: 0, asleep: 0 };
    for seed in 0..count {
        world::<S>(name, seed, &mut worst);
    }
    println!(
        "{name}: {count} worlds, {:.2} m beyond, {:.2} of the energy, {:.2} points a step, {:.4} dropped, {:.2} asleep",
        worst.beyond,
        worst.energy,
        worst.contacts as f64 / worst.steps as f64,
        worst.dropped as f64 / worst.steps as f64,
        worst.asleep as f64 / worst.steps as f64
    );
    assert!(worst.gained <= count / RARE + 1, "{name}: {} of {count} worlds gained energy", worst.gained);
    assert!(worst.contacts > worst.steps, "{name}: little touched");
    assert!(worst.asleep > worst.steps / 20, "{name}: nothing came to rest");
}

#[cfg(feature = "f32")]
#[test]
fn f32() {
    worlds::<f32>("f32", 3000);
}

#[cfg(feature = "f64")]
#[test]
fn f64() {
    worlds::<f64>("f64", 500);
}

#[cfg(feature = "fixed")]
mod fixed_point {
    use super::worlds;

    #[test]
    fn i16f16() {
        worlds::<fixed::types::I16F16>("i16f16", 3000);
    }

    #[test]
    fn i12f20() {
        worlds::<fixed::types::I12F20>("i12f20", 3000);
    }

    #[test]
    fn i8f24() {
        worlds::<fixed::types::I8F24>("i8f24", 1000);
    }
}
