//! The limits of the units check: at them a scene still goes, beyond them it does not.
#![cfg(all(feature = "fixed", feature = "f64"))]

#[path = "support/host.rs"]
mod host;
#[path = "support/scene.rs"]
mod scene;

use carom::impulse::resolve_collision;
use carom::solver::Settings;
use carom::units::{Format, Misfit, NumberFormat, Property, Quantity, Scene, Units};
use carom::{Body, Contact, Scalar, UnitVec3, Vec3};
use fixed::FixedI32;
use fixed::types::extra::U31;
use fixed::types::{I2F30, I3F29, I4F28, I16F16};
use host::HostScalar;
use scene::{Scene as World, Shape, mass, number, vector};

/// A check in each fixed-point format.
macro_rules! each_fixed {
    ($($check:ident),+ $(,)?) => {$(
        mod $check {
            #[test]
            fn i16f16() {
                super::$check::<fixed::types::I16F16>();
            }
            #[test]
            fn i12f20() {
                super::$check::<fixed::types::I12F20>();
            }
            #[test]
            fn i8f24() {
                super::$check::<fixed::types::I8F24>();
            }
        }
    )+};
}

each_fixed!(ranges, impulses, sizes, gravity, falls, drops);

const G: Quantity = Quantity::whole(4);

/// A scene in the middle of each format.
const BASE: Scene = Scene {
    smallest_size: Quantity::ratio(1, 8),
    largest_distance: Quantity::whole(10),
    lightest: Quantity::ONE,
    heaviest: Quantity::ONE,
    fastest: Quantity::whole(2),
    gravity: G,
    step: Quantity::ratio(1, 60),
    sub_steps: 4,
    duration: Quantity::whole(100),
};

/// So many units of the last place.
fn units<S: NumberFormat>(n: i32) -> Quantity {
    let Format::Fixed { fraction_bits } = S::FORMAT else { panic!("fixed point") };
    Quantity::ratio(n, 1 << fraction_bits)
}

/// The power of two next to the largest number.
fn beyond<S: NumberFormat>() -> Quantity {
    let Format::Fixed { fraction_bits } = S::FORMAT else { panic!("fixed point") };
    Quantity::whole(1 << (31 - fraction_bits))
}

fn accepts<S: NumberFormat>(scene: Scene) {
    let fit = scene.check::<S>();
    assert!(fit.is_ok(), "{}", fit.unwrap_err());
    assert_eq!(fit.unwrap().room, 0, "not at the limit");
}

fn refuses<S: NumberFormat>(scene: Scene, property: Property, misfit: Misfit) {
    let error = scene.check::<S>().expect_err("beyond the limit");
    assert_eq!((error.property, error.misfit), (property, misfit), "{error}");
}

