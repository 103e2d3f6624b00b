//! The world: handles, capacities, events, sleep, filters, sensors, what goes wrong, and the same bits after a copy.
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

use carom::world::{Filter, Phase};
use carom::{Body, BodyHandle, Collide as _, HandleError, InsertError, Material, Pose, Ray, UnitVec3, World};
use host::HostScalar;
use random::Random;
use scene::{Piece, Shape, floats, number, quat, vector};
use stage::{G, Stage, settings};

each_number!(
    handles,
    capacities,
    phases,
    impacts,
    sleep,
    neighbours_sleep,
    edges_are_no_bed,
    filters_and_sensors,
    sensors_notice_what_overlaps,
    driven,
    copies,
    steps_in_parts,
    questions,
    one_spot,
    walls_stop_what_is_fast,
);

fn handles<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::new(0.5, 0.0);
    let first = stage.solid(1.0, Shape::Sphere(0.5), [0.0, 0.5, 0.0]);
    let second = stage.solid(1.0, Shape::Sphere(0.5), [3.0, 0.5, 0.0]);
    stage.world.remove(first).expect("it is there");
    assert_eq!(stage.world.body(first).err(), Some(HandleError::Stale), "{name}");
    assert_eq!(stage.world.remove(first).err(), Some(HandleError::Stale), "{name}");
    let third = stage.solid(1.0, Shape::Sphere(0.25), [6.0, 0.25, 0.0]);
    assert_eq!(third.index(), first.index(), "{name}: the place is used again");
    assert_ne!(third, first, "{name}");
    assert_eq!(stage.world.body(first).err(), Some(HandleError::Stale), "{name}: the old handle means the new body");
    assert_eq!(stage.world.bodies().map(|(handle, _)| handle).filter(|h| *h == second || *h == third).count(), 2);
    stage.run(1.0);
    assert!((stage.position(third)[1] - 0.25).abs() < 0.01, "{name}: it stands on its own size");
    stage.world.clear();
    assert_eq!(stage.world.body(second).err(), Some(HandleError::Stale), "{name}");
    assert_eq!(stage.world.bodies().count(), 0);
}

fn capacities<S: HostScalar>(name: &str) {
    let mut world = World::<S, Piece<S>, 3, 1, 4>::new();
    let material = Material::new(S::ZERO, number(0.5)).expect("a material");
    let ball = |x: f64| {
        let mut body = Body::dynamic(scene::solid(1.0, Shape::Sphere(0.5)));
        body.position = vector([x, 0.5, 0.0]);
        body
    };
    let ground = Shape::HalfSpace([0.0, 1.0, 0.0]).build::<S>();
    let sphere = Shape::Sphere(0.5).build::<S>();
    world.insert(Body::immovable(), ground, material).expect("room");
    let [a, b] = [0.0, 3.0].map(|x| world.insert(ball(x), sphere, material).expect("room"));
    assert_eq!(world.insert(ball(6.0), sphere, material), Err(InsertError::Full), "{name}");
    let mut dropped = 0;
    for _ in 0..30 {
        dropped += world.step(&settings()).dropped;
    }
    // One of the two falls through for lack of room; the other one lies there.
    let heights = [a, b].map(|handle| floats(world.body(handle).expect("it is there").position)[1]);
    assert_eq!(heights.iter().filter(|y| **y > 0.49).count(), 1, "{name}: {heights:?}");
    assert!(dropped >= 20, "{name}: {dropped} dropped");
}

fn phases<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::new(0.0, 0.5);
    let ball = stage.solid(1.0, Shape::Sphere(0.1), [0.0, 0.3, 0.0]);
    let (mut began, mut ended, mut persisted) = (0, 0, 0);
    let mut touching = false;
    for step in 0..240 {
        stage.step();
        for contact in stage.world.contacts() {
            assert!(contact.bodies.contains(&ball), "{name}");
            match contact.phase {
                Phase::Began => {
                    assert!(!touching, "{name}: began twice, step {step}");
                    (touching, began) = (true, began + 1);
                }
                Phase::Persists => {
                    assert!(touching, "{name}: persists what has not begun, step {step}");
                    persisted += 1;
                }
                Phase::Ended => {
                    assert!(touching, "{name}: ended what has not begun, step {step}");
                    (touching, ended) = (false, ended + 1);
                }
            }
        }
    }
    // It bounces a few times and lies in the end.
    assert!(
        touching && began == ended + 1 && (3..30).contains(&began) && persisted > 60,
        "{name}: {began} {ended} {persisted}"
    );
}

