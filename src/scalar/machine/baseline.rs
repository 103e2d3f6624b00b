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

/// The same of a number that lies there in halves, the lower one first.
macro_rules! halves {
    ($high:literal, $low:literal, $at:literal) => {
        concat!("ldr ", $low, ", [sp, #", $at, "]\n ldr ", $high, ", [sp, #", $at, " + 4]\n")
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

/// `r0 d1 - r1 d0` in r0 and r4, of words at `$r0` and `$r1` of the stack and two factors that `$of` loads.
///
/// Lower halves are not negative. Of the middle products only two fit a common word: |d| <= 2^30.
macro_rules! minor {
    ($of:ident, $r0:literal, $d1:literal, $r1:literal, $d0:literal) => {
        concat!(
            word!("r0", "r1", $r0),
            $of!("r2", "r3", $d1),
            // r0, r4: the upper and the lower product. r3, r1: the middle ones.
            "mov r4, r1\n muls r4, r3, r4\n muls r3, r0, r3\n muls r1, r2, r1\n muls r0, r2, r0\n",
            "lsls r2, r3, #16\n asrs r3, r3, #16\n adds r4, r4, r2\n adcs r0, r3\n",
            word!("r2", "r5", $r1),
            $of!("r6", "r7", $d0),
            "mov r3, r2\n muls r3, r6, r3\n muls r2, r7, r2\n muls r6, r5, r6\n muls r5, r7, r5\n",
            "subs r4, r4, r5\n sbcs r0, r3\n subs r1, r1, r6\n",
            "lsls r3, r2, #16\n asrs r2, r2, #16\n subs r4, r4, r3\n sbcs r0, r2\n",
            "lsls r3, r1, #16\n asrs r1, r1, #16\n adds r4, r4, r3\n adcs r0, r1\n",
        )
    };
}

mod arm;
mod lever;
mod numbers;
mod push;
mod quotient;
mod slip;
mod strike;

pub use arm::arm;
pub(super) use lever::lever_words;
pub use numbers::{leading_zeros, times30};
pub(super) use push::add_scaled_words;
pub use push::{add_along, add_turn, push};
pub use quotient::{long_quotient, reciprocal};
pub use slip::excess;
pub use strike::strike;
