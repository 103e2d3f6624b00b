//! lab
#![cfg_attr(target_os = "none", no_std, no_main)]
mod board;
mod numbers;
use board::Exit;
use carom::solver::*;
use carom::*;
use numbers::{Job, Number};

board::entry!(run);
fn run() -> Exit {
    numbers::dispatch(&Pile)
}
struct Pile;

#[cfg(target_os = "none")]
fn ticks() -> u32 {
    unsafe { core::ptr::read_volatile(0xE000_E018 as *const u32) }
}
#[cfg(not(target_os = "none"))]
fn ticks() -> u32 {
    0
}
#[cfg(target_os = "none")]
fn start() {
    unsafe {
        core::ptr::write_volatile(0xE000_E014 as *mut u32, 0xffffff);
        core::ptr::write_volatile(0xE000_E018 as *mut u32, 0);
        core::ptr::write_volatile(0xE000_E010 as *mut u32, 5);
    }
}
#[cfg(not(target_os = "none"))]
fn start() {}

#[inline(never)]
pub fn step<S: Number>(
    bodies: &mut [Body<S>],
    n: usize,
    buffers: Buffers<'_, S>,
    settings: &Settings<S>,
    material: &Material<S>,
    warm: &mut [WarmStart<S>],
    radius: S,
    t: &mut [u32; 6],
) {
    let sphere = Sphere::new(radius).ok().unwrap();
    let plane = HalfSpace::new(UnitVec3::Y);
    let margin = S::from_ratio(1, 100).ok().unwrap();
    t[0] = ticks();
    let mut step = Step::begin(&mut bodies[..n + 1], buffers, settings);
    t[1] = ticks();
    for i in 0..n {
        let mut m: Option<Manifold<S>> = None;
        let b = step.bodies();
        let pb = Pose::new(b[i + 1].position, b[i + 1].orientation());
        let pa = Pose::new(b[i].position, b[i].orientation());
        if i == 0 {
            plane.collide(&pa, &sphere, &pb, margin, &mut m)
        } else {
            sphere.collide(&pa, &sphere, &pb, margin, &mut m)
        }
        t[5] = ticks();
        if let Some(m) = m {
            step.add([i as u16, i as u16 + 1], &m, material, &warm[i..i + 1]);
        }
    }
    t[2] = ticks();
    let (mut c, _) = step.finish();
    t[3] = ticks();
    c.impulses(|i, w| {
        if let (Some(a), Some(b)) = (warm.get_mut(i), w.first()) {
            *a = *b;
        }
    });
    t[4] = ticks();
}

impl Job for Pile {
    fn run<S: Number>(&self) -> Exit {
        start();
        let r = |a, b| S::from_ratio(a, b).ok().unwrap();
        board::println!(
            "body {} motion {} manifold {} point {} warm {}",
            size_of::<Body<S>>(),
            size_of::<Motion<S>>(),
            size_of::<ManifoldConstraint<S>>(),
            size_of::<PointConstraint<S>>(),
            size_of::<WarmStart<S>>()
        );
        for n in [1usize, 4, 8] {
            let mut bodies = [Body::<S>::immovable(); 9];
            let mass = Solid::sphere(r(1, 2)).ok().unwrap().with_mass(r(1, 1)).ok().unwrap();
            for i in 0..8 {
                bodies[i + 1] = Body::dynamic(mass);
                bodies[i + 1].position.y = r(1 + 2 * i as i32, 2);
            }
            let mut motions = [Motion::<S>::NEW; 9];
            let mut manifolds = [ManifoldConstraint::<S>::NEW; 8];
            let mut points = [PointConstraint::<S>::NEW; 8];
            let mut warm = [WarmStart::<S>::NONE; 8];
            let settings = Settings::new(Vec3::new(r(0, 1), r(-981, 100), r(0, 1)), [1, 60], 4).ok().unwrap();
            let material = Material::new(r(0, 1), r(1, 2)).ok().unwrap();
            let mut t = [0u32; 6];
            for _ in 0..20 {
                step(
                    &mut bodies,
                    n,
                    Buffers { motions: &mut motions, manifolds: &mut manifolds, points: &mut points },
                    &settings,
                    &material,
                    &mut warm,
                    r(1, 2),
                    &mut t,
                );
            }
            let d = |a: usize, b: usize| t[a].wrapping_sub(t[b]) & 0xffffff;
            board::println!(
                "{} n {n}: total {} begin {} collide {} add {} finish {} keep {} top {:?}",
                S::NAME,
                d(0, 4),
                d(0, 1),
                d(1, 5),
                d(5, 2),
                d(2, 3),
                d(3, 4),
                bodies[n].position.y
            );
        }
        Exit::Success
    }
}
