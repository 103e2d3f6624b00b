//! What the search for a direction of sliding asks at each turn.

use core::arch::naked_asm;
use core::mem::{MaybeUninit, offset_of};
use core::ptr::from_ref;

use crate::scalar::slip32::Slip32;

/// `r0 k / 2^30` cut off, for a k not negative in halves in r6 and r7. |r0| and k are at most 2^30 and a few
/// units: the middle products fit a word.
macro_rules! times {
    () => {
        concat!(
            "uxth r1, r0\n asrs r0, r0, #16\n mov r2, r1\n muls r2, r6, r2\n lsrs r2, r2, #16\n muls r1, r7, r1\n",
            "adds r1, r1, r2\n mov r2, r0\n muls r2, r6, r2\n adds r1, r1, r2\n muls r0, r7, r0\n",
            "asrs r1, r1, #14\n lsls r0, r0, #2\n adds r0, r0, r1\n",
        )
    };
}

/// Puts a number that is not negative, at `$at` from r5, into r6 and r7 in halves.
macro_rules! halves {
    ($at:literal) => {
        concat!("ldr r6, [r5, #{", $at, "}]\n lsrs r7, r6, #16\n uxth r6, r6\n")
    };
}

/// Components of t N and its derivative, for those of q and p.
macro_rules! component {
    ($q:literal, $p:literal, $more:literal, $tn:literal, $m:literal) => {
        concat!(
            "ldr r0, [r5, #{",
            $p,
            "} + ",
            $more,
            "]\n",
            times!(),
            "ldr r3, [r5, #{",
            $q,
            "} + ",
            $more,
            "]\n adds r3, r3, r0\n adds r0, r0, r3\n str r0, [sp, #",
            $m,
            "]\n mov r0, r3\n",
            times!(),
            "str r0, [sp, #",
            $tn,
            "]\n",
        )
    };
}

/// The product of two numbers, of which `$x` and `$y` load the words to r0 and r2: into r3 and r4. r6, r1: the middle products.
macro_rules! first {
    ($x:literal, $y:literal) => {
        concat!(
            "ldr r0, ",
            $x,
            "\n uxth r1, r0\n asrs r0, r0, #16\n ldr r2, ",
            $y,
            "\n uxth r6, r2\n asrs r2, r2, #16\n",
            "mov r4, r1\n muls r4, r6, r4\n muls r6, r0, r6\n mov r3, r0\n muls r3, r2, r3\n muls r1, r2, r1\n",
        )
    };
}

/// A product added to r3 and r4.
macro_rules! next {
    ($x:literal, $y:literal) => {
        concat!(
            "ldr r0, ",
            $x,
            "\n uxth r1, r0\n asrs r0, r0, #16\n ldr r2, ",
            $y,
            "\n uxth r6, r2\n asrs r2, r2, #16\n",
            "mov r7, r1\n muls r7, r6, r7\n muls r6, r0, r6\n muls r0, r2, r0\n muls r1, r2, r1\n",
            "adds r4, r4, r7\n adcs r3, r0\n",
        )
    };
}

/// Adds middle products to r3 and r4.
macro_rules! middle {
    ($r:literal) => {
        concat!("lsls r7, ", $r, ", #16\n asrs ", $r, ", ", $r, ", #16\n adds r4, r4, r7\n adcs r3, ", $r, "\n")
    };
}

/// The middle products of factors within 2^30, which fit a word together.
macro_rules! both {
    () => {
        concat!("adds r1, r1, r6\n", middle!("r1"))
    };
}

/// The middle products of any factors.
macro_rules! each {
    () => {
        concat!(middle!("r1"), middle!("r6"))
    };
}

/// A square added to r3 and r4, or taken from them: of the word at `$at` of the stack.
macro_rules! square {
    ($at:literal, $add:literal, $carry:literal) => {
        concat!(
            "ldr r0, [sp, #",
            $at,
            "]\n uxth r1, r0\n asrs r0, r0, #16\n mov r2, r1\n muls r2, r2, r2\n muls r1, r0, r1\n muls r0, r0, r0\n",
            $add,
            " r4, r4, r2\n ",
            $carry,
            " r3, r0\n lsls r2, r1, #17\n asrs r1, r1, #15\n ",
            $add,
            " r4, r4, r2\n ",
            $carry,
            " r3, r1\n",
        )
    };
}

#[repr(C)]
struct Excess {
    excess: i64,
    slope: i64,
}