fn impacts<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::weightless(0.0, 1.0);
    let a = stage.solid(2.0, Shape::Sphere(0.1), [0.0, 0.0, 0.0]);
    let b = stage.solid(1.0, Shape::Sphere(0.1), [0.5, 0.0, 0.0]);
    stage.world.body_mut(a).expect("a body").linear_velocity = vector([1.5, 0.0, 0.0]);
    let mut heard = vec![];
    for _ in 0..60 {
        stage.step();
        heard.extend(stage.world.impacts());
    }
    let [impact] = heard[..] else { panic!("{name}: {heard:?}") };
    assert_eq!(impact.bodies, [a, b]);
    assert!((S::scaled_to_f64(impact.normal_impulse) - 2.0).abs() < 0.02, "{name}: {impact:?}");
    assert!((impact.approach_speed.to_f64() - 1.5).abs() < 0.015, "{name}: {impact:?}");
    assert!((floats(stage.world.body(b).expect("a body").linear_velocity)[0] - 2.0).abs() < 0.02, "{name}");
}

fn sleep<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::new(0.5, 0.0);
    let pile = [0.5, 1.5, 2.5].map(|y| stage.solid(1.0, Shape::Cuboid([0.5; 3]), [0.0, y, 0.0]));
    let apart = stage.solid(1.0, Shape::Sphere(0.5), [5.0, 0.5, 0.0]);
    stage.run(3.0);
    assert_eq!(stage.report.asleep, 4, "{name}: {:?}", stage.report);
    let hash = stage.world.hash();
    stage.run(1.0);
    assert_eq!(stage.world.hash(), hash, "{name}: what sleeps does not move");
    assert!(stage.world.contacts().all(|contact| contact.phase == Phase::Persists), "{name}");
    assert!(stage.world.contacts().count() >= 4, "{name}: contacts of sleeping bodies are still there");

    // Touching one wakes its island, not the other.
    stage.world.body_mut(pile[2]).expect("a body").linear_velocity = vector([0.0, 0.5, 0.0]);
    assert!(pile.iter().all(|handle| stage.world.is_asleep(*handle) == Ok(false)), "{name}");
    assert_eq!(stage.world.is_asleep(apart), Ok(true), "{name}");
    stage.run(3.0);
    assert_eq!(stage.report.asleep, 4, "{name}");

    // A ball that rolls against the pile wakes it before it strikes.
    let mut ball = Body::dynamic(scene::solid(1.0, Shape::Sphere(0.3)));
    (ball.position, ball.linear_velocity) = (vector([3.0, 0.3, 0.0]), vector([-4.0, 0.0, 0.0]));
    let ball = stage.insert(ball, Shape::Sphere(0.3));
    let mut struck = false;
    for _ in 0..60 {
        stage.step();
        struck |= stage.world.impacts().any(|impact| impact.bodies.contains(&ball) && impact.bodies.contains(&pile[0]));
    }
    assert!(struck, "{name}: the ball hits the lowest box");
    assert!(stage.position(pile[0])[0] < -1e-3, "{name}: and moves it: {:?}", stage.position(pile[0]));

    // So does a change of gravity, and what takes the ground away.
    stage.world.remove(ball).expect("the ball");
    stage.run(4.0);
    assert_eq!(stage.report.asleep, 4, "{name}: {:?}", stage.report);
    stage.settings.gravity = vector([0.5, -G, 0.0]);
    stage.step();
    assert_eq!(stage.report.asleep, 0, "{name}");
    stage.run(8.0);
    stage.world.remove(stage.ground).expect("the ground");
    stage.run(0.5);
    assert!(stage.position(apart)[1] < 0.4, "{name}: without ground it falls");
}

