//! Through C's door as through Rust's: the same bits, from impacts and from worlds.
#![cfg(all(feature = "f32", feature = "fixed"))]
#![allow(non_camel_case_types)]

use carom::impulse;
use carom::solver::Settings;
use carom::world::Filter;
use carom::{
    Body, Capsule, Contact, Cuboid, HalfSpace, Material, Quat, Ray, Scalar, Solid, Sphere, UnitVec3, Vec3, World,
};
use carom_c::Number;
use carom_c::abi::*;
use carom_c::*;
use core::ptr::null_mut;
use fixed::types::{I12F20, I16F16};

carom::shapes! { enum Piece<S> { Sphere, Cuboid, Capsule, HalfSpace } }

/// xorshift32 (Marsaglia, 2003).
struct Random(u32);

impl Random {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// In thousandths.
    fn integer(&mut self, low: i32, high: i32) -> i32 {
        low + (self.next() >> 8) as i32 % (high - low)
    }

    fn milli<S: Scalar>(&mut self, low: i32, high: i32) -> S {
        S::from_ratio(self.integer(low, high), 1000).unwrap()
    }

    fn vector<S: Scalar>(&mut self, low: i32, high: i32) -> Vec3<S> {
        Vec3::new(self.milli(low, high), self.milli(low, high), self.milli(low, high))
    }
}

fn orientation<S: Scalar>(random: &mut Random) -> Quat<S> {
    let mut part = || S::Unit::from_ratio(random.integer(-500, 500), 1024).unwrap();
    Quat::normalize(part(), part(), part(), part()).unwrap()
}

