//! The lever of an arm.

use core::arch::naked_asm;

use super::numbers::zeros_of;
use crate::scalar::lever32::Lever32;
use crate::scalar::scaled32::Scaled32;

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

/// The first product of `c . b`, of c's component at `$at` of the stack and b's at `$of` from r6. r5, r4: the sum. r8, r9: sums of
/// the middle products.
macro_rules! first {
    ($of:literal, $at:literal) => {
        concat!(
            "ldr r5, [r6, #",
            $of,
            "]\n uxth r3, r5\n asrs r5, r5, #16\n",
            "ldr r0, [sp, #",
            $at,
            "]\n ldr r1, [sp, #",
            $at,
            " + 4]\n",
            "mov r4, r0\n muls r4, r3, r4\n muls r3, r1, r3\n muls r0, r5, r0\n muls r5, r1, r5\n",
            "mov r8, r3\n",
        )
    };
}

/// The next product.
macro_rules! next {
    ($of:literal, $at:literal) => {
        concat!(
            "ldr r2, [r6, #",
            $of,
            "]\n uxth r3, r2\n asrs r2, r2, #16\n",
            "ldr r0, [sp, #",
            $at,
            "]\n ldr r1, [sp, #",
            $at,
            " + 4]\n",
            "mov r7, r0\n muls r7, r3, r7\n muls r3, r1, r3\n muls r0, r2, r0\n muls r2, r1, r2\n",
            "adds r4, r4, r7\n adcs r5, r2\n add r8, r3\n",
        )
    };
}

/// Adds a sum of middle products, in `$r` and a low register at hand.
macro_rules! middle {
    ($r:literal, $free:literal) => {
        concat!(
            "lsls ",
            $free,
            ", ",
            $r,
            ", #16\n asrs ",
            $r,
            ", ",
            $r,
            ", #16\n adds r4, r4, ",
            $free,
            "\n adcs r5, ",
            $r,
            "\n",
        )
    };
}

/// `c . b` for a b within 2^29.8, or a row of a tensor. With |c| < 2^29.8, each sum of middle products fits a word.
macro_rules! dot {
    ($x:literal, $y:literal, $z:literal) => {
        concat!(
            first!($x, 0),
            "mov r9, r0\n",
            next!($y, 8),
            "add r9, r0\n",
            next!($z, 16),
            "add r0, r9\n",
            "mov r1, r8\n",
            middle!("r0", "r2"),
            middle!("r1", "r2"),
        )
    };
}

/// A component of u, of a row of the tensor.
macro_rules! turn {
    ($x:literal, $y:literal, $z:literal, $to:literal) => {
        concat!(
            "ldr r6, [sp, #68]\n",
            dot!($x, $y, $z),
            "lsls r5, r5, #3\n lsrs r4, r4, #29\n orrs r5, r4\n ldr r0, [sp, #40]\n str r5, [r0, #",
            $to,
            "]\n",
        )
    };
}

/// A lever; `r`, `w` and `d` point to three words each, `inv_inertia` to six.
#[unsafe(naked)]
pub(in crate::scalar::machine) unsafe extern "C" fn lever_words(
    r: *const i32,
    w: *const i32,
    d: *const i32,
    inv_inertia: *const i32,
    exponent: i32,
) -> Lever32 {
    naked_asm!(
        // On the stack from here on: c in halves, four registers, at 40 the lever, at 44 w, at 68 the tensor, at 72 its exponent.
        "push {{r0, r2, r4-r7, lr}}",
        "mov r4, r8",
        "mov r5, r9",
        "mov r6, r10",
        "mov r7, r11",
        "push {{r4-r7}}",
        "sub sp, #24",
        // r8, r9, r10: r, moved left until it fills 31 bits. r11, r12, lr: d.
        "mov r7, r3",
        "ldm r1!, {{r4, r5, r6}}",
        "asrs r0, r4, #31",
        "eors r0, r4",
        "asrs r1, r5, #31",
        "eors r1, r5",
        "orrs r0, r1",
        "asrs r1, r6, #31",
        "eors r1, r6",
        "orrs r0, r1",
        "movs r1, #1",
        "orrs r0, r1",
        "bl {zeros_of}",
        "subs r0, #1",
        "ldr r1, [sp, #40]",
        "str r0, [r1, #20]",
        "lsls r4, r0",
        "lsls r5, r0",
        "lsls r6, r0",
        "mov r8, r4",
        "mov r9, r5",
        "mov r10, r6",
        "ldm r7!, {{r0, r1, r2}}",
        "mov r11, r0",
        "mov r12, r1",
        "mov lr, r2",
        cross!("r9", "lr", "r10", "r12", 0),
        cross!("r10", "r11", "r8", "lr", 8),
        cross!("r8", "r12", "r9", "r11", 16),
        // w . c: any numbers of 32 bits, whose middle products are added one by one.
        "ldr r6, [sp, #44]",
        first!(0, 0),
        middle!("r0", "r2"),
        next!(4, 8),
        middle!("r0", "r2"),
        next!(8, 16),
        middle!("r0", "r2"),
        "mov r1, r8",
        middle!("r1", "r2"),
        "ldr r0, [sp, #40]",
        "stm r0!, {{r4, r5}}",
        // u = I^-1 c
        turn!(0, 4, 8, 8),
        turn!(4, 12, 16, 12),
        turn!(8, 16, 20, 16),
        // r5, r4: c . u. r6: the lever.
        "ldr r6, [sp, #40]",
        dot!(8, 12, 16),
        "cmp r5, #0",
        "bge 2f",
        "movs r5, #0",
        "movs r4, #0",
        "2:",
        // r0: how far it moves left; r5: its leading 30 bits.
        "movs r0, #1",
        "orrs r0, r5",
        "bl {zeros_of}",
        "lsls r5, r0",
        "movs r1, #31",
        "eors r1, r0",
        "lsrs r4, r4, #1",
        "lsrs r4, r1",
        "orrs r5, r4",
        "lsrs r5, r5, #2",
        "str r5, [r6, #28]",
        // The exponents of u and of c . u.
        "ldr r1, [sp, #72]",
        "ldr r2, [r6, #20]",
        "subs r1, r1, r2",
        "str r1, [r6, #24]",
        "subs r1, r1, r2",
        "subs r1, r1, r0",
        "cmp r5, #0",
        "bne 3f",
        "ldr r1, 4f",
        "3:",
        "str r1, [r6, #32]",
        "add sp, #24",
        "pop {{r4-r7}}",
        "mov r8, r4",
        "mov r9, r5",
        "mov r10, r6",
        "mov r11, r7",
        "pop {{r0, r2, r4-r7, pc}}",
        ".p2align 2",
        "4:",
        ".word {lowest}",
        zeros_of = sym zeros_of,
        lowest = const Scaled32::LOWEST,
    )
}