/// Two that lie beside each other, hardly apart, both fall asleep, whichever came first.
fn neighbours_sleep<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::new(0.5, 0.0);
    stage.solid(1.0, Shape::Cuboid([0.5; 3]), [0.0, 0.5, 0.0]);
    stage.run(2.0);
    assert_eq!(stage.report.asleep, 1, "{name}");
    let late = stage.solid(1.0, Shape::Cuboid([0.5; 3]), [1.002, 0.5, 0.0]);
    stage.step();
    assert_eq!(stage.report.asleep, 0, "{name}: the new one wakes the other");
    stage.run(2.0);
    assert_eq!(stage.report.asleep, 2, "{name}: {:?}", stage.position(late));
    let hash = stage.world.hash();
    stage.run(1.0);
    assert_eq!(stage.world.hash(), hash, "{name}: and stay so");
}

/// A cube on its edge does not fall asleep there.
fn edges_are_no_bed<S: HostScalar>(name: &str) {
    for past in [0.5f64, 0.05, 0.01] {
        let mut stage = Stage::<S>::new(0.5, 0.0);
        let height = 0.5 * 2f64.sqrt() * past.to_radians().cos();
        let cube = stage.solid(1.0, Shape::Cuboid([0.5; 3]), [0.0, height, 0.0]);
        let turn = (45.0 + past).to_radians() / 2.0;
        stage.world.body_mut(cube).expect("a body").set_orientation(quat([turn.cos(), 0.0, 0.0, turn.sin()]));
        stage.run(6.0);
        let [w, _, _, z] = stage.world.body(cube).expect("a body").orientation().to_array().map(S::unit_to_f64);
        let angle = (2.0 * z.atan2(w)).to_degrees();
        assert!((angle - 90.0).abs() < 1.0, "{name}: {past} degrees past the edge it is at {angle}");
        assert_eq!(stage.report.asleep, 1, "{name}: and sleeps on its side");
    }
}

fn filters_and_sensors<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::new(0.5, 0.0);
    let ball = stage.solid(1.0, Shape::Sphere(0.1), [0.0, 2.0, 0.0]);
    let gate = stage.insert(Body::immovable().at(vector([0.0, 1.0, 0.0])), Shape::Cuboid([0.5, 0.2, 0.5]));
    let ghost = stage.solid(1.0, Shape::Sphere(0.1), [0.3, 3.0, 0.0]);
    stage.world.set_sensor(gate, true).expect("a body");
    let of_ghosts = Filter { groups: 2, meets: u16::MAX };
    stage.world.set_filter(ghost, of_ghosts).expect("a body");
    assert_eq!((stage.world.is_sensor(gate), stage.world.is_sensor(ball)), (Ok(true), Ok(false)), "{name}");
    assert_eq!(stage.world.filter(ghost), Ok(of_ghosts), "{name}");
    stage.world.set_filter(stage.ground, Filter { groups: 1, meets: !2 }).expect("a body");
    let (mut seen, mut inside) = (vec![], 0);
    for _ in 0..120 {
        stage.step();
        for contact in stage.world.contacts().filter(|contact| contact.sensor) {
            assert_eq!(contact.normal_impulse, stage::nothing::<S>(), "{name}: a sensor pushes nothing");
            match contact.phase {
                Phase::Persists => inside += 1,
                phase => seen.push((contact.bodies, phase)),
            }
        }
    }
    let pair = |other: BodyHandle| if other < gate { [other, gate] } else { [gate, other] };
    let expected = [
        (pair(ball), Phase::Began),
        (pair(ball), Phase::Ended),
        (pair(ghost), Phase::Began),
        (pair(ghost), Phase::Ended),
    ];
    assert_eq!(seen, expected, "{name}");
    assert!(inside > 4, "{name}");
    assert!((stage.position(ball)[1] - 0.1).abs() < 0.01, "{name}: the ball lies on the ground");
    assert!(stage.position(ghost)[1] < -1.0, "{name}: the ground lets the ghost through");
}

