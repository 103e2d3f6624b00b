//! A marble in a maze that a hand tilts, on a Cortex-M with 16 KB of RAM.
#![no_std]
#![no_main]

use carom::solver::Settings;
use carom::world::Phase;
use carom::{Body, BodyHandle, Cuboid, HalfSpace, Material, Scalar, Sphere, UnitVec3, Vec3, World};
use cortex_m as _; // brings the critical sections of `hprintln!`
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};

/// The number type. With an FPU: `f32`, and carom's feature of that name.
type Real = fixed::types::I12F20;

carom::shapes! {
    /// What there is: only the pairs of these are linked.
    enum Piece<S> { Sphere, Cuboid, HalfSpace }
}

/// Floor, four sides, two walls, the goal and the marble; pairs that touch at once, and their points.
type Maze = World<Real, Piece<Real>, 9, 6, 6>;

/// Steps in a second, and from one printed place to the next.
const RATE: u16 = 60;
const FRAME: u32 = 30;

/// Thousandths: millimetres of metres, grams of kilograms.
fn milli(n: i32) -> Real {
    Real::from_ratio(n, 1000).expect("a number in the range of the format")
}

fn vector([x, y, z]: [i32; 3]) -> Vec3<Real> {
    Vec3::new(milli(x), milli(y), milli(z))
}

/// A tray of 12 by 8 cm with two walls in it; the goal and the marble.
fn build(world: &mut Maze) -> [BodyHandle; 2] {
    let glass = Material::new(milli(400), milli(250)).expect("restitution and friction");
    let mut fixture =
        |piece: Piece<Real>, at| world.insert(Body::immovable().at(vector(at)), piece, glass).expect("room for a body");
    fixture(HalfSpace::new(UnitVec3::Z).into(), [0, 0, 0]);
    fixture(HalfSpace::new(UnitVec3::X).into(), [-60, 0, 0]);
    fixture(HalfSpace::new(-UnitVec3::X).into(), [60, 0, 0]);
    fixture(HalfSpace::new(UnitVec3::Y).into(), [0, -40, 0]);
    fixture(HalfSpace::new(-UnitVec3::Y).into(), [0, 40, 0]);
    let wall = Cuboid::new(vector([3, 28, 10])).expect("a solid wall");
    fixture(wall.into(), [-20, -12, 10]);
    fixture(wall.into(), [20, 12, 10]);
    let ball = Sphere::new(milli(6)).expect("a ball");
    let goal = fixture(ball.into(), [52, 32, 6]);
    world.set_sensor(goal, true).expect("the goal is there");

    let mass = ball.solid().expect("a solid ball").with_mass(milli(2)).expect("a mass");
    let marble = Body::dynamic(mass).at(vector([-45, -30, 6]));
    [goal, world.insert(marble, ball, glass).expect("room for the marble")]
}

/// How the hand holds the tray: gravity in the tray's frame, mm/s^2. An accelerometer at rest shows the opposite.
fn gravity(step: u32) -> [i32; 3] {
    const TILT: i32 = 1200;
    let [x, y] = match step / u32::from(RATE) {
        0 => [0, TILT],
        1 => [TILT, TILT],
        2 => [TILT, -TILT],
        _ => [TILT, TILT],
    };
    [x, y, -9700]
}

#[entry]
fn main() -> ! {
    // All of it is zero at first: it takes no flash, and never crosses the stack.
    static mut WORLD: Maze = World::new();
    let [goal, marble] = build(WORLD);
    let mut settings = Settings::new(vector(gravity(0)), [1, RATE], 4).expect("a time");

    for step in 0..10 * u32::from(RATE) {
        settings.gravity = vector(gravity(step));
        let report = WORLD.step(&settings);
        if report.dropped > 0 || report.saturated {
            hprintln!("{:?}", report);
        }
        for impact in WORLD.impacts().filter(|impact| impact.approach_speed > milli(50)) {
            hprintln!("  a blow at {} mm/s", to_milli(impact.approach_speed));
        }
        let place = WORLD.body(marble).expect("the marble is there").position;
        if step % FRAME == 0 {
            hprintln!(
                "after {:4} ms: {:3} {:3} mm",
                step * 1000 / u32::from(RATE),
                to_milli(place.x),
                to_milli(place.y)
            );
        }
        if WORLD.contacts().any(|contact| contact.bodies.contains(&goal) && contact.phase == Phase::Began) {
            hprintln!("goal after {} steps, state {:016x}", step + 1, WORLD.hash());
            end(true);
        }
    }
    end(false)
}

/// Thousandths, rounded. In 64 bits: a thousand times 3 m/s is beyond the format.
fn to_milli(x: Real) -> i32 {
    let half = 1 << (Real::FRAC_NBITS - 1);
    ((i64::from(x.to_bits()) * 1000 + half) >> Real::FRAC_NBITS) as i32
}

/// Ends QEMU. On a part of your own there is nothing to end.
fn end(good: bool) -> ! {
    debug::exit(if good { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {}
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo<'_>) -> ! {
    hprintln!("{}", info);
    end(false)
}
