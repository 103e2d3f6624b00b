//! What an impulse adds to a velocity.

use core::arch::naked_asm;
use core::ptr::{from_mut, from_ref};

use fixed::FixedI32;
use fixed::types::I2F30;

use crate::math::Vec3;
use crate::scalar::machine::words::add_far;

/// A component of x, at `$at` from r0, and d k / 2^(32 + down) in r2; to `2:` where they leave the range.
///
/// With d = 2^16 d1 + d0, d0 of either sign, the middle products fit a word together: |d| < 2^30.5 and |k| < 2^30.
macro_rules! added {
    ($at:literal) => {
        concat!(
            "ldr r6, [r1, #",
            $at,
            "]\n sxth r7, r6\n subs r6, r6, r7\n asrs r6, r6, #16\n",
            "mov r2, r7\n muls r2, r4, r2\n asrs r2, r2, #16\n muls r7, r5, r7\n adds r7, r7, r2\n",
            "mov r2, r6\n muls r2, r4, r2\n adds r7, r7, r2\n muls r6, r5, r6\n asrs r7, r7, #16\n adds r6, r6, r7\n",
            // The last bit that leaves by a shift is the carry, and the half that rounds.
            "asrs r6, r3\n ldr r2, [r0, #",
            $at,
            "]\n adcs r2, r6\n bvs 2f\n",
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
        "cmp r3, #1",
        "blt 2f",
        "cmp r3, #31",
        "ble 1f",
        "movs r3, #31",
        "1:",
        "uxth r4, r2",
        "asrs r5, r2, #16",
        added!(0),
        "mov r12, r2",
        added!(4),
        "mov lr, r2",
        added!(8),
        "str r2, [r0, #8]",
        "mov r2, r12",
        "mov r3, lr",
        "stm r0!, {{r2, r3}}",
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