macro_rules! number {
    ($module:ident, $p:ident, $number:ty) => { pastey::paste! { mod $module {
        use super::*;
        type N = $number;

        fn vec3(v: Vec3<N>) -> [<$p _vec3>] {
            let [x, y, z] = v.to_array().map(Number::raw);
            [<$p _vec3>] { x, y, z }
        }

        fn unit_vec3(d: UnitVec3<N>) -> [<$p _unit_vec3>] {
            let [x, y, z] = d.get().to_array().map(<N as Number>::unit_raw);
            [<$p _unit_vec3>] { x, y, z }
        }

        fn quat(q: Quat<N>) -> [<$p _quat>] {
            let [w, x, y, z] = q.to_array().map(<N as Number>::unit_raw);
            [<$p _quat>] { w, x, y, z }
        }

        fn ok(status: carom_status) {
            assert_eq!(status, carom_status::CAROM_OK);
        }

        /// Both hold the same bits: what is public, and, through the pointers of C, what is not.
        fn assert_same(c: &[<$p _body>], rust: &Body<N>) {
            let mut copy = *c;
            // SAFETY: a body of the same layout, which the library asserts.
            let seen = unsafe { *core::ptr::from_mut(&mut copy).cast::<Body<N>>() };
            assert_eq!(seen, *rust);
        }

        /// A random box and its description for C.
        fn cuboid(random: &mut Random) -> (Vec3<N>, [<$p _shape>]) {
            let half = random.vector(100, 900);
            let shape = [<$p _shape>] {
                kind: carom_shape_kind::CAROM_CUBOID as u32,
                half_extents: vec3(half),
                ..Default::default()
            };
            (half, shape)
        }

        fn body(random: &mut Random) -> (Body<N>, [<$p _body>]) {
            let (half, shape) = cuboid(random);
            let mass: N = random.milli(200, 9_000);
            let mut rust = Body::dynamic(Solid::cuboid(half).unwrap().with_mass(mass).unwrap());
            let mut c = core::mem::MaybeUninit::uninit();
            // SAFETY: pointers to objects of their types.
            let mut c = unsafe {
                ok([<$p _body_dynamic>](&shape, mass.raw(), c.as_mut_ptr()));
                c.assume_init()
            };
            rust.position = random.vector(-2_000, 2_000);
            rust.linear_velocity = random.vector(-9_000, 9_000);
            rust.angular_velocity = random.vector(-9_000, 9_000);
            c.position = vec3(rust.position);
            c.linear_velocity = vec3(rust.linear_velocity);
            c.angular_velocity = vec3(rust.angular_velocity);
            let turn = orientation(random);
            rust.set_orientation(turn);
            // SAFETY: as above.
            ok(unsafe { [<$p _body_set_orientation>](&mut c, &quat(turn)) });
            assert_same(&c, &rust);
            (rust, c)
        }

        #[test]
        fn impacts() {
            let mut random = Random(0x5eed_0001);
            let mut struck = 0;
            for round in 0..10_000 {
                let ((mut a, mut c_a), (mut b, mut c_b)) = (body(&mut random), body(&mut random));
                if round % 7 == 0 {
                    a = Body::immovable();
                    // SAFETY: pointers to objects of their types, here and below.
                    ok(unsafe { [<$p _body_immovable>](&mut c_a) });
                }
                let Ok(normal) = UnitVec3::normalize(random.vector(-1_000, 1_000)) else { continue };
                let contact = Contact { normal, r_a: random.vector(-900, 900), r_b: random.vector(-900, 900) };
                let c_contact = [<$p _contact>] { normal: unit_vec3(normal), r_a: vec3(contact.r_a), r_b: vec3(contact.r_b) };
                let e: N = random.milli(0, 1_001);
                let mu: N = if round % 3 == 0 { N::from_ratio(0, 1).unwrap() } else { random.milli(0, 1_500) };
                let law = [carom::RestitutionLaw::Newton, carom::RestitutionLaw::EnergySafe][round % 2];
                let material = Material::new(e, mu).unwrap().with_law(law);
                let c_material = [<$p _material>] { restitution: e.raw(), friction: mu.raw(), law: (round % 2) as u32 };

                let mut number = N::from_ratio(0, 1).unwrap().raw();
                let mut vector = [<$p _vec3>]::default();
                let mut impact = core::mem::MaybeUninit::<[<$p _impact>]>::uninit();
                unsafe {
                    ok([<$p _effective_mass>](&c_a, &c_b, &c_contact, &mut number));
                    assert_eq!(number, impulse::effective_mass(&a, &b, &contact, normal).raw());
                    ok([<$p _collision_impulse>](&c_a, &c_b, &c_contact, e.raw(), &mut number));
                    assert_eq!(number, impulse::collision_impulse(&a, &b, &contact, e).raw());
                    ok([<$p _relative_velocity>](&c_a, &c_b, &c_contact, &mut vector));
                    assert_eq!(vector, vec3(impulse::relative_velocity(&a, &b, &contact)));
                    let rust = if round % 5 == 0 {
                        ok([<$p _resolve_collision>](&mut c_a, &mut c_b, &c_contact, e.raw(), impact.as_mut_ptr()));
                        impulse::resolve_collision(&mut a, &mut b, &contact, e)
                    } else {
                        ok([<$p _resolve_collision_with_friction>](
                            &mut c_a, &mut c_b, &c_contact, &c_material, impact.as_mut_ptr(),
                        ));
                        impulse::resolve_collision_with_friction(&mut a, &mut b, &contact, &material)
                    };
                    let told = impact.assume_init();
                    assert_eq!(told, rust.into());
                    struck += u32::from(rust.normal_impulse > N::from_ratio(0, 1).unwrap());
                }
                assert_same(&c_a, &a);
                assert_same(&c_b, &b);
            }
            assert!(struck > 4_000, "only {struck} of the contacts approached");
        }

        /// Balls that fall into a corner: in a world of balls as in one of all shapes, to which boxes alone are another matter.
        #[test]
        fn balls() {
            let zero = N::from_ratio(0, 1).unwrap();
            let settings = [<$p _settings>] {
                gravity: vec3(Vec3::new(N::from_ratio(1, 1).unwrap(), zero, N::from_ratio(-10, 1).unwrap())),
                push_out_speed: zero.raw(),
                seconds_numerator: 1,
                seconds_denominator: 60,
                sub_steps: 4,
            };
            let material = [<$p _material>] {
                restitution: N::from_ratio(1, 2).unwrap().raw(),
                friction: N::from_ratio(1, 2).unwrap().raw(),
                law: 0,
            };
            let mut memories = [vec![0u64; [<$p:upper _BALLS_16X16_SIZE>] / 8], vec![0u64; [<$p:upper _WORLD_16X64_SIZE>] / 8]];
            let inits: [unsafe extern "C" fn(_, _, _, _) -> _; 2] = [[<$p _balls_16x16_init>], [<$p _world_16x64_init>]];
            let ends = [0, 1].map(|which| {
                let (mut world, mut handle, mut hash) = (null_mut(), carom_body_handle::default(), 0);
                let (memory, mut random) = (&mut memories[which], Random(0x5eed_0003));
                let radius = N::from_ratio(1, 2).unwrap();
                let ball = [<$p _shape>] { kind: 1, radius: radius.raw(), ..Default::default() };
                // SAFETY: pointers to objects of their types.
                unsafe {
                    ok(inits[which](memory.as_mut_ptr().cast(), memory.len() * 8, &settings, &mut world));
                    let mut body = core::mem::MaybeUninit::<[<$p _body>]>::uninit();
                    ok([<$p _body_immovable>](body.as_mut_ptr()));
                    for normal in [UnitVec3::<N>::Z, -UnitVec3::<N>::X] {
                        let wall = [<$p _shape>] { kind: 4, normal: unit_vec3(normal), ..Default::default() };
                        ok([<$p _world_insert>](world, body.as_ptr(), &wall, &material, &mut handle));
                    }
                    let (_, cuboid) = cuboid(&mut Random(1));
                    let status = [<$p _world_insert>](world, body.as_ptr(), &cuboid, &material, &mut handle);
                    assert_eq!(status, [carom_status::CAROM_SHAPE, carom_status::CAROM_OK][which]);
                    if which == 0 {
                        assert_eq!([<$p _world_set_shape>](world, handle, &cuboid), carom_status::CAROM_SHAPE);
                    } else {
                        ok([<$p _world_remove>](world, handle, null_mut()));
                    }
                    for n in 0..8 {
                        ok([<$p _body_dynamic>](&ball, N::from_ratio(1, 1).unwrap().raw(), body.as_mut_ptr()));
                        let side = random.milli::<N>(-2_000, -1_000);
                        body.assume_init_mut().position = vec3(Vec3::new(side, zero, N::from_ratio(1 + 2 * n, 1).unwrap()));
                        ok([<$p _world_insert>](world, body.as_ptr(), &ball, &material, &mut handle));
                    }
                    (0..200).for_each(|_| ok([<$p _world_step>](world, null_mut())));
                    ok([<$p _world_hash>](world, &mut hash));
                }
                hash
            });
            assert_eq!(ends[0], ends[1]);
        }

        /// Forty bodies of all shapes fall into a corner; bodies are taken out, put in, pushed and asked for on the way.
        #[test]
        fn world() {
            let mut random = Random(0x5eed_0002);
            let mut rust = Box::new(World::<N, Piece<N>, 64, 128, 256>::new());
            let fall = Vec3::new(N::from_ratio(0, 1).unwrap(), N::from_ratio(1, 2).unwrap(), N::from_ratio(-98, 10).unwrap());
            let steps = Settings::new(fall, [1, 60], 4).unwrap();
            let settings = [<$p _settings>] {
                gravity: vec3(fall),
                push_out_speed: N::from_ratio(0, 1).unwrap().raw(),
                seconds_numerator: 1,
                seconds_denominator: 60,
                sub_steps: 4,
            };
            let mut memory = vec![0u64; carom_c::abi::[<$p:upper _WORLD_64X256_SIZE>] / 8];
            let mut world = null_mut();
            // SAFETY: pointers to objects of their types, here and below.
            let start = memory.as_mut_ptr();
            ok(unsafe { [<$p _world_64x256_init>](start.cast(), memory.len() * 8, &settings, &mut world) });

            let e: N = N::from_ratio(3, 10).unwrap();
            let mu: N = N::from_ratio(1, 2).unwrap();
            let material = Material::new(e, mu).unwrap();
            let c_material = [<$p _material>] { restitution: e.raw(), friction: mu.raw(), law: 0 };
            let mut handles = Vec::new();
            let insert = |rust: &mut World<N, Piece<N>, 64, 128, 256>, body: Body<N>, piece: Piece<N>, shape: [<$p _shape>]| {
                // SAFETY: a body of the same layout, which the library asserts.
                let c: [<$p _body>] = unsafe { core::mem::transmute(body) };
                let mut handle = carom_body_handle::default();
                ok(unsafe { [<$p _world_insert>](world, &c, &shape, &c_material, &mut handle) });
                let ours = rust.insert(body, piece, material).unwrap();
                assert_eq!(handle, ours.into());
                (ours, handle)
            };
            for normal in [UnitVec3::<N>::Z, UnitVec3::X, -UnitVec3::<N>::Y] {
                let shape = [<$p _shape>] { kind: 4, normal: unit_vec3(normal), ..Default::default() };
                insert(&mut rust, Body::immovable(), HalfSpace::new(normal).into(), shape);
            }
            for n in 0..40 {
                let radius: N = random.milli(100, 300);
                let half: N = random.milli(100, 400);
                let (piece, shape): (Piece<N>, _) = match n % 3 {
                    0 => (Sphere::new(radius).unwrap().into(), [<$p _shape>] { kind: 1, radius: radius.raw(), ..Default::default() }),
                    1 => {
                        let (half, shape) = cuboid(&mut random);
                        (Cuboid::new(half).unwrap().into(), shape)
                    }
                    _ => (
                        Capsule::new(radius, half).unwrap().into(),
                        [<$p _shape>] { kind: 3, radius: radius.raw(), half_length: half.raw(), ..Default::default() },
                    ),
                };
                let solid = match piece {
                    Piece::Sphere(sphere) => sphere.solid(),
                    Piece::Cuboid(cuboid) => cuboid.solid(),
                    Piece::Capsule(capsule) => capsule.solid(),
                    Piece::HalfSpace(_) => unreachable!(),
                };
                let mut body = Body::dynamic(solid.unwrap().with_mass(random.milli(500, 3_000)).unwrap());
                let place = |n: i32| N::from_ratio(n, 1).unwrap();
                body.position = Vec3::new(place(1 + n % 3 * 2), place(-1 - n / 3 % 3 * 2), place(1 + n / 9 * 2));
                body.set_orientation(orientation(&mut random));
                handles.push(insert(&mut rust, body, piece, shape));
            }
            let (mut met, mut seen) = (0, 0);
            for step in 0..300 {
                let mut report = carom_world_report::default();
                ok(unsafe { [<$p _world_step>](world, &mut report) });
                assert_eq!(report, rust.step(&steps).into());
                let mut touching = vec![core::mem::MaybeUninit::<[<$p _touching>]>::uninit(); 128];
                let mut count = 0;
                let told = |touching: &[core::mem::MaybeUninit<[<$p _touching>]>], count: usize| {
                    // SAFETY: so many were written.
                    touching[..count].iter().map(|one| unsafe { one.assume_init() }).collect::<Vec<_>>()
                };
                ok(unsafe { [<$p _world_contacts>](world, touching.as_mut_ptr().cast(), 128, &mut count) });
                let ours: Vec<_> = rust.contacts().map(|touching| [<$p _touching>]::from(&touching)).collect();
                assert_eq!(told(&touching, count), ours);
                ok(unsafe { [<$p _world_impacts>](world, touching.as_mut_ptr().cast(), 128, &mut count) });
                let ours: Vec<_> = rust.impacts().map(|touching| [<$p _touching>]::from(&touching)).collect();
                assert_eq!(told(&touching, count), ours);
                met += count;

                let Ok(direction) = UnitVec3::normalize(random.vector(-1_000, 1_000)) else { continue };
                let ray = Ray { origin: random.vector(-1_000, 5_000), direction, length: random.milli(1_000, 9_000) };
                let c_ray = [<$p _ray>] { origin: vec3(ray.origin), direction: unit_vec3(direction), length: ray.length.raw() };
                let mut hit = [<$p _ray_hit>]::default();
                ok(unsafe { [<$p _world_cast_ray>](world, &c_ray, u16::MAX, &mut hit) });
                match rust.cast_ray(&ray, Filter { groups: u16::MAX, meets: u16::MAX }) {
                    None => assert_eq!(hit, [<$p _ray_hit>]::default()),
                    Some(sight) => {
                        seen += 1;
                        assert_eq!(hit.body, sight.body.into());
                        assert_eq!(hit.distance, sight.hit.distance.raw());
                        assert_eq!(hit.normal, unit_vec3(sight.hit.normal));
                    }
                }
                let mut hash = 0;
                ok(unsafe { [<$p _world_hash>](world, &mut hash) });
                assert_eq!(hash, rust.hash(), "after step {step}");
                if step % 20 == 10 {
                    let (ours, handle) = handles[step as usize % handles.len()];
                    let mut c = core::mem::MaybeUninit::<[<$p _body>]>::uninit();
                    ok(unsafe { [<$p _world_get_body>](world, handle, c.as_mut_ptr()) });
                    let mut c = unsafe { c.assume_init() };
                    assert_same(&c, rust.body(ours).unwrap());
                    let (push, arm) = (random.vector::<N>(-5_000, 5_000), random.vector::<N>(-200, 200));
                    ok(unsafe { [<$p _body_apply_impulse>](&mut c, &vec3(push), &vec3(arm), null_mut()) });
                    ok(unsafe { [<$p _world_set_body>](world, handle, &c) });
                    rust.body_mut(ours).unwrap().apply_impulse_at(push, arm);
                }
                if step % 50 == 25 {
                    let (ours, handle) = handles.remove(step as usize % handles.len());
                    ok(unsafe { [<$p _world_remove>](world, handle, null_mut()) });
                    rust.remove(ours).unwrap();
                }
            }
            // A copy of the memory is a state to return to.
            let mut saved = vec![0u64; memory.len()];
            let go_on = || {
                let mut hash = 0;
                (0..30).for_each(|_| ok(unsafe { [<$p _world_step>](world, null_mut()) }));
                ok(unsafe { [<$p _world_hash>](world, &mut hash) });
                hash
            };
            let before = rust.hash();
            unsafe { start.copy_to_nonoverlapping(saved.as_mut_ptr(), saved.len()) };
            let after = go_on();
            assert_ne!(after, before);
            unsafe { start.copy_from_nonoverlapping(saved.as_ptr(), saved.len()) };
            assert_eq!(go_on(), after);
            assert!(met > 40 && seen > 100, "{met} impacts, {seen} rays that met something");
        }
    } } };
}

number!(q16, carom_q16, I16F16);
number!(q20, carom_q20, I12F20);
number!(f32, carom_f32, f32);
