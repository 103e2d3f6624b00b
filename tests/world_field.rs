//! Mazes in a height field: walls from one sample to the next hold what rolls and slides between them.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed"))]

#[macro_use]
#[path = "support/each_number.rs"]
mod each_number;
#[path = "support/host.rs"]
mod host;
#[path = "support/random.rs"]
mod random;
#[path = "support/scene.rs"]
mod scene;

use carom::solver::Settings;
use carom::{Body, Cuboid, HeightField, Material, Sphere, World};
use host::HostScalar;
use random::Random;
use scene::{Shape, floats, number, solid, vector};

carom::shapes! { enum Piece<'a, S> { Sphere, Cuboid, Field (HeightField<'a, S>) } }

each_number!(walls_hold_marbles, walls_hold_boxes, ridges_stop_what_is_fast);

/// Points of the grid along a side.
const SIDE: usize = 17;

/// How the walls are, in metres: their height, the distance of two points of the grid, and the size of what moves between them.
type Walls = [f64; 3];

/// A wall of two samples all around, and posts and walls in between; not in the middle.
fn maze<S: HostScalar>(wall: f64, random: &mut Random) -> Vec<S> {
    let middle = SIDE / 2 - 1..SIDE / 2 + 2;
    let is_wall = |i: usize, j: usize, random: &mut Random| {
        let border = [i, j].iter().any(|i| *i < 2 || *i > SIDE - 3);
        border || (random.one_in(8) && !(middle.contains(&i) && middle.contains(&j)))
    };
    (0..SIDE * SIDE).map(|n| number(if is_wall(n % SIDE, n / SIDE, random) { wall } else { 0.0 })).collect()
}

/// Half a minute on a table that tilts to and fro by a tenth of gravity: what rolls there runs up a wall at 0.55 m/s at most.
fn is_held<S: HostScalar>([wall, spacing, size]: Walls, shape: Shape, seed: u64) -> bool {
    let mut random = Random::new(seed);
    let heights = maze::<S>(wall, &mut random);
    let field = HeightField::new(&heights, SIDE as u16, SIDE as u16, number(spacing)).expect("a field");
    let material = Material::new(S::ZERO, number(0.4)).expect("a material");
    let mut world = World::<S, Piece<S>, 2, 32, 64>::new();
    world.insert(Body::immovable(), field, material).expect("room");
    let body = Body::dynamic(solid(0.05, shape)).at(vector([0.0, 0.0, size]));
    let piece: Piece<S> = match shape {
        Shape::Cuboid(half) => Cuboid::new(vector(half)).expect("a box").into(),
        _ => Sphere::new(number(size)).expect("a ball").into(),
    };
    let body = world.insert(body, piece, material).expect("room");
    let mut settings = Settings::<S>::new(vector([0.0, 0.0, -9.3]), [1, 60], 4).expect("settings");
    for step in 0..1800 {
        if step % 30 == 0 {
            settings.gravity = vector([random.between(-1.0, 1.0), random.between(-1.0, 1.0), -9.3]);
        }
        world.step(&settings);
        let body = world.body(body).expect("a body");
        let ([_, _, height], [_, _, up]) = (floats(body.position), floats(body.linear_velocity));
        if height < 0.0 || height > wall + size || up > 0.6 {
            return false;
        }
    }
    true
}

fn walls_hold_marbles<S: HostScalar>(name: &str) {
    for walls in [[0.15, 0.1, 0.04], [0.15, 0.05, 0.04], [0.3, 0.1, 0.04], [0.15, 0.1, 0.02], [0.15, 0.1, 0.08]] {
        let out: Vec<_> = (0..10).filter(|seed| !is_held::<S>(walls, Shape::Sphere(walls[2]), *seed)).collect();
        assert!(out.is_empty(), "{name}: it left the mazes {out:?} with walls {walls:?}");
    }
}

fn walls_hold_boxes<S: HostScalar>(name: &str) {
    for walls in [[0.15, 0.1, 0.03], [0.3, 0.1, 0.03]] {
        let out: Vec<_> = (0..10).filter(|seed| !is_held::<S>(walls, Shape::Cuboid([walls[2]; 3]), *seed)).collect();
        assert!(out.is_empty(), "{name}: it left the mazes {out:?} with walls {walls:?}");
    }
}

/// A marble that flies low over flat ground strikes the ridge across its way, wherever its steps begin: along a slope of 45
/// degrees it goes on at half of its speed in either direction, less the friction of the blow.
fn ridges_stop_what_is_fast<S: HostScalar>(name: &str) {
    let ridge = SIDE - 4;
    let heights: Vec<S> = (0..SIDE * SIDE).map(|n| number(if n % SIDE == ridge { 0.1 } else { 0.0 })).collect();
    for from in 0..40 {
        for speed in [10.0, 30.0] {
            let field = HeightField::new(&heights, SIDE as u16, SIDE as u16, number(0.1)).expect("a field");
            let material = Material::new(S::ZERO, number(0.1)).expect("a material");
            let mut world = World::<S, Piece<S>, 2, 32, 64>::new();
            world.insert(Body::immovable(), field, material).expect("room");
            let mut ball = Body::dynamic(solid(0.05, Shape::Sphere(0.02)));
            ball.position = vector([-0.7 + 0.015 * f64::from(from), 0.03, 0.05]);
            ball.linear_velocity = vector([speed, 0.0, 0.0]);
            let ball = world.insert(ball, Sphere::new(number(0.02)).expect("a ball"), material).expect("room");
            let settings = Settings::<S>::new(vector([0.0; 3]), [1, 60], 4).expect("settings");
            for _ in 0..(1.6 / speed * 60.0) as usize {
                world.step(&settings);
            }
            let [x, _, up] = floats(world.body(ball).expect("a body").linear_velocity);
            let right = 0.5 * (1.0 - 0.1) * speed;
            let off = (x - right).abs().max((up - right).abs());
            assert!(off < 0.01 * speed, "{name}: from {from} at {speed} it goes on at {x}, {up} up");
        }
    }
}
