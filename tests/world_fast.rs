//! Fast bodies: they meet what is on their way, and nothing else.
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

use carom::{Body, BodyHandle};
use host::HostScalar;
use random::Random;
use scene::{Shape, floats, quat, vector};
use stage::Stage;

each_number!(
    a_box_is_hit_where_it_is,
    balls_hit_each_other_where_they_meet,
    corners_hold,
    gliding_past_an_edge,
    a_tumbling_box_passes_or_hits,
    a_flipper_hits,
    a_struck_wall_is_a_wall,
    boxes_hit_cubes,
);

type Point = [f64; 3];

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn length(v: Point) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn random_point(random: &mut Random, size: f64) -> Point {
    [0; 3].map(|_| random.between(-size, size))
}

/// A vector in the frame of a unit quaternion.
fn unrotated([w, x, y, z]: [f64; 4], v: Point) -> Point {
    let u = [-x, -y, -z];
    let cross = |a: Point, b: Point| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let t = cross(u, v).map(|x| 2.0 * x);
    let s = cross(u, t);
    [0, 1, 2].map(|i| v[i] + w * t[i] + s[i])
}

/// The distance from a box around the origin.
fn distance(half: Point, p: Point) -> f64 {
    length([0, 1, 2].map(|i| (p[i].abs() - half[i]).max(0.0)))
}

fn set_off<S: HostScalar>(stage: &mut Stage<S>, body: BodyHandle, velocity: Point) {
    stage.world.body_mut(body).expect("a body").linear_velocity = vector(velocity);
}

fn velocity<S: HostScalar>(stage: &Stage<S>, body: BodyHandle) -> Point {
    floats(stage.world.body(body).expect("a body").linear_velocity)
}

/// A ball of 2 cm that goes by up to half a metre a step, and a box that lies somewhere near its way: it keeps its velocity
/// where it passes, and where it strikes it bounces off, and never is in the box by more than half its radius and a bit.
fn a_box_is_hit_where_it_is<S: HostScalar>(name: &str) {
    let mut random = Random::new(11);
    let (mut hits, mut misses) = (0, 0);
    for case in 0..3000 {
        let half = [0; 3].map(|_| random.between(0.005, 0.3));
        let turn = [0; 4].map(|_| random.between(-1.0, 1.0));
        let size = turn.iter().map(|x| x * x).sum::<f64>().sqrt();
        let turn = turn.map(|x| x / size);
        let target = random_point(&mut random, 0.35);
        let direction = random_point(&mut random, 1.0);
        let speed = random.between(2.0, 30.0) / length(direction);
        let v = direction.map(|x| x * speed);
        let radius = 0.01;
        let back = random.between(0.8, 1.6) / length(v);
        let start = minus(target, v.map(|x| x * back));
        // The nearest that its straight way comes to the box.
        let at = |t: f64| distance(half, unrotated(turn, minus(start, v.map(|x| -x * t))));
        let samples = 4000;
        let nearest =
            (0..=samples).map(|i| at(2.0 * back * f64::from(i) / f64::from(samples))).fold(f64::MAX, f64::min);
        if at(0.0) < 0.02 || (nearest - radius).abs() < 0.003 {
            continue;
        }
        let mut stage = Stage::<S>::weightless(0.0, 1.0);
        let mut wall = Body::immovable();
        wall.set_orientation(quat(turn));
        stage.insert(wall, Shape::Cuboid(half));
        let ball = stage.solid(0.01, Shape::Sphere(radius), start);
        set_off(&mut stage, ball, v);
        for _ in 0..(2.0 * back * 60.0).ceil() as usize {
            stage.step();
            let depth = radius - distance(half, unrotated(turn, stage.position(ball)));
            assert!(depth < 0.55 * radius, "{name}: {depth} deep in case {case}");
        }
        let change = length(minus(velocity(&stage, ball), v)) / length(v);
        if nearest < radius {
            hits += 1;
            assert!(change > 1e-3, "{name}: case {case} went through, {nearest} from the middle");
        } else {
            misses += 1;
            assert!(change < 1e-3, "{name}: case {case} bounced off the air, {nearest} beside it");
        }
    }
    assert!(hits > 300 && misses > 300, "{name}: {hits} hits, {misses} misses");
}