/// What a sensor notices is what is no farther than nothing, by the exact distance: of balls and boxes in any place and turn.
fn sensors_notice_what_overlaps<S: HostScalar>(name: &str) {
    let mut random = Random::new(17);
    let (mut noticed, mut apart) = (0, 0);
    for _ in 0..400 {
        let mut stage = Stage::<S>::weightless(0.5, 0.0);
        let mut place = |stage: &mut Stage<S>, reach: f64| {
            let size = [0; 3].map(|_| random.between(0.1, 0.5));
            let shape = if random.one_in(3) { Shape::Sphere(size[0]) } else { Shape::Cuboid(size) };
            let mut body = Body::dynamic(scene::solid(1.0, shape));
            body.position = vector([0; 3].map(|_| random.between(-reach, reach)));
            body.set_orientation(quat([0; 4].map(|_| random.between(-1.0, 1.0))));
            let pose = Pose::new(body.position, body.orientation());
            (stage.insert(body, shape), shape.build::<S>(), pose)
        };
        let (gate, a, pose_a) = place(&mut stage, 0.0);
        let (_, b, pose_b) = place(&mut stage, 0.6);
        stage.world.set_sensor(gate, true).expect("a body");
        stage.step();
        let seen = stage.world.contacts().any(|contact| contact.sensor);
        let distance = a.closest(&pose_a, &b, &pose_b).expect("a distance").separation.to_f64();
        assert!(
            seen == (distance <= 0.0) || distance.abs() < 1e-4,
            "{name}: {a:?} {pose_a:?} {b:?} {pose_b:?}: {distance}"
        );
        *if seen { &mut noticed } else { &mut apart } += 1;
    }
    assert!(noticed > 100 && apart > 100, "{name}: {noticed} noticed, {apart} apart");
}

/// A conveyor and a lift: bodies that only their own velocity moves.
fn driven<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::new(0.5, 0.0);
    let plate = Body::immovable().at(vector([0.0, 1.0, 0.0])).moving(vector([0.0, 0.5, 0.0]));
    let plate = stage.insert(plate, Shape::Cuboid([1.0, 0.1, 1.0]));
    let cube = stage.solid(1.0, Shape::Cuboid([0.2; 3]), [0.0, 1.3, 0.0]);
    stage.run(1.0);
    let (under, above) = (stage.position(plate)[1], stage.position(cube)[1]);
    assert!((under - 1.5).abs() < 0.01, "{name}: the lift is at {under}");
    assert!((above - under - 0.3).abs() < 0.01, "{name}: and the cube on it, {above}");
    // Slower than sleepers may be: it goes up with the lift all the same.
    stage.world.body_mut(plate).expect("a body").linear_velocity = vector([0.0, 0.015625, 0.0]);
    stage.run(4.0);
    let (under, above) = (stage.position(plate)[1], stage.position(cube)[1]);
    assert!((under - 1.5625).abs() < 0.01, "{name}: the slow lift is at {under}");
    let speed = floats(stage.world.body(cube).expect("a body").linear_velocity)[1];
    assert!((above - under - 0.3).abs() < 1e-3 && (speed - 0.015625).abs() < 2e-3, "{name}: {above} at {speed} m/s");
    stage.world.body_mut(plate).expect("a body").linear_velocity = vector([0.5, 0.0, 0.0]);
    stage.run(1.5);
    let speed = floats(stage.world.body(cube).expect("a body").linear_velocity)[0];
    assert!((speed - 0.5).abs() < 0.01, "{name}: it goes along, {speed}");
}

fn copies<S: HostScalar>(name: &str) {
    let mut stage = stage::heap::<S>(12);
    stage.run(0.4);
    let kept = stage.world.clone();
    let mut heard = vec![];
    for _ in 0..60 {
        stage.step();
        heard.push((stage.world.hash(), stage.world.contacts().collect::<Vec<_>>(), stage.report));
    }
    for way in 0..2 {
        if way == 0 {
            stage.world = kept.clone();
        } else {
            stage.world.copy_from(&kept);
        }
        for (hash, contacts, report) in &heard {
            stage.step();
            assert_eq!(stage.world.hash(), *hash, "{name}: way {way}");
            assert_eq!(stage.world.contacts().collect::<Vec<_>>(), *contacts, "{name}: way {way}");
            assert_eq!(stage.report, *report, "{name}");
        }
    }
    let phases =
        |phase| heard.iter().flat_map(|(_, contacts, _)| contacts).filter(|contact| contact.phase == phase).count();
    let [began, ended] = [Phase::Began, Phase::Ended].map(phases);
    assert!(began > 8 && ended > 8, "{name}: {began} contacts began and {ended} ended");
}