/// The end of the range: distances, speeds, spins, masses and gravity at it are numbers, and beyond it are none.
fn ranges<S: HostScalar + NumberFormat>() {
    let (last, beyond) = (units::<S>(i32::MAX - 1), beyond::<S>());
    assert!(Units::SI.length::<S>(last).is_ok() && Units::SI.length::<S>(beyond).is_err());
    const LIGHT: Quantity = Quantity::ratio(1, 128);
    let weightless = Scene { gravity: Quantity::whole(0), smallest_size: Quantity::ONE, ..BASE };
    type With = fn(Scene, Quantity) -> Scene;
    let scenes: [(Property, With); 4] = [
        (Property::Distance, |scene, x| Scene { largest_distance: x, ..scene }),
        (Property::Speed, |scene, x| Scene {
            fastest: x,
            smallest_size: Quantity::whole(10),
            lightest: LIGHT,
            heaviest: LIGHT,
            ..scene
        }),
        (Property::HeaviestMass, |scene, x| Scene { heaviest: x, fastest: Quantity::ratio(1, 2), ..scene }),
        (Property::Gravity, |scene, x| Scene { gravity: x, ..scene }),
    ];
    for (property, with) in scenes {
        accepts::<S>(with(weightless, last));
        refuses::<S>(with(weightless, beyond), property, Misfit::TooLarge);
    }
    // A small ball that comes to roll: within the range of spins, or beyond.
    for (percent, saturates) in [(80, false), (130, true)] {
        let (size, g, range) = (1.0 / 64.0, 100.0, S::to_f64(S::LARGEST));
        let v = size * range * f64::from(percent) / 100.0;
        let fastest = Quantity::milli((v * 1000.0) as i32);
        let scene = Scene { smallest_size: Quantity::ratio(1, 64), fastest, gravity: Quantity::whole(0), ..BASE };
        assert_eq!(scene.check::<S>().is_err_and(|error| error.property == Property::Spin), saturates);
        let mut world = World::<S>::new([0.0, -g, 0.0], [1, 240], 4, 0.5, 0.0);
        world.ground([0.0, 1.0, 0.0]);
        let ball = world.solid(1.0, Shape::Sphere(size), [0.0, size, 0.0]);
        world.bodies[ball].linear_velocity = vector([v, 0.0, 0.0]);
        world.bodies[ball].angular_velocity = vector([0.0, 0.0, -0.7 * range]);
        world.run((v - 0.7 * range * size) / (3.5 * 0.5 * g) + 0.1);
        assert_eq!(world.saturated, saturates, "{percent} %: {:?}", world.spin(ball));
    }
}

/// Twice the highest speed by the largest mass.
fn impulses<S: HostScalar + NumberFormat>() {
    let quarter = S::to_f64(S::LARGEST) / 4.0;
    for (part, fits) in [(0.999, true), (1.001, false)] {
        let scene = Scene { heaviest: Quantity::milli((quarter * part * 1000.0) as i32), ..BASE };
        assert_eq!(scene.check::<S>().is_ok(), fits);
        if !fits {
            refuses::<S>(scene, Property::Impulse, Misfit::TooLarge);
        }
        let mut ball = Body::<S>::dynamic(mass(quarter * part, [1.0; 3]));
        ball.linear_velocity = vector([2.0, 0.0, 0.0]);
        let contact = Contact { normal: UnitVec3::X, r_a: Vec3::ZERO, r_b: Vec3::ZERO };
        let hit = resolve_collision(&mut ball, &mut Body::immovable(), &contact, S::ONE);
        assert_eq!(hit.saturated, !fits, "{hit:?}");
    }
}

/// Four boxes of so many units stand, or fall.
fn stands<S: HostScalar>(n: f64) -> bool {
    let r = n * S::spacing(1.0);
    let mut world = World::<S>::new([0.0, -1000.0 * r, 0.0], [1, 60], 4, 0.5, 0.0);
    world.ground([0.0, 1.0, 0.0]);
    for i in 0..4 {
        world.solid(1.0, Shape::Cuboid([r; 3]), [0.0, r * f64::from(2 * i + 1), 0.0]);
    }
    world.run(10.0);
    world.position(4)[1] > 6.5 * r
}

/// 512 units of the last place: rounding to them is off by a thousandth at most, and piles stand.
fn sizes<S: HostScalar + NumberFormat>() {
    let scene = |n| Scene { smallest_size: units::<S>(n), fastest: units::<S>(n), gravity: Quantity::ONE, ..BASE };
    accepts::<S>(scene(512));
    refuses::<S>(scene(511), Property::Size, Misfit::TooSmall);
    let light = |n| Scene { lightest: units::<S>(n), ..BASE };
    accepts::<S>(light(512));
    refuses::<S>(light(511), Property::LightestMass, Misfit::TooSmall);
    assert!(stands::<S>(512.0) && stands::<S>(600.0) && stands::<S>(1000.0));
    assert!(!stands::<S>(256.0) && !stands::<S>(128.0));
}

