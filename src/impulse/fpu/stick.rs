//! A rebound with friction: the contact's problem, and the impulse if the points stick.
#![allow(unsafe_code)]

use core::arch::naked_asm;

use super::super::{Impact, Outcome};
use super::{INVERSE, MOTION};
use crate::body::Body;
use crate::contact::Contact;

/// (r x .)^T I^-1 (r x .) for I^-1 and r in registers: `$then` follows an entry. By way of s29, s30 and s31.
macro_rules! inverse_mass {
    ([$xx:literal, $xy:literal, $xz:literal, $yy:literal, $yz:literal, $zz:literal], [$x:literal, $y:literal, $z:literal],
     $kxx:literal $then_xx:literal, $kxy:literal $then_xy:literal, $kyy:literal $then_yy:literal,
     $kxz:literal $then_xz:literal, $kyz:literal $then_yz:literal, $kzz:literal $then_zz:literal) => {
        concat!(
            minor!("s29", $yy, $z, $yz, $y),
            minor!("s30", $yz, $z, $zz, $y),
            minor!($kxx, "s29", $z, "s30", $y),
            $then_xx,
            minor!("s29", $yz, $x, $xy, $z),
            minor!("s30", $zz, $x, $xz, $z),
            minor!($kxy, "s29", $z, "s30", $y),
            $then_xy,
            minor!("s31", $xz, $x, $xx, $z),
            minor!($kyy, "s30", $x, "s31", $z),
            $then_yy,
            minor!("s29", $xy, $y, $yy, $x),
            minor!("s30", $xz, $y, $yz, $x),
            minor!($kxz, "s29", $z, "s30", $y),
            $then_xz,
            minor!("s31", $xx, $y, $xy, $x),
            minor!($kyz, "s30", $x, "s31", $z),
            $then_yz,
            minor!($kzz, "s31", $y, "s29", $x),
            $then_zz,
        )
    };
}

/// The bits of the smallest normal number: of limits, those from there on are within the reach of constants.
const LEAST: u32 = f32::MIN_POSITIVE.to_bits();

