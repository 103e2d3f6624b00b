//! A ball that falls on a floor.
#![no_std]
#![no_main]

use carom::solver::Settings;
use carom::{Body, HalfSpace, Material, Scalar, Sphere, UnitVec3, Vec3, World};
use cortex_m as _; // brings the critical sections of `hprintln!`
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};

/// The number type. With an FPU: `f32`, and carom's feature of that name.
type Real = fixed::types::I12F20;

carom::shapes! {
    /// What there is: only the pairs of these are linked.
    enum Piece<S> { Sphere, HalfSpace }
}

/// Thousandths: millimetres of metres, grams of kilograms.
fn milli(n: i32) -> Real {
    Real::from_ratio(n, 1000).expect("a number in the range of the format")
}

#[entry]
fn main() -> ! {
    // Bodies, pairs that touch at once, their points. All of it is zero at first: it takes no flash, and never crosses the stack.
    static mut WORLD: World<Real, Piece<Real>, 2, 1, 1> = World::new();
    let rubber = Material::new(milli(500), milli(500)).expect("restitution and friction");
    WORLD.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), rubber).expect("room for the floor");
    let shape = Sphere::new(milli(20)).expect("a ball");
    let mass = shape.solid().expect("a solid ball").with_mass(milli(30)).expect("a mass");
    let ball = Body::dynamic(mass).at(Vec3::new(milli(0), milli(0), milli(500)));
    let ball = WORLD.insert(ball, shape, rubber).expect("room for the ball");

    let settings = Settings::new(Vec3::new(milli(0), milli(0), milli(-9810)), [1, 60], 4).expect("a time");
    for _ in 0..180 {
        WORLD.step(&settings);
    }
    let height = WORLD.body(ball).expect("the ball is there").position.z;
    hprintln!("the ball is {} m up", height);
    end(true)
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
