//! The lever of an arm.

use core::arch::naked_asm;
use core::mem::offset_of;

use fixed::types::I32F0;

use super::numbers::zeros_of;
use crate::body::Body;
use crate::scalar::lever32::Lever32;
use crate::scalar::scaled32::Scaled32;

/// `r0 d1 - r1 d0` in r0 and r4, of words of the stack.
///
/// Lower halves are not negative. Of the middle products only two fit a common word: |d| <= 2^30.
macro_rules! minor {
    ($r0:literal, $d1:literal, $r1:literal, $d0:literal) => {
        concat!(
            word!("r0", "r1", $r0),
            word!("r2", "r3", $d1),
            // r0, r4: the upper and the lower product. r3, r1: the middle ones.
            "mov r4, r1\n muls r4, r3, r4\n muls r3, r0, r3\n muls r1, r2, r1\n muls r0, r2, r0\n",
            "lsls r2, r3, #16\n asrs r3, r3, #16\n adds r4, r4, r2\n adcs r0, r3\n",
            word!("r2", "r5", $r1),
            word!("r6", "r7", $d0),
            "mov r3, r2\n muls r3, r6, r3\n muls r2, r7, r2\n muls r6, r5, r6\n muls r5, r7, r5\n",
            "subs r4, r4, r5\n sbcs r0, r3\n subs r1, r1, r6\n",
            "lsls r3, r2, #16\n asrs r2, r2, #16\n subs r4, r4, r3\n sbcs r0, r2\n",
            "lsls r3, r1, #16\n asrs r1, r1, #16\n adds r4, r4, r3\n adcs r0, r1\n",
        )
    };
}

/// A component of c = r x d, halved into two words at `$at` of the stack.
macro_rules! cross {
    ($r0:literal, $d1:literal, $r1:literal, $d0:literal, $at:literal) => {
        concat!(
            minor!($r0, $d1, $r1, $d0),
            "uxth r1, r0\n asrs r0, r0, #16\n str r1, [sp, #",
            $at,
            "]\n str r0, [sp, #",
            $at,
            " + 4]\n",
        )
    };
}

/// The first product of `c . b`, of c's component at `$at` of the stack and b's at `$of`. r5, r4: the sum. r3, r0: middle products.
macro_rules! first {
    ($of:literal, $at:literal) => {
        concat!(
            "ldr r5, [sp, #",
            $of,
            "]\n uxth r3, r5\n asrs r5, r5, #16\n",
            "ldr r0, [sp, #",
            $at,
            "]\n ldr r1, [sp, #",
            $at,
            " + 4]\n",
            "mov r4, r0\n muls r4, r3, r4\n muls r3, r1, r3\n muls r0, r5, r0\n muls r5, r1, r5\n",
        )
    };
}

/// The next product; r3: the sum of those middle products.
macro_rules! next {
    ($of:literal, $at:literal) => {
        concat!(
            "ldr r2, [sp, #",
            $of,
            "]\n uxth r6, r2\n asrs r2, r2, #16\n",
            "ldr r0, [sp, #",
            $at,
            "]\n ldr r1, [sp, #",
            $at,
            " + 4]\n",
            "mov r7, r0\n muls r7, r6, r7\n muls r6, r1, r6\n muls r0, r2, r0\n muls r2, r1, r2\n",
            "adds r4, r4, r7\n adcs r5, r2\n adds r3, r3, r6\n",
        )
    };
}

/// Adds middle products.
macro_rules! middle {
    ($r:literal) => {
        concat!("lsls r2, ", $r, ", #16\n asrs ", $r, ", ", $r, ", #16\n adds r4, r4, r2\n adcs r5, ", $r, "\n")
    };
}

/// `c . b` for a b within 2^29.8, or a row of a tensor. With |c| < 2^29.8, each sum of middle products fits a word.
macro_rules! dot {
    ($x:literal, $y:literal, $z:literal) => {
        concat!(
            first!($x, 0),
            "mov r12, r0\n",
            next!($y, 8),
            "add r12, r0\n",
            next!($z, 16),
            "add r0, r12\n",
            middle!("r0"),
            middle!("r3"),
        )
    };
}

