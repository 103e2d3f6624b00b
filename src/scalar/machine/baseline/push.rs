//! What an impulse adds to a velocity.

use core::arch::naked_asm;
use core::mem::offset_of;
use core::ptr::{from_mut, from_ref};

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::LeEqU32;

use crate::math::Vec3;
use crate::scalar::lever32::Lever32;
use crate::scalar::machine::words::add_far;
use crate::scalar::scaled32::Scaled32;

/// A component of x, at `$at` from r0, and d k / 2^(32 + down) in r2; to `$far` where they leave the range.
///
/// With d = 2^16 d1 + d0, d0 of either sign, the middle products fit a word together: |d| < 2^30.5 and |k| < 2^30, or |d| <= 2^30
/// and |k| < 2^31.
macro_rules! added {
    ($at:literal, $far:literal) => {
        concat!(
            "ldr r6, [r1, #",
            $at,
            "]\n sxth r7, r6\n subs r6, r6, r7\n asrs r6, r6, #16\n",
            "mov r2, r7\n muls r2, r4, r2\n asrs r2, r2, #16\n muls r7, r5, r7\n adds r7, r7, r2\n",
            "mov r2, r6\n muls r2, r4, r2\n adds r7, r7, r2\n muls r6, r5, r6\n asrs r7, r7, #16\n adds r6, r6, r7\n",
            // The last bit that leaves by a shift is the carry, and the half that rounds.
            "asrs r6, r3\n ldr r2, [r0, #",
            $at,
            "]\n adcs r2, r6\n bvs ",
            $far,
            "\n",
        )
    };
}

/// `add_scaled` for x at r0, d at r1, k in r2 and down in r3; to `$far`, with all but k as they were, where it has nothing added.
macro_rules! add_scaled {
    ($far:literal) => {
        concat!(
            "cmp r3, #1\n blt ",
            $far,
            "\n cmp r3, #31\n ble 1f\n movs r3, #31\n 1:\n uxth r4, r2\n asrs r5, r2, #16\n",
            added!(0, $far),
            "mov r12, r2\n",
            added!(4, $far),
            "mov lr, r2\n",
            added!(8, $far),
            "str r2, [r0, #8]\n mov r2, r12\n mov r3, lr\n stm r0!, {{r2, r3}}\n",
        )
    };
}

/// `add_scaled` for vectors of three words.
#[unsafe(naked)]
pub(in crate::scalar::machine) unsafe extern "C" fn add_scaled_words(
    x: *mut i32,
    d: *const i32,
    k: i32,
    down: i32,
) -> bool {
    naked_asm!(
        "push {{r2-r7, lr}}",
        add_scaled!("2f"),
        "movs r0, #0",
        "pop {{r2-r7, pc}}",
        "2:",
        "ldr r2, [sp]",
        "ldr r3, [sp, #4]",
        "sub sp, #4",
        "bl {far}",
        "add sp, #4",
        "pop {{r2-r7, pc}}",
        far = sym add_far,
    )
}

/// What of a push turns, as arguments of `add_scaled`.
macro_rules! turn {
    () => {
        concat!(
            "ldr r2, [sp, #44]\n ldr r1, [sp, #12]\n ldr r3, [r1, #{turn_exponent}]\n adds r1, #{turn}\n",
            // -(turn_exponent + exponent of j) - 3
            "ldr r5, [sp, #48]\n adds r3, r3, r5\n mvns r3, r3\n subs r3, #2\n ldr r0, [sp, #4]\n",
        )
    };
}

/// The push of an impulse j; `places` is 29 less the fraction bits.
#[unsafe(naked)]
unsafe extern "C" fn push_words(
    v: *mut i32,
    w: *mut i32,
    d: *const i32,
    lever: *const Lever32,
    inv_mass: Scaled32,
    j: Scaled32,
    places: i32,
) -> bool {
    naked_asm!(
        // On the stack from here on: v, w, d, the lever, at 36 the inverse mass, at 44 j, at 52 the places.
        "push {{r0-r7, lr}}",
        // r2: the product of the mantissas without its last 29 places; the middle products are below 2^30.
        "ldr r6, [sp, #36]",
        "ldr r4, [sp, #44]",
        "uxth r0, r6",
        "asrs r6, r6, #16",
        "uxth r1, r4",
        "asrs r4, r4, #16",
        "mov r2, r0",
        "muls r2, r1, r2",
        "muls r1, r6, r1",
        "muls r0, r4, r0",
        "muls r6, r4, r6",
        "adds r1, r1, r0",
        "lsls r0, r1, #16",
        "asrs r1, r1, #16",
        "adds r2, r2, r0",
        "adcs r6, r1",
        "lsrs r2, r2, #29",
        "lsls r6, r6, #3",
        "orrs r2, r6",
        "str r2, [sp, #36]",
        "ldr r3, [sp, #52]",
        "ldr r0, [sp, #40]",
        "subs r3, r3, r0",
        "ldr r0, [sp, #48]",
        "subs r3, r3, r0",
        "ldr r0, [sp]",
        "ldr r1, [sp, #8]",
        add_scaled!("3f"),
        turn!(),
        "b 2f",
        "3:",
        "ldr r2, [sp, #36]",
        "sub sp, #4",
        "bl {far}",
        "add sp, #4",
        "str r0, [sp]",
        turn!(),
        "sub sp, #4",
        "bl {add_scaled}",
        "add sp, #4",
        "ldr r1, [sp]",
        "orrs r0, r1",
        "add sp, #16",
        "pop {{r4-r7, pc}}",
        "2:",
        add_scaled!("4f"),
        "movs r0, #0",
        "add sp, #16",
        "pop {{r4-r7, pc}}",
        "4:",
        "ldr r2, [sp, #44]",
        "sub sp, #4",
        "bl {far}",
        "add sp, #4",
        "add sp, #16",
        "pop {{r4-r7, pc}}",
        far = sym add_far,
        add_scaled = sym add_scaled_words,
        turn = const offset_of!(Lever32, turn),
        turn_exponent = const offset_of!(Lever32, turn_exponent),
    )
}

