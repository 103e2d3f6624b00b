//! The smallest use: two bodies, one contact, one impulse.
//!
//! A dart of 20 g hits the rim of a resting disc of 100 g off its centre, at 10 m/s, and the disc starts to move and turn.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;

use board::Exit;
use carom::impulse::{Impact, Outcome, resolve_collision_with_friction};
use carom::{Body, Contact, Material, Solid, UnitVec3, Vec3};
use numbers::{Job, Number};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Quickstart)
}

struct Quickstart;

impl Job for Quickstart {
    fn run<S: Number>(&self) -> Exit {
        impact::<S>().unwrap_or(Exit::Failure)
    }
}

#[inline(never)]
fn kernel_resolve<S: Number>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    material: &Material<S>,
) -> Impact<S> {
    resolve_collision_with_friction(a, b, contact, material)
}

fn impact<S: Number>() -> Option<Exit> {
    let milli = |n| S::from_ratio(n, 1000).ok();
    let zero = S::ZERO;

    // Metres, kilograms, seconds. Mass and inertia may be as small as they are: they carry an exponent of their own.
    let mut dart = Body::<S>::dynamic(Solid::sphere(milli(5)?).ok()?.with_mass(milli(20)?).ok()?);
    let mut disc = Body::<S>::dynamic(Solid::cylinder(milli(50)?, milli(3)?).ok()?.with_mass(milli(100)?).ok()?);
    dart.linear_velocity = Vec3::new(milli(10_000)?, zero, zero);

    // The disc's axis is z; the dart touches its rim 30 mm off the centre line. The normal points from dart to disc.
    let contact = Contact {
        normal: UnitVec3::normalize(Vec3::new(milli(800)?, milli(-600)?, zero)).ok()?,
        r_a: Vec3::new(milli(4)?, milli(-3)?, zero),
        r_b: Vec3::new(milli(-40)?, milli(30)?, zero),
    };
    let material = Material::new(milli(500)?, milli(200)?).ok()?;
    let hit = kernel_resolve(&mut dart, &mut disc, &contact, &material);

    board::println!("{}: the contact {}", S::NAME, outcome(hit.outcome));
    board::println!("normal impulse   {} mN s", hit.normal_impulse.milli());
    print_vec3("friction impulse", hit.friction_impulse, "mN s");
    print_vec3("disc velocity   ", disc.linear_velocity, "mm/s");
    print_vec3("disc spin       ", disc.angular_velocity, "mrad/s");
    print_vec3("dart velocity   ", dart.linear_velocity, "mm/s");
    if hit.saturated {
        // In I8F24 the dart would spin faster than the format's 128 rad/s.
        board::println!("a velocity met the end of the format and stayed there");
    }
    Some(Exit::Success)
}

fn outcome(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Stuck => "stuck",
        Outcome::Slid => "slid",
        _ => "did nothing",
    }
}

fn print_vec3<S: Number>(name: &str, v: Vec3<S>, unit: &str) {
    let [x, y, z] = v.to_array().map(Number::milli);
    board::println!("{name} {x} {y} {z} {unit}");
}
