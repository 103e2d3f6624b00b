//! A rebound without friction.

use core::arch::naked_asm;
use core::mem::offset_of;

use fixed::FixedI32;
use fixed::types::I32F0;
use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U30};

use super::lever::lever_words;
use super::numbers::zeros_of;
use super::push::push_words;
use super::quotient::long_quotient_words;
use crate::body::Body;
use crate::contact::Contact;
use crate::impulse::{self, Impact, Outcome};
use crate::scalar::lever32::{Lever32, places_of_speed};

/// A product of a component of the relative velocity, in `$v`, and one of the direction, at `$at` from r2, added to r4 and r6.
macro_rules! next {
    ($v:literal, $at:literal) => {
        concat!(
            "mov r3, ",
            $v,
            "\n ldr r0, [r2, #",
            $at,
            "]\n uxth r5, r3\n asrs r3, r3, #16\n uxth r1, r0\n asrs r0, r0, #16\n",
            "mov r7, r5\n muls r7, r1, r7\n muls r1, r3, r1\n muls r3, r0, r3\n muls r5, r0, r5\n",
            "adds r6, r6, r7\n adcs r4, r3\n",
            "adds r1, r1, r5\n bvs 9f\n lsls r5, r1, #16\n asrs r1, r1, #16\n adds r6, r6, r5\n adcs r4, r1\n",
        )
    };
}

