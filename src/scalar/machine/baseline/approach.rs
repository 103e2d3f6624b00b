//! The impulse of two approaching points.

use core::arch::naked_asm;
use core::mem::offset_of;
use core::ptr::from_ref;

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::LeEqU32;

use super::numbers::zeros_of;
use super::quotient::long_quotient_words;
use crate::math::Vec3;
use crate::scalar::Scaled;
use crate::scalar::lever32::{self, Lever32, places_of_speed};
use crate::scalar::scaled32::Scaled32;
use crate::scalar::wide::bits_of;

/// What a number format makes of the exponents.
#[repr(C)]
struct Places {
    /// By how much the speed of the centres moves right, and by how much less than its arm's places a spin does.
    coarse: i32,
    fewer: i32,
    /// The exponent of c . u for that of its lever.
    of_arm: i32,
    /// The exponent of the quotient for the places that its parts move by.
    of_quotient: i32,
}

impl Places {
    const fn of(frac: i32) -> Self {
        let coarse = places_of_speed(frac);
        Self { coarse, fewer: 32 - frac - coarse, of_arm: 67 - 2 * frac, of_quotient: coarse - frac + 36 }
    }
}

/// A product of a component of the relative velocity, in `$v`, and one of the direction, at `$at` from r2, added to r4 and r6;
/// to `9:` for speeds of which the two middle products do not fit a word together, 2^30 and more.
macro_rules! next {
    ($v:literal, $at:literal) => {
        concat!(
            "mov r3, ",
            $v,
            "\n ldr r0, [r2, #",
            $at,
            "]\n uxth r5, r3\n asrs r3, r3, #16\n uxth r1, r0\n asrs r0, r0, #16\n",
            "mov r7, r5\n muls r7, r1, r7\n muls r1, r3, r1\n muls r3, r0, r3\n muls r5, r0, r5\n",
            "adds r6, r6, r7\n adcs r4, r3\n adds r1, r1, r5\n bvs 9f\n",
            "lsls r5, r1, #16\n asrs r1, r1, #16\n adds r6, r6, r5\n adcs r4, r1\n",
        )
    };
}

/// Adds a spin to the speed in r4 and r6; r7: by how much less than its arm's places it moves right. To `9:` for long arms.
macro_rules! spin {
    ($lever:literal) => {
        concat!(
            "ldr r5, [sp, #",
            $lever,
            "]\n ldr r0, [r5, #{places}]\n subs r0, r0, r7\n bmi 9f\n ldm r5!, {{r1, r3}}\n",
            // By 32 places nothing is left.
            "movs r5, #32\n subs r5, r5, r0\n mov r2, r3\n lsls r2, r5\n lsrs r1, r0\n orrs r1, r2\n asrs r3, r0\n",
            "adds r6, r6, r1\n adcs r4, r3\n",
        )
    };
}

/// The higher of two exponents, in r7.
macro_rules! top {
    ($exponent:literal) => {
        concat!("cmp ", $exponent, ", r7\n ble 1f\n mov r7, ", $exponent, "\n 1:\n")
    };
}

/// A mantissa moved from its exponent to that in r7.
macro_rules! lowered {
    ($mantissa:literal, $exponent:literal) => {
        concat!(
            "subs ",
            $exponent,
            ", r7, ",
            $exponent,
            "\n cmp ",
            $exponent,
            ", #31\n bls 1f\n movs ",
            $exponent,
            ", #31\n 1:\n lsrs ",
            $mantissa,
            ", ",
            $exponent,
            "\n",
        )
    };
}

/// What became of it.
const ELSEWHERE: u32 = 0;
const APPROACHING: u32 = 1;
const PARTING: u32 = 2;

