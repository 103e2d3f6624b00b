//! What a row of the solver asks of velocities, as that of `machine/speeds.rs`.
//!
//! The vectors are copied to the stack, from where a word is loaded without a base register; the middle products of the whole sum
//! wait in one word. Where those overflow it, a difference saturates, or the result leaves its range, the portable form does
//! all of it.

use core::arch::naked_asm;

use fixed::types::{I2F30, I32F0};

use crate::math::Vec3;
use crate::scalar::machine::row_words::COLUMN;
use crate::scalar::machine::speeds::{central_speed, lone_speed, pair_speed};
use crate::scalar::step::{Column, Velocity};

/// Adds the product of the words at `$x` and `$y` of the stack to the sum in r7, r6, and to that of the middle products in r1.
macro_rules! add_product {
    ($x:literal, $y:literal, $far:literal) => {
        concat!(
            "ldr r2, [sp, #",
            $x,
            "]\n ldr r3, [sp, #",
            $y,
            "]\n uxth r4, r2\n uxth r5, r3\n asrs r2, r2, #16\n asrs r3, r3, #16\n",
            // x0 y0, x1 y0, x0 y1, x1 y1. A product leaves the carry alone.
            "mov r0, r4\n muls r0, r5, r0\n muls r5, r2, r5\n muls r4, r3, r4\n muls r2, r3, r2\n",
            "adds r7, r7, r0\n adcs r6, r2\n",
            "adds r1, r1, r5\n bvs ",
            $far,
            "\n adds r1, r1, r4\n bvs ",
            $far,
            "\n",
        )
    };
}

/// The sum of three products, of a vector on the stack at `$x0` and one at `$y0`.
macro_rules! add_dot {
    ([$x0:literal, $x1:literal, $x2:literal], [$y0:literal, $y1:literal, $y2:literal], $far:literal) => {
        concat!(add_product!($x0, $y0, $far), add_product!($x1, $y1, $far), add_product!($x2, $y2, $far))
    };
}

/// Pushes the vector at `$from`, which goes on.
macro_rules! copy {
    ($from:literal) => {
        concat!("ldm ", $from, "!, {{r4, r5, r6}}\n push {{r4, r5, r6}}\n")
    };
}

/// Pushes the vector at r2 less that at r1. Both go on.
macro_rules! copy_difference {
    ($far:literal) => {
        concat!(
            "ldm r1!, {{r4, r5, r6}}\n",
            "ldr r7, [r2]\n subs r4, r7, r4\n bvs ",
            $far,
            "\n ldr r7, [r2, #4]\n subs r5, r7, r5\n bvs ",
            $far,
            "\n ldr r7, [r2, #8]\n subs r6, r7, r6\n bvs ",
            $far,
            "\n adds r2, #12\n push {{r4, r5, r6}}\n",
        )
    };
}

/// Sums of nothing.
macro_rules! begin {
    () => {
        "movs r1, #0\n movs r6, #0\n movs r7, #0\n"
    };
}

/// The sum over 2^28, rounded, in r0; to `$far` where it has more than 32 bits.
macro_rules! near {
    ($far:literal) => {
        concat!(
            "lsls r0, r1, #16\n asrs r1, r1, #16\n adds r7, r7, r0\n adcs r6, r1\n",
            "movs r0, #1\n lsls r0, r0, #27\n movs r1, #0\n adds r7, r7, r0\n adcs r6, r1\n",
            "lsrs r7, r7, #28\n lsls r0, r6, #4\n orrs r0, r7\n",
            "asrs r1, r0, #31\n asrs r6, r6, #28\n cmp r1, r6\n bne ",
            $far,
            "\n",
        )
    };
}

/// Leaves the work to the portable form: with the arguments as they were, below `$copies` bytes on the stack.
macro_rules! far {
    ($label:literal, $copies:literal) => {
        concat!($label, ":\n add sp, #", $copies, "\n pop {{r0-r3}}\n bl {far}\n pop {{r3-r7, pc}}\n")
    };
}

#[unsafe(naked)]
pub(in crate::scalar::machine) unsafe extern "C" fn lone_speed_words(
    d: *const i32,
    body: *const i32,
    column: *const i32,
) -> i32 {
    naked_asm!(
        "push {{r3-r7, lr}}",
        "push {{r0-r3}}",
        // On the stack: the arm, w, d, v.
        copy!("r1"),
        copy!("r0"),
        copy!("r1"),
        copy!("r2"),
        begin!(),
        add_dot!([36, 40, 44], [24, 28, 32], "2f"),
        add_dot!([12, 16, 20], [0, 4, 8], "2f"),
        near!("2f"),
        "add sp, #64",
        "pop {{r3-r7, pc}}",
        far!("2", "48"),
        far = sym lone_far,
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
        "push {{r3-r7, lr}}",
        "push {{r0-r3}}",
        // On the stack: B's arm, its w, A's arm, its w, d, the difference of v.
        copy_difference!("4f"),
        copy!("r0"),
        copy!("r1"),
        copy!("r3"),
        copy!("r2"),
        "adds r3, #{column}",
        copy!("r3"),
        begin!(),
        add_dot!([60, 64, 68], [48, 52, 56], "2f"),
        add_product!(36, 24, "2f"),
        // A conditional branch goes no farther than 256 bytes.
        "b 3f",
        far!("2", "72"),
        far!("4", "0"),
        "3:",
        add_product!(40, 28, "2b"),
        add_product!(44, 32, "2b"),
        add_dot!([12, 16, 20], [0, 4, 8], "2b"),
        near!("2b"),
        "add sp, #88",
        "pop {{r3-r7, pc}}",
        far = sym pair_far,
        column = const COLUMN - 12,
    )
}

#[unsafe(naked)]
pub(in crate::scalar::machine) unsafe extern "C" fn central_speed_words(
    d: *const i32,
    a: *const i32,
    b: *const i32,
) -> i32 {
    naked_asm!(
        "push {{r3-r7, lr}}",
        "push {{r0-r3}}",
        // On the stack: d, the difference of v.
        copy_difference!("4f"),
        copy!("r0"),
        begin!(),
        add_dot!([12, 16, 20], [0, 4, 8], "2f"),
        near!("2f"),
        "add sp, #40",
        "pop {{r3-r7, pc}}",
        far!("2", "24"),
        far!("4", "0"),
        far = sym central_far,
    )
}

// For the few speeds that the functions above leave alone. The format makes no difference.

#[cold]
extern "C" fn lone_far(d: &Vec3<I2F30>, body: &Velocity<I32F0>, column: &Column<I32F0>) -> i32 {
    lone_speed(d, body, column).to_bits()
}

#[cold]
extern "C" fn pair_far(d: &Vec3<I2F30>, a: &Velocity<I32F0>, b: &Velocity<I32F0>, columns: &[Column<I32F0>; 2]) -> i32 {
    pair_speed(d, [a, b], columns).to_bits()
}

#[cold]
extern "C" fn central_far(d: &Vec3<I2F30>, a: &Vec3<I32F0>, b: &Vec3<I32F0>) -> i32 {
    central_speed(d, [a, b]).to_bits()
}
