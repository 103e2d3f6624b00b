//! Scenes that the units check accepts go in fixed point as in f64; what it refuses goes wrong.
#![cfg(all(feature = "f64", any(feature = "f32", feature = "fixed", feature = "micromath")))]

#[macro_use]
#[path = "support/each_number.rs"]
mod each_number;
#[path = "support/host.rs"]
mod host;
#[path = "support/random.rs"]
mod random;
#[path = "support/scene.rs"]
mod scene;

use carom::UnitVec3;
use carom::solver::Settings;
use carom::units::{Dimension, NumberFormat, Quantity, Scene, Units};
use host::HostScalar;
use random::Random;
use scene::{Scene as World, Shape, number, vector};

each_format!(proposals_fit, conversions, accepted_scenes, settings_of_a_scene);

/// A quantity's value, from the text that shows it: `numerator e exponent / denominator`.
fn float(q: Quantity) -> f64 {
    let text = q.to_string();
    let (n, d) = text.split_once('/').unwrap_or((&text, "1"));
    n.parse::<f64>().expect("a number") / d.parse::<f64>().expect("a number")
}

/// Three digits of a number.
fn quantity(x: f64) -> Quantity {
    let exponent = x.log10().floor() as i32 - 2;
    Quantity::new((x / 10f64.powi(exponent)).round() as i32, exponent as i8)
}

fn random_scene(random: &mut Random) -> Scene {
    let size = random.spread(5e-4, 2.0);
    let distance = size * random.spread(10.0, 3000.0);
    let gravity = random.spread(0.05, 50.0);
    let lightest = random.spread(1e-4, 10.0);
    Scene {
        smallest_size: quantity(size),
        largest_distance: quantity(distance),
        lightest: quantity(lightest),
        heaviest: quantity(lightest * random.spread(1.0, 300.0)),
        fastest: quantity((2.0 * gravity * distance).sqrt() * random.spread(0.3, 3.0)),
        gravity: quantity(gravity),
        step: [Quantity::ratio(1, 30), Quantity::ratio(1, 60), Quantity::ratio(1, 120), Quantity::milli(5)]
            [random.pick(4) as usize],
        sub_steps: [1, 2, 4, 8][random.pick(4) as usize],
        duration: quantity(random.spread(1.0, 1e5)),
    }
}

fn proposals_fit<S: HostScalar + NumberFormat>(name: &str) {
    let mut random = Random::new(1);
    let (mut plain, mut proposed, mut refused) = (0, 0, 0);
    for _ in 0..10_000 {
        let scene = random_scene(&mut random);
        match scene.propose::<S>() {
            Ok(units) => {
                assert!(scene.check_in::<S>(&units).is_ok(), "{name}: {scene:?} in {units}");
                if scene.check::<S>().is_ok() {
                    assert_eq!(units, Units::SI);
                    plain += 1;
                } else {
                    proposed += 1;
                }
            }
            Err(error) => {
                let of_check = scene.check::<S>().expect_err("no units, not SI's either");
                assert!(of_check.remedy.is_none() && scene.check_in::<S>(&error.units).is_err());
                for _ in 0..60 {
                    let (low, high) = [(1e-3, 1.0), (1.0, 1e3)][random.pick(2) as usize];

                    let units = Units {
                        length: quantity(random.spread(1e-6, 1e6)),
                        mass: quantity(random.spread(1e-6, 1e6)),
                        time: quantity(random.spread(low, high)),
                    };
                    let room = scene.check_in::<S>(&units).map_or(-1, |fit| fit.room);
                    assert!(room < 2, "{name}: {scene:?} fits in {units} after all");
                }
                refused += 1;
            }
        }
    }
    println!("{name}: {plain} scenes in SI units, {proposed} in others, {refused} in none");
}

fn conversions<S: HostScalar + NumberFormat>(name: &str) {
    let mut random = Random::new(2);
    let mut seen = 0;
    for _ in 0..20_000 {
        let mut any = || match random.pick(3) {
            0 => Quantity::new(random.below(20_001) as i32 - 10_000, random.below(9) as i8 - 6),
            1 => Quantity::ratio(random.below(4001) as i32 - 2000, random.below(2000) + 1),
            _ => Quantity::new(1, random.below(7) as i8 - 4),
        };
        let x = any();
        let one = |q: Quantity| if float(q) > 0.0 { q } else { Quantity::ONE };
        let units = Units { length: one(any()), mass: one(any()), time: one(any()) };
        let dimension =
            [Dimension::SPEED, Dimension::ACCELERATION, Dimension::IMPULSE, Dimension::DENSITY][(seen % 4) as usize];
        let scale = float(units.length).powi(i32::from(dimension.length))
            * float(units.mass).powi(i32::from(dimension.mass))
            * float(units.time).powi(i32::from(dimension.time));
        let right = float(x) / scale;
        match units.convert::<S>(x, dimension) {
            Ok(found) => {
                // A handful of roundings of the intermediate format, and one of the format itself.
                let bound = 0.5 * S::spacing(right)
                    + 12.0 * right.abs() * 2f64.powi(-24).min(S::spacing(1.0).max(2f64.powi(-30)));
                assert!((found.to_f64() - right).abs() <= bound, "{name}: {x} in {units}: {found:?} for {right}");
                let of = quantity(scale);
                let count = units.count(found, dimension, of);
                let exact = found.to_f64() * scale / float(of);
                if exact.abs() < 1e6 {
                    assert!(
                        (f64::from(count) - exact).abs() <= 0.5 + exact.abs() * 1e-6,
                        "{name}: {count} for {exact}"
                    );
                    seen += 1;
                }
            }
            Err(_) => assert!(S::from_f64(right * (1.0 + 1e-6)).is_none(), "{name}: {right} refused"),
        }
    }
    assert!(seen > 2000, "{name}: {seen}");
}