/// Adds a spin to the speed in r4 and r6. To `9:` for long arms.
macro_rules! spin {
    ($lever:literal) => {
        concat!(
            "ldr r0, [sp, #",
            $lever,
            " + {places}]\n subs r0, #{fewer}\n bmi 9f\n ldr r1, [sp, #",
            $lever,
            "]\n ldr r3, [sp, #",
            $lever,
            " + 4]\n",
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

/// What is where.
const _: () = {
    assert!(offset_of!(Body<I32F0>, linear_velocity) == 12);
    assert!(offset_of!(Body<I32F0>, inv_mass) == 48);
    assert!(offset_of!(Contact<I32F0>, normal) == 0);
    assert!(offset_of!(Contact<I32F0>, r_a) == 12);
    assert!(offset_of!(Contact<I32F0>, r_b) == 24);
    assert!(offset_of!(Lever32, spin) == 0);
    assert!(offset_of!(Lever32, inverse_mass_exponent) == 32);
    assert!(offset_of!(Impact<I32F0>, normal_impulse) == 0);
    assert!(offset_of!(Impact<I32F0>, friction_impulse) == 4);
    assert!(offset_of!(Impact<I32F0>, outcome) == 16);
    assert!(offset_of!(Impact<I32F0>, saturated) == 17);
    assert!(Outcome::Separating as u8 == 0);
};

/// By how much less than its arm's places a spin moves right.
const fn fewer(frac: i32) -> i32 {
    32 - frac - places_of_speed(frac)
}

/// Whether the shifts of a format are such as the function below has.
const fn is_common(frac: i32) -> bool {
    frac > 0 && fewer(frac) >= 0
}

/// The fraction bits of a common format; for others, which never run the function, those of one that is.
const fn frac(frac: i32) -> i32 {
    if is_common(frac) { frac } else { 16 }
}

/// The impulse along the normal and what it does, as that of `impulse.rs`, to which it leaves what is rare before a body changes.
///
/// As A sees it, the normal points the other way.
#[unsafe(naked)]
unsafe extern "C" fn strike_words<F>(
    a: &mut Body<FixedI32<F>>,
    b: &mut Body<FixedI32<F>>,
    contact: &Contact<FixedI32<F>>,
    restitution: FixedI32<F>,
) -> Impact<FixedI32<F>>
where
    F: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
    naked_asm!(
        // On the stack from here on: at 0 what `push_words` takes, at 12 -n, at 24 and 60 the levers, at 100 where the impact
        // goes, A, B and the contact, at 136 the restitution.
        "push {{r0-r7, lr}}",
        "sub sp, #100",
        "ldm r3!, {{r4, r5, r6}}",
        "rsbs r4, r4, #0",
        "rsbs r5, r5, #0",
        "rsbs r6, r6, #0",
        "add r0, sp, #12",
        "stm r0!, {{r4, r5, r6}}",
        "mov r2, r1",
        "mov r1, r3",
        "add r3, sp, #12",
        "bl {lever_words}",
        "ldr r3, [sp, #112]",
        "ldr r2, [sp, #108]",
        "mov r1, r3",
        "adds r1, #24",
        "add r0, sp, #60",
        "bl {lever_words}",
        "add r0, sp, #104",
        "ldm r0, {{r0, r1, r2}}",
        "adds r0, #12",
        "adds r1, #12",
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
        // r4, r6: (v_b - v_a) . n
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
        "lsls r3, r4, #32 - {coarse}",
        "lsrs r6, r6, #{coarse}",
        "orrs r6, r3",
        "asrs r4, r4, #{coarse}",
        spin!(24),
        spin!(60),
        // What fits a word has too few bits.
        "asrs r0, r4, #31",
        "cmp r0, r4",
        "beq 9f",
        "cmp r4, #0",
        "blt 2f",
        "ldr r0, [sp, #100]",
        "movs r1, #0",
        "movs r2, #0",
        "movs r3, #0",
        "stm r0!, {{r1, r2, r3}}",
        "stm r0!, {{r1, r2}}",
        "add sp, #116",
        "pop {{r4-r7, pc}}",
        "9:",
        "ldr r4, 8f",
        "mov r12, r4",
        "ldr r4, [sp, #132]",
        "mov lr, r4",
        "add sp, #100",
        "pop {{r0-r7}}",
        "add sp, #4",
        "bx r12",
        ".p2align 2",
        "8:",
        ".word {portable}",
        // The nearest e in 0 to 1.
        "3:",
        "mvns r7, r7",
        "lsrs r7, r7, #31",
        "lsls r7, r7, #{frac}",
        "b 4f",
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
        // r7: 1 + e in Q2.30.
        "ldr r7, [sp, #136]",
        "lsrs r0, r7, #{frac}",
        "bne 3b",
        "4:",
        "lsls r7, r7, #30 - {frac}",
        "movs r0, #1",
        "lsls r0, r0, #30",
        "adds r7, r7, r0",
        // r5: the upper half of the speed times that, filled. r12: by how many places.
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
        "add r7, sp, #104",
        "ldm r7!, {{r0, r2}}",
        "adds r0, #{inv_mass}",
        "ldm r0, {{r0, r1}}",
        "adds r2, #{inv_mass}",
        "ldm r2, {{r2, r3}}",
        "ldr r4, [sp, #24 + {inverse_mass_exponent}]",
        "adds r4, #{of_arm}",
        "ldr r6, [sp, #60 + {inverse_mass_exponent}]",
        "adds r6, #{of_arm}",
        "mov r7, r1",
        top!("r3"),
        top!("r4"),
        top!("r6"),
        "adds r7, #1",
        lowered!("r0", "r1"),
        lowered!("r2", "r3"),
        "adds r0, r0, r2",
        "ldr r1, [sp, #24 + {inverse_mass}]",
        lowered!("r1", "r4"),
        "adds r0, r0, r1",
        "ldr r1, [sp, #60 + {inverse_mass}]",
        lowered!("r1", "r6"),
        "adds r1, r0, r1",
        "beq 7f",
        // r1: K, of 31 bits at most, filled. r7: the exponent of the quotient.
        "movs r0, #0",
        "1:",
        "adds r0, #1",
        "lsls r1, r1, #1",
        "bpl 1b",
        "subs r7, r0, r7",
        "mov r0, r12",
        "subs r7, r7, r0",
        "adds r7, #{of_quotient}",
        "mov r0, r5",
        "bl {long_quotient}",
        "cmp r0, #0",
        "bmi 2f",
        "1:",
        "subs r7, #1",
        "lsls r0, r0, #1",
        "bpl 1b",
        "2:",
        "lsrs r4, r0, #2",
        // r4: j. r2: the places by which the report moves right.
        "movs r2, #30 - {frac}",
        "subs r2, r2, r7",
        "ble 7f",
        "cmp r2, #31",
        "bls 1f",
        "movs r2, #31",
        "1:",
        // j, and what of the places by which products move right is the same for both bodies.
        "movs r6, #29 - {frac}",
        "subs r6, r6, r7",
        "mvns r7, r7",
        "subs r7, #2",
        "mov r3, sp",
        "stm r3!, {{r4, r6, r7}}",
        // r4: j to be reported, with the half that rounds as the carry.
        "movs r3, #0",
        "lsrs r4, r2",
        "adcs r4, r3",
        "ldr r0, [sp, #104]",
        "add r1, sp, #12",
        "add r2, sp, #24",
        "mov r3, sp",
        "bl {push_words}",
        "mov r5, r0",
        "ldr r0, [sp, #108]",
        "ldr r1, [sp, #112]",
        "add r2, sp, #60",
        "mov r3, sp",
        "bl {push_words}",
        "orrs r0, r5",
        "lsls r0, r0, #8",
        "adds r0, #{slid}",
        "ldr r1, [sp, #100]",
        "movs r5, #0",
        "movs r6, #0",
        "movs r7, #0",
        "stm r1!, {{r4, r5, r6, r7}}",
        "strh r0, [r1]",
        "add sp, #116",
        "pop {{r4-r7, pc}}",
        "7:",
        "b 9b",
        // The factor's lower half is rarely of so many bits.
        "6:",
        "movs r1, #1",
        "lsls r1, r1, #16",
        "adds r5, r5, r1",
        "b 5b",
        lever_words = sym lever_words,
        zeros_of = sym zeros_of,
        long_quotient = sym long_quotient_words,
        push_words = sym push_words,
        portable = sym portable::<F>,
        frac = const frac(F::I32),
        coarse = const places_of_speed(F::I32),
        fewer = const fewer(frac(F::I32)),
        of_arm = const 67 - 2 * F::I32,
        of_quotient = const places_of_speed(F::I32) - F::I32 + 36,
        places = const offset_of!(Lever32, places),
        inverse_mass = const offset_of!(Lever32, inverse_mass),
        inverse_mass_exponent = const offset_of!(Lever32, inverse_mass_exponent),
        inv_mass = const offset_of!(Body<I32F0>, inv_mass),
        slid = const Outcome::Slid as u8,
    )
}

/// What `strike_words` leaves alone.
#[cold]
extern "C" fn portable<F>(
    a: &mut Body<FixedI32<F>>,
    b: &mut Body<FixedI32<F>>,
    contact: &Contact<FixedI32<F>>,
    restitution: FixedI32<F>,
) -> Impact<FixedI32<F>>
where
    F: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
    impulse::strike(a, b, contact, restitution)
}

/// A rebound without friction, as that of `impulse.rs`.
#[inline(always)]
pub fn strike<F>(
    a: &mut Body<FixedI32<F>>,
    b: &mut Body<FixedI32<F>>,
    contact: &Contact<FixedI32<F>>,
    restitution: FixedI32<F>,
) -> Impact<FixedI32<F>>
where
    F: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
    if !is_common(F::I32) {
        return impulse::strike(a, b, contact, restitution);
    }
    // SAFETY: the function reads and writes the velocities of two bodies, which are distinct, reads their inverse masses and
    // tensors and the contact, all of them `repr(C)` and laid out as the constants above say, writes the impact, and keeps to the
    // calling convention.
    unsafe { strike_words(a, b, contact, restitution) }
}
