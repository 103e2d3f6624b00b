//! Every status is reached, and what is refused is left as it was.
#![cfg(all(feature = "f32", feature = "fixed"))]
#![allow(non_camel_case_types)]

use carom_c::abi::*;
use carom_c::carom_status::*;
use carom_c::*;
use core::ffi::CStr;
use core::ptr::{null, null_mut};
use fixed::types::I16F16;

const ONE: i32 = 1 << 16;
const UNIT: i32 = 1 << 30;
const ZERO: carom_q16_vec3 = carom_q16_vec3 { x: 0, y: 0, z: 0 };

fn settings() -> carom_q16_settings {
    carom_q16_settings {
        gravity: carom_q16_vec3 { z: -10 * ONE, ..ZERO },
        push_out_speed: 0,
        seconds_numerator: 1,
        seconds_denominator: 60,
        sub_steps: 4,
    }
}

fn ball() -> carom_q16_shape {
    carom_q16_shape { kind: carom_shape_kind::CAROM_SPHERE as u32, radius: ONE, ..Default::default() }
}

fn body() -> carom_q16_body {
    let mut body = core::mem::MaybeUninit::uninit();
    // SAFETY: pointers to objects of their types, here and in all tests but where a pointer is meant to be wrong.
    unsafe {
        assert_eq!(carom_q16_body_dynamic(&ball(), ONE, body.as_mut_ptr()), CAROM_OK);
        body.assume_init()
    }
}

fn contact() -> carom_q16_contact {
    let normal = carom_q16_unit_vec3 { x: UNIT, y: 0, z: 0 };
    carom_q16_contact { normal, r_a: carom_q16_vec3 { x: ONE, ..ZERO }, r_b: carom_q16_vec3 { x: -ONE, ..ZERO } }
}

const MATERIAL: carom_q16_material = carom_q16_material { restitution: ONE / 2, friction: ONE / 2, law: 0 };

/// All of the body, what is behind the public fields too.
fn seen(body: &carom_q16_body) -> carom::Body<I16F16> {
    // SAFETY: the same layout, which the library asserts.
    unsafe { *core::ptr::from_ref(body).cast() }
}

/// A world in memory of its own.
struct Room {
    world: *mut carom_q16_world,
    _memory: Vec<u64>,
}

impl Room {
    fn new() -> Self {
        let mut memory = vec![0u64; CAROM_Q16_WORLD_4X12_SIZE / 8];
        let mut world = null_mut();
        let size = memory.len() * 8;
        unsafe {
            assert_eq!(carom_q16_world_4x12_init(memory.as_mut_ptr().cast(), size, &settings(), &mut world), CAROM_OK);
        }
        Self { world, _memory: memory }
    }

    fn insert(&self) -> (carom_status, carom_body_handle) {
        self.insert_at(0)
    }

    fn insert_at(&self, x: i32) -> (carom_status, carom_body_handle) {
        let mut handle = carom_body_handle::default();
        let mut body = body();
        body.position.x = x;
        let status = unsafe { carom_q16_world_insert(self.world, &body, &ball(), &MATERIAL, &mut handle) };
        (status, handle)
    }
}

#[test]
fn texts() {
    let mut texts = std::collections::BTreeSet::new();
    for (number, &status) in carom_status::ALL.iter().enumerate() {
        assert_eq!(status as usize, number, "the numbers have no gaps");
        let text = unsafe { CStr::from_ptr(carom_status_text(status as u32)) }.to_str().unwrap();
        assert!(texts.insert(text.to_owned()), "{text} is said twice");
    }
    for other in [carom_status::ALL.len() as u32, u32::MAX] {
        assert_eq!(unsafe { CStr::from_ptr(carom_status_text(other)) }, c"not a carom_status");
    }
}

