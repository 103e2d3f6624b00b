//! Functions of numbers, called from assembly, which tells the compiler that memory is left alone.

use core::arch::{asm, naked_asm};

/// `a b / 2^30` cut off, for results within 32 bits and b below 2^31 - 2^15.
#[inline(always)]
pub fn times30(a: i32, b: i32) -> i32 {
    let mut product = a;
    // SAFETY: a call with the numbers in the registers where the function takes and leaves them; the others that it changes are
    // declared.
    unsafe {
        asm!(
            "bl {times30}",
            times30 = sym times30_words,
            inout("r0") product,
            inout("r1") b => _,
            out("r2") _,
            out("r3") _,
            out("r12") _,
            out("lr") _,
            options(pure, nomem),
        );
    }
    product
}

#[unsafe(naked)]
extern "C" fn times30_words(a: i32, b: i32) -> i32 {
    naked_asm!(
        // With a = 2^16 a1 + a0, a0 not negative, and b = 2^16 b1 + b0, b0 of either sign:
        "uxth r2, r0",
        "asrs r0, r0, #16",
        "sxth r3, r1",
        "subs r1, r1, r3",
        "asrs r1, r1, #16",
        "mov r12, r3",
        "muls r3, r2, r3", // a0 b0
        "asrs r3, r3, #16",
        "muls r2, r1, r2", // a0 b1
        "adds r2, r2, r3",
        "bvs 2f",
        "mov r3, r12",
        "muls r3, r0, r3", // a1 b0
        "adds r2, r2, r3",
        "bvs 3f",
        "muls r0, r1, r0", // a1 b1
        "asrs r2, r2, #14",
        "lsls r0, r0, #2",
        "adds r0, r0, r2",
        "bx lr",
        // A sum beyond 2^31 has the sign of a0 b1, to which the others add less than 2^31.
        "2:",
        "mov r3, r12",
        "muls r3, r0, r3",
        "adds r2, r2, r3",
        "3:",
        "muls r0, r1, r0",
        "lsrs r2, r2, #14",
        "lsls r0, r0, #2",
        "adds r0, r0, r2",
        "cmp r1, #0",
        "bge 4f",
        "movs r2, #1",
        "lsls r2, r2, #18",
        "subs r0, r0, r2",
        "4:",
        "bx lr",
    )
}

/// How many leading digits of `x` are zero; 32 for zero.
#[inline(always)]
pub fn leading_zeros(x: u32) -> u32 {
    let mut zeros = x;
    // SAFETY: as that of `times30`.
    unsafe {
        asm!(
            "bl {zeros_of}",
            zeros_of = sym zeros_of,
            inout("r0") zeros,
            out("r1") _,
            out("r2") _,
            out("lr") _,
            options(pure, nomem),
        );
    }
    zeros
}

/// By halves, and a table for the last four digits.
#[unsafe(naked)]
pub(super) extern "C" fn zeros_of(x: u32) -> u32 {
    naked_asm!(
        "movs r1, #28",
        "lsrs r2, r0, #16",
        "beq 1f",
        "mov r0, r2",
        "subs r1, #16",
        "1:",
        "lsrs r2, r0, #8",
        "beq 2f",
        "mov r0, r2",
        "subs r1, #8",
        "2:",
        "lsrs r2, r0, #4",
        "beq 3f",
        "mov r0, r2",
        "subs r1, #4",
        "3:",
        "adr r2, 4f",
        "ldrb r0, [r2, r0]",
        "adds r0, r0, r1",
        "bx lr",
        ".p2align 2",
        "4:",
        ".byte 4, 3, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0",
    )
}
