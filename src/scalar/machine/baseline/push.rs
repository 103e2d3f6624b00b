//! What an impulse adds to a velocity.

use core::arch::naked_asm;
use core::mem::offset_of;
use core::ptr::{from_mut, from_ref};

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;
use fixed::types::{I2F30, I32F0};

use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::scalar::lever32::Lever32;
use crate::scalar::machine::words::add_far;
use crate::scalar::scaled32::Scaled32;

/// `add_scaled` for vectors of three words.
#[unsafe(naked)]
unsafe extern "C" fn add_scaled_words(x: *mut i32, d: *const i32, k: i32, down: i32) -> bool {
    naked_asm!(
        "push {{r1-r7, lr}}",
        add_scaled!(signed, "2f"),
        "movs r0, #0",
        "pop {{r1-r7, pc}}",
        "2:",
        far!(),
        "pop {{r1-r7, pc}}",
        far = sym add_far,
    )
}

/// What of a push turns, as arguments of `add_scaled` for w at r0.
macro_rules! turn {
    () => {
        concat!(
            "ldr r1, [sp, #4]\n ldr r3, [sp, #8]\n ldr r2, [r3]\n ldr r3, [r3, #8]\n",
            "ldr r4, [r1, #{turn_exponent}]\n subs r3, r3, r4\n adds r1, #{turn}\n",
        )
    };
}

/// The push of an impulse; `blow` points to its mantissa, and for an exponent of zero in 1/m and in u, to the places by which
/// `add_scaled` moves the products right.
#[unsafe(naked)]
pub(super) unsafe extern "C" fn push_words(
    body: *mut Body<I32F0>,
    d: *const i32,
    lever: *const Lever32,
    blow: *const [i32; 3],
) -> bool {
    naked_asm!(
        // On the stack from here on: d, the lever, the blow.
        "push {{r1-r7, lr}}",
        // r2: the product of the mantissas without its last 29 places; the middle products are below 2^30.
        "ldr r4, [r3]",
        "ldr r3, [r3, #4]",
        "adds r0, #{inv_mass}",
        "ldm r0!, {{r5, r6}}",
        "subs r3, r3, r6",
        "subs r0, #{inv_mass} + 8 - {linear_velocity}",
        "uxth r6, r5",
        "asrs r5, r5, #16",
        "uxth r7, r4",
        "asrs r4, r4, #16",
        "mov r2, r6",
        "muls r2, r7, r2",
        "muls r7, r5, r7",
        "muls r6, r4, r6",
        "muls r5, r4, r5",
        "adds r7, r7, r6",
        "lsls r6, r7, #16",
        "asrs r7, r7, #16",
        "adds r2, r2, r6",
        "adcs r5, r7",
        "lsrs r2, r2, #29",
        "lsls r5, r5, #3",
        "orrs r2, r5",
        add_scaled!(signed, "3f"),
        // r0 is 8 bytes further on.
        "adds r0, #4",
        turn!(),
        add_scaled!(plain, "4f"),
        "movs r0, #0",
        "pop {{r1-r7, pc}}",
        "3:",
        "mov r6, r0",
        far!(),
        "str r0, [sp]",
        "mov r0, r6",
        "adds r0, #12",
        turn!(),
        "bl {add_scaled}",
        "ldr r1, [sp]",
        "orrs r0, r1",
        "pop {{r1-r7, pc}}",
        "4:",
        far!(),
        "pop {{r1-r7, pc}}",
        far = sym add_far,
        add_scaled = sym add_scaled_words,
        turn = const offset_of!(Lever32, turn),
        turn_exponent = const offset_of!(Lever32, turn_exponent),
        inv_mass = const offset_of!(Body<I32F0>, inv_mass),
        linear_velocity = const offset_of!(Body<I32F0>, linear_velocity),
    )
}

/// A push, as that of `machine/impulses.rs`.
#[inline(always)]
pub fn push<F: LeEqU32>(body: &mut Body<FixedI32<F>>, d: &Vec3<I2F30>, lever: &Lever32, j: Scaled32) -> bool
where
    FixedI32<F>: Scalar,
{
    let blow =
        [j.mantissa(), 29i32.wrapping_sub(F::I32).wrapping_sub(j.exponent()), (-3i32).wrapping_sub(j.exponent())];
    // SAFETY: the references are to a body, laid out as the constants of `words.rs` say, to three words, to a lever, which is
    // `repr(C)`, and to three words; the function reads them, writes the body's velocities, and keeps to the calling convention.
    unsafe { push_words(from_mut(body).cast(), from_ref(d).cast(), lever, &blow) }
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
