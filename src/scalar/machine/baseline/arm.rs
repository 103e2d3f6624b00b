//! What an arm does in any direction.

use core::arch::naked_asm;
use core::mem::offset_of;
use core::ptr::from_ref;

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::LeEqU32;

use super::numbers::zeros_of;
use crate::math::{SymMat3, Vec3};
use crate::scalar::arm32::Arm32;
use crate::scalar::scaled32::Scaled32;

/// The upper and the lower half of a number in halves at `$at` of the stack, the lower one first.
macro_rules! halves {
    ($high:literal, $low:literal, $at:literal) => {
        concat!("ldr ", $low, ", [sp, #", $at, "]\n ldr ", $high, ", [sp, #", $at, " + 4]\n")
    };
}

/// `i0 r1 - i1 r0` in r0 and r4, of words of the tensor and numbers in halves, all on the stack.
///
/// Of the middle products those of one kind fit a common word each: |i| < 2^29.1 and |r| <= 2^30.
macro_rules! minor {
    ($i0:literal, $r1:literal, $i1:literal, $r0:literal) => {
        concat!(
            word!("r0", "r1", $i0),
            halves!("r2", "r3", $r1),
            // r0, r4: the upper and the lower product. r3, r1: the middle ones.
            "mov r4, r1\n muls r4, r3, r4\n muls r3, r0, r3\n muls r1, r2, r1\n muls r0, r2, r0\n",
            word!("r2", "r5", $i1),
            "ldr r6, [sp, #",
            $r0,
            "]\n mov r7, r5\n muls r7, r6, r7\n muls r6, r2, r6\n subs r3, r3, r6\n",
            "ldr r6, [sp, #",
            $r0,
            " + 4]\n muls r5, r6, r5\n subs r1, r1, r5\n muls r2, r6, r2\n subs r4, r4, r7\n sbcs r0, r2\n",
            "lsls r2, r3, #16\n asrs r3, r3, #16\n adds r4, r4, r2\n adcs r0, r3\n",
            "lsls r2, r1, #16\n asrs r1, r1, #16\n adds r4, r4, r2\n adcs r0, r1\n",
        )
    };
}

/// An element of W without its last 29 places, at `$to` of what a word of the stack points to.
macro_rules! element {
    ($i0:literal, $r1:literal, $i1:literal, $r0:literal, $to:literal, $column:literal) => {
        concat!(
            minor!($i0, $r1, $i1, $r0),
            "lsls r0, r0, #3\n lsrs r4, r4, #29\n orrs r0, r4\n ldr r1, [sp, #48]\n str r0, [r1, #",
            $to,
            " + ",
            $column,
            "]\n",
        )
    };
}

/// A row of W, of one of I^-1.
macro_rules! row {
    ($x:literal, $y:literal, $z:literal, $to:literal) => {
        concat!(element!($y, 16, $z, 8, $to, 0), element!($z, 0, $x, 16, $to, 4), element!($x, 8, $y, 0, $to, 8),)
    };
}

/// An arm; `r` points to three words, `inv_inertia` to six.
#[unsafe(naked)]
unsafe extern "C" fn arm_words(r: *const i32, inv_inertia: *const i32, exponent: i32, frac: i32) -> Arm32 {
    naked_asm!(
        // On the stack from here on: r in halves, at 24 the tensor, at 48 the arm, then its W, at 52 the exponent, at 76 frac.
        "push {{r0, r3-r7, lr}}",
        "sub sp, #48",
        "ldm r1!, {{r4, r5, r6}}",
        "add r7, sp, #24",
        "ldm r2!, {{r0, r1, r3}}",
        "stm r7!, {{r0, r1, r3}}",
        "ldm r2!, {{r0, r1, r3}}",
        "stm r7!, {{r0, r1, r3}}",
        // r, moved left until it fills 31 bits, and one back.
        zeros!(),
        "subs r1, r0, #1",
        "lsls r4, r1",
        "asrs r4, r4, #1",
        "lsls r5, r1",
        "asrs r5, r5, #1",
        "lsls r6, r1",
        "asrs r6, r6, #1",
        "ldr r3, [sp, #48]",
        "stm r3!, {{r4, r5, r6}}",
        // r7: the exponent of r, and from it that of W.
        "ldr r7, 4f",
        "mov r2, r4",
        "orrs r2, r5",
        "orrs r2, r6",
        "beq 2f",
        "ldr r2, [sp, #76]",
        "adds r2, r2, r0",
        "movs r7, #2",
        "subs r7, r7, r2",
        "2:",
        "stm r3!, {{r7}}",
        "ldr r0, [sp, #52]",
        "adds r7, r7, r0",
        "subs r7, #1",
        "str r7, [r3, #{turn_exponent} - {turn}]",
        "str r3, [sp, #48]",
        "uxth r0, r4",
        "asrs r1, r4, #16",
        "uxth r2, r5",
        "asrs r3, r5, #16",
        "uxth r4, r6",
        "asrs r5, r6, #16",
        "mov r6, sp",
        "stm r6!, {{r0-r5}}",
        row!(24, 28, 32, 0),
        row!(28, 36, 40, 12),
        row!(32, 40, 44, 24),
        "add sp, #48",
        "pop {{r0, r3-r7, pc}}",
        ".p2align 2",
        "4:",
        ".word {lowest}",
        zeros_of = sym zeros_of,
        lowest = const Scaled32::LOWEST,
        turn = const offset_of!(Arm32, turn),
        turn_exponent = const offset_of!(Arm32, turn_exponent),
    )
}

/// An arm, as that of `machine/rows.rs`.
#[inline(always)]
pub fn arm<F: LeEqU32>(r: &Vec3<FixedI32<F>>, inv_inertia: &SymMat3<I2F30>, exponent: i32) -> Arm32 {
    // SAFETY: the references are to three words and to six; the function reads them, writes every field of the arm, which is
    // `repr(C)`, and keeps to the calling convention.
    unsafe { arm_words(from_ref(r).cast(), from_ref(inv_inertia).cast(), exponent, F::I32) }
}
