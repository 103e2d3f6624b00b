//! What an impulse spends most on, in instructions of Armv6-M and Armv8-M Baseline: an island of `unsafe`.
//!
//! These cores multiply 32 bits by 32 and keep 32, so a wide product is four products of halves. Taken apart once, a factor
//! serves many products; sums of the two middle products wait until the end of a dot product; and what is left to the compiler
//! passes numbers through memory. Every bit is that of the portable functions: `examples/levers.rs` prints the same hashes of
//! thirty thousand contacts on all cores.
#![allow(unsafe_code)]

use core::arch::{asm, naked_asm};
use core::ptr::{from_mut, from_ref};

use fixed::FixedI32;
use fixed::types::{I2F30, I32F0};

use crate::math::{SymMat3, Vec3};
use crate::scalar::lever32::Lever32;
use crate::scalar::scaled32::Scaled32;
use crate::scalar::stored32;

/// `$r0 $d1 - $r1 $d0` in r0 and r4, of high registers.
///
/// Lower halves are not negative. Of the middle products only two fit a common word: |d| <= 2^30.
macro_rules! minor {
    ($r0:literal, $d1:literal, $r1:literal, $d0:literal) => {
        concat!(
            "mov r0, ",
            $r0,
            "\n uxth r1, r0\n asrs r0, r0, #16\n",
            "mov r2, ",
            $d1,
            "\n uxth r3, r2\n asrs r2, r2, #16\n",
            // r0, r4: the upper and the lower product. r3, r1: the middle ones.
            "mov r4, r1\n muls r4, r3, r4\n muls r3, r0, r3\n muls r1, r2, r1\n muls r0, r2, r0\n",
            "lsls r2, r3, #16\n asrs r3, r3, #16\n adds r4, r4, r2\n adcs r0, r3\n",
            "mov r2, ",
            $r1,
            "\n uxth r5, r2\n asrs r2, r2, #16\n",
            "mov r6, ",
            $d0,
            "\n uxth r7, r6\n asrs r6, r6, #16\n",
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
unsafe extern "C" fn lever_words(
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

/// A lever, as that of `portable.rs`.
#[inline(always)]
pub fn lever<F>(
    r: &Vec3<FixedI32<F>>,
    w: &Vec3<FixedI32<F>>,
    d: &Vec3<I2F30>,
    inv_inertia: &SymMat3<I2F30>,
    exponent: i32,
) -> Lever32 {
    let (r, w, d, inv_inertia) =
        (from_ref(r).cast(), from_ref(w).cast(), from_ref(d).cast(), from_ref(inv_inertia).cast());
    // SAFETY: the references are to three words, or six, each; the function reads those, writes every field of the lever, which
    // is `repr(C)`, and keeps to the calling convention, as does `zeros_of`, which leaves r4 to r11 alone.
    unsafe { lever_words(r, w, d, inv_inertia, exponent) }
}

/// A component of x, at `$at` from r0, and d k / 2^(32 + down) in r2; to `2:` where they leave the range.
///
/// With d = 2^16 d1 + d0, d0 of either sign, the middle products fit a word together: |d| < 2^30.5 and |k| < 2^30.
macro_rules! added {
    ($at:literal) => {
        concat!(
            "ldr r6, [r1, #",
            $at,
            "]\n sxth r7, r6\n subs r6, r6, r7\n asrs r6, r6, #16\n",
            "mov r2, r7\n muls r2, r4, r2\n asrs r2, r2, #16\n muls r7, r5, r7\n adds r7, r7, r2\n",
            "mov r2, r6\n muls r2, r4, r2\n adds r7, r7, r2\n muls r6, r5, r6\n asrs r7, r7, #16\n adds r6, r6, r7\n",
            // The last bit that leaves by a shift is the carry, and the half that rounds.
            "asrs r6, r3\n ldr r2, [r0, #",
            $at,
            "]\n adcs r2, r6\n bvs 2f\n",
        )
    };
}

/// `add_scaled` for vectors of three words.
#[unsafe(naked)]
unsafe extern "C" fn add_scaled_words(x: *mut i32, d: *const i32, k: i32, down: i32) -> bool {
    naked_asm!(
        "push {{r2-r7, lr}}",
        "cmp r3, #1",
        "blt 2f",
        "cmp r3, #31",
        "ble 1f",
        "movs r3, #31",
        "1:",
        "uxth r4, r2",
        "asrs r5, r2, #16",
        added!(0),
        "mov r12, r2",
        added!(4),
        "mov lr, r2",
        added!(8),
        "str r2, [r0, #8]",
        "mov r2, r12",
        "mov r3, lr",
        "stm r0!, {{r2, r3}}",
        "movs r0, #0",
        "pop {{r2-r7, pc}}",
        "2:",
        "ldr r2, [sp]",
        "ldr r3, [sp, #4]",
        "sub sp, #4",
        "bl {far}",
        "add sp, #4",
        "pop {{r2-r7, pc}}",
        far = sym add_far,
    )
}

/// For the few changes that `add_scaled` leaves alone. The format makes no difference.
#[cold]
extern "C" fn add_far(x: &mut Vec3<I32F0>, d: &Vec3<I2F30>, k: i32, down: i32) -> bool {
    stored32::add_far(x, d, k, down)
}

/// Adds `d k / 2^(32 + down)` to `x`, rounded once a component; whether a component met the end of the range. The upper half of
/// `d k` has 29 bits at most.
#[inline(always)]
pub fn add_scaled<F>(x: &mut Vec3<FixedI32<F>>, d: &Vec3<I2F30>, k: i32, down: i32) -> bool {
    // SAFETY: the references are to three words each; the function reads those, writes those of `x` or leaves it to `add_far`,
    // and keeps to the calling convention.
    unsafe { add_scaled_words(from_mut(x).cast(), from_ref(d).cast(), k, down) }
}

/// An element of W without its last 29 places, at `$at` of what the stack's first word points to.
macro_rules! element {
    ($r0:literal, $d1:literal, $r1:literal, $d0:literal, $at:literal) => {
        concat!(
            minor!($r0, $d1, $r1, $d0),
            "lsls r0, r0, #3\n lsrs r4, r4, #29\n orrs r0, r4\n ldr r1, [sp]\n str r0, [r1, #",
            $at,
            "]\n",
        )
    };
}

/// The rows of W = I^-1 (r x .); `r` points to three words, `inv_inertia` to six and `rows` to nine.
#[unsafe(naked)]
unsafe extern "C" fn turn_words(rows: *mut i32, r: *const i32, inv_inertia: *const i32) {
    naked_asm!(
        "push {{r4-r7, lr}}",
        "mov r4, r8",
        "mov r5, r9",
        "mov r6, r10",
        "mov r7, r11",
        "push {{r4-r7}}",
        // On the stack: where the next row of W goes, where that of I^-1 is, and the rows of I^-1.
        "sub sp, #44",
        "str r0, [sp]",
        "ldm r1!, {{r4, r5, r6}}",
        "mov r11, r4",
        "mov r12, r5",
        "mov lr, r6",
        "ldm r2, {{r2, r3, r4, r5, r6, r7}}",
        "add r1, sp, #8",
        "str r1, [sp, #4]",
        "stm r1!, {{r2, r3, r4}}",
        "stm r1!, {{r3, r5, r6}}",
        "stm r1!, {{r4, r6, r7}}",
        "2:",
        "ldr r7, [sp, #4]",
        "ldm r7!, {{r0, r1, r2}}",
        "str r7, [sp, #4]",
        "mov r8, r0",
        "mov r9, r1",
        "mov r10, r2",
        element!("r9", "lr", "r10", "r12", 0),
        element!("r10", "r11", "r8", "lr", 4),
        element!("r8", "r12", "r9", "r11", 8),
        "adds r1, #12",
        "str r1, [sp]",
        "ldr r0, [sp, #4]",
        "add r1, sp, #44",
        "cmp r0, r1",
        "beq 3f",
        "b 2b",
        "3:",
        "add sp, #44",
        "pop {{r4-r7}}",
        "mov r8, r4",
        "mov r9, r5",
        "mov r10, r6",
        "mov r11, r7",
        "pop {{r4-r7, pc}}",
    )
}

/// The rows of I^-1 (r x .) without their last 29 places, as those of `portable.rs`, for an arm within 2^30.
#[inline(always)]
pub fn turn_rows(r: &[i32; 3], inv_inertia: &SymMat3<I2F30>) -> [[i32; 3]; 3] {
    let mut rows = [[0; 3]; 3];
    // SAFETY: the references are to three words, six and nine; the function reads the first two, writes the last, and keeps to the
    // calling convention.
    unsafe { turn_words(from_mut(&mut rows).cast(), from_ref(r).cast(), from_ref(inv_inertia).cast()) }
    rows
}

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

/// A component of `v`, at `$at` from r0, and `d k / 2^K`, of which 32 - K is `$up` and K - 16 is `$down`: r3 and r4 are k in halves.
///
/// |d k| < 2^56 and |k| <= 2^26, so that the middle products fit a word together.
macro_rules! along {
    ($at:literal, $up:literal, $down:literal) => {
        concat!(
            "ldr r5, [r1, #",
            $at,
            "]\n uxth r6, r5\n asrs r5, r5, #16\n",
            "mov r7, r6\n muls r7, r3, r7\n lsrs r7, r7, #16\n muls r6, r4, r6\n adds r7, r7, r6\n",
            "mov r6, r5\n muls r6, r3, r6\n adds r7, r7, r6\n muls r5, r4, r5\n",
            // The last bit that leaves by a shift is the carry, and the half that rounds.
            "lsls r5, r5, #",
            $up,
            "\n asrs r7, r7, #",
            $down,
            "\n adcs r5, r7\n",
            "ldr r2, [r0, #",
            $at,
            "]\n adds r2, r2, r5\n bvc 2f\n",
            "asrs r2, r2, #31\n movs r5, #1\n lsls r5, r5, #31\n eors r2, r5\n",
            "2:\n str r2, [r0, #",
            $at,
            "]\n",
        )
    };
}

/// A function that adds `d k / 2^K` to `v`.
macro_rules! add_along {
    ($name:ident, $up:literal, $down:literal) => {
        #[unsafe(naked)]
        unsafe extern "C" fn $name(v: *mut i32, d: *const i32, k: i32) {
            naked_asm!(
                "push {{r4-r7, lr}}",
                "uxth r3, r2",
                "asrs r4, r2, #16",
                along!(0, $up, $down),
                along!(4, $up, $down),
                along!(8, $up, $down),
                "pop {{r4-r7, pc}}",
            )
        }
    };
}

add_along!(along_words, 4, 12);
add_along!(turn_along_words, 6, 10);

/// Adds `k` times a direction to `v`, for |k| <= 2^26, as that of `rows.rs`.
#[inline(always)]
pub fn add_along<F>(v: &mut Vec3<FixedI32<F>>, d: &Vec3<I2F30>, k: i32) {
    // SAFETY: the references are to three words each; the function reads them, writes those of `v`, and keeps to the calling
    // convention.
    unsafe { along_words(from_mut(v).cast(), from_ref(d).cast(), k) }
}

/// Adds `k` times a turn to `w`, for |k| <= 2^26, as that of `rows.rs`.
#[inline(always)]
pub fn add_turn<F>(w: &mut Vec3<FixedI32<F>>, turn: &Vec3<I2F30>, k: i32) {
    // SAFETY: as above.
    unsafe { turn_along_words(from_mut(w).cast(), from_ref(turn).cast(), k) }
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
extern "C" fn zeros_of(x: u32) -> u32 {
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