/// A body that falls `steps` from rest, in a world where another turns as fast as its speed and size let it: how far it falls, in
/// parts of f64's way.
fn fall<S: HostScalar>(g: f64, step: [u16; 2], sub_steps: u8, fastest: f64, size: f64) -> f64 {
    fn way<S: HostScalar>(g: f64, step: [u16; 2], sub_steps: u8, fastest: f64, size: f64) -> f64 {
        let mut world = World::<S>::new([0.0, -g, 0.0], step, sub_steps, 0.0, 0.0);
        let spinner = world.solid(1.0, Shape::Sphere(size), [0.0, 0.0, -10.0 * size]);
        world.bodies[spinner].angular_velocity = vector([0.0, fastest / size, 0.0]);
        world.bodies[spinner].gravity_scale = S::ZERO;
        let ball = world.solid(1.0, Shape::Sphere(size), [0.0; 3]);
        (0..200).for_each(|_| world.step());
        world.position(ball)[1]
    }
    way::<S>(g, step, sub_steps, fastest, size) / way::<f64>(g, step, sub_steps, fastest, size)
}

/// 512 units again: gravity, once rounded, is off by a thousandth at most.
fn gravity<S: HostScalar + NumberFormat>() {
    let scene = |n| Scene { gravity: units::<S>(n), step: Quantity::ratio(1, 5), fastest: units::<S>(1 << 13), ..BASE };
    accepts::<S>(scene(512));
    refuses::<S>(scene(511), Property::Gravity, Misfit::TooSmall);
    let unit = S::spacing(1.0);
    let off = |n: f64| (fall::<S>(n * unit, [1, 5], 4, 0.0, 0.125) - 1.0).abs();
    assert!(off(512.5) <= 1.05e-3 && off(600.45) <= 1.05e-3);
    assert!(off(128.5) > 2e-3, "{}", off(128.5));
}

/// What gravity adds in a sub-step is a thousandth off at the limit, and more beyond it.
fn falls<S: HostScalar + NumberFormat>() {
    let size = 8.0;
    let scene = |fastest: i32| Scene {
        smallest_size: Quantity::whole(8),
        gravity: Quantity::ONE,
        lightest: Quantity::ratio(1, 100),
        heaviest: Quantity::ratio(1, 100),
        fastest: Quantity::milli(fastest),
        ..BASE
    };
    // Highest speeds in powers of two, in mm/s.
    let Some(first) = (0..20).find(|k| scene(1 << k).check::<S>().is_err_and(|error| error.property == Property::Fall))
    else {
        // What it takes is there up to the end of the range.
        assert!(S::LARGEST.to_f64() < 200.0);
        return;
    };
    let first = (0..first)
        .rev()
        .fold(0, |found, bit| if scene(found | 1 << bit).check::<S>().is_ok() { found | 1 << bit } else { found });
    accepts::<S>(scene(first));
    let worst = |fastest: f64| {
        let off = |k: i32| (fall::<S>(1.0 + 3e-3 * f64::from(k), [1, 60], 4, fastest, size) - 1.0).abs();
        (0..10).map(off).fold(0.0, f64::max)
    };
    let last = f64::from(first) / 1000.0;
    assert!(worst(last) <= 2e-3, "{}", worst(last));
    assert!(worst(32.0 * last) > 4e-3, "{}", worst(32.0 * last));
}