/// A push, as that of `machine/impulses.rs`.
#[inline(always)]
pub fn push<F: LeEqU32>(
    v: &mut Vec3<FixedI32<F>>,
    w: &mut Vec3<FixedI32<F>>,
    (d, inv_mass): (&Vec3<I2F30>, Scaled32),
    lever: &Lever32,
    j: Scaled32,
) -> bool {
    let places = 29i32.wrapping_sub(F::I32);
    // SAFETY: the references are to three words each, and to a lever, which is `repr(C)`; the function reads them, writes the
    // first two, and keeps to the calling convention.
    unsafe { push_words(from_mut(v).cast(), from_mut(w).cast(), from_ref(d).cast(), lever, inv_mass, j, places) }
}

/// A component of `v`, at `$at` from r0, and `d k / 2^K`, of which 32 - K is `$up` and K - 16 is `$down`: r3 and r4 are k in halves.
///
/// |d k| < 2^56 and |k| <= 2^26, so that the middle products fit a word together.
macro_rules! along {
    ($at:literal, $up:literal, $down:literal) => {
        concat!(
            "ldr r5, [r1, #",
            $at,
            "]\n uxth r6, r5\n asrs r5, r5, #16\n",
            "mov r7, r6\n muls r7, r3, r7\n lsrs r7, r7, #16\n muls r6, r4, r6\n adds r7, r7, r6\n",
            "mov r6, r5\n muls r6, r3, r6\n adds r7, r7, r6\n muls r5, r4, r5\n",
            // The last bit that leaves by a shift is the carry, and the half that rounds.
            "lsls r5, r5, #",
            $up,
            "\n asrs r7, r7, #",
            $down,
            "\n adcs r5, r7\n",
            "ldr r2, [r0, #",
            $at,
            "]\n adds r2, r2, r5\n bvc 2f\n",
            "asrs r2, r2, #31\n movs r5, #1\n lsls r5, r5, #31\n eors r2, r5\n",
            "2:\n str r2, [r0, #",
            $at,
            "]\n",
        )
    };
}

/// A function that adds `d k / 2^K` to `v`.
macro_rules! add_along {
    ($name:ident, $up:literal, $down:literal) => {
        #[unsafe(naked)]
        unsafe extern "C" fn $name(v: *mut i32, d: *const i32, k: i32) {
            naked_asm!(
                "push {{r4-r7, lr}}",
                "uxth r3, r2",
                "asrs r4, r2, #16",
                along!(0, $up, $down),
                along!(4, $up, $down),
                along!(8, $up, $down),
                "pop {{r4-r7, pc}}",
            )
        }
    };
}

add_along!(along_words, 4, 12);
add_along!(turn_along_words, 6, 10);

/// Adds `k` times a direction to `v`, for |k| <= 2^26, as that of `machine/rows.rs`.
#[inline(always)]
pub fn add_along<F>(v: &mut Vec3<FixedI32<F>>, d: &Vec3<I2F30>, k: i32) {
    // SAFETY: the references are to three words each; the function reads them, writes those of `v`, and keeps to the calling
    // convention.
    unsafe { along_words(from_mut(v).cast(), from_ref(d).cast(), k) }
}

/// Adds `k` times a turn to `w`, for |k| <= 2^26, as that of `machine/rows.rs`.
#[inline(always)]
pub fn add_turn<F>(w: &mut Vec3<FixedI32<F>>, turn: &Vec3<I2F30>, k: i32) {
    // SAFETY: as above.
    unsafe { turn_along_words(from_mut(w).cast(), from_ref(turn).cast(), k) }
}
