//! What an impulse spends most on, in instructions of Armv7-M and Armv8-M Mainline: an island of `unsafe`.
//!
//! The compiler spills what thirteen registers do hold, and knows neither shifts that may go beyond 31 places nor the bit
//! that they leave in the carry. Both functions give every bit that the portable ones give, which the other cores and the host
//! run: `examples/levers.rs` prints the same hashes of thirty thousand contacts on all of them.
#![allow(unsafe_code)]

pub(super) mod rows;

pub use self::rows::{add_along, add_turn};

use core::arch::{asm, naked_asm};
use core::ptr::{from_mut, from_ref};

use fixed::FixedI32;
use fixed::types::extra::Unsigned;
use fixed::types::{I2F30, I32F0};

use super::words::add_far;
use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::lever32::Lever32;
use crate::scalar::scaled32::Scaled32;
use crate::scalar::stored32::clip;

/// A lever; `r` and `d` point to three words each.
#[unsafe(naked)]
pub(super) unsafe extern "C" fn lever_words(r: *const i32, body: *const Body<I32F0>, d: *const i32) -> Lever32 {
    naked_asm!(
        "push {{r4-r11, lr}}",
        // r4, r5, r6: r. r7: the places by which it moves left. A word's sign bits, less one, are the leading zeros of x ^ 2x.
        "ldm r1, {{r4, r5, r6}}",
        "eor r7, r4, r4, lsl #1",
        "eor r8, r5, r5, lsl #1",
        "orr r7, r7, r8",
        "eor r8, r6, r6, lsl #1",
        "orr r7, r7, r8",
        "orr r7, r7, #2",
        "clz r7, r7",
        "lsl r4, r4, r7",
        "lsl r5, r5, r7",
        "lsl r6, r6, r7",
        // lr, r1, r3: c = r x d. r8, r9, r10: d.
        "ldm r3, {{r8, r9, r10}}",
        "rsb r11, r9, #0",
        "smull r12, lr, r5, r10",
        "smlal r12, lr, r6, r11",
        "rsb r11, r10, #0",
        "smull r12, r1, r6, r8",
        "smlal r12, r1, r4, r11",
        "rsb r11, r8, #0",
        "smull r12, r3, r4, r9",
        "smlal r12, r3, r5, r11",
        // w . c
        "adds r2, #24",
        "ldm r2!, {{r4, r5, r6}}",
        "smull r8, r9, r4, lr",
        "smlal r8, r9, r5, r1",
        "smlal r8, r9, r6, r3",
        "strd r8, r9, [r0], #8",
        // r4, r5, r6, r8, r9, r10: I^-1, xx, xy, xz, yy, yz, zz. r12: its exponent.
        "adds r2, #20",
        "ldr r12, [r2, #24]",
        "ldm r2, {{r4, r5, r6, r8, r9, r10}}",
        // r4, r5, r6: u = I^-1 c.
        "smull r2, r11, r4, lr",
        "smlal r2, r11, r5, r1",
        "smlal r2, r11, r6, r3",
        "lsl r11, r11, #3",
        "orr r4, r11, r2, lsr #29",
        "smull r2, r11, r5, lr",
        "smlal r2, r11, r8, r1",
        "smlal r2, r11, r9, r3",
        "lsl r11, r11, #3",
        "orr r5, r11, r2, lsr #29",
        "smull r2, r11, r6, lr",
        "smlal r2, r11, r9, r1",
        "smlal r2, r11, r10, r3",
        "lsl r11, r11, #3",
        "orr r6, r11, r2, lsr #29",
        // r8: the exponent of u.
        "sub r8, r12, r7",
        // r10, r9: c . u. r9, r10: its leading 30 bits and their exponent.
        "smull r9, r10, r4, lr",
        "smlal r9, r10, r5, r1",
        "smlal r9, r10, r6, r3",
        "cmp r10, #0",
        "ble 3f",
        "clz r1, r10",
        "rsb r2, r1, #32",
        "lsl r10, r10, r1",
        "lsr r9, r9, r2",
        "orr r9, r9, r10",
        "lsr r9, r9, #2",
        "2:",
        "sub r10, r8, r7",
        "sub r10, r10, r1",
        "stm r0, {{r4-r10}}",
        "pop {{r4-r11, pc}}",
        // c . u below 2^32, most often zero: r parallel to d.
        "3:",
        "it mi",
        "movmi r9, #0",
        "mov r1, #31",
        "lsrs r9, r9, #3",
        "bne 2b",
        "mov r10, #{lowest}",
        "stm r0, {{r4-r10}}",
        "pop {{r4-r11, pc}}",
        lowest = const Scaled32::LOWEST,
    )
}

