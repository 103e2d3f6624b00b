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
