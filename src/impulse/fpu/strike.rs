//! A rebound without friction: levers, the impulse of (10), and both bodies pushed.
#![allow(unsafe_code)]

use core::arch::naked_asm;

use super::{INVERSE, MOTION, refused};
use crate::body::Body;
use crate::contact::Contact;

/// The bits of the impulse; where there is none, nothing is changed, and it is what [`refused`] returns.
///
/// As A sees it, the normal n points the other way: its lever has c = n x r, and is pushed against n.
#[unsafe(naked)]
pub(super) unsafe extern "C" fn strike(
    a: &mut Body<f32>,
    b: &mut Body<f32>,
    contact: &Contact<f32>,
    restitution: f32,
) -> i32 {
    naked_asm!(
        ".fpu fpv4-sp-d16",
        "vpush {{s16-s31}}",
        // s9: 1 + e. s0-s2: n. s3-s5: r_a. s6-s8: r_b.
        "vmov.f32 s9, #1.0",
        "vadd.f32 s9, s9, s0",
        "vldm r2, {{s0-s8}}",
        // s10: 1/m_a. s11-s16: I_a^-1, xx, xy, xz, yy, yz, zz. s17-s19: c_a.
        "add r3, r0, #{inverse}",
        "vldm r3, {{s10-s16}}",
        "vmul.f32 s17, s1, s5",
        "vmls.f32 s17, s2, s4",
        "vmul.f32 s18, s2, s3",
        "vmls.f32 s18, s0, s5",
        "vmul.f32 s19, s0, s4",
        "vmls.f32 s19, s1, s3",
        // s3-s5: u_a. s20: c_a . u_a.
        "vmul.f32 s3, s11, s17",
        "vmla.f32 s3, s12, s18",
        "vmla.f32 s3, s13, s19",
        "vmul.f32 s4, s12, s17",
        "vmla.f32 s4, s14, s18",
        "vmla.f32 s4, s15, s19",
        "vmul.f32 s5, s13, s17",
        "vmla.f32 s5, s15, s18",
        "vmla.f32 s5, s16, s19",
        "vmul.f32 s20, s17, s3",
        "vmla.f32 s20, s18, s4",
        "vmla.f32 s20, s19, s5",
        // s21-s23: v_a. s24-s26: w_a. s27: w_a . c_a.
        "adds r0, r0, #{motion}",
        "vldm r0, {{s21-s26}}",
        "vmul.f32 s27, s24, s17",
        "vmla.f32 s27, s25, s18",
        "vmla.f32 s27, s26, s19",
        // s11: 1/m_b. s12-s17: I_b^-1. s18, s19, s28: c_b.
        "add r3, r1, #{inverse}",
        "vldm r3, {{s11-s17}}",
        "vmul.f32 s18, s7, s2",
        "vmls.f32 s18, s8, s1",
        "vmul.f32 s19, s8, s0",
        "vmls.f32 s19, s6, s2",
        "vmul.f32 s28, s6, s1",
        "vmls.f32 s28, s7, s0",
        // s6-s8: u_b. s29: c_b . u_b.
        "vmul.f32 s6, s12, s18",
        "vmla.f32 s6, s13, s19",
        "vmla.f32 s6, s14, s28",
        "vmul.f32 s7, s13, s18",
        "vmla.f32 s7, s15, s19",
        "vmla.f32 s7, s16, s28",
        "vmul.f32 s8, s14, s18",
        "vmla.f32 s8, s16, s19",
        "vmla.f32 s8, s17, s28",
        "vmul.f32 s29, s18, s6",
        "vmla.f32 s29, s19, s7",
        "vmla.f32 s29, s28, s8",
        // s20: the denominator of (10).
        "vadd.f32 s20, s20, s29",
        "vadd.f32 s29, s10, s11",
        "vadd.f32 s20, s29, s20",
        // s12-s14: v_b. s15-s17: w_b. s27: the spins' share of the speed.
        "adds r1, r1, #{motion}",
        "vldm r1, {{s12-s17}}",
        "vmul.f32 s29, s15, s18",
        "vmla.f32 s29, s16, s19",
        "vmla.f32 s29, s17, s28",
        "vadd.f32 s27, s27, s29",
        // s29: the speed at which the points part.
        "vsub.f32 s29, s12, s21",
        "vsub.f32 s30, s13, s22",
        "vsub.f32 s31, s14, s23",
        "vmul.f32 s29, s29, s0",
        "vmla.f32 s29, s30, s1",
        "vmla.f32 s29, s31, s2",
        "vadd.f32 s29, s29, s27",
        // s9, r2: j, which is an impulse if it is above zero and finite.
        "vnmul.f32 s9, s9, s29",
        "vdiv.f32 s9, s9, s20",
        "vmov r2, s9",
        "cbz r2, 2f",
        "cmp r2, #{infinity}",
        "bhs 2f",
        "vmul.f32 s10, s10, s9",
        "vmls.f32 s21, s0, s10",
        "vmls.f32 s22, s1, s10",
        "vmls.f32 s23, s2, s10",
        "vmla.f32 s24, s3, s9",
        "vmla.f32 s25, s4, s9",
        "vmla.f32 s26, s5, s9",
        "vstm r0, {{s21-s26}}",
        "vmul.f32 s11, s11, s9",
        "vmla.f32 s12, s0, s11",
        "vmla.f32 s13, s1, s11",
        "vmla.f32 s14, s2, s11",
        "vmla.f32 s15, s6, s9",
        "vmla.f32 s16, s7, s9",
        "vmla.f32 s17, s8, s9",
        "vstm r1, {{s12-s17}}",
        "mov r0, r2",
        "vpop {{s16-s31}}",
        "bx lr",
        "2:",
        "vmov.f32 s0, s29",
        "vmov.f32 s1, s20",
        "vpop {{s16-s31}}",
        "b {refused}",
        motion = const MOTION,
        inverse = const INVERSE,
        infinity = const f32::INFINITY.to_bits(),
        refused = sym refused,
    )
}