/// By how much the way of a sliding box is off f64's at worst, beside two units of the last place, for a gravity of 600 units.
fn slides<S: HostScalar>(step: [u16; 2], sub_steps: u8) -> f64 {
    fn way<S: HostScalar>(unit: f64, step: [u16; 2], sub_steps: u8, sizes: f64, heading: f64) -> f64 {
        let (g, r) = (600.0 * unit, 512.0 * unit);
        let mut world = World::<S>::new([0.0, -g, 0.0], step, sub_steps, 0.5, 0.0);
        world.settings.push_out_speed = number(60.0 * r);
        world.ground([0.0, 1.0, 0.0]);
        let slab = world.solid(1.0, Shape::Cuboid([2.0 * r, r, 2.0 * r]), [0.0, r, 0.0]);
        let v = (g * sizes * r).sqrt();
        world.bodies[slab].linear_velocity = vector([v * heading.cos(), 0.0, v * heading.sin()]);
        world.run(2.0 * v / g + 1.0);
        let [x, _, z] = world.position(slab);
        x.hypot(z)
    }
    let unit = S::spacing(1.0);
    let mut worst = 0f64;
    for sizes in [0.1, 0.3, 1.0] {
        for heading in [0.0, 0.2, 0.64, 1.0] {
            let found = way::<S>(unit, step, sub_steps, sizes, heading);
            let right = way::<f64>(unit, step, sub_steps, sizes, heading);
            worst = worst.max(((found - right).abs() - 2.0 * unit) / right);
        }
    }
    worst
}

/// The weight of a body at rest, beside the rounding of its position.
fn drops<S: HostScalar + NumberFormat>() {
    let scene = |n| Scene {
        gravity: units::<S>(600),
        step: Quantity::ratio(1, n),
        sub_steps: 8,
        fastest: units::<S>(512),
        ..BASE
    };
    accepts::<S>(scene(69));
    refuses::<S>(scene(70), Property::Drop, Misfit::TooSmall);
    for (at, beyond) in [([1, 69], [1, 200]), ([1, 138], [1, 400])] {
        let sub_steps = if at[1] < 100 { 8 } else { 4 };
        let (at, beyond) = (slides::<S>(at, sub_steps), slides::<S>(beyond, sub_steps));
        assert!(at <= 0.01, "{at}");
        assert!(beyond > 0.2, "{beyond}");
    }
}

/// A sub-step has to be less than a unit of time.
#[test]
fn sub_steps() {
    let scene = |n, d| Scene { step: Quantity::ratio(n, d), sub_steps: 1, fastest: Quantity::milli(1), ..BASE };
    let settings = |step| Settings::<I16F16>::new(Vec3::ZERO, step, 1);
    assert!(scene(9, 10).check::<I16F16>().is_ok() && settings([9, 10]).is_ok());
    refuses::<I16F16>(scene(1, 1), Property::SubStep, Misfit::TooLarge);
    assert!(settings([1, 1]).is_err());
    let units = scene(1, 1).propose::<I16F16>().expect("longer units of time");
    assert!(settings(units.step(Quantity::ONE).expect("a step")).is_ok());
}

/// The clock is one step off after as long as it takes.
#[test]
fn clock() {
    let drift = |seconds: f64| {
        let h: FixedI32<U31> = I16F16::sub_step(1, 240).expect("a sub-step");
        (h.to_num::<f64>() * 240.0 - 1.0).abs() * seconds
    };
    let scene = |seconds| Scene { duration: Quantity::whole(seconds), ..BASE };
    let last = (0..).find(|k| scene(1000 * k).check::<I16F16>().is_err()).expect("an end") - 1;
    refuses::<I16F16>(scene(1000 * last + 1000), Property::Clock, Misfit::TooLarge);
    let step = 1.0 / 60.0;
    assert!(drift(1000.0 * f64::from(last)) <= step);
    assert!(drift(1200.0 * f64::from(last)) > step);
}

/// Formats that cannot hold what `Settings::new` stores.
#[test]
fn few_integer_bits() {
    fn settings<S: Scalar>() -> bool {
        Settings::<S>::new(Vec3::ZERO, [1, 60], 4).is_ok()
    }
    fn refused<S: NumberFormat>() -> bool {
        BASE.propose::<S>().is_err_and(|error| error.property == Property::PushOutSpeed)
    }
    assert!(refused::<I2F30>() && !settings::<I2F30>());
    assert!(refused::<I3F29>() && !settings::<I3F29>());
    assert!(!refused::<I4F28>() && settings::<I4F28>());
}
