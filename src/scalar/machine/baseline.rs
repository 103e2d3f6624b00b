//! What an impulse spends most on, in instructions of Armv6-M and Armv8-M Baseline: an island of `unsafe`.
//!
//! These cores multiply 32 bits by 32 and keep 32, so a wide product is four products of halves. Taken apart once, a factor
//! serves many products; sums of the two middle products wait until the end of a dot product; and what is left to the compiler
//! passes numbers through memory. Every bit is that of the portable functions: `examples/levers.rs` prints the same hashes of
//! thirty thousand contacts on all cores.
#![allow(unsafe_code)]

/// The upper and the lower half of a word at `$at` of the stack.
macro_rules! word {
    ($high:literal, $low:literal, $at:literal) => {
        concat!(
            "ldr ",
            $high,
            ", [sp, #",
            $at,
            "]\n uxth ",
            $low,
            ", ",
            $high,
            "\n asrs ",
            $high,
            ", ",
            $high,
            ", #16\n",
        )
    };
}

/// How many leading digits r4, r5 and r6 have in common with their signs, in r0; 31 at most.
macro_rules! zeros {
    () => {
        concat!(
            "asrs r0, r4, #31\n eors r0, r4\n asrs r1, r5, #31\n eors r1, r5\n orrs r0, r1\n",
            "asrs r1, r6, #31\n eors r1, r6\n orrs r0, r1\n movs r1, #1\n orrs r0, r1\n bl {zeros_of}\n",
        )
    };
}

/// d = 2^16 d1 + d0 in r6 and r7, d0 of either sign, so that the middle products of a direction and |k| < 2^31 fit a word together,
/// and those of |d| < 2^30.5 and |k| < 2^30.
macro_rules! signed {
    (asr) => {
        "asrs"
    };
    () => {
        "sxth r7, r6\n subs r6, r6, r7\n asrs r6, r6, #16\n"
    };
}

/// The same with d0 not negative, for |d| < 2^29.8 and |k| < 2^30.
macro_rules! plain {
    (asr) => {
        "lsrs"
    };
    () => {
        "uxth r7, r6\n asrs r6, r6, #16\n"
    };
}

/// A component of d k / 2^32 in r6.
macro_rules! times {
    ($at:literal, $halves:ident) => {
        concat!(
            "ldr r6, [r1, #",
            $at,
            "]\n",
            $halves!(),
            "mov r2, r7\n muls r2, r4, r2\n ",
            $halves!(asr),
            " r2, r2, #16\n muls r7, r5, r7\n adds r7, r7, r2\n",
            "mov r2, r6\n muls r2, r4, r2\n adds r7, r7, r2\n muls r6, r5, r6\n asrs r7, r7, #16\n adds r6, r6, r7\n",
        )
    };
}

/// The sum of a component of x and r6 / 2^down, rounded, in r2; to `$far` where it leaves the range.
macro_rules! added {
    ($at:literal, $far:literal) => {
        // The last bit that leaves by a shift is the carry, and the half that rounds.
        concat!("asrs r6, r3\n ldr r2, [r0, #", $at, "]\n adcs r2, r6\n bvs ", $far, "\n")
    };
}

/// `add_scaled` for x at r0, d at r1, k in r2 and down in r3; to `$far`, with k in halves in r4 and r5, where it has nothing added.
macro_rules! add_scaled {
    ($halves:ident, $far:literal) => {
        concat!(
            "uxth r4, r2\n asrs r5, r2, #16\n",
            times!(0, $halves),
            "cmp r3, #31\n ble 1f\n movs r3, #31\n 1:\n",
            added!(0, $far),
            "mov r12, r2\n",
            times!(4, $halves),
            added!(4, $far),
            "mov lr, r2\n",
            times!(8, $halves),
            added!(8, $far),
            // What shifts by other numbers of places have left is of no use.
            "cmp r3, #1\n blt ",
            $far,
            "\n str r2, [r0, #8]\n mov r2, r12\n mov r3, lr\n stm r0!, {{r2, r3}}\n",
        )
    };
}

/// What `add_scaled` leaves alone: r0 says whether a component met the end of the range. The stack is aligned.
macro_rules! far {
    () => {
        "lsls r2, r5, #16\n adds r2, r2, r4\n bl {far}\n"
    };
}

mod arm;
mod kick;
mod lever;
mod numbers;
mod push;
mod quotient;
pub(super) mod rows;
mod slip;
mod strike;

pub use arm::arm;
pub use kick::kick;
pub(super) use lever::lever_words;
pub use numbers::{leading_zeros, times30};
pub use push::{add_along, add_turn, push};
pub use quotient::{long_quotient, reciprocal};
pub use slip::excess;
pub use strike::strike;