/// However a step is split, and if it is dropped half made, it comes to the same bits.
fn steps_in_parts<S: HostScalar>(name: &str) {
    let mut stage = stage::heap::<S>(12);
    let settings = stage.settings;
    let mut whole = stage.world.clone();
    for step in 0..120u8 {
        let report = whole.step(&settings);
        let mut split = stage.world.split_step(&settings);
        let parts = match step % 4 {
            0 => vec![],
            1 => vec![1, 1, 1, 1],
            2 => vec![3, 0, 200],
            _ => vec![2],
        };
        let mut left = 4;
        for sub_steps in parts {
            left -= sub_steps.min(left);
            assert_eq!(split.advance(sub_steps), left, "{name}: step {step}");
        }
        if step % 8 < 4 {
            assert_eq!(split.finish(), report, "{name}: step {step}");
        } else {
            drop(split);
        }
        assert_eq!(stage.world.hash(), whole.hash(), "{name}: step {step}");
    }
    assert!(whole.contacts().count() > 8, "{name}: nothing lies on anything");
}

fn questions<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::new(0.5, 0.0);
    let near = stage.solid(1.0, Shape::Sphere(0.5), [2.0, 1.0, 0.0]);
    let far = stage.solid(1.0, Shape::Cuboid([0.5; 3]), [5.0, 1.0, 0.0]);
    let ray = Ray { origin: vector([0.0, 1.0, 0.0]), direction: UnitVec3::X, length: number(20.0) };
    let sight = stage.world.cast_ray(&ray, Filter::ALL).expect("a body is there");
    assert_eq!(sight.body, near, "{name}");
    assert!((sight.hit.distance.to_f64() - 1.5).abs() < 1e-3, "{name}");
    stage.world.set_filter(near, Filter { groups: 4, meets: u16::MAX }).expect("a body");
    let others = Filter { groups: 1, meets: !4 };
    assert_eq!(stage.world.cast_ray(&ray, others).expect("the cube").body, far, "{name}");
    let closest = stage.world.closest_point(vector([3.9, 1.0, 0.0]), others).expect("a surface");
    assert_eq!(closest.body, far, "{name}");
    assert!((closest.point.separation.to_f64() - 0.6).abs() < 1e-3, "{name}");
    let pose = Pose::at(vector([4.2, 1.0, 0.0]));
    let probe = Shape::Sphere(0.4).build::<S>();
    let found: Vec<BodyHandle> = stage.world.overlapping(&probe, &pose, Filter::ALL).collect();
    assert_eq!(found, [far], "{name}");
}

/// All bodies in one spot: they come apart, everything stays finite, and the ground still holds.
fn one_spot<S: HostScalar>(name: &str) {
    let mut stage = Stage::<S>::new(0.5, 0.0);
    let all: Vec<BodyHandle> = (0..8)
        .map(|i| if i % 2 == 0 { Shape::Sphere(0.5) } else { Shape::Cuboid([0.4; 3]) })
        .map(|shape| stage.solid(1.0, shape, [0.0, 1.0, 0.0]))
        .collect();
    stage.run(6.0);
    for handle in &all {
        let [x, y, z] = stage.position(*handle);
        assert!(y > 0.3 && y < 5.0 && x.hypot(z) < 30.0, "{name}: at {x} {y} {z}");
    }
    for (i, a) in all.iter().enumerate() {
        for b in &all[..i] {
            let [p, q] = [stage.position(*a), stage.position(*b)];
            let square: f64 = p.iter().zip(&q).map(|(p, q)| (p - q).powi(2)).sum();
            assert!(square.sqrt() > 0.6, "{name}: two are still in one place");
        }
    }
}

/// A ball of 1 cm at 20 m/s stays on its side of a wall of 1 cm.
fn walls_stop_what_is_fast<S: HostScalar>(name: &str) {
    let mut crossed = 0;
    for offset in 0..40 {
        for restitution in [0.0, 0.9] {
            let mut stage = Stage::<S>::weightless(0.3, restitution);
            let wall = Body::immovable().at(vector([1.0, 0.0, 0.0]));
            stage.insert(wall, Shape::Cuboid([0.005, 0.5, 0.5]));
            let x = 0.1 + 0.01 * f64::from(offset);
            let ball = stage.solid(0.01, Shape::Sphere(0.005), [x, 0.1, 0.0]);
            stage.world.body_mut(ball).expect("a body").linear_velocity = vector([20.0, 1.0, 0.0]);
            stage.run(0.2);
            let at = stage.position(ball)[0];
            crossed += usize::from(at > 0.992);
        }
    }
    assert_eq!(crossed, 0, "{name}");
}

