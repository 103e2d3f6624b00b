//! Piles, by the solver.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed"))]

#[path = "support/bounds.rs"]
mod bounds;
#[macro_use]
#[path = "support/each_number.rs"]
mod each_number;
#[path = "support/host.rs"]
mod host;
#[path = "support/scene.rs"]
mod scene;

use host::HostScalar;
use scene::{Scene, Shape};

each_number!(eight_spheres, ten_boxes, ten_dice, heavy_on_light, small_boxes, ten_small_boxes);

const G: f64 = 9.81;

fn eight_spheres<S: HostScalar>(name: &str) {
    let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.5, 0.0);
    scene.ground([0.0, 1.0, 0.0]);
    for i in 0..8 {
        scene.solid(1.0, Shape::Sphere(0.5), [0.0, 0.5 + f64::from(i), 0.0]);
    }
    scene.run(3.0);
    let top = scene.position(8);
    assert!(top[1] >= bounds::EIGHT_SPHERES && top[1] < 7.5, "{name}: {top:?}");
    assert!(!scene.saturated);
}

/// A pile of cubes after ten seconds: by how much of a cube the worst has sunk, and moved aside.
fn pile<S: HostScalar>(name: &str, half: f64, masses: &[f64], sub_steps: u8) {
    let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 60], sub_steps, 0.5, 0.0);
    scene.ground([0.0, 1.0, 0.0]);
    let height = |i: usize| half * (2 * i + 1) as f64;
    for (i, mass) in masses.iter().enumerate() {
        scene.solid(*mass, Shape::Cuboid([half; 3]), [0.0, height(i), 0.0]);
    }
    scene.run(10.0);
    for i in 0..masses.len() {
        let [x, y, z] = scene.position(i + 1);
        let (sunk, aside) = ((height(i) - y) / (2.0 * half), x.hypot(z) / (2.0 * half));
        assert!(sunk <= bounds::SINKS, "{name}: cube {i} sank by {sunk} of it");
        assert!(aside <= bounds::ASIDE, "{name}: cube {i} moved aside by {aside} of it");
    }
    assert!(!scene.saturated);
}

fn ten_boxes<S: HostScalar>(name: &str) {
    pile::<S>(name, 0.5, &[1.0; 10], 4);
}

fn ten_dice<S: HostScalar>(name: &str) {
    pile::<S>(name, 0.05, &[0.37; 10], 4);
}

fn heavy_on_light<S: HostScalar>(name: &str) {
    pile::<S>(name, 0.5, &[1.0, 1.0, 1.0, 1.0, 100.0], 4);
}

fn small_boxes<S: HostScalar>(name: &str) {
    pile::<S>(name, 0.01, &[0.01; 4], 4);
}

/// Contacts give way by g/w^2 a load, and w is a quarter of a cycle a sub-step: with 4 sub-steps ten boxes of 2 cm are a column
/// soft enough to buckle under its weight.
fn ten_small_boxes<S: HostScalar>(name: &str) {
    pile::<S>(name, 0.01, &[0.01; 10], 12);
}
