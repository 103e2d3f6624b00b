//! Forces and torques in a world, step after step: F t/m, the spin of a torque, weak ones, weight held up, sleep.
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
#[path = "support/stage.rs"]
mod stage;

use carom::Body;
use host::HostScalar;
use scene::{Shape, floats, mass, quat, vector};
use stage::{G, Stage};

each_number!(seconds, force, torque, weak, at_an_arm, hover, wakes);

fn seconds<S: HostScalar>(name: &str) {
    for (step, sub_steps) in [([1, 60], 4), ([1, 1000], 1), ([7, 50], 3), ([3, 2], 2)] {
        let settings = carom::solver::Settings::<S>::new(vector([0.0; 3]), step, sub_steps).expect("settings");
        let (found, right) = (S::scaled_to_f64(settings.seconds()), f64::from(step[0]) / f64::from(step[1]));
        let off = (found / right - 1.0).abs();
        assert!(off <= 2f64.powi(-29).max(S::spacing(1.0).min(2f64.powi(-23))), "{name}: {found} for {right}");
    }
}

/// A velocity in units of the last place of the largest of the numbers that it is made of.
fn units<S: HostScalar>(found: f64, right: f64) -> f64 {
    (found - right).abs() / S::spacing(right.abs())
}

/// The bound on that after some steps, for what is at last as fast as that: in fixed point the rounding of what is stored, and in
/// each step of a number with 29 bits for the highest speed, as the solver has it; in floating point one for each sum, and two before.
fn bound<S: HostScalar>(step: u32, fastest: f64) -> f64 {
    let spacing = S::spacing(1.0);
    let is_fixed = spacing == S::spacing(2.0);
    if is_fixed { 0.5 + f64::from(step) * fastest / spacing * 2f64.powi(-29) } else { 1.0 + 0.5 * f64::from(step) }
}

fn force<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::weightless(0.0, 0.0);
    let ball = stage.solid(0.5, Shape::Sphere(0.25), [0.0; 3]);
    let force = [1.75, -0.625, 0.3125];
    for step in 1..=60 {
        let body = stage.world.body_mut(ball).expect("a body");
        assert!(!body.apply_force(vector(force), stage.settings.seconds()), "{name}: step {step}");
        stage.step();
        let found = floats(stage.world.body(ball).expect("a body").linear_velocity);
        for (found, force) in found.into_iter().zip(force) {
            let right = force * f64::from(step) / 60.0 / 0.5;
            assert!(units::<S>(found, right) <= bound::<S>(step, 3.5), "{name}, step {step}: {found} for {right}");
        }
    }
    // x = F/m dt^2 (1 + 2 + ... + 60), but for what positions and sub-steps round.
    let x = stage.position(ball)[0];
    let right = 3.5 / 3600.0 * 1830.0;
    assert!((x - right).abs() <= 60.0 * S::spacing(1.0), "{name}: {x} for {right}");
}

fn torque<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::weightless(0.0, 0.0);
    // Moments of 1/4, 1/2 and 5/8; turned by a quarter, x is the body's y.
    let mut body = Body::dynamic(mass(2.0, [0.25, 0.5, 0.625]));
    body.set_orientation(quat([1.0, 0.0, 0.0, 1.0]));
    let top = stage.insert(body, Shape::Sphere(0.5));
    for step in 1..=60 {
        let body = stage.world.body_mut(top).expect("a body");
        assert!(!body.apply_torque(vector([0.375, 0.0, 0.0]), stage.settings.seconds()), "{name}: step {step}");
        stage.step();
        let [x, y, z] = floats(stage.world.body(top).expect("a body").angular_velocity);
        let right = 0.375 * f64::from(step) / 60.0 / 0.5;
        // The orientation turns with it, and is rounded.
        assert!(
            (x - right).abs() <= bound::<S>(step, 1.0) * S::spacing(right) + 2e-6,
            "{name}, step {step}: {x} for {right}"
        );
        assert!(y.abs().max(z.abs()) <= 1e-4, "{name}, step {step}: {y}, {z}");
    }
}

