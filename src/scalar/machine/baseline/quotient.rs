//! Reciprocals and quotients.

use core::arch::{asm, naked_asm};

use crate::scalar::integer::RECIPROCAL_SEED;

/// 2^62 over r1 in r6, and r1 in halves in r4 and r5: the steps of `integer.rs`. No estimate on the way is of more than 16 bits,
/// so that a product with it is one of halves, too.
macro_rules! reciprocal {
    () => {
        concat!(
            "lsls r2, r1, #1\n lsrs r2, r2, #26\n ldr r3, 9f\n ldrb r2, [r3, r2]\n adds r2, #255\n adds r2, #1\n",
            "lsrs r3, r1, #17\n muls r3, r2, r3\n movs r4, #1\n lsls r4, r4, #24\n subs r3, r4, r3\n",
            "lsrs r3, r3, #8\n muls r3, r2, r3\n lsrs r3, r3, #8\n",
            // r3: the estimate of 13 bits, in Q15.
            "uxth r4, r1\n lsrs r5, r1, #16\n",
            "mov r6, r4\n muls r6, r3, r6\n lsrs r6, r6, #16\n mov r7, r5\n muls r7, r3, r7\n adds r6, r6, r7\n",
            "lsrs r6, r6, #1\n movs r7, #1\n lsls r7, r7, #31\n subs r6, r7, r6\n",
            "uxth r7, r6\n muls r7, r3, r7\n lsrs r7, r7, #15\n lsrs r6, r6, #16\n muls r6, r3, r6\n lsls r6, r6, #1\n",
            "adds r6, r6, r7\n",
        )
    };
}

/// `2^62 / d`, as that of `integer.rs`.
#[inline(always)]
pub fn reciprocal(d: u32) -> u32 {
    let x;
    // SAFETY: a call with the number in the register where the function takes it; it leaves memory alone but for what it pushes
    // and a table that nothing writes, and what it changes is declared.
    unsafe {
        asm!(
            "bl {words}",
            words = sym reciprocal_words,
            out("r0") x,
            inout("r1") d => _,
            out("r2") _,
            out("r3") _,
            out("lr") _,
            options(pure, nomem),
        );
    }
    x
}

#[unsafe(naked)]
extern "C" fn reciprocal_words() {
    naked_asm!(
        "push {{r4-r7, lr}}",
        reciprocal!(),
        "mov r0, r6",
        "pop {{r4-r7, pc}}",
        ".p2align 2",
        "9:",
        ".word {seed}",
        seed = sym RECIPROCAL_SEED,
    )
}

/// `n 2^30 / d`, as that of `integer.rs`.
#[inline(always)]
pub fn long_quotient(n: u32, d: u32) -> u32 {
    let mut q = n;
    // SAFETY: as above.
    unsafe {
        asm!(
            "bl {words}",
            words = sym long_quotient_words,
            inout("r0") q,
            inout("r1") d => _,
            out("r2") _,
            out("r3") _,
            out("r12") _,
            out("lr") _,
            options(pure, nomem),
        );
    }
    q
}

#[unsafe(naked)]
pub(super) extern "C" fn long_quotient_words(n: u32, d: u32) -> u32 {
    naked_asm!(
        "push {{r4-r7, lr}}",
        reciprocal!(),
        // r1: the upper half of n x, to 26 bits the quotient.
        "mov r12, r0",
        "uxth r2, r0",
        "lsrs r3, r0, #16",
        "uxth r7, r6",
        "lsrs r1, r6, #16",
        "mov r0, r2",
        "muls r0, r7, r0",
        "muls r7, r3, r7",
        "muls r2, r1, r2",
        "muls r1, r3, r1",
        "lsrs r0, r0, #16",
        "adds r2, r2, r0",
        "adds r2, r2, r7",
        "bcs 3f",
        "2:",
        "lsrs r2, r2, #16",
        "adds r1, r1, r2",
        // r3: n 2^30 less that times d, without the last eight places. A carry beyond 2^40 is none of its bits.
        "uxth r2, r1",
        "lsrs r3, r1, #16",
        "mov r0, r2",
        "muls r0, r4, r0",
        "muls r2, r5, r2",
        "muls r4, r3, r4",
        "muls r5, r3, r5",
        "adds r2, r2, r4",
        "lsls r3, r2, #16",
        "lsrs r2, r2, #16",
        "adds r0, r0, r3",
        "adcs r5, r2",
        "mov r2, r12",
        "lsls r3, r2, #30",
        "lsrs r2, r2, #2",
        "subs r3, r3, r0",
        "sbcs r2, r5",
        "lsrs r3, r3, #8",
        "lsls r2, r2, #24",
        "orrs r3, r2",
        // That times the reciprocal is what lacks; it is below 2^30, and so are the middle products.
        "lsrs r6, r6, #1",
        "uxth r2, r3",
        "asrs r3, r3, #16",
        "uxth r4, r6",
        "lsrs r5, r6, #16",
        "mov r0, r2",
        "muls r0, r4, r0",
        "muls r4, r3, r4",
        "muls r2, r5, r2",
        "muls r3, r5, r3",
        "lsrs r0, r0, #16",
        "adds r2, r2, r0",
        "adds r2, r2, r4",
        "asrs r2, r2, #16",
        "adds r3, r3, r2",
        "asrs r3, r3, #21",
        "adds r0, r1, r3",
        "pop {{r4-r7, pc}}",
        "3:",
        "movs r0, #1",
        "lsls r0, r0, #16",
        "adds r1, r1, r0",
        "b 2b",
        ".p2align 2",
        "9:",
        ".word {seed}",
        seed = sym RECIPROCAL_SEED,
    )
}