/// `add_scaled` for vectors of three words.
#[unsafe(naked)]
pub(super) unsafe extern "C" fn add_scaled_words(x: *mut i32, d: *const i32, k: i32, down: i32) -> bool {
    naked_asm!(
        "cmp r3, #1",
        "blt {far}",
        "push {{r4-r8, lr}}",
        // r4, r5, r6: d. r7, r8, r12: x.
        "ldm r1, {{r4, r5, r6}}",
        "ldm r0, {{r7, r8, r12}}",
        "usat r3, #5, r3",
        // The last bit that leaves by a shift is the carry, and the half that rounds.
        "smull lr, r4, r4, r2",
        "asrs r4, r4, r3",
        "adcs r7, r7, r4",
        "bvs 2f",
        "smull lr, r5, r5, r2",
        "asrs r5, r5, r3",
        "adcs r8, r8, r5",
        "bvs 2f",
        "smull lr, r6, r6, r2",
        "asrs r6, r6, r3",
        "adcs r12, r12, r6",
        "bvs 2f",
        "stm r0, {{r7, r8, r12}}",
        "mov r0, #0",
        "pop {{r4-r8, pc}}",
        "2:",
        "pop {{r4-r8, lr}}",
        "b {far}",
        far = sym add_far,
    )
}

/// Places to move right by: 31 leave of a word as much as more do. `places` is not negative.
#[inline(always)]
pub fn at_most_31(places: i32) -> u32 {
    // Both ends, which is one instruction.
    places.clamp(0, 31) as u32
}

/// `x / 2^places` rounded, ties up, for |x| <= 2^30 and one place or more.
#[inline(always)]
pub fn round_right(mut x: i32, places: i32) -> i32 {
    // SAFETY: reads and writes the declared registers and the flags, and touches neither memory nor stack.
    unsafe {
        asm!(
            "usat {places}, #5, {places}",
            "asrs {x}, {x}, {places}",
            "adc {x}, {x}, #0",
            x = inout(reg) x,
            places = inout(reg) places => _,
            options(pure, nomem, nostack),
        );
    }
    x
}

/// `x / 2^places` cut off. `places` in `0..=31`.
#[inline(always)]
pub fn shift_right(x: i64, places: u32) -> i64 {
    let (mut low, mut high) = (x as u32, (x >> 32) as i32);
    // SAFETY: reads and writes the declared registers, and touches neither memory, stack nor flags.
    unsafe {
        asm!(
            // By 32 places nothing is left.
            "lsr {low}, {low}, {places}",
            "lsl {carried}, {high}, {rest}",
            "orr {low}, {low}, {carried}",
            "asr {high}, {high}, {places}",
            low = inout(reg) low,
            high = inout(reg) high,
            carried = out(reg) _,
            places = in(reg) places,
            rest = in(reg) 32u32.wrapping_sub(places),
            options(pure, nomem, nostack, preserves_flags),
        );
    }
    (high as i64) << 32 | low as i64
}