/// Bounds against f64: of ways fallen and slid, in parts of them, and of the depth at rest in parts of the smallest size. Gravity
/// and the change of speed in a sub-step are a thousandth off at most.
const FALL: f64 = 2e-3;
const SLIDE: f64 = 1e-2;
const SINK: f64 = 2e-3;

/// What became of the box that slid.
struct Slab {
    way: f64,
    speed: f64,
    sunk: f64,
}

/// A world in the scene's units, and the same in f64.
struct Run<'a> {
    scene: &'a Scene,
    units: &'a Units,
}

impl Run<'_> {
    fn in_units(&self, x: Quantity, dimension: Dimension) -> f64 {
        self.units.convert::<f64>(x, dimension).expect("within f64")
    }

    fn world<S: HostScalar>(&self, friction: f64) -> World<S> {
        let g = self.in_units(self.scene.gravity, Dimension::ACCELERATION);
        let step = self.units.step(self.scene.step).expect("a step");
        let mut world = World::new([0.0, -g, 0.0], step, self.scene.sub_steps, friction, 0.0);
        world.settings.push_out_speed = number(self.in_units(self.scene.fastest, Dimension::SPEED));
        world.ground([0.0, 1.0, 0.0]);
        world
    }

    /// A small ball that turns as fast as one can and touches nothing: what keeps the solver's places few.
    fn spinner<S: HostScalar>(&self, world: &mut World<S>) {
        let (size, speed) = (self.size(), self.in_units(self.scene.fastest, Dimension::SPEED));
        let spinner = world.solid(self.light(), Shape::Sphere(size), [0.0, 4.0 * size, -5.0 * size]);
        world.bodies[spinner].angular_velocity = vector([0.0, speed / size, 0.0]);
        world.bodies[spinner].gravity_scale = S::ZERO;
    }

    fn size(&self) -> f64 {
        self.in_units(self.scene.smallest_size, Dimension::LENGTH)
    }

    fn light(&self) -> f64 {
        self.in_units(self.scene.lightest, Dimension::MASS)
    }

    /// How far a ball falls in some steps, less than the distance.
    fn falls<S: HostScalar>(&self) -> f64 {
        let mut world = self.world::<S>(0.5);
        self.spinner(&mut world);
        let distance = self.in_units(self.scene.largest_distance, Dimension::LENGTH);
        let (g, top) = (self.in_units(self.scene.gravity, Dimension::ACCELERATION), 0.9 * distance);
        let ball = world.solid(self.light(), Shape::Sphere(self.size()), [0.0, top, 0.0]);
        let start = world.position(ball)[1];
        let speed = self.in_units(self.scene.fastest, Dimension::SPEED);
        let time = (distance / g).sqrt().min(0.9 * speed / g);
        let steps = ((time / world.dt) as usize).clamp(1, 400);
        (0..steps).for_each(|_| world.step());
        assert!(!world.saturated);
        start - world.position(ball)[1]
    }

    /// A flat box slides until it rests.
    fn slides<S: HostScalar>(&self) -> Slab {
        let mut world = self.world::<S>(0.5);
        self.spinner(&mut world);
        let distance = self.in_units(self.scene.largest_distance, Dimension::LENGTH);
        let (size, g) = (self.size(), self.in_units(self.scene.gravity, Dimension::ACCELERATION));
        let speed = self.in_units(self.scene.fastest, Dimension::SPEED);
        // As many sizes as leave it a number of steps to stop in.
        let slow = (0.5 * g * 100.0 * world.dt).max(speed * 0.02);
        let v = slow.min(0.6 * speed).min((0.5 * g * distance).sqrt()).min(size / world.dt);
        let half = [2.0 * size, size, 2.0 * size];
        let slab = world.solid(self.light(), Shape::Cuboid(half), [0.0, size, 0.0]);
        world.bodies[slab].linear_velocity = vector([0.8 * v, 0.0, 0.6 * v]);
        let steps = ((v / (0.5 * g) / world.dt) as usize).clamp(1, 1000) + 60;
        (0..steps).for_each(|_| world.step());
        let [x, y, z] = world.position(slab);
        let speed = world.velocity(slab).iter().map(|v| v * v).sum::<f64>().sqrt();
        assert!(!world.saturated);
        Slab { way: x.hypot(z), speed, sunk: size - y }
    }
}