/// A body that has a number which is not finite is not taken, whichever of its numbers it is.
#[cfg(feature = "f32")]
#[test]
fn what_is_not_finite_is_refused() {
    use carom::BodyError::{AngularVelocity, Damping, GravityScale, LinearVelocity, Position};
    type Place = fn(&mut Body<f32>) -> &mut f32;
    let places: [(Place, carom::BodyError); 6] = [
        (|body| &mut body.position.x, Position),
        (|body| &mut body.linear_velocity.y, LinearVelocity),
        (|body| &mut body.angular_velocity.z, AngularVelocity),
        (|body| &mut body.gravity_scale, GravityScale),
        (|body| &mut body.linear_damping, Damping),
        (|body| &mut body.angular_damping, Damping),
    ];
    for (place, error) in places {
        for poison in [f32::NAN, f32::INFINITY] {
            let mut stage = Stage::<f32>::new(0.5, 0.0);
            let mut body = Body::immovable();
            assert_eq!(body.check(), Ok(()));
            *place(&mut body) = poison;
            assert_eq!(body.check(), Err(error));
            let shape = Shape::Sphere(0.5).build::<f32>();
            assert_eq!(stage.world.insert(body, shape, Material::DEAD), Err(InsertError::NotFinite), "{error}");
        }
    }
}

/// In floats a place or velocity that is not finite stays with its body.
#[cfg(feature = "f32")]
#[test]
fn what_is_not_finite_is_quarantined() {
    for poison in [f32::NAN, f32::INFINITY] {
        let mut stage = Stage::<f32>::new(0.5, 0.0);
        let sick = stage.solid(1.0, Shape::Sphere(0.5), [0.0, 0.5, 0.0]);
        let well = stage.solid(1.0, Shape::Sphere(0.5), [0.02, 1.4995, 0.0]);
        stage.run(0.1);
        stage.world.body_mut(sick).expect("a body").linear_velocity.y = poison;
        stage.step();
        assert_eq!(stage.report.quarantined, 1);
        assert_eq!(stage.world.is_quarantined(sick), Ok(true));
        let of_it = stage.world.contacts().filter(|contact| contact.bodies.contains(&sick));
        let phases: Vec<Phase> = of_it.map(|contact| contact.phase).collect();
        assert!(phases.iter().all(|phase| *phase == Phase::Ended) && !phases.is_empty(), "{phases:?}");
        stage.run(0.2);
        assert!(stage.world.body(well).expect("a body").check().is_ok());
        assert!(stage.world.contacts().all(|contact| contact.phase == Phase::Ended || !contact.bodies.contains(&sick)));
        let mended = stage.world.body_mut(sick).expect("a body");
        mended.linear_velocity = vector([0.0; 3]);
        stage.run(0.3);
        assert_eq!(stage.report.quarantined, 0);
    }
}

/// A world costs no flash: all its bits are zero, so that it lies where a program has no bytes of its own.
#[cfg(all(feature = "fixed", feature = "f32", target_os = "linux"))]
#[test]
fn an_empty_world_takes_no_flash() {
    use std::ptr::addr_of;
    use std::sync::Mutex;

    // Of the linker: the part of the memory that is zero when the program starts.
    unsafe extern "C" {
        static __bss_start: u8;
        static _end: u8;
    }
    type Fixed = fixed::types::I16F16;
    static FIXED: Mutex<World<Fixed, Piece<Fixed>, 4, 8, 16>> = Mutex::new(World::new());
    static FLOAT: Mutex<World<f32, Piece<f32>, 4, 8, 16>> = Mutex::new(World::new());
    static OTHER: Mutex<u8> = Mutex::new(1);
    let is_zero = |place: usize| (addr_of!(__bss_start) as usize..addr_of!(_end) as usize).contains(&place);
    assert!(is_zero(addr_of!(FIXED) as usize) && is_zero(addr_of!(FLOAT) as usize));
    assert!(!is_zero(addr_of!(OTHER) as usize), "what is not zero lies elsewhere");
    assert_eq!(FIXED.lock().expect("nobody else").bodies().count(), 0);
    assert_eq!(*OTHER.lock().expect("nobody else"), 1);
}
