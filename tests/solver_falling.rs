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

use carom::RestitutionLaw;
use host::HostScalar;
use scene::{Scene, Shape};

each_number!(perfect_bounces, series_of_bounces, safe_boxes);

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

/// A box that bounces without friction and without loss, on a corner, on an edge and askew: under the safe law its energy does
/// not grow.
fn safe_boxes<S: HostScalar>(name: &str) {
    let half = [0.5; 3];
    let inertia = 1.0 / 6.0;
    let mut grown = 0.0f64;
    for (orientation, what) in [
        ([0.8804762, 0.3647052, 0.0, -0.2798482], "corner"),
        ([0.9238795, 0.3826834, 0.0, 0.0], "edge"),
        ([0.9, 0.1, 0.2, 0.3], "askew"),
    ] {
        for law in [RestitutionLaw::EnergySafe, RestitutionLaw::Newton] {
            let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.0, 1.0);
            scene.material = scene.material.with_law(law);
            scene.ground([0.0, 1.0, 0.0]);
            let cube = scene.solid(1.0, Shape::Cuboid(half), [0.0, 2.0, 0.0]);
            scene.bodies[cube].set_orientation(scene::quat(orientation));
            let energy = |scene: &Scene<S>| {
                let square = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>();
                0.5 * square(scene.velocity(cube))
                    + 0.5 * inertia * square(scene.spin(cube))
                    + G * scene.position(cube)[1]
            };
            // What is left to lose: down to lying flat.
            let flat = 0.5 * G;
            let first = energy(&scene) - flat;
            let (mut most, mut bounces) = (0.0f64, 0);
            for _ in 0..600 {
                scene.step();
                most = most.max((energy(&scene) - flat) / first);
                bounces += usize::from(scene.touches.iter().any(|touch| touch.approach > 0.5));
            }
            assert!(bounces >= 5, "{name}, {what}, {law:?}: {bounces} impacts");
            match law {
                RestitutionLaw::EnergySafe => assert!(most <= bounds::SAFE, "{name}, {what}: {most}"),
                RestitutionLaw::Newton => grown = grown.max(most),
            }
        }
    }
    assert!(grown > bounds::SAFE, "{name}: the other law, too, has no more than {grown}");
}

/// SimBenchmark's bouncing: 49 balls that keep their energy, by the mean square of the error in it over 20 s. The floor is that of
/// exact bounces between sub-steps of symplectic Euler, whose energy is off by m g dt v/2.
#[cfg(any(feature = "f32", feature = "f64"))]
fn energy_of_bounces<S: HostScalar>(name: &str, steps: &[u16], bound: f64) {
    const MASS: f64 = 490.0;
    for &per_second in steps {
        // A step is a ratio of 16-bit numbers: that of 1e-5 s is half of one.
        let sub_steps = if per_second == 50_000 { 2 } else { 1 };
        let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, per_second], sub_steps, 0.0, 1.0);
        scene.ground([0.0, 1.0, 0.0]);
        let ball = scene.solid(10.0, Shape::Sphere(0.1), [0.0, 5.0, 0.0]);
        let (mut sum, count) = (0.0, 20 * usize::from(per_second));
        for _ in 0..count {
            scene.step();
            let [_, v, _] = scene.velocity(ball);
            sum += (MASS * (0.5 * v * v + G * (scene.position(ball)[1] - 5.0))).powi(2);
        }
        let h = scene.dt / f64::from(sub_steps);
        let floor = (MASS * G * h / 2.0).powi(2) * 2.0 * G * 4.9 / 3.0;
        let part = sum / count as f64 / floor;
        assert!(part <= bound, "{name}, h = {h}: {part} of the floor");
        // Less would be another floor.
        assert!(part >= 0.95, "{name}, h = {h}: {part} of the floor");
    }
}

#[cfg(feature = "f64")]
#[test]
fn energy_of_bounces_f64() {
    energy_of_bounces::<f64>("f64", &[50_000, 10_000, 2500, 1000, 250, 100, 25], bounds::BOUNCING);
    energy_of_bounces::<f64>("f64", &[10], bounds::BOUNCING_COARSE);
}

#[cfg(feature = "f32")]
#[test]
fn energy_of_bounces_f32() {
    energy_of_bounces::<f32>("f32", &[2500, 1000, 250, 100, 25], bounds::BOUNCING);
    energy_of_bounces::<f32>("f32", &[10], bounds::BOUNCING_COARSE);
}
