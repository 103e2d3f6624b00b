//! The README's table of scenes is what the solver comes to.
#![cfg(all(feature = "f32", feature = "f64", feature = "fixed"))]

#[path = "support/host.rs"]
mod host;
#[path = "support/scene.rs"]
mod scene;
#[path = "support/validation.rs"]
mod validation;

use carom::Body;
use fixed::types::{I12F20, I16F16};
use host::HostScalar;
use scene::{Scene, Shape, mass, quat, vector};

const G: f64 = 9.81;

/// The beginning of a row: the words, and the figures of a scene in f32, I16F16 and I12F20.
macro_rules! row {
    ($words:literal, $digits:literal, $scene:ident($($argument:expr),*)) => {{
        let figures = [$scene::<f32>($($argument),*), $scene::<I16F16>($($argument),*), $scene::<I12F20>($($argument),*)];
        format!("| {} | {} |", $words, figures.map(|x| format!("{:.*}", $digits, x)).join(" | "))
    }};
}

fn assert_in_readme(rows: &[String]) {
    let missing: Vec<_> = rows.iter().filter(|row| !include_str!("../README.md").contains(*row)).cloned().collect();
    assert!(missing.is_empty(), "the README's rows should begin\n{}", missing.join("\n"));
}

/// Steps of 1/60 s in four sub-steps on a ground, as in all scenes but the top.
fn on_the_ground<S: HostScalar>(friction: f64, restitution: f64) -> Scene<S> {
    let mut scene = Scene::new([0.0, -G, 0.0], [1, 60], 4, friction, restitution);
    scene.ground([0.0, 1.0, 0.0]);
    scene
}

fn rolls<S: HostScalar>() -> f64 {
    let mut scene = on_the_ground::<S>(0.25, 0.0);
    let ball = scene.solid(1.0, Shape::Sphere(0.5), [0.0, 0.5, 0.0]);
    scene.bodies[ball].linear_velocity = vector([7.0, 0.0, 0.0]);
    scene.run(3.0);
    scene.velocity(ball)[0]
}

/// The apexes of a ball that was dropped from 1 m, as the steps of ten seconds see them.
fn apexes<S: HostScalar>(restitution: f64) -> Vec<f64> {
    let mut scene = on_the_ground::<S>(0.0, restitution);
    let ball = scene.solid(1.0, Shape::Sphere(0.1), [0.0, 1.1, 0.0]);
    let heights: Vec<f64> = (0..600)
        .map(|_| {
            scene.step();
            scene.position(ball)[1] - 0.1
        })
        .collect();
    heights.windows(3).filter(|w| w[1] > w[0] && w[1] >= w[2]).map(|w| w[1]).collect()
}

fn first_apex<S: HostScalar>(restitution: f64) -> f64 {
    apexes::<S>(restitution)[0]
}

fn last_apex<S: HostScalar>(restitution: f64) -> f64 {
    *apexes::<S>(restitution).last().expect("it bounces")
}

/// The worst of twelve headings of a slab that slides to rest, degrees.
fn aside<S: HostScalar>() -> f64 {
    let off = |heading: u32| {
        let angle = 0.1 + f64::from(heading) * 30f64.to_radians();
        let mut scene = on_the_ground::<S>(0.5, 0.0);
        let slab = scene.solid(1.0, Shape::Cuboid([0.5, 0.1, 0.5]), [0.0, 0.1, 0.0]);
        scene.bodies[slab].linear_velocity = vector([5.0 * angle.cos(), 0.0, 5.0 * angle.sin()]);
        scene.run(3.0);
        let [x, _, z] = scene.position(slab);
        (z.atan2(x) - angle).sin().to_degrees().abs()
    };
    (0..12).map(off).fold(0.0, f64::max)
}

fn eight_spheres<S: HostScalar>() -> f64 {
    let mut scene = on_the_ground::<S>(0.5, 0.0);
    for i in 0..8 {
        scene.solid(1.0, Shape::Sphere(0.5), [0.0, 0.5 + f64::from(i), 0.0]);
    }
    scene.run(3.0);
    scene.position(8)[1]
}

/// By how much of a cube the one on top of a pile is lower after ten seconds than it was.
fn sinks<S: HostScalar>(half: f64, masses: &[f64]) -> f64 {
    let mut scene = on_the_ground::<S>(0.5, 0.0);
    let height = |i: usize| half * (2 * i + 1) as f64;
    for (i, mass) in masses.iter().enumerate() {
        scene.solid(*mass, Shape::Cuboid([half; 3]), [0.0, height(i), 0.0]);
    }
    scene.run(10.0);
    let top = masses.len();
    (height(top - 1) - scene.position(top)[1]) / (2.0 * half)
}

/// Seconds in which a cube of 1 m whose centre is that many degrees past its edge falls by 40 degrees.
fn falls<S: HostScalar>(past: f64) -> f64 {
    let mut scene = on_the_ground::<S>(0.5, 0.0);
    let cube = scene.solid(1.0, Shape::Cuboid([0.5; 3]), [0.0, 0.5f64.sqrt() * past.to_radians().cos(), 0.0]);
    let turn = (45.0 + past).to_radians() / 2.0;
    scene.bodies[cube].set_orientation(quat([turn.cos(), 0.0, 0.0, turn.sin()]));
    for step in 1..=1200 {
        scene.step();
        let [w, _, _, z] = scene.orientation(cube);
        if (2.0 * z.atan2(w)).to_degrees() > 85.0 {
            return f64::from(step) / 60.0;
        }
    }
    f64::INFINITY
}