/// A thirtieth of a unit of the last place a step, and it arrives.
fn weak<S: HostScalar>(name: &str) {
    if S::spacing(1.0) != S::spacing(2.0) {
        return;
    }
    let mut stage = Stage::<S>::weightless(0.0, 0.0);
    stage.world.set_sleeping(false);
    let ball = stage.solid(4096.0f64.min(0.4 / S::spacing(1.0).sqrt()).min(64.0), Shape::Sphere(0.5), [0.0; 3]);
    let m = 1.0 / S::scaled_to_f64(stage.world.body(ball).expect("a body").inv_mass());
    let unit = S::spacing(1.0);
    for step in 1..=600 {
        let seconds = stage.settings.seconds();
        let body = stage.world.body_mut(ball).expect("a body");
        assert!(!body.apply_force(vector([2.0 * 60.0 * unit, -60.0 * unit, 0.0]), seconds), "{name}");
        stage.step();
        let found = floats(stage.world.body(ball).expect("a body").linear_velocity);
        for (found, units) in found.into_iter().zip([2.0, -1.0, 0.0]) {
            let right = f64::from(step) * units / m;
            assert!((found / unit - right).abs() <= 0.52, "{name}, step {step}: {} for {right}", found / unit);
        }
    }
}

/// A force at the end of an arm is one at the centre and its torque.
fn at_an_arm<S: HostScalar>(name: &str) {
    let mut body = Body::<S>::dynamic(scene::solid(2.0, Shape::Cuboid([0.5, 0.25, 0.125])));
    body.set_orientation(quat([0.9, 0.1, -0.3, 0.2]));
    let seconds = S::scaled(0.25);
    let (force, arm, torque) = ([1.0, -2.0, 0.5], [0.5, 0.25, -0.25], [-0.375, -0.5, -1.25]);
    let (mut one, mut two) = (body, body);
    assert!(!one.apply_force_at(vector(force), vector(arm), seconds));
    assert!(!two.apply_force(vector(force), seconds) && !two.apply_torque(vector(torque), seconds));
    assert_eq!(one, two, "{name}");
    assert!(floats(one.linear_velocity) == [0.125, -0.25, 0.0625], "{name}: {:?}", one.linear_velocity);
    assert!(one.angular_velocity.x != S::ZERO, "{name}");
}

/// Held up against its weight it stays, above the ground and without touching it.
fn hover<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::new(0.5, 0.0);
    let drone = stage.solid(0.5, Shape::Sphere(0.25), [0.0, 1.0, 0.0]);
    for _ in 0..120 {
        let seconds = stage.settings.seconds();
        let body = stage.world.body_mut(drone).expect("a body");
        body.apply_force(vector([0.0, 0.5 * G, 0.0]), seconds);
        stage.step();
    }
    // The force acts at the start of the step, gravity over it: between them lies g dt^2/2 (1 - 1/n) a step, upwards.
    let rise = 120.0 * G / 3600.0 * 0.5 * 0.75;
    let y = stage.position(drone)[1];
    assert!((y - 1.0 - rise).abs() < 2e-3, "{name}: {y}, {rise}");
}

/// What sleeps wakes up where it is pushed, and only there.
fn wakes<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::new(0.5, 0.0);
    let [pushed, other] = [0.0, 3.0].map(|x| stage.solid(1.0, Shape::Cuboid([0.25; 3]), [x, 0.25, 0.0]));
    stage.run(3.0);
    assert_eq!(stage.report.asleep, 2, "{name}");
    let seconds = stage.settings.seconds();
    stage.world.body_mut(pushed).expect("a body").apply_force(vector([90.0, 0.0, 0.0]), seconds);
    stage.step();
    assert_eq!(stage.report.asleep, 1, "{name}");
    stage.run(0.25);
    let moved = |handle, x: f64| stage.position(handle)[0] - x;
    assert!(moved(pushed, 0.0) > 0.1 && moved(other, 3.0).abs() < 1e-3, "{name}: {}", moved(pushed, 0.0));
}