/// Two fast balls, each of them moving.
fn balls_hit_each_other_where_they_meet<S: HostScalar>(name: &str) {
    let mut random = Random::new(12);
    let (mut hits, mut misses) = (0, 0);
    for case in 0..2000 {
        let radius = 0.01;
        let [v, w] = [0, 1].map(|_| random_point(&mut random, 15.0));
        let relative = minus(w, v);
        let meet = random.between(0.02, 0.1);
        let beside = random_point(&mut random, 0.05);
        let start = minus([0.0; 3], v.map(|x| x * meet));
        let other = minus(beside, w.map(|x| x * meet));
        let between = minus(other, start);
        let t = -(0..3).map(|i| between[i] * relative[i]).sum::<f64>() / length(relative).powi(2);
        let nearest = length([0, 1, 2].map(|i| between[i] + relative[i] * t));
        if length(between) < 0.03 || t < 0.0 || (nearest - 2.0 * radius).abs() < 0.002 {
            continue;
        }
        let mut stage = Stage::<S>::weightless(0.0, 1.0);
        let one = stage.solid(0.01, Shape::Sphere(radius), start);
        let two = stage.solid(0.01, Shape::Sphere(radius), other);
        set_off(&mut stage, one, v);
        set_off(&mut stage, two, w);
        stage.run(0.2);
        let change = length(minus(velocity(&stage, one), v)) / length(relative);
        if nearest < 2.0 * radius {
            hits += 1;
            assert!(change > 1e-3, "{name}: case {case} went through");
        } else {
            misses += 1;
            assert!(change < 1e-3, "{name}: case {case} bounced off the air, {nearest} apart");
        }
    }
    assert!(hits > 200 && misses > 200, "{name}: {hits} hits, {misses} misses");
}

/// What strikes one wall near a corner does not pass the end of the other in the rest of the step.
fn corners_hold<S: HostScalar>(name: &str) {
    let mut random = Random::new(13);
    for case in 0..600 {
        for restitution in [0.0, 0.8] {
            let mut stage = Stage::<S>::weightless(0.1, restitution);
            // Four walls of a box of 1 m, each ending where the next one begins.
            for [x, y] in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
                let wall = Body::immovable().at(vector([0.51 * x, 0.51 * y, 0.0]));
                let half = [if x == 0.0 { 0.5 } else { 0.01 }, if y == 0.0 { 0.5 } else { 0.01 }, 0.5];
                stage.insert(wall, Shape::Cuboid(half));
            }
            let ball =
                stage.solid(0.01, Shape::Sphere(0.01), [random.between(-0.4, 0.4), random.between(-0.4, 0.4), 0.0]);
            set_off(&mut stage, ball, [random.between(-30.0, 30.0), random.between(-30.0, 30.0), 0.0]);
            for _ in 0..20 {
                stage.step();
                let [x, y, _] = stage.position(ball);
                assert!(x.abs() < 0.5 && y.abs() < 0.5, "{name}: case {case} got out to {x}, {y}");
            }
        }
    }
}

/// The ground that a fast ball glides on turns nothing aside.
fn gliding_past_an_edge<S: HostScalar>(name: &str) {
    for from in 0..40 {
        let mut stage = Stage::<S>::new(0.0, 0.0);
        stage.insert(Body::immovable().at(vector([1.0, 0.05, 0.0])), Shape::Cuboid([0.01, 0.05, 0.1]));
        let ball = stage.solid(0.01, Shape::Sphere(0.01), [0.01 * f64::from(from), 0.01, 0.15]);
        set_off(&mut stage, ball, [20.0, 0.0, 0.0]);
        stage.run(0.1);
        let [x, _, z] = velocity(&stage, ball);
        assert!((x - 20.0).abs() < 0.02 && z.abs() < 0.02, "{name}: from {from} cm it goes on at {x}, {z}");
    }
}

/// A box that turns while it flies: by less than its size a step.
fn a_tumbling_box_passes_or_hits<S: HostScalar>(name: &str) {
    let mut random = Random::new(14);
    for case in 0..300 {
        let half = [0.02, 0.015, 0.01];
        let beside = random.between(0.06, 0.2);
        let past = case % 2 == 0;
        let y = if past { 0.3 + beside } else { random.between(-0.2, 0.2) };
        let mut stage = Stage::<S>::weightless(0.3, 0.3);
        stage.insert(Body::immovable().at(vector([1.0, 0.0, 0.0])), Shape::Cuboid([0.02, 0.3, 0.3]));
        let body = stage.solid(0.01, Shape::Cuboid(half), [random.between(0.0, 0.4), y, 0.0]);
        set_off(&mut stage, body, [25.0, 0.0, 0.0]);
        stage.world.body_mut(body).expect("a body").angular_velocity = vector(random_point(&mut random, 10.0));
        stage.run(0.1);
        let [x, ..] = velocity(&stage, body);
        if past {
            assert!((x - 25.0).abs() < 0.01, "{name}: case {case} bounced off the air {beside} beside the wall: {x}");
        } else {
            let at = stage.position(body)[0];
            assert!(x < 1.0 && at < 0.99, "{name}: case {case} is at {at} with {x}");
        }
    }
}

