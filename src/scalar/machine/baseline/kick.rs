//! An impulse in any direction at the end of an arm.

use core::arch::naked_asm;
use core::mem::offset_of;
use core::ptr::{from_mut, from_ref};

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;
use fixed::types::{I2F30, I32F0};

use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::scalar::arm32::Arm32;
use crate::scalar::machine::words::add_far;
use crate::scalar::stored32::add_block;
use crate::scalar::wide::bits;

/// The first product of a row, of its word at `$at` from r7 and the vector's number in halves at `$of` of the stack: r5 and r4.
/// r3: the middle products, all of a row in one word but where that overflows.
macro_rules! first {
    ($at:literal, $of:literal, $far:literal) => {
        concat!(
            "ldr r0, [r7, #",
            $at,
            "]\n uxth r1, r0\n asrs r0, r0, #16\n ldr r3, [sp, #",
            $of,
            "]\n mov r4, r1\n muls r4, r3, r4\n muls r3, r0, r3\n ldr r5, [sp, #",
            $of,
            " + 4]\n muls r1, r5, r1\n adds r3, r3, r1\n bvs ",
            $far,
            "\n muls r5, r0, r5\n",
        )
    };
}

/// The next product, and its middle products added to those before.
macro_rules! next {
    ($at:literal, $of:literal, $far:literal) => {
        concat!(
            "ldr r0, [r7, #",
            $at,
            "]\n uxth r1, r0\n asrs r0, r0, #16\n ldr r2, [sp, #",
            $of,
            "]\n mov r6, r1\n muls r6, r2, r6\n muls r2, r0, r2\n adds r3, r3, r2\n bvs ",
            $far,
            "\n ldr r2, [sp, #",
            $of,
            " + 4]\n muls r1, r2, r1\n adds r3, r3, r1\n bvs ",
            $far,
            "\n muls r0, r2, r0\n adds r4, r4, r6\n adcs r5, r0\n",
        )
    };
}

/// A component of w, at `$w` from r12, and the product of a row of W and j, moved right by lr places and rounded: in r2.
macro_rules! turned {
    ($x:literal, $y:literal, $z:literal, $w:literal, $far:literal) => {
        concat!(
            first!($x, 0, $far),
            next!($y, 8, $far),
            next!($z, 16, $far),
            "lsls r0, r3, #16\n asrs r3, r3, #16\n adds r4, r4, r0\n adcs r5, r3\n",
            "lsls r5, r5, #1\n lsrs r4, r4, #31\n orrs r5, r4\n",
            // The last bit that leaves by a shift is the carry, and the half that rounds.
            "mov r0, lr\n mov r1, r12\n ldr r2, [r1, #",
            $w,
            "]\n asrs r5, r0\n adcs r2, r5\n bvs ",
            $far,
            "\n",
        )
    };
}

/// A kick; `j` points to three words, `base` is the sum of their exponent and the format's fraction bits.
#[unsafe(naked)]
unsafe extern "C" fn kick_words(body: *mut Body<I32F0>, arm: *const Arm32, j: *const i32, base: i32) -> bool {
    naked_asm!(
        // On the stack from here on: j in halves, the lower one first, at 24 two components of w, at 36 the arguments.
        "push {{r0-r7, lr}}",
        "sub sp, #36",
        "adds r0, #{inv_mass}",
        "ldm r0!, {{r4, r5}}",
        "subs r0, #{inv_mass} + 8 - {linear_velocity}",
        "movs r6, #28",
        "subs r6, r6, r3",
        "subs r3, r6, r5",
        "mov r1, r2",
        "mov r2, r4",
        add_scaled!(signed, "3f"),
        // r0 is 8 bytes further on.
        "adds r0, #4",
        "mov r12, r0",
        "ldm r1, {{r0, r1, r2}}",
        "uxth r3, r0",
        "asrs r4, r0, #16",
        "uxth r5, r1",
        "asrs r6, r1, #16",
        "mov r0, sp",
        "stm r0!, {{r3, r4, r5, r6}}",
        "uxth r3, r2",
        "asrs r4, r2, #16",
        "stm r0!, {{r3, r4}}",
        // By how many places what turns moves right.
        "ldr r7, [sp, #40]",
        "ldr r0, [r7, #{turn_exponent}]",
        "ldr r3, [sp, #48]",
        "adds r3, r3, r0",
        "mvns r3, r3",
        "cmp r3, #2",
        "blt 4f",
        "cmp r3, #31",
        "ble 1f",
        "movs r3, #31",
        "1:",
        "mov lr, r3",
        "adds r7, #{turn}",
        "b 2f",
        "3:",
        far!(),
        "mov r4, r0",
        "b 5f",
        // What `turned` leaves alone.
        "4:",
        "movs r4, #0",
        "5:",
        "add r3, sp, #36",
        "ldm r3!, {{r0, r1, r2}}",
        "ldr r3, [r3]",
        "bl {far_turn}",
        "orrs r0, r4",
        "add sp, #52",
        "pop {{r4-r7, pc}}",
        "2:",
        turned!(0, 4, 8, 0, "4b"),
        "str r2, [sp, #24]",
        turned!(12, 16, 20, 4, "6f"),
        "str r2, [sp, #28]",
        "b 7f",
        "6:",
        "b 4b",
        "7:",
        turned!(24, 28, 32, 8, "6b"),
        "mov r5, r2",
        "add r2, sp, #24",
        "ldm r2!, {{r3, r4}}",
        "stm r1!, {{r3, r4, r5}}",
        "movs r0, #0",
        "add sp, #52",
        "pop {{r4-r7, pc}}",
        far = sym add_far,
        far_turn = sym add_far_turn,
        turn = const offset_of!(Arm32, turn),
        turn_exponent = const offset_of!(Arm32, turn_exponent),
        inv_mass = const offset_of!(Body<I32F0>, inv_mass),
        linear_velocity = const offset_of!(Body<I32F0>, linear_velocity),
    )
}

/// What a kick adds to the angular velocity, where that is fast or a sum of middle products leaves its word. The format is in `base`.
#[cold]
extern "C" fn add_far_turn(body: &mut Body<I32F0>, arm: &Arm32, j: &Vec3<I2F30>, base: i32) -> bool {
    let (u, exponent) = arm.turn(bits(j));
    add_block(&mut body.angular_velocity, u, exponent.wrapping_add(base).wrapping_sub(30))
}

/// A kick, as that of `machine/impulses.rs`.
#[inline(always)]
pub fn kick<F: LeEqU32>(body: &mut Body<FixedI32<F>>, arm: &Arm32, j: &Vec3<I2F30>, exponent: i32) -> bool
where
    FixedI32<F>: Scalar,
{
    // SAFETY: the references are to a body, laid out as the constants of `words.rs` say, to an arm, which is `repr(C)`, and to
    // three words; the function reads them, writes the body's velocities, and keeps to the calling convention.
    unsafe { kick_words(from_mut(body).cast(), arm, from_ref(j).cast(), exponent.wrapping_add(F::I32)) }
}
