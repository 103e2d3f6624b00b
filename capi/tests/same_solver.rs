//! The solver through C's door as through Rust's: piles on the caller's own arrays, step by step the same bits.
#![cfg(all(feature = "f32", feature = "fixed"))]
#![allow(non_camel_case_types)]

use carom::solver::{Buffers, ManifoldConstraint, Motion, PointConstraint, Settings, Step, WarmStart};
use carom::{Body, Collide, Cuboid, HalfSpace, Manifold, Material, Pose, Scalar, Solid, UnitVec3, Vec3};
use carom_c::abi::*;
use carom_c::carom_status::*;
use carom_c::*;
use core::ptr::null_mut;
use fixed::types::{I12F20, I16F16};

/// Boxes on the ground and on each other.
const BOXES: usize = 4;

macro_rules! number {
    ($module:ident, $p:ident, $number:ty) => { pastey::paste! { mod $module {
        use super::*;
        type N = $number;

        fn ratio(n: i32, d: i32) -> N {
            N::from_ratio(n, d).unwrap()
        }

        fn vec3(v: Vec3<N>) -> [<$p _vec3>] {
            let [x, y, z] = v.to_array().map(Number::raw);
            [<$p _vec3>] { x, y, z }
        }

        fn settings() -> (Settings<N>, [<$p _settings>]) {
            let gravity = Vec3::new(ratio(0, 1), ratio(0, 1), ratio(-98, 10));
            let c = [<$p _settings>] {
                gravity: vec3(gravity),
                push_out_speed: ratio(0, 1).raw(),
                seconds_numerator: 1,
                seconds_denominator: 60,
                sub_steps: 4,
            };
            (Settings::new(gravity, [1, 60], 4).unwrap(), c)
        }

        /// The ground, and boxes that fall on each other from 5 cm, each turned a little further.
        fn bodies() -> Vec<Body<N>> {
            let half = Vec3::new(ratio(1, 2), ratio(1, 2), ratio(1, 2));
            let solid = Solid::cuboid(half).unwrap().with_mass(ratio(2, 1)).unwrap();
            let mut bodies = vec![Body::immovable()];
            for n in 0..BOXES as i32 {
                let mut body = Body::dynamic(solid);
                body.position = Vec3::new(ratio(n, 20), ratio(0, 1), ratio(11 + 21 * n, 20));
                body.angular_velocity.z = ratio(n, 4);
                bodies.push(body);
            }
            bodies
        }

        /// Where neighbours touch, as the kernel's own geometry sees it.
        fn touching(bodies: &[Body<N>], upper: usize) -> Manifold<N> {
            let cuboid = Cuboid::new(Vec3::new(ratio(1, 2), ratio(1, 2), ratio(1, 2))).unwrap();
            let pose = |n: usize| Pose::new(bodies[n].position, bodies[n].orientation());
            let mut manifold = Manifold::empty(UnitVec3::Z);
            let margin = ratio(1, 50);
            if upper == 1 {
                HalfSpace::new(UnitVec3::Z).collide(&pose(0), &cuboid, &pose(1), margin, &mut manifold);
            } else {
                cuboid.collide(&pose(upper - 1), &cuboid, &pose(upper), margin, &mut manifold);
            }
            manifold
        }

        /// A manifold that C made of zeros.
        fn zeros() -> [<$p _manifold>] {
            // SAFETY: integers and floats.
            unsafe { core::mem::zeroed() }
        }

        fn describe(c: &mut [<$p _manifold>], manifold: &Manifold<N>) {
            let [x, y, z] = manifold.normal.get().to_array().map(<N as Number>::unit_raw);
            c.normal = [<$p _unit_vec3>] { x, y, z };
            c.point_count = manifold.points().len() as u32;
            for (c, point) in c.points.iter_mut().zip(manifold.points()) {
                c.r_a = vec3(point.r_a);
                c.r_b = vec3(point.r_b);
                c.separation = point.separation.raw();
                c.feature = point.feature.0;
            }
        }

        #[test]
        fn pile() {
            let (settings, c_settings) = settings();
            let mut bodies = bodies();
            // SAFETY: the same layout, which the library asserts.
            let mut c_bodies: Vec<[<$p _body>]> = bodies.iter().map(|body| unsafe { core::mem::transmute_copy(body) }).collect();
            let material = Material::new(ratio(1, 5), ratio(1, 2)).unwrap();
            let mut c_manifolds = vec![zeros(); BOXES];
            for (n, manifold) in c_manifolds.iter_mut().enumerate() {
                (manifold.a, manifold.b) = (n as u16, n as u16 + 1);
                manifold.material = [<$p _material>] { restitution: ratio(1, 5).raw(), friction: ratio(1, 2).raw(), law: 0 };
            }
            let mut warm = [[WarmStart::NONE; 4]; BOXES];
            let mut warm_count = [0; BOXES];
            let (mut motions, mut pairs) = ([Motion::NEW; BOXES + 1], [ManifoldConstraint::NEW; BOXES]);
            let mut points = [PointConstraint::NEW; 4 * BOXES];
            let mut workspace = [0u64; 600];
            let (mut pushed, mut met) = (0, 0);
            for step in 0..240 {
                let manifolds: Vec<_> = (1..=BOXES).map(|upper| touching(&bodies, upper)).collect();
                c_manifolds.iter_mut().zip(&manifolds).for_each(|(c, manifold)| describe(c, manifold));

                let buffers = Buffers { motions: &mut motions, manifolds: &mut pairs, points: &mut points };
                let mut solver = Step::begin(&mut bodies, buffers, &settings);
                for (n, manifold) in manifolds.iter().enumerate() {
                    let places = [n as u16, n as u16 + 1];
                    assert!(solver.add(places, manifold, &material, &warm[n][..warm_count[n]]));
                }
                let (mut constraints, _) = solver.finish();
                // Manifolds without points were not added.
                let added: Vec<_> = (0..BOXES).filter(|&n| !manifolds[n].is_empty()).collect();
                let mut told = [(ratio(0, 1), ratio(0, 1)); BOXES];
                constraints.touches(|index, touch| {
                    told[added[index]] = (N::from_scaled(touch.impulse).0, touch.approach);
                    pushed += u32::from(touch.pushed);
                    met += u32::from(touch.approach > ratio(0, 1));
                });
                warm_count = [0; BOXES];
                constraints.impulses(|index, impulses| {
                    warm[added[index]][..impulses.len()].copy_from_slice(impulses);
                    warm_count[added[index]] = impulses.len();
                });

                // SAFETY: arrays of so many objects.
                let status = unsafe {
                    [<$p _solver_step>](
                        &c_settings, c_bodies.as_mut_ptr(), c_bodies.len(), c_manifolds.as_mut_ptr(), c_manifolds.len(),
                        workspace.as_mut_ptr().cast(), size_of_val(&workspace), null_mut(),
                    )
                };
                assert_eq!(status, CAROM_OK);
                for (c, body) in c_bodies.iter().zip(&bodies) {
                    // SAFETY: the same layout, which the library asserts.
                    assert_eq!(unsafe { &*core::ptr::from_ref(c).cast::<Body<N>>() }, body, "step {step}");
                }
                for (c, (impulse, approach)) in c_manifolds.iter().zip(told) {
                    assert_eq!((c.normal_impulse, c.approach_speed), (impulse.raw(), approach.raw()));
                }
            }
            assert!(pushed > 600 && met >= 4, "{pushed} manifolds pushed, {met} met");
            let highest = bodies[BOXES].position.z;
            assert!(highest > ratio(33, 10) && highest < ratio(36, 10), "the pile stands: {highest:?}");
        }

        #[test]
        fn refusals() {
            let (_, settings) = settings();
            // SAFETY: the same layout, which the library asserts.
            let mut bodies: Vec<[<$p _body>]> = bodies().iter().map(|body| unsafe { core::mem::transmute_copy(body) }).collect();
            let mut good = zeros();
            (good.a, good.b, good.point_count) = (0, 1, 1);
            good.normal.z = <N as Number>::unit_raw(<N as Scalar>::Unit::from_ratio(1, 1).unwrap());
            let mut workspace = [0u64; 128];
            let start: *mut u64 = workspace.as_mut_ptr();
            let first: *mut [<$p _body>] = bodies.as_mut_ptr();
            let count = bodies.len();
            let size = size_of_val(&workspace);
            let step = |bodies, count, manifold: *mut [<$p _manifold>], memory: *mut u64, size| {
                // SAFETY: what is wrong is meant to be refused.
                unsafe { [<$p _solver_step>](&settings, bodies, count, manifold, 1, memory.cast(), size, null_mut()) }
            };
            let with = |change: &dyn Fn(&mut [<$p _manifold>])| {
                let mut manifold = good;
                change(&mut manifold);
                step(first, count, &mut manifold, start, size)
            };
            assert_eq!(with(&|_| ()), CAROM_OK);
            assert_eq!(with(&|manifold| manifold.b = 5), CAROM_INDEX);
            assert_eq!(with(&|manifold| manifold.a = 1), CAROM_INDEX);
            assert_eq!(with(&|manifold| manifold.point_count = 5), CAROM_COUNT);
            assert_eq!(with(&|manifold| manifold.warm_count = 5), CAROM_COUNT);
            assert_eq!(with(&|manifold| manifold.normal = Default::default()), CAROM_ZERO_LENGTH);
            assert_eq!(with(&|manifold| manifold.material.law = 9), CAROM_LAW);
            let mut manifold = good;
            let needed = 5 * [<$p:upper _SOLVER_BODY_SIZE>] + [<$p:upper _SOLVER_MANIFOLD_SIZE>] + [<$p:upper _SOLVER_POINT_SIZE>];
            assert_eq!(step(first, count, &mut manifold, start, needed - 1), CAROM_TOO_SMALL);
            assert_eq!(step(first, count, &mut manifold, start, needed), CAROM_OK);
            assert_eq!(step(first, count, &mut manifold, null_mut(), size), CAROM_NULL);
            assert_eq!(step(first, count, &mut manifold, start.wrapping_byte_add(4), size - 8), CAROM_MISALIGNED);
            assert_eq!(step(null_mut(), count, &mut manifold, start, size), CAROM_NULL);
            assert_eq!(step(first, 1 << 16, &mut manifold, start, size), CAROM_COUNT);
            assert_eq!(step(first, count, &mut manifold, first.cast(), size), CAROM_OVERLAP);
            assert_eq!(step(first, count, first.cast(), start, size), CAROM_OVERLAP);
            // SAFETY: integers and floats.
            bodies[1] = unsafe { core::mem::zeroed() };
            assert_eq!(step(bodies.as_mut_ptr(), count, &mut manifold, start, size), CAROM_NOT_A_BODY);
        }
    } } };
}

number!(q16, carom_q16, I16F16);
number!(q20, carom_q20, I12F20);
number!(f32, carom_f32, f32);