/// A rod that the caller turns fast strikes what lies in its sweep: at e = 0.5 a ball leaves at one and a half times the speed
/// of its surface there. (Later it may catch up with it.)
fn a_flipper_hits<S: HostScalar>(name: &str) {
    for place in 3..10 {
        let mut stage = Stage::<S>::weightless(0.1, 0.5);
        let rod = stage.insert(Body::immovable(), Shape::Cuboid([0.5, 0.02, 0.02]));
        let arm = 0.05 * f64::from(place);
        let ball = stage.solid(0.01, Shape::Sphere(0.02), [arm, 0.08, 0.0]);
        stage.world.body_mut(rod).expect("a body").angular_velocity = vector([0.0, 0.0, 20.0]);
        stage.step();
        let [_, y, _] = velocity(&stage, ball);
        assert!((y / (1.5 * 20.0 * arm) - 1.0).abs() < 0.01, "{name}: at {arm} it leaves at {y}");
    }
}

/// A wall that was struck before lets others pass as it did.
fn a_struck_wall_is_a_wall<S: HostScalar>(name: &str) {
    for from in 0..34 {
        let mut stage = Stage::<S>::weightless(0.0, 1.0);
        stage.insert(Body::immovable().at(vector([1.0, 0.0, 0.0])), Shape::Cuboid([0.005, 0.05, 0.05]));
        let first = stage.solid(0.01, Shape::Sphere(0.005), [0.7, 0.0, 0.0]);
        set_off(&mut stage, first, [20.0, 0.0, 0.0]);
        stage.run(0.1);
        assert!(velocity(&stage, first)[0] < -19.0, "{name}: it strikes");
        let second = stage.solid(0.01, Shape::Sphere(0.005), [0.3 + 0.01 * f64::from(from), 0.155, 0.0]);
        set_off(&mut stage, second, [20.0, 0.0, 0.0]);
        stage.run(0.1);
        let [x, ..] = velocity(&stage, second);
        assert!((x - 20.0).abs() < 0.01, "{name}: from {from} cm it bounces off the air: {x}");
    }
}

/// Boxes that do not turn, and a cube: where two boxes along the axes meet, and when, is a sum of edges.
fn boxes_hit_cubes<S: HostScalar>(name: &str) {
    let mut random = Random::new(15);
    let (mut hits, mut misses) = (0, 0);
    for case in 0..2000 {
        let half = [0; 3].map(|_| random.between(0.01, 0.03));
        let cube = [0; 3].map(|_| random.between(0.04, 0.2));
        let target = random_point(&mut random, 0.3);
        let direction = random_point(&mut random, 1.0);
        let speed = random.between(5.0, 25.0) / length(direction);
        let v = direction.map(|x| x * speed);
        let back = random.between(0.5, 1.0) / length(v);
        let start = minus(target, v.map(|x| x * back));
        let apart = |t: f64| {
            let gaps = [0, 1, 2].map(|i| (start[i] + v[i] * t).abs() - half[i] - cube[i]);
            gaps.iter().fold(f64::MIN, |a, b| a.max(*b))
        };
        let nearest = (0..=4000).map(|i| apart(2.0 * back * f64::from(i) / 4000.0)).fold(f64::MAX, f64::min);
        // What is hit by a part of its size at least, or missed.
        if apart(0.0) < 0.02 || (-0.02..0.005).contains(&nearest) {
            continue;
        }
        let mut stage = Stage::<S>::weightless(0.0, 0.0);
        stage.insert(Body::immovable(), Shape::Cuboid(cube));
        let body = stage.solid(0.01, Shape::Cuboid(half), start);
        set_off(&mut stage, body, v);
        stage.run(2.0 * back);
        let change = length(minus(velocity(&stage, body), v)) / length(v);
        if nearest < 0.0 {
            hits += 1;
            assert!(change > 1e-3, "{name}: case {case} went through, {nearest} deep");
        } else {
            misses += 1;
            assert!(change < 1e-3, "{name}: case {case} bounced off the air, {nearest} beside it");
        }
    }
    assert!(hits > 200 && misses > 200, "{name}: {hits} hits, {misses} misses");
}