#[test]
fn pointers() {
    let (mut a, mut b) = (body(), body());
    a.linear_velocity.x = ONE;
    let before = seen(&a);
    let resolve = |a: *mut carom_q16_body, b, contact: *const carom_q16_contact, impact| unsafe {
        carom_q16_resolve_collision_with_friction(a, b, contact, &MATERIAL, impact)
    };
    let good = contact();
    assert_eq!(resolve(null_mut(), &mut b, &good, null_mut()), CAROM_NULL);
    assert_eq!(resolve(&mut a, null_mut(), &good, null_mut()), CAROM_NULL);
    assert_eq!(resolve(&mut a, &mut b, null(), null_mut()), CAROM_NULL);
    let same: *mut _ = &mut a;
    assert_eq!(resolve(same, same, &good, null_mut()), CAROM_OVERLAP);
    // A body that begins in the middle of another one.
    let mut two = [a, a];
    let first = two.as_mut_ptr();
    let second = unsafe { first.byte_add(size_of::<carom_q16_body>() - 4) };
    assert_eq!(resolve(first, second, &good, null_mut()), CAROM_OVERLAP);
    assert_eq!(resolve(second, first, &good, null_mut()), CAROM_OVERLAP);
    // The result in the body.
    assert_eq!(resolve(first, &mut b, &good, first.cast()), CAROM_OVERLAP);
    assert_eq!(two.each_ref().map(seen), [before, before]);
    let odd = unsafe { (&raw mut two).byte_add(1) };
    assert_eq!(resolve(odd.cast(), &mut b, &good, null_mut()), CAROM_MISALIGNED);
    let mut words = [0u64; 64];
    assert_eq!(resolve(&mut a, &mut b, &good, words.as_mut_ptr().wrapping_byte_add(2).cast()), CAROM_MISALIGNED);
    assert_eq!(seen(&a), before);
    assert_eq!(resolve(&mut a, &mut b, &good, null_mut()), CAROM_OK);
    assert_ne!(seen(&a), before);
}

#[test]
fn numbers() {
    let mut number = 7;
    unsafe {
        assert_eq!(carom_q16_ratio(1, 0, &mut number), CAROM_RANGE);
        assert_eq!(carom_q16_ratio(40_000, 1, &mut number), CAROM_RANGE);
        assert_eq!(carom_q20_ratio(-3_000, 1, &mut number), CAROM_RANGE);
        assert_eq!(number, 7);
        assert_eq!(carom_q16_ratio(3, 2, &mut number), CAROM_OK);
        assert_eq!(number, 3 * ONE / 2);
        assert_eq!(carom_q16_ratio(3, 2, null_mut()), CAROM_NULL);

        let mut direction = carom_q16_unit_vec3::default();
        assert_eq!(carom_q16_direction(&ZERO, &mut direction), CAROM_ZERO_LENGTH);
        let nan = carom_f32_vec3 { x: f32::NAN, y: 0.0, z: 1.0 };
        let mut float_direction = carom_f32_unit_vec3::default();
        assert_eq!(carom_f32_direction(&nan, &mut float_direction), CAROM_NOT_FINITE);

        let mut zero = carom_q16_quat::default();
        assert_eq!(carom_q16_quat_normalize(&mut zero), CAROM_ZERO_LENGTH);
        let mut one = body();
        let twice = carom_q16_quat { w: UNIT / 2, ..Default::default() };
        assert_eq!(carom_q16_body_set_orientation(&mut one, &twice), CAROM_NOT_UNIT);
        assert_eq!(seen(&one), seen(&body()));
        let bent = carom_q16_contact { normal: carom_q16_unit_vec3 { x: UNIT / 2, y: 0, z: 0 }, ..contact() };
        assert_eq!(carom_q16_resolve_collision(&mut one, &mut body(), &bent, 0, null_mut()), CAROM_NOT_UNIT);
        assert_eq!(
            carom_q16_resolve_collision(&mut one, &mut body(), &contact(), 2 * ONE, null_mut()),
            CAROM_RESTITUTION
        );
        assert_eq!(carom_q16_resolve_collision(&mut one, &mut body(), &contact(), -1, null_mut()), CAROM_RESTITUTION);
        let far = carom_q16_vec3 { x: 20_000 * ONE, ..ZERO };
        let mut saturated = 7;
        assert_eq!(carom_q16_body_apply_impulse(&mut one, &far, null(), &mut saturated), CAROM_OK);
        assert_eq!(saturated, 0);
        assert_eq!(carom_q16_body_apply_impulse(&mut one, &far, null(), &mut saturated), CAROM_OK);
        assert_eq!((saturated, one.linear_velocity.x), (1, i32::MAX));
    }
}

