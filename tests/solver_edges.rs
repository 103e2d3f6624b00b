//! Bodies that hardly move: on an edge, at a slow roll, rocking.
#![cfg(feature = "f64")]

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
use scene::{Scene, Shape, quat, vector};

each_number!(past_the_edge, slow_balls, rocking_block);

const G: f64 = 9.81;

/// The angle about z, in degrees.
fn angle<S: HostScalar>(scene: &Scene<S>, body: usize) -> f64 {
    let [w, _, _, z] = scene.orientation(body);
    (2.0 * z.atan2(w)).to_degrees()
}

/// A cube on its edge, its centre that many degrees past it: when it has fallen 40 degrees, and to which side.
fn falls<S: HostScalar>(half: f64, mass: f64, past: f64) -> (f64, f64) {
    let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.5, 0.0);
    scene.ground([0.0, 1.0, 0.0]);
    let height = half * 2f64.sqrt() * past.to_radians().cos();
    let cube = scene.solid(mass, Shape::Cuboid([half; 3]), [0.0, height, 0.0]);
    let turn = (45.0 + past).to_radians() / 2.0;
    scene.bodies[cube].set_orientation(quat([turn.cos(), 0.0, 0.0, turn.sin()]));
    for step in 1..=1200 {
        scene.step();
        let fallen = angle(&scene, cube) - 45.0;
        if fallen.abs() > 40.0 {
            return (f64::from(step) / 60.0, fallen.signum());
        }
    }
    (f64::INFINITY, 0.0)
}

fn past_the_edge<S: HostScalar>(name: &str) {
    for (half, mass) in [(0.5, 1.0), (0.05, 0.37)] {
        for past in [0.5, 0.1, 0.05, 0.01] {
            for side in [1.0, -1.0] {
                let (time, to) = falls::<S>(half, mass, side * past);
                let (right, _) = falls::<f64>(half, mass, side * past);
                let bound = if past < 0.02 { bounds::EDGE[1] } else { bounds::EDGE[0] };
                let at = format!("{name}: half edge {half}, {past} degrees to side {side}");
                assert!(right.is_finite() && right > 0.4, "{at}: f64 takes {right} s");
                assert_eq!(to, side, "{at}: fell to the other side");
                assert!(time <= bound * right && right <= bound * time, "{at}: {time} s, f64 {right} s");
            }
        }
    }
}

fn slow_balls<S: HostScalar>(name: &str) {
    let mut far = 0;
    for start in [0.0, 1000.0] {
        for speed in [0.001, 0.01, 0.1] {
            if S::from_f64(start).is_none() {
                continue;
            }
            let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.5, 0.0);
            scene.ground([0.0, 1.0, 0.0]);
            let ball = scene.solid(1.0, Shape::Sphere(0.1), [start, 0.1, 0.0]);
            scene.bodies[ball].linear_velocity = vector([speed, 0.0, 0.0]);
            scene.bodies[ball].angular_velocity = vector([0.0, 0.0, -speed / 0.1]);
            scene.run(10.0);
            let way = scene.position(ball)[0] - start;
            assert!(
                (way / (10.0 * speed) - 1.0).abs() <= bounds::SLOW,
                "{name}: {way} m at {speed} m/s from {start} m"
            );
            far += usize::from(start > 0.0);
        }
    }
    assert_eq!(far, if S::from_f64(1000.0).is_some() { 3 } else { 0 });
}

/// The peaks of the angle of a slender block that was let go at 0.15.
fn peaks<S: HostScalar>() -> Vec<f64> {
    let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 120], 8, 0.5, 0.0);
    scene.ground([0.0, 1.0, 0.0]);
    let tilt = 0.15f64;
    let height = 0.5 * tilt.cos() + 0.1 * tilt.sin();
    let block = scene.solid(1.0, Shape::Cuboid([0.1, 0.5, 0.5]), [0.0, height, 0.0]);
    scene.bodies[block].set_orientation(quat([(tilt / 2.0).cos(), 0.0, 0.0, (tilt / 2.0).sin()]));
    let (mut peaks, mut before, mut last) = (vec![], tilt, tilt);
    while peaks.len() < 10 {
        scene.step();
        let now = angle(&scene, block).to_radians().abs();
        if last > before && last >= now {
            // The top of the parabola through three steps.
            peaks.push(last + (now - before).powi(2) / (8.0 * (2.0 * last - before - now)));
        }
        (before, last) = (last, now);
    }
    peaks
}

fn rocking_block<S: HostScalar>(name: &str) {
    let (found, right) = (peaks::<S>(), peaks::<f64>());
    assert!(right[0] > 0.08 && right[0] < 0.15 && right[9] > 0.003, "{right:?}");
    for (i, (found, right)) in found.iter().zip(&right).enumerate() {
        assert!((found / right - 1.0).abs() <= bounds::ROCKING, "{name}: peak {i} at {found}, f64 at {right}");
    }
}