/// Applies the impulse where the points approach, and puts it into `impact`. What it does not find out it leaves to
/// [`portable`](super::portable): why the points do not approach, and what is beyond the limits below.
///
/// What lies within them is finite, and has no pivot that the portable form would raise further: each is
/// 1/m_a + 1/m_b at least, which is no less than the trace's last digit.
#[unsafe(naked)]
pub(super) unsafe extern "C" fn stick(
    a: &mut Body<f32>,
    b: &mut Body<f32>,
    contact: &Contact<f32>,
    restitution: f32,
    friction: f32,
) -> Impact<f32> {
    naked_asm!(
        ".fpu fpv4-sp-d16",
        "vpush {{s16-s31}}",
        // s0: e. s1: mu. s2-s4: n. s5-s7: r_a. s8-s10: r_b.
        "vldm r3, {{s2-s10}}",
        // s11-s13: v_a. s14-s16: w_a. s17-s19: w_a x r_a.
        "adds r1, r1, #{motion}",
        "vldm r1, {{s11-s16}}",
        minor!("s17", "s15", "s7", "s16", "s6"),
        minor!("s18", "s16", "s5", "s14", "s7"),
        minor!("s19", "s14", "s6", "s15", "s5"),
        // s20-s22: v_b. s23-s25: w_b. s26-s28: w_b x r_b.
        "adds r2, r2, #{motion}",
        "vldm r2, {{s20-s25}}",
        minor!("s26", "s24", "s10", "s25", "s9"),
        minor!("s27", "s25", "s8", "s23", "s10"),
        minor!("s28", "s23", "s9", "s24", "s8"),
        // s11-s13: the relative velocity. s14: along n.
        "vsub.f32 s26, s26, s17",
        "vsub.f32 s27, s27, s18",
        "vsub.f32 s28, s28, s19",
        "vsub.f32 s11, s20, s11",
        "vsub.f32 s12, s21, s12",
        "vsub.f32 s13, s22, s13",
        "vadd.f32 s11, s11, s26",
        "vadd.f32 s12, s12, s27",
        "vadd.f32 s13, s13, s28",
        dot!("s14", ["s11", "s12", "s13"], ["s2", "s3", "s4"]),
        "vpush {{s11-s13}}",
        "vcmp.f32 s14, #0.0",
        "vmrs APSR_nzcv, fpscr",
        "bpl 5f",
        // s15: 1/m_a. s16-s21: I_a^-1. s23-s28: A's share of K.
        "add r12, r1, #{inverse}",
        "vldm r12, {{s15-s21}}",
        inverse_mass!(["s16", "s17", "s18", "s19", "s20", "s21"], ["s5", "s6", "s7"],
            "s23" "", "s24" "", "s26" "", "s25" "", "s27" "", "s28" ""),
        // s16: 1/m_b. s17-s22: I_b^-1. s23-s28: both shares.
        "add r12, r2, #{inverse}",
        "vldm r12, {{s16-s22}}",
        inverse_mass!(["s17", "s18", "s19", "s20", "s21", "s22"], ["s8", "s9", "s10"],
            "s31" "vadd.f32 s23, s23, s31\n ", "s31" "vadd.f32 s24, s24, s31\n ", "s29" "vadd.f32 s26, s26, s29\n ",
            "s31" "vadd.f32 s25, s25, s31\n ", "s30" "vadd.f32 s27, s27, s30\n ", "s31" "vadd.f32 s28, s28, s31\n "),
        // s15: 1/m_a + 1/m_b. s23-s28: K, xx, xy, xz, yy, yz, zz. s16: its trace.
        "vadd.f32 s15, s15, s16",
        "vadd.f32 s23, s15, s23",
        "vadd.f32 s26, s15, s26",
        "vadd.f32 s28, s15, s28",
        "vpush {{s23-s28}}",
        "vadd.f32 s16, s23, s26",
        "vadd.f32 s16, s16, s28",
        // K = L D L^T. s18, s21, s29: 1/D. s19, s20, s22: L, 10, 20, 21.
        "vcmp.f32 s23, s15",
        "vmrs APSR_nzcv, fpscr",
        "bmi 4f",
        "vmov.f32 s17, #1.0",
        "vdiv.f32 s18, s17, s23",
        "vmul.f32 s19, s24, s18",
        "vmul.f32 s20, s25, s18",
        "vmls.f32 s26, s19, s24",
        at_least!("s26", "s15"),
        "vdiv.f32 s21, s17, s26",
        "vmls.f32 s27, s19, s25",
        "vmul.f32 s22, s27, s21",
        "vmls.f32 s28, s20, s25",
        "vmls.f32 s28, s22, s27",
        at_least!("s28", "s15"),
        "vdiv.f32 s29, s17, s28",
        // The bound on the condition has to be above zero and below 64, and the impulse along n below 2^64.
        "vadd.f32 s30, s18, s21",
        "vadd.f32 s30, s30, s29",
        "vmul.f32 s30, s30, s16",
        "vmov r12, s30",
        "sub r12, r12, #{least}",
        "cmp r12, #{well_conditioned}",
        "bhs 4f",
        // s23-s25: the opposite of the impulse, K^-1 (v + e v_n n).
        "vmul.f32 s31, s0, s14",
        "vmla.f32 s11, s2, s31",
        "vmla.f32 s12, s3, s31",
        "vmla.f32 s13, s4, s31",
        "vmls.f32 s12, s19, s11",
        "vmls.f32 s13, s20, s11",
        "vmls.f32 s13, s22, s12",
        "vmul.f32 s25, s13, s29",
        "vmul.f32 s24, s12, s21",
        "vmls.f32 s24, s22, s25",
        "vmul.f32 s23, s11, s18",
        "vmls.f32 s23, s19, s24",
        "vmls.f32 s23, s20, s25",
        // s26: the impulse along n. s27-s29: across it.
        "vnmul.f32 s26, s23, s2",
        "vmls.f32 s26, s24, s3",
        "vmls.f32 s26, s25, s4",
        "vnmul.f32 s27, s26, s2",
        "vnmul.f32 s28, s26, s3",
        "vnmul.f32 s29, s26, s4",
        "vsub.f32 s27, s27, s23",
        "vsub.f32 s28, s28, s24",
        "vsub.f32 s29, s29, s25",
        // The squares of what is across and of the limit, which is finite where the former is less.
        dot!("s30", ["s27", "s28", "s29"], ["s27", "s28", "s29"]),
        "vmul.f32 s31, s1, s26",
        "vmul.f32 s31, s31, s31",
        "vmov r12, s26",
        "sub r12, r12, #{least}",
        "cmp r12, #{moderate}",
        "bhs 4f",
        "vcmp.f32 s30, s31",
        "vmrs APSR_nzcv, fpscr",
        "bpl 3f",
        "vstm r0!, {{s26-s29}}",
        "mov r12, #{stuck}",
        "strh r12, [r0, #{outcome}]",
        "add sp, #36",
        "b {kick}",
        "3:",
        "bls 4f",
        "b {slide}",
        "4:",
        "add sp, #24",
        "5:",
        "add sp, #12",
        "vpop {{s16-s31}}",
        "subs r1, r1, #{motion}",
        "subs r2, r2, #{motion}",
        "b {portable}",
        motion = const MOTION,
        inverse = const INVERSE - MOTION,
        least = const LEAST,
        well_conditioned = const 64.0f32.to_bits() - LEAST,
        moderate = const 1.8446744e19f32.to_bits() - LEAST,
        outcome = const super::OUTCOME,
        stuck = const Outcome::Stuck as u32,
        portable = sym super::portable,
        slide = sym super::slide::slide,
        kick = sym super::kick::kick,
    )
}