/// The impulse in `j` for approaching points that something can move; `ELSEWHERE` where the speed needs more care.
#[unsafe(naked)]
unsafe extern "C" fn approach_words(
    v_a: *const i32,
    v_b: *const i32,
    d: *const i32,
    factor: u32,
    lever_a: *const Lever32,
    lever_b: *const Lever32,
    inv_mass_a: Scaled32,
    inv_mass_b: Scaled32,
    places: *const Places,
    j: *mut Scaled32,
) -> u32 {
    naked_asm!(
        // On the stack from here on: the factor, at 24 and 28 the levers, at 32 the inverse masses, at 48 the places, at 52 j.
        "push {{r3-r7, lr}}",
        "ldm r0!, {{r4, r5, r6}}",
        "ldm r1!, {{r0, r3, r7}}",
        "subs r4, r0, r4",
        "bvs 9f",
        "subs r5, r3, r5",
        "bvs 9f",
        "subs r6, r7, r6",
        "bvs 9f",
        "mov r12, r5",
        "mov lr, r6",
        // r4, r6: (v_b - v_a) . d
        "ldr r0, [r2]",
        "uxth r5, r4",
        "asrs r4, r4, #16",
        "uxth r1, r0",
        "asrs r0, r0, #16",
        "mov r6, r5",
        "muls r6, r1, r6",
        "muls r1, r4, r1",
        "muls r4, r0, r4",
        "muls r5, r0, r5",
        "adds r1, r1, r5",
        "bvs 9f",
        "lsls r5, r1, #16",
        "asrs r1, r1, #16",
        "adds r6, r6, r5",
        "adcs r4, r1",
        next!("r12", 4),
        next!("lr", 8),
        // The speed at which the points part.
        "ldr r2, [sp, #48]",
        "ldm r2!, {{r0, r7}}",
        "movs r1, #32",
        "subs r1, r1, r0",
        "mov r3, r4",
        "lsls r3, r1",
        "lsrs r6, r0",
        "orrs r6, r3",
        "asrs r4, r0",
        spin!(24),
        spin!(28),
        // What fits a word has too few bits.
        "asrs r0, r4, #31",
        "cmp r0, r4",
        "beq 9f",
        "cmp r4, #0",
        "blt 2f",
        "movs r0, #{parting}",
        "pop {{r3-r7, pc}}",
        "9:",
        "movs r0, #{elsewhere}",
        "pop {{r3-r7, pc}}",
        "2:",
        // r5: the leading 32 bits of the speed.
        "movs r5, #0",
        "rsbs r6, r6, #0",
        "sbcs r5, r4",
        "mov r0, r5",
        "bl {zeros_of}",
        "mov r12, r0",
        "movs r1, #32",
        "subs r1, r1, r0",
        "lsls r5, r0",
        "lsrs r6, r1",
        "orrs r5, r6",
        // r5: the upper half of that times the factor, filled. r12: by how many places.
        "ldr r7, [sp]",
        "uxth r0, r5",
        "lsrs r5, r5, #16",
        "uxth r1, r7",
        "lsrs r7, r7, #16",
        "mov r2, r0",
        "muls r2, r1, r2",
        "muls r1, r5, r1",
        "muls r0, r7, r0",
        "muls r5, r7, r5",
        "lsrs r2, r2, #16",
        "adds r0, r0, r2",
        "adds r0, r0, r1",
        "bcs 6f",
        "5:",
        "lsrs r0, r0, #16",
        "movs r1, #0",
        "adds r5, r5, r0",
        "bmi 2f",
        "1:",
        "adds r1, #1",
        "lsls r5, r5, #1",
        "bpl 1b",
        "add r12, r1",
        "2:",
        // r0: K under the exponent in r7.
        "add r7, sp, #32",
        "ldm r7!, {{r0, r1, r2, r3}}",
        "ldr r7, [sp, #48]",
        "ldr r7, [r7, #8]",
        "ldr r4, [sp, #24]",
        "ldr r4, [r4, #{inverse_mass_exponent}]",
        "adds r4, r4, r7",
        "ldr r6, [sp, #28]",
        "ldr r6, [r6, #{inverse_mass_exponent}]",
        "adds r6, r6, r7",
        "mov r7, r1",
        top!("r3"),
        top!("r4"),
        top!("r6"),
        "adds r7, #1",
        lowered!("r0", "r1"),
        lowered!("r2", "r3"),
        "adds r0, r0, r2",
        "ldr r1, [sp, #24]",
        "ldr r1, [r1, #{inverse_mass}]",
        lowered!("r1", "r4"),
        "adds r0, r0, r1",
        "ldr r1, [sp, #28]",
        "ldr r1, [r1, #{inverse_mass}]",
        lowered!("r1", "r6"),
        "adds r1, r0, r1",
        "bne 2f",
        "movs r0, #{elsewhere}",
        "pop {{r3-r7, pc}}",
        // The factor's lower half is rarely of so many bits.
        "6:",
        "movs r1, #1",
        "lsls r1, r1, #16",
        "adds r5, r5, r1",
        "b 5b",
        "2:",
        // r1: K, of 31 bits at most, filled. r7: the exponent of the quotient.
        "movs r0, #0",
        "1:",
        "adds r0, #1",
        "lsls r1, r1, #1",
        "bpl 1b",
        "subs r7, r0, r7",
        "mov r0, r12",
        "subs r7, r7, r0",
        "ldr r0, [sp, #48]",
        "ldr r0, [r0, #12]",
        "adds r7, r7, r0",
        "mov r0, r5",
        "bl {long_quotient}",
        "cmp r0, #0",
        "bmi 2f",
        "1:",
        "subs r7, #1",
        "lsls r0, r0, #1",
        "bpl 1b",
        "2:",
        "lsrs r0, r0, #2",
        "ldr r1, [sp, #52]",
        "str r0, [r1]",
        "str r7, [r1, #4]",
        "movs r0, #{approaching}",
        "pop {{r3-r7, pc}}",
        zeros_of = sym zeros_of,
        long_quotient = sym long_quotient_words,
        elsewhere = const ELSEWHERE,
        approaching = const APPROACHING,
        parting = const PARTING,
        places = const offset_of!(Lever32, places),
        inverse_mass = const offset_of!(Lever32, inverse_mass),
        inverse_mass_exponent = const offset_of!(Lever32, inverse_mass_exponent),
    )
}