/// B; the difference of the squares and half its derivative go to `excess`.
#[unsafe(naked)]
unsafe extern "C" fn excess_words(slip: *const Slip32, t: i32, excess: *mut Excess) -> i32 {
    naked_asm!(
        // On the stack: t N, at 8 its derivative, at 16 t times the determinant, at 20 1 - t, at 24 that and t times the trace, at
        // 28 t, at 32 half the derivative of B, at 36 B, at 40 where the result goes.
        "push {{r2, r4-r7, lr}}",
        "sub sp, #40",
        "mov r5, r0",
        "str r1, [sp, #28]",
        "uxth r6, r1",
        "lsrs r7, r1, #16",
        "movs r0, #1",
        "lsls r0, r0, #30",
        "subs r0, r0, r1",
        "str r0, [sp, #20]",
        component!("q", "p", 0, 0, 8),
        component!("q", "p", 4, 4, 12),
        "ldr r0, [r5, #{half_trace}]",
        times!(),
        "lsls r0, r0, #1",
        "ldr r1, [sp, #20]",
        "adds r0, r0, r1",
        "str r0, [sp, #24]",
        "ldr r0, [r5, #{determinant}]",
        times!(),
        "str r0, [sp, #16]",
        // D, of numbers that are not negative.
        "uxth r1, r0",
        "lsrs r0, r0, #16",
        "mov r2, r1",
        "muls r2, r6, r2",
        "muls r1, r7, r1",
        "mov r3, r0",
        "muls r3, r6, r3",
        "muls r0, r7, r0",
        "adds r1, r1, r3",
        "lsls r3, r1, #16",
        "lsrs r1, r1, #16",
        "adds r2, r2, r3",
        "adcs r0, r1",
        "ldr r1, [sp, #20]",
        "uxth r3, r1",
        "lsrs r1, r1, #16",
        "ldr r4, [sp, #24]",
        "uxth r6, r4",
        "lsrs r4, r4, #16",
        "mov r7, r3",
        "muls r7, r6, r7",
        "muls r6, r1, r6",
        "muls r3, r4, r3",
        "muls r1, r4, r1",
        "adds r2, r2, r7",
        "adcs r0, r1",
        "adds r3, r3, r6",
        "lsls r6, r3, #16",
        "lsrs r3, r3, #16",
        "adds r2, r2, r6",
        "adcs r0, r3",
        "lsls r4, r0, #2",
        "lsrs r2, r2, #30",
        "orrs r4, r2",
        // r3: half the derivative of D.
        halves!("half_trace"),
        "ldr r3, [sp, #20]",
        "ldr r0, [sp, #28]",
        "subs r0, r3, r0",
        times!(),
        "subs r3, r0, r3",
        "ldr r0, [sp, #16]",
        "adds r3, r3, r0",
        // B, and half its derivative.
        halves!("load"),
        "mov r0, r4",
        times!(),
        "str r0, [sp, #36]",
        "mov r0, r3",
        times!(),
        "str r0, [sp, #32]",
        first!("[r5, #{coupling}]", "[sp, #0]"),
        both!(),
        next!("[r5, #{coupling} + 4]", "[sp, #4]"),
        both!(),
        "lsls r3, r3, #2",
        "lsrs r4, r4, #30",
        "orrs r3, r4",
        "ldr r0, [sp, #36]",
        "subs r0, r0, r3",
        "str r0, [sp, #36]",
        first!("[r5, #{coupling}]", "[sp, #8]"),
        each!(),
        next!("[r5, #{coupling} + 4]", "[sp, #12]"),
        each!(),
        "lsls r3, r3, #1",
        "lsrs r4, r4, #31",
        "orrs r3, r4",
        "ldr r0, [sp, #32]",
        "subs r0, r0, r3",
        "str r0, [sp, #32]",
        // Half the derivative of the difference, and the difference.
        first!("[sp, #36]", "[sp, #32]"),
        each!(),
        "adds r4, r4, r4",
        "adcs r3, r3",
        "movs r0, #0",
        "rsbs r4, r4, #0",
        "sbcs r0, r3",
        "mov r3, r0",
        next!("[sp, #0]", "[sp, #8]"),
        each!(),
        next!("[sp, #4]", "[sp, #12]"),
        each!(),
        "ldr r0, [sp, #40]",
        "str r4, [r0, #{slope}]",
        "str r3, [r0, #{slope} + 4]",
        "movs r3, #0",
        "movs r4, #0",
        square!(0, "adds", "adcs"),
        square!(4, "adds", "adcs"),
        square!(36, "subs", "sbcs"),
        "ldr r0, [sp, #40]",
        "str r4, [r0]",
        "str r3, [r0, #4]",
        "ldr r0, [sp, #36]",
        "add sp, #40",
        "pop {{r2, r4-r7, pc}}",
        q = const offset_of!(Slip32, q),
        p = const offset_of!(Slip32, p),
        half_trace = const offset_of!(Slip32, half_trace),
        determinant = const offset_of!(Slip32, determinant),
        load = const offset_of!(Slip32, load),
        coupling = const offset_of!(Slip32, coupling),
        slope = const offset_of!(Excess, slope),
    )
}

/// B, the difference of the squares, and half its derivative, as those of `slip32.rs`.
#[inline(always)]
pub fn excess(slip: &Slip32, t: i32) -> (i32, i64, i64) {
    let mut excess = MaybeUninit::uninit();
    // SAFETY: the references are to the equation and to two numbers, which are `repr(C)`; the function reads the first, writes the
    // others, and keeps to the calling convention.
    unsafe {
        let b = excess_words(from_ref(slip), t, excess.as_mut_ptr());
        let Excess { excess, slope } = excess.assume_init();
        (b, excess, slope)
    }
}