fn accepted_scenes<S: HostScalar + NumberFormat>(name: &str) {
    let mut random = Random::new(3);
    let (mut seen, mut tight, mut worst) = (0, 0, [0f64; 4]);
    while seen < 300 {
        let scene = random_scene(&mut random);
        // Gravity alone takes a body through its own size in a step: no number helps.
        if float(scene.gravity) * float(scene.step).powi(2) > 0.25 * float(scene.smallest_size) {
            continue;
        }
        let Ok(units) = scene.propose::<S>() else { continue };
        let fit = scene.check_in::<S>(&units).expect("what was proposed");
        let run = Run { scene: &scene, units: &units };
        let unit = S::spacing(run.in_units(scene.largest_distance, Dimension::LENGTH));
        let at = format!("{name}, {units}, {fit:?}, {scene:?}");

        let (fallen, right) = (run.falls::<S>(), run.falls::<f64>());
        let off = ((fallen - right).abs() - 2.0 * unit).max(0.0) / right;
        assert!(off <= FALL, "{at}: fell {fallen} for {right}");
        let (slab, exact) = (run.slides::<S>(), run.slides::<f64>());
        let way = ((slab.way - exact.way).abs() - 2.0 * unit).max(0.0) / exact.way;
        assert!(way <= SLIDE, "{at}: slid {} for {}", slab.way, exact.way);
        let noise =
            (slab.speed - exact.speed).abs() * float(units.length) / float(units.time) / float(fit.resting_noise);
        assert!(noise <= 1.0, "{at}: rests at {} m/s", slab.speed);
        let sunk = (slab.sunk - exact.sunk).abs() / run.size();
        assert!(sunk <= SINK, "{at}: sinks by {sunk} of its size");

        for (worst, x) in worst.iter_mut().zip([off, way, noise, sunk]) {
            *worst = worst.max(x);
        }
        seen += 1;
        tight += usize::from(fit.room <= 1);
    }
    assert!(tight >= 50, "{name}: only {tight} scenes within a factor of four of a limit");
    println!("{name}: {seen} scenes, {tight} tight; worst {worst:?}");
}

/// A scene's settings are its numbers in its units, and boxes that overlap part as in metres; at the 4 units of plain settings
/// they would not.
fn settings_of_a_scene<S: HostScalar + NumberFormat>(name: &str) {
    let scene = Scene {
        smallest_size: Quantity::centi(4),
        largest_distance: Quantity::whole(1),
        lightest: Quantity::ONE,
        heaviest: Quantity::ONE,
        fastest: Quantity::whole(-2),
        gravity: Quantity::centi(-981),
        step: Quantity::ratio(1, 60),
        sub_steps: 4,
        duration: Quantity::whole(60),
    };
    // How high a box of 8 cm is after a fifth of a second that began 3 cm in the ground, in metres.
    let rises = |units: Units, plain: bool| {
        let length = |x: f64| x / float(units.length);
        let mut settings = scene.settings::<S>(&units, -UnitVec3::Y).expect("within the format");
        if plain {
            settings = Settings::new(settings.gravity, [1, 60], 4).expect("settings");
        }
        let mut world = World::<S>::new([0.0; 3], [1, 60], 4, 0.5, 0.0);
        world.settings = settings;
        world.ground([0.0, 1.0, 0.0]);
        let cube = world.solid(1.0, Shape::Cuboid([length(0.04); 3]), [0.0, length(0.01), 0.0]);
        world.run(0.2);
        world.position(cube)[1] * float(units.length)
    };
    let centimetres = Units { length: Quantity::centi(1), ..Units::SI };
    if scene.check_in::<S>(&centimetres).is_err() {
        // Gravity is beyond the range.
        assert_eq!(name, "i8f24");
        assert!(scene.settings::<S>(&centimetres, -UnitVec3::Y).is_err());
        return;
    }
    let settings = scene.settings::<S>(&centimetres, -UnitVec3::Y).expect("within the format");
    assert_eq!(scene::floats(settings.gravity), [0.0, -981.0, 0.0], "{name}");
    assert_eq!(settings.push_out_speed.to_f64(), 200.0, "{name}");
    assert!((S::scaled_to_f64(settings.seconds()) * 60.0 - 1.0).abs() < 1e-6, "{name}");
    let [si, scaled, plain] = [rises(Units::SI, false), rises(centimetres, false), rises(centimetres, true)];
    assert!((si - 0.04).abs() < 1e-3, "{name}: {si} in metres");
    assert!((scaled - si).abs() < 2e-4, "{name}: {scaled}, and {si} in metres");
    assert!(plain < 0.03, "{name}: {plain} with plain settings");
}