#[test]
fn bodies() {
    let mut made = core::mem::MaybeUninit::<carom_q16_body>::uninit();
    let made = made.as_mut_ptr();
    let dynamic = |shape: carom_q16_shape, mass| unsafe { carom_q16_body_dynamic(&shape, mass, made) };
    assert_eq!(dynamic(ball(), 0), CAROM_MASS);
    assert_eq!(dynamic(carom_q16_shape { radius: 0, ..ball() }, ONE), CAROM_DIMENSION);
    assert_eq!(dynamic(carom_q16_shape { kind: 2, ..ball() }, ONE), CAROM_DIMENSION);
    assert_eq!(dynamic(carom_q16_shape { kind: 3, ..ball() }, ONE), CAROM_DIMENSION);
    assert_eq!(dynamic(carom_q16_shape { kind: 0, ..ball() }, ONE), CAROM_SHAPE);
    assert_eq!(dynamic(carom_q16_shape { kind: 99, ..ball() }, ONE), CAROM_SHAPE);
    let half_space = carom_q16_shape { kind: 4, normal: contact().normal, ..ball() };
    assert_eq!(dynamic(half_space, ONE), CAROM_SHAPE);
    let inertia = |six: [i32; 6]| unsafe { carom_q16_body_with_inertia(ONE, six.as_ptr(), made) };
    assert_eq!(inertia([ONE, 0, 0, ONE, 0, 3 * ONE]), CAROM_INERTIA);
    assert_eq!(inertia([ONE, 0, 0, -ONE, 0, ONE]), CAROM_INERTIA);
    assert_eq!(inertia([ONE, 0, 0, ONE, 0, ONE]), CAROM_OK);

    // What C zeroed is no body.
    let mut zeros: carom_q16_body = unsafe { core::mem::zeroed() };
    assert_eq!(
        unsafe { carom_q16_resolve_collision(&mut zeros, &mut body(), &contact(), 0, null_mut()) },
        CAROM_NOT_A_BODY
    );
    let mut quat = carom_q16_quat::default();
    assert_eq!(unsafe { carom_q16_body_orientation(&zeros, &mut quat) }, CAROM_NOT_A_BODY);

    let floats = carom_f32_shape { kind: 1, radius: f32::NAN, ..Default::default() };
    let mut float_body = core::mem::MaybeUninit::uninit();
    assert_eq!(unsafe { carom_f32_body_dynamic(&floats, 1.0, float_body.as_mut_ptr()) }, CAROM_DIMENSION);
    let floats = carom_f32_shape { radius: 1.0, ..floats };
    assert_eq!(unsafe { carom_f32_body_dynamic(&floats, f32::INFINITY, float_body.as_mut_ptr()) }, CAROM_MASS);
    let mut other = core::mem::MaybeUninit::uninit();
    unsafe {
        assert_eq!(carom_f32_body_dynamic(&floats, 1.0, float_body.as_mut_ptr()), CAROM_OK);
        assert_eq!(carom_f32_body_dynamic(&floats, 1.0, other.as_mut_ptr()), CAROM_OK);
        let (float_body, other) = (float_body.as_mut_ptr(), other.as_mut_ptr());
        (*float_body).linear_velocity.y = f32::NAN;
        let contact = carom_f32_contact {
            normal: carom_f32_unit_vec3 { x: 1.0, y: 0.0, z: 0.0 },
            r_a: carom_f32_vec3 { x: 1.0, y: 0.0, z: 0.0 },
            r_b: carom_f32_vec3 { x: -1.0, y: 0.0, z: 0.0 },
        };
        let resolve = move |contact| carom_f32_resolve_collision(float_body, other, contact, 0.5, null_mut());
        assert_eq!(resolve(&contact), CAROM_NOT_FINITE);
        (*float_body).linear_velocity.y = 0.0;
        let endless = carom_f32_vec3 { x: f32::INFINITY, y: 0.0, z: 0.0 };
        assert_eq!(resolve(&carom_f32_contact { r_b: endless, ..contact }), CAROM_NOT_FINITE);
    }
}

#[test]
fn materials() {
    let resolve = |material: carom_q16_material| unsafe {
        carom_q16_resolve_collision_with_friction(&mut body(), &mut body(), &contact(), &material, null_mut())
    };
    assert_eq!(resolve(carom_q16_material { restitution: ONE + 1, ..MATERIAL }), CAROM_RESTITUTION);
    assert_eq!(resolve(carom_q16_material { friction: -1, ..MATERIAL }), CAROM_FRICTION);
    assert_eq!(resolve(carom_q16_material { law: 2, ..MATERIAL }), CAROM_LAW);
}