/// A component of u, of a row of the tensor.
macro_rules! turn {
    ($x:literal, $y:literal, $z:literal, $to:literal) => {
        concat!(dot!($x, $y, $z), "lsls r5, r5, #3\n lsrs r4, r4, #29\n orrs r5, r4\n str r5, [sp, #", $to, "]\n")
    };
}

/// A lever; `r` and `d` point to three words each.
#[unsafe(naked)]
pub(in crate::scalar::machine) unsafe extern "C" fn lever_words(
    r: *const i32,
    body: *const Body<I32F0>,
    d: *const i32,
) -> Lever32 {
    naked_asm!(
        // On the stack from here on: c in halves, at 24 d and r, then the tensor, at 48 w, then u, at 60 the places, at 64 the
        // lever, at 68 the body.
        "push {{r0, r2, r4-r7, lr}}",
        "sub sp, #64",
        // r, moved left until it fills 31 bits.
        "mov r7, r3",
        "ldm r1!, {{r4, r5, r6}}",
        zeros!(),
        "subs r0, #1",
        "str r0, [sp, #60]",
        "lsls r4, r0",
        "lsls r5, r0",
        "lsls r6, r0",
        "ldm r7!, {{r0, r1, r2}}",
        "add r3, sp, #24",
        "stm r3!, {{r0, r1, r2, r4, r5, r6}}",
        cross!(40, 32, 44, 28, 0),
        cross!(44, 24, 36, 32, 8),
        cross!(36, 28, 40, 24, 16),
        "ldr r7, [sp, #68]",
        "adds r7, #24",
        "ldm r7!, {{r0, r1, r2}}",
        "add r6, sp, #48",
        "stm r6!, {{r0, r1, r2}}",
        "adds r7, #20",
        "ldm r7!, {{r0, r1, r2, r3, r4, r5}}",
        "add r6, sp, #24",
        "stm r6!, {{r0, r1, r2, r3, r4, r5}}",
        // w . c: any numbers of 32 bits, of whose middle products one kind is added one by one.
        first!(48, 0),
        middle!("r0"),
        next!(52, 8),
        middle!("r0"),
        next!(56, 16),
        middle!("r0"),
        middle!("r3"),
        "ldr r0, [sp, #64]",
        "stm r0!, {{r4, r5}}",
        // u = I^-1 c
        turn!(24, 28, 32, 48),
        turn!(28, 36, 40, 52),
        turn!(32, 40, 44, 56),
        // r5, r4: c . u.
        dot!(48, 52, 56),
        "cmp r5, #0",
        "bge 2f",
        "movs r5, #0",
        "movs r4, #0",
        "2:",
        // r0: how far it moves left; r4: its leading 30 bits.
        "movs r0, #1",
        "orrs r0, r5",
        "bl {zeros_of}",
        "lsls r5, r0",
        "movs r1, #31",
        "eors r1, r0",
        "lsrs r4, r4, #1",
        "lsrs r4, r1",
        "orrs r4, r5",
        "lsrs r4, r4, #2",
        // r3 and r5: the exponents of u and of c . u.
        "ldr r2, [sp, #60]",
        "ldr r3, [sp, #68]",
        "ldr r3, [r3, #80]",
        "subs r3, r3, r2",
        "subs r5, r3, r2",
        "subs r5, r5, r0",
        "cmp r4, #0",
        "bne 3f",
        "ldr r5, 4f",
        "3:",
        "ldr r0, [sp, #64]",
        "adds r0, #{places}",
        "stm r0!, {{r2, r3, r4, r5}}",
        "subs r0, #16 + {places} - {turn}",
        "add r1, sp, #48",
        "ldm r1!, {{r2, r3, r4}}",
        "stm r0!, {{r2, r3, r4}}",
        "add sp, #64",
        "pop {{r0, r2, r4-r7, pc}}",
        ".p2align 2",
        "4:",
        ".word {lowest}",
        zeros_of = sym zeros_of,
        lowest = const Scaled32::LOWEST,
        turn = const offset_of!(Lever32, turn),
        places = const offset_of!(Lever32, places),
    )
}