/// The way of a ball that rolls at 1 mm/s, in ten seconds, mm.
fn slow_ball<S: HostScalar>() -> f64 {
    let mut scene = on_the_ground::<S>(0.5, 0.0);
    let ball = scene.solid(1.0, Shape::Sphere(0.1), [0.0, 0.1, 0.0]);
    scene.bodies[ball].linear_velocity = vector([0.001, 0.0, 0.0]);
    scene.bodies[ball].angular_velocity = vector([0.0, 0.0, -0.01]);
    scene.run(10.0);
    1000.0 * scene.position(ball)[0]
}

/// The attitude of a free box of 1 by 2 by 3 after five seconds at 240 steps a second, and the one in closed form: the angle
/// between them in degrees.
fn top<S: HostScalar>(rows: &[[f64; 8]]) -> f64 {
    let mut scene = Scene::<S>::new([0.0; 3], [1, 240], 1, 0.0, 0.0);
    let [start, end] = [rows[0], *rows.iter().find(|row| row[0] == 5.0).expect("a row at 5 s")];
    let mut top = Body::dynamic(mass(1.0, [208.0, 160.0, 80.0]));
    top.angular_velocity = vector([start[1], start[2], start[3]]);
    let top = scene.push(top, Shape::Sphere(0.1));
    (0..1200).for_each(|_| scene.step());
    let q = scene.orientation(top);
    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    let cosine = q.iter().zip(&end[4..]).map(|(a, b)| a * b).sum::<f64>().abs() / length;
    2.0 * cosine.min(1.0).acos().to_degrees()
}

#[test]
fn motion() {
    assert_in_readme(&[
        row!("a ball set off at 7 m/s slides, then rolls: m/s (5.000)", 4, rolls()),
        row!("e = 1, dropped from 1 m: the last apex before 10 s, m (1.000)", 5, last_apex(1.0)),
        row!("e = 0.8, dropped from 1 m: the first apex, m (0.640)", 3, first_apex(0.8)),
        row!("a slab slides to rest in twelve directions: the worst is off by, degrees (0)", 3, aside()),
        row!("a ball rolls at 1 mm/s: its way in 10 s, mm (10)", 2, slow_ball()),
        row!("a cube of 1 m, its centre 0.01 degrees past its edge, falls by 40, s (2.79)", 2, falls(0.01)),
    ]);
}

/// A pendulum upside down with the cube's moment of inertia about its edge: it gains what the centre of mass falls.
#[test]
fn what_is_right_at_the_edge() {
    let rate = G * 0.5f64.sqrt() / (2.0 / 3.0);
    let (mut angle, mut spin, mut time) = (0.01f64.to_radians(), 0.0, 0.0);
    let step = 1e-6;
    while angle < 40f64.to_radians() {
        spin += step * rate * angle.sin();
        angle += step * spin;
        time += step;
    }
    assert_eq!(format!("{time:.2}"), "2.79");
}

#[test]
fn piles() {
    assert_in_readme(&[
        row!("eight spheres of 1 m: the centre of the highest, m (7.5)", 3, eight_spheres()),
        row!("ten cubes of 1 m: the highest sinks by, m (0)", 3, sinks(0.5, &[1.0; 10])),
        row!("100 kg on four cubes of 1 m and 1 kg: sinks by, m (0)", 3, sinks(0.5, &[1.0, 1.0, 1.0, 1.0, 100.0])),
        row!("four cubes of 2 cm and 10 g: the highest sinks by, sides (0)", 3, sinks(0.01, &[0.01; 4])),
    ]);
}

/// A limit that the README states: whoever lifts it changes that.
#[test]
fn ten_small_cubes_need_more_than_four_sub_steps() {
    let sunk =
        [sinks::<f32>(0.01, &[0.01; 10]), sinks::<I16F16>(0.01, &[0.01; 10]), sinks::<I12F20>(0.01, &[0.01; 10])];
    assert!(sunk.iter().all(|sunk| *sunk > 1.0), "{sunk:?} of a cube");
}

#[test]
fn free_top() {
    let Some(file) = validation::file("oracles/torque_free_top.csv") else { return };
    let text = std::fs::read_to_string(file).expect("a readable file");
    let numbers =
        |line: &str| line.split(',').take(8).map(|cell| cell.parse().expect("a number")).collect::<Vec<f64>>();
    let rows: Vec<[f64; 8]> = text
        .lines()
        .filter_map(|line| line.strip_prefix("box123_rapier,"))
        .map(|line| numbers(line).try_into().expect("eight numbers"))
        .collect();
    assert_in_readme(&[row!(
        "a free box of 1 by 2 by 3 spins for 5 s at 240 steps/s: its attitude is off by, degrees (0)",
        2,
        top(&rows)
    )]);
}