#[test]
fn memory() {
    let mut memory = vec![0u64; CAROM_Q16_WORLD_4X12_SIZE / 8 + 1];
    let start: *mut core::ffi::c_void = memory.as_mut_ptr().cast();
    let mut world = null_mut();
    let mut init =
        |memory, size, settings: *const _| unsafe { carom_q16_world_4x12_init(memory, size, settings, &mut world) };
    let size = CAROM_Q16_WORLD_4X12_SIZE;
    assert_eq!(init(null_mut(), size, &settings()), CAROM_NULL);
    assert_eq!(init(start, size, null()), CAROM_NULL);
    assert_eq!(init(start.wrapping_byte_add(4), size, &settings()), CAROM_MISALIGNED);
    assert_eq!(init(start, size - 1, &settings()), CAROM_TOO_SMALL);
    assert_eq!(init(start, size, &carom_q16_settings { sub_steps: 0, ..settings() }), CAROM_STEP_TIME);
    assert_eq!(init(start, size, &carom_q16_settings { sub_steps: 256, ..settings() }), CAROM_STEP_TIME);
    assert_eq!(init(start, size, &carom_q16_settings { seconds_denominator: 0, ..settings() }), CAROM_STEP_TIME);
    assert_eq!(init(start, size, &carom_q16_settings { seconds_numerator: 120, ..settings() }), CAROM_STEP_TIME);
    assert_eq!(init(start, size, &carom_q16_settings { push_out_speed: -1, ..settings() }), CAROM_RANGE);
    assert!(memory.iter().all(|&word| word == 0), "what was refused was not touched");
    assert!(world.is_null());

    // Memory that was never made a world; a null world; a world of another number type; one between words.
    let mut hash = 0;
    let start: *mut carom_q16_world = memory.as_mut_ptr().cast();
    assert_eq!(unsafe { carom_q16_world_hash(start, &mut hash) }, CAROM_NOT_A_WORLD);
    assert_eq!(unsafe { carom_q16_world_hash(null_mut(), &mut hash) }, CAROM_NULL);
    let room = Room::new();
    assert_eq!(unsafe { carom_q20_world_hash(room.world.cast(), &mut hash) }, CAROM_NOT_A_WORLD);
    assert_eq!(unsafe { carom_q16_world_hash(room.world.wrapping_byte_add(4), &mut hash) }, CAROM_MISALIGNED);
    assert_eq!(unsafe { carom_q16_world_hash(room.world, null_mut()) }, CAROM_NULL);
}

#[test]
fn handles() {
    let room = Room::new();
    let handles: Vec<_> = (0..4).map(|_| room.insert()).collect();
    assert!(handles.iter().all(|(status, _)| *status == CAROM_OK));
    assert_eq!(room.insert().0, CAROM_FULL);
    let (world, (_, handle)) = (room.world, handles[1]);
    let nobody = carom_body_handle::default();
    let mut made = body();
    unsafe {
        assert_eq!(carom_q16_world_remove(world, handle, &mut made), CAROM_OK);
        for gone in [handle, nobody] {
            assert_eq!(carom_q16_world_remove(world, gone, null_mut()), CAROM_STALE_HANDLE);
            assert_eq!(carom_q16_world_get_body(world, gone, &mut made), CAROM_STALE_HANDLE);
            assert_eq!(carom_q16_world_set_body(world, gone, &made), CAROM_STALE_HANDLE);
            assert_eq!(carom_q16_world_set_shape(world, gone, &ball()), CAROM_STALE_HANDLE);
            assert_eq!(carom_q16_world_set_material(world, gone, &MATERIAL), CAROM_STALE_HANDLE);
            assert_eq!(carom_q16_world_set_sensor(world, gone, true), CAROM_STALE_HANDLE);
            assert_eq!(carom_q16_world_set_filter(world, gone, 1, 1), CAROM_STALE_HANDLE);
            assert_eq!(carom_q16_world_is_asleep(world, gone, &mut false), CAROM_STALE_HANDLE);
        }
        let (status, again) = room.insert();
        assert_eq!(status, CAROM_OK);
        assert_ne!(again, handle, "the place is the same, the body is not");
        assert_eq!(carom_q16_world_clear(world), CAROM_OK);
        assert_eq!(carom_q16_world_get_body(world, again, &mut made), CAROM_STALE_HANDLE);

        let ray = carom_q16_ray { origin: ZERO, direction: contact().normal, length: -1 };
        let mut hit = carom_q16_ray_hit::default();
        assert_eq!(carom_q16_world_cast_ray(world, &ray, 1, &mut hit), CAROM_RANGE);
        let mut count = 0;
        assert_eq!(carom_q16_world_contacts(world, null_mut(), 1, &mut count), CAROM_NULL);
        assert_eq!(carom_q16_world_contacts(world, null_mut(), 0, null_mut()), CAROM_NULL);
        assert_eq!(carom_q16_world_contacts(world, null_mut(), 0, &mut count), CAROM_OK);
    }
}

/// Balls in each other: two pairs that push, and room for one. What does not fit is counted and not written.
#[test]
fn lists() {
    let room = Room::new();
    (0..3).for_each(|n| assert_eq!(room.insert_at(n * ONE / 2).0, CAROM_OK));
    let mut touching = [core::mem::MaybeUninit::<[u32; 6]>::new([7; 6]); 3];
    let mut count = 0;
    unsafe {
        assert_eq!(carom_q16_world_step(room.world, null_mut()), CAROM_OK);
        assert_eq!(carom_q16_world_contacts(room.world, touching.as_mut_ptr().cast(), 1, &mut count), CAROM_OK);
        assert_eq!(count, 2);
        assert_ne!(touching[0].assume_init(), [7; 6]);
        assert_eq!(touching[1].assume_init(), [7; 6]);
    }
}