/// `-(1 + e) speed / k`, as that of `lever32.rs`; where the points part, the error says that and no more: `without_impulse`
/// looks at the speed first.
#[inline(always)]
pub fn approach_impulse<F: LeEqU32>(
    factor: u32,
    v: [&Vec3<FixedI32<F>>; 2],
    d: [&Vec3<I2F30>; 2],
    inv_masses: [Scaled32; 2],
    levers: [&Lever32; 2],
) -> Result<Scaled32, (Scaled32, Scaled32)> {
    let mut j = Scaled32::ZERO;
    let places = const { &Places::of(F::I32) };
    let (v_a, v_b, of_b) = (from_ref(v[0]).cast(), from_ref(v[1]).cast(), from_ref(d[1]).cast());
    let ([lever_a, lever_b], [mass_a, mass_b]) = (levers, inv_masses);
    // SAFETY: the references are to three words each, to levers, places and a number, which are all `repr(C)`; the function reads
    // the others, writes the last, and keeps to the calling convention.
    let found = unsafe { approach_words(v_a, v_b, of_b, factor, lever_a, lever_b, mass_a, mass_b, places, &mut j) };
    match found {
        APPROACHING => Ok(j),
        PARTING => Err((Scaled32::ZERO, Scaled32::ONE)),
        _ => elsewhere(factor, [bits_of(v[0]), bits_of(v[1])], d, inv_masses, levers, F::I32),
    }
}

/// For what `approach_words` leaves alone.
#[cold]
#[inline(never)]
fn elsewhere(
    factor: u32,
    v: [[i32; 3]; 2],
    d: [&Vec3<I2F30>; 2],
    inv_masses: [Scaled32; 2],
    levers: [&Lever32; 2],
    frac: i32,
) -> Result<Scaled32, (Scaled32, Scaled32)> {
    lever32::approach_impulse(factor, v, d, inv_masses, levers, frac)
}
