//! What a row of the solver asks of velocities, and does to them, as `rows.rs` and `speeds.rs` beside it do for others.

use core::arch::naked_asm;
use core::ptr::{from_mut, from_ref};

use fixed::FixedI32;
use fixed::types::I2F30;

use crate::math::Vec3;
use crate::scalar::machine::row_words::COLUMN;

/// Where a result left 32 bits: the end of the range that it went beyond.
macro_rules! end {
    ($label:literal, $x:literal, $back:literal) => {
        concat!($label, ":\n asr ", $x, ", ", $x, ", #31\n eor ", $x, ", ", $x, ", #0x80000000\n b ", $back, "b\n")
    };
}

/// `x += d k / 2^32` rounded, for `x` in `$x` and the number where a last result outside the range comes back to.
macro_rules! along {
    ($x:literal, $d:literal, $k:literal, $far:literal, $back:literal) => {
        concat!(
            // The last bit that leaves by a shift is the carry, and the half that rounds.
            "smull r7, lr, ",
            $d,
            ", ",
            $k,
            "\n lsls r7, r7, #1\n adcs ",
            $x,
            ", ",
            $x,
            ", lr\n bvs ",
            $far,
            "f\n",
            $back,
            ":\n"
        )
    };
}

/// The same for `d k / 2^31`.
macro_rules! turned {
    ($x:literal, $d:literal, $k:literal, $far:literal, $back:literal) => {
        concat!(
            "smull r7, lr, ",
            $d,
            ", ",
            $k,
            "\n lsls r7, r7, #1\n adc lr, lr, lr\n lsls r7, r7, #1\n adcs ",
            $x,
            ", ",
            $x,
            ", lr\n bvs ",
            $far,
            "f\n",
            $back,
            ":\n"
        )
    };
}

/// A function that adds `d k / 2^K` to `v`: `k` moves left by `$up`.
macro_rules! add_along {
    ($name:ident, $part:ident, $up:literal) => {
        #[unsafe(naked)]
        unsafe extern "C" fn $name(v: *mut i32, d: *const i32, k: i32) {
            naked_asm!(
                "push {{r4-r7, lr}}",
                concat!("lsl r2, r2, #", $up),
                "ldm r1, {{r1, r3, r12}}",
                "ldm r0, {{r4, r5, r6}}",
                $part!("r4", "r1", "r2", "21", "31"),
                $part!("r5", "r3", "r2", "22", "32"),
                $part!("r6", "r12", "r2", "23", "33"),
                "stm r0, {{r4, r5, r6}}",
                "pop {{r4-r7, pc}}",
                end!("21", "r4", "31"),
                end!("22", "r5", "32"),
                end!("23", "r6", "33"),
            )
        }
    };
}

add_along!(along_words, along, 4);
add_along!(turn_words, turned, 5);

/// Adds `k` times a direction to `v`, for |k| <= 2^26.
#[inline(always)]
pub fn add_along<F>(v: &mut Vec3<FixedI32<F>>, d: &Vec3<I2F30>, k: i32) {
    // SAFETY: the references are to three words each; the function reads them, writes those of `v`, and keeps to the calling
    // convention.
    unsafe { along_words(from_mut(v).cast(), from_ref(d).cast(), k) }
}

/// Adds `k` times a turn to `w`, for -2^26 <= k < 2^26.
#[inline(always)]
pub fn add_turn<F>(w: &mut Vec3<FixedI32<F>>, turn: &Vec3<I2F30>, k: i32) {
    // SAFETY: as above.
    unsafe { turn_words(from_mut(w).cast(), from_ref(turn).cast(), k) }
}

/// r12, lr: a sum of products. r0: it over 2^28, rounded, or the end of the range.
macro_rules! near {
    ($registers:literal) => {
        concat!(
            "adds r12, r12, #0x8000000\n adc lr, lr, #0\n lsr r0, r12, #28\n orr r0, r0, lr, lsl #4\n",
            "asr r1, lr, #28\n teq r1, r0, asr #31\n bne 4f\n pop {{",
            $registers,
            ", pc}}\n",
            "4:\n mvn r0, #0x80000000\n eor r0, r0, lr, asr #31\n pop {{",
            $registers,
            ", pc}}\n"
        )
    };
}

/// r4 to r6: the vector at r2 less that at r1. Both pointers go on.
macro_rules! difference {
    () => {
        concat!(
            "ldm r1!, {{r4, r5, r6}}\n ldm r2!, {{r7, r8, r10}}\n",
            "subs r4, r7, r4\n bvs 21f\n 31:\n subs r5, r8, r5\n bvs 22f\n 32:\n subs r6, r10, r6\n bvs 23f\n 33:\n"
        )
    };
}

#[unsafe(naked)]
pub(in crate::scalar::machine) unsafe extern "C" fn lone_speed_words(
    d: *const i32,
    body: *const i32,
    column: *const i32,
) -> i32 {
    naked_asm!(
        "push {{r4-r8, r10, lr}}",
        "ldm r0, {{r4, r5, r6}}",
        "ldm r1!, {{r7, r8, r10}}",
        "smull r12, lr, r4, r7",
        "smlal r12, lr, r5, r8",
        "smlal r12, lr, r6, r10",
        "ldm r2, {{r4, r5, r6}}",
        "ldm r1, {{r7, r8, r10}}",
        "smlal r12, lr, r4, r7",
        "smlal r12, lr, r5, r8",
        "smlal r12, lr, r6, r10",
        near!("r4-r8, r10"),
    )
}

#[unsafe(naked)]
pub(in crate::scalar::machine) unsafe extern "C" fn pair_speed_words(
    d: *const i32,
    a: *const i32,
    b: *const i32,
    columns: *const i32,
) -> i32 {
    naked_asm!(
        "push {{r4-r8, r10, lr}}",
        difference!(),
        "ldm r0, {{r7, r8, r10}}",
        "smull r12, lr, r4, r7",
        "smlal r12, lr, r5, r8",
        "smlal r12, lr, r6, r10",
        "ldm r1, {{r4, r5, r6}}",
        "ldm r3, {{r7, r8, r10}}",
        "smlal r12, lr, r4, r7",
        "smlal r12, lr, r5, r8",
        "smlal r12, lr, r6, r10",
        "adds r3, #{column}",
        "ldm r2, {{r4, r5, r6}}",
        "ldm r3, {{r7, r8, r10}}",
        "smlal r12, lr, r4, r7",
        "smlal r12, lr, r5, r8",
        "smlal r12, lr, r6, r10",
        near!("r4-r8, r10"),
        end!("21", "r4", "31"),
        end!("22", "r5", "32"),
        end!("23", "r6", "33"),
        column = const COLUMN,
    )
}

#[unsafe(naked)]
pub(in crate::scalar::machine) unsafe extern "C" fn central_speed_words(
    d: *const i32,
    a: *const i32,
    b: *const i32,
) -> i32 {
    naked_asm!(
        "push {{r4-r8, r10, lr}}",
        difference!(),
        "ldm r0, {{r7, r8, r10}}",
        "smull r12, lr, r4, r7",
        "smlal r12, lr, r5, r8",
        "smlal r12, lr, r6, r10",
        near!("r4-r8, r10"),
        end!("21", "r4", "31"),
        end!("22", "r5", "32"),
        end!("23", "r6", "33"),
    )
}
