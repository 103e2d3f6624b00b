//! Falling and bouncing, by the solver.
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

each_number!(perfect_bounces, series_of_bounces);

const G: f64 = 9.81;

/// Heights of the apexes, seen once a step, of a ball dropped from 1 m.
fn apexes<S: HostScalar>(restitution: f64) -> Vec<f64> {
    let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.0, restitution);
    scene.ground([0.0, 1.0, 0.0]);
    let ball = scene.solid(1.0, Shape::Sphere(0.1), [0.0, 1.1, 0.0]);
    let (mut apexes, mut before, mut last) = (vec![], 1.1, 1.1);
    for _ in 0..600 {
        scene.step();
        let height = scene.position(ball)[1];
        if last > before && last >= height {
            apexes.push(last - 0.1);
        }
        (before, last) = (last, height);
    }
    assert!(!scene.saturated);
    apexes
}

fn perfect_bounces<S: HostScalar>(name: &str) {
    let apexes = apexes::<S>(1.0);
    assert!(apexes.len() >= 10, "{name}: {} bounces", apexes.len());
    let (first, last) = (apexes[0], apexes[apexes.len() - 1]);
    assert!((last / first - 1.0).abs() <= bounds::APEX, "{name}: from {first} to {last}");
    assert!((first - 1.0).abs() <= bounds::APEX, "{name}: {first}");
}

fn series_of_bounces<S: HostScalar>(name: &str) {
    // A parabola seen every 1/60 s is seen within 1/120 s of its top.
    let unseen = 0.5 * G / 120f64.powi(2);
    for (restitution, count) in [(0.8, 8), (0.5, 3), (0.3, 2)] {
        let apexes = apexes::<S>(restitution);
        for (i, apex) in apexes[..count].iter().enumerate() {
            let right = f64::powi(restitution, 2 * (i as i32 + 1));
            let (least, most) = (right * (1.0 - bounds::SERIES) - unseen, right * (1.0 + bounds::SERIES));
            assert!(least <= *apex && *apex <= most, "{name}, e = {restitution}, bounce {i}: {apex} for {right}");
        }
        let rest = apexes[apexes.len() - 1];
        assert!(rest.abs() < 1e-3, "{name}, e = {restitution}: still bounces {rest} high");
    }
}
