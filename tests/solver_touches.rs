//! What a step tells of its contacts, and bodies that take no part in it.
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
use scene::{Scene, Shape, vector};

each_number!(balls_head_on, a_ball_lands, rests, keeps_what_is_held);

const G: f64 = 9.81;

/// Two balls in free space: 2 m_red v, whatever the masses, and the speed at which they met.
fn balls_head_on<S: HostScalar>(name: &str) {
    for (restitution, m) in [(1.0, [1.0, 1.0]), (1.0, [0.2, 3.0]), (0.5, [2.0, 1.0]), (0.0, [2.0, 1.0])] {
        let mut scene = Scene::<S>::new([0.0; 3], [1, 60], 4, 0.5, restitution);
        let a = scene.solid(m[0], Shape::Sphere(0.1), [-0.3, 0.0, 0.0]);
        let b = scene.solid(m[1], Shape::Sphere(0.1), [0.3, 0.0, 0.0]);
        scene.bodies[a].linear_velocity = vector([2.0, 0.0, 0.0]);
        scene.bodies[b].linear_velocity = vector([-1.0, 0.0, 0.0]);
        let (mut impulse, mut approach, mut steps) = (0.0, vec![], 0);
        for _ in 0..30 {
            scene.step();
            impulse += scene.touches.iter().map(|touch| touch.impulse).sum::<f64>();
            approach.extend(scene.touches.iter().map(|touch| touch.approach).filter(|speed| *speed > 1e-3));
            steps += scene.touches.iter().filter(|touch| touch.pushed).count();
        }
        let right = (1.0 + restitution) * 3.0 * m[0] * m[1] / (m[0] + m[1]);
        let at = format!("{name}: e = {restitution}, masses {m:?}");
        assert!((impulse / right - 1.0).abs() <= bounds::IMPULSE, "{at}: {impulse} N s for {right}");
        assert_eq!(approach.len(), 1, "{at}: met at {approach:?}");
        assert!((approach[0] / 3.0 - 1.0).abs() <= bounds::IMPULSE, "{at}: met at {approach:?}");
        assert!(steps >= 1, "{at}");
    }
}

/// Onto the ground, with rebound and without: the speed is that before the gravity of the last sub-step.
fn a_ball_lands<S: HostScalar>(name: &str) {
    for restitution in [0.0, 0.5, 1.0] {
        let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.5, restitution);
        scene.ground([0.0, 1.0, 0.0]);
        let ball = scene.solid(0.3, Shape::Sphere(0.1), [0.0, 1.1, 0.0]);
        let mut before = 0.0;
        for _ in 0..60 {
            before = -scene.velocity(ball)[1];
            scene.step();
            if scene.touches.iter().any(|touch| touch.approach > 0.0) {
                break;
            }
        }
        let approach = scene.touches[0].approach;
        // Up to three sub-steps of gravity more than at the step's start.
        assert!(before - 1e-3 <= approach && approach <= before + 3.1 * G / 240.0, "{name}: {approach}, {before}");
        assert!(approach > 4.2, "{name}: {approach}");
        let right = 0.3 * (scene.velocity(ball)[1] + before + G / 60.0);
        let found = scene.touches[0].impulse;
        assert!((found / right - 1.0).abs() <= bounds::IMPULSE, "{name}: {found} N s for {right}");
    }
}

/// A slab at rest on four points, and a ball on it.
fn rests<S: HostScalar>(name: &str) {
    let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.5, 0.0);
    scene.ground([0.0, 1.0, 0.0]);
    scene.solid(2.0, Shape::Cuboid([0.5, 0.1, 0.5]), [0.0, 0.1, 0.0]);
    scene.solid(0.5, Shape::Sphere(0.1), [0.0, 0.3, 0.0]);
    scene.run(2.0);
    for (touch, mass) in scene.touches.iter().zip([2.5, 0.5]) {
        let right = mass * G / 60.0;
        assert!((touch.impulse / right - 1.0).abs() <= bounds::IMPULSE, "{name}: {touch:?} for {right}");
        assert!(touch.pushed && touch.approach == 0.0, "{name}: {touch:?}");
    }
    assert_eq!(scene.touches.len(), 2);
}

/// A held body is like the ground, even with a velocity, and stays as it is.
fn keeps_what_is_held<S: HostScalar>(name: &str) {
    let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.5, 0.0);
    let slab = scene.solid(1.0, Shape::Cuboid([0.5, 0.1, 0.5]), [0.0, 0.1, 0.0]);
    let ball = scene.solid(1.0, Shape::Sphere(0.1), [0.0, 0.3, 0.0]);
    scene.bodies[slab].linear_velocity = vector([0.5, 0.5, 0.0]);
    scene.held = vec![slab];
    let before = scene.bodies[slab];
    scene.run(1.0);
    assert_eq!(scene.bodies[slab], before, "{name}");
    let [x, y, _] = scene.position(ball);
    assert!(x.abs() < 1e-3 && (y - 0.3).abs() < 1e-3, "{name}: {x} {y}");
}

/// A body whose numbers are not finite stays as it is, and the rest of the scene goes on as if it were not there.
#[cfg(feature = "f32")]
#[test]
fn nothing_spreads() {
    type Spoil = fn(&mut carom::Body<f32>);
    let spoilt: [Spoil; 5] = [
        |body| body.position.x = f32::NAN,
        |body| body.linear_velocity.y = f32::INFINITY,
        |body| body.angular_velocity.z = f32::NAN,
        |body| body.gravity_scale = f32::NAN,
        |body| body.angular_damping = f32::NEG_INFINITY,
    ];
    for spoil in spoilt {
        let mut scene = Scene::<f32>::new([0.0, -G as f32 as f64, 0.0], [1, 60], 4, 0.5, 0.0);
        scene.ground([0.0, 1.0, 0.0]);
        for i in 0..3 {
            scene.solid(1.0, Shape::Cuboid([0.5; 3]), [0.0, 0.5 + f64::from(i), 0.0]);
        }
        scene.run(0.1);
        spoil(&mut scene.bodies[2]);
        let bits = |scene: &Scene<f32>| format!("{:?}", scene.bodies[2]);
        let before = bits(&scene);
        scene.run(3.0);
        assert_eq!(scene.not_finite, 180);
        assert_eq!(bits(&scene), before);
        for i in [1, 3] {
            assert!(scene.bodies[i].check().is_ok(), "{:?}", scene.bodies[i]);
        }
        // The upper box has fallen through where the other was, as far as the lowest.
        assert!(scene.position(3)[1] < 1.6 && scene.position(3)[1] > 1.4, "{:?}", scene.position(3));
    }
}