/// `x 2^places / 2^32` cut off, for results within 32 bits. `places` in `0..=31`.
#[inline(always)]
pub fn shift_left(x: i64, places: u32) -> i32 {
    let mut high = (x >> 32) as i32;
    // SAFETY: reads and writes the declared registers, and touches neither memory, stack nor flags.
    unsafe {
        asm!(
            "lsl {high}, {high}, {places}",
            "lsr {low}, {low}, {rest}",
            "orr {high}, {high}, {low}",
            low = inout(reg) x as u32 => _,
            high = inout(reg) high,
            places = in(reg) places,
            rest = in(reg) 32u32.wrapping_sub(places),
            options(pure, nomem, nostack, preserves_flags),
        );
    }
    high
}

/// One less, where `x` is below zero.
#[inline(always)]
pub fn plus_sign(x: i64) -> i64 {
    let (mut low, mut high) = (x as u32, (x >> 32) as i32);
    // SAFETY: reads and writes the declared registers and the flags, and touches neither memory nor stack.
    unsafe {
        asm!(
            "adds {low}, {low}, {high}, asr #31",
            "adc {high}, {high}, {high}, asr #31",
            low = inout(reg) low,
            high = inout(reg) high,
            options(pure, nomem, nostack),
        );
    }
    (high as i64) << 32 | low as i64
}

/// `x / 2^Frac` rounded and clipped, for a product of 32-bit numbers or the difference of two, and 30 places at most.
///
/// Of two products of the lowest numbers the difference is nearest to the end of 64 bits: it leaves 2^31, more than rounding
/// adds.
#[inline(always)]
pub fn round_product<Frac: Unsigned>(x: i64) -> i32 {
    if Frac::U32 == 0 {
        return clip(x).0;
    }
    let (mut low, high) = (x as u32, (x >> 32) as i32);
    // SAFETY: reads and writes the declared registers and the flags, and touches neither memory nor stack.
    unsafe {
        asm!(
            // Less one where below zero, and a half.
            "adds {low}, {low}, {high}, asr #31",
            "adc {rest}, {high}, {high}, asr #31",
            "adds {low}, {low}, #{half}",
            "adc {rest}, {rest}, #0",
            "lsr {low}, {low}, #{places}",
            "orr {low}, {low}, {rest}, lsl #(32 - {places})",
            // What is left above has to be the sign.
            "asr {rest}, {rest}, #{places}",
            "teq {rest}, {low}, asr #31",
            "itt ne",
            "mvnne {low}, #0x80000000",
            "eorne {low}, {low}, {high}, asr #31",
            low = inout(reg) low,
            high = in(reg) high,
            rest = out(reg) _,
            half = const 1u32 << (at_least_1(Frac::U32) - 1),
            places = const at_least_1(Frac::U32),
            options(pure, nomem, nostack),
        );
    }
    low as i32
}

/// So that instructions that nothing runs can be assembled.
const fn at_least_1(places: u32) -> u32 {
    if places == 0 { 1 } else { places }
}

/// A number above zero moved left until it fills 32 bits, and by how many places.
#[inline(always)]
pub fn filled(x: u32) -> (u32, u32) {
    let (filled, zeros): (u32, u32);
    // SAFETY: reads and writes the declared registers, and touches neither memory, stack nor flags.
    unsafe {
        asm!(
            "clz {zeros}, {x}",
            "lsl {filled}, {x}, {zeros}",
            x = in(reg) x,
            zeros = out(reg) zeros,
            filled = lateout(reg) filled,
            options(pure, nomem, nostack, preserves_flags),
        );
    }
    (filled, zeros)
}

/// Adds `d k / 2^(32 + down)` to `x`, rounded once a component; whether a component met the end of the range. The upper half of
/// `d k` has 29 bits at most.
#[inline(always)]
pub fn add_scaled<F>(x: &mut Vec3<FixedI32<F>>, d: &Vec3<I2F30>, k: i32, down: i32) -> bool {
    // SAFETY: the references are to three words each; the function reads those, writes those of `x` or leaves it to `add_far`,
    // and keeps to the calling convention.
    unsafe { add_scaled_words(from_mut(x).cast(), from_ref(d).cast(), k, down) }
}
