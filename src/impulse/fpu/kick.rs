//! An impulse with friction on both bodies.
#![allow(unsafe_code)]

use core::arch::naked_asm;

use super::{INVERSE, MOTION};

/// Where [`stick`](super::stick::stick) and [`slide`](super::slide::slide) end, with the bodies' velocities at r1 and r2, the arms
/// in s5 to s7 and s8 to s10, and the opposite of the impulse in s23 to s25. The impact has been stored.
#[unsafe(naked)]
pub(super) unsafe extern "C" fn kick() {
    naked_asm!(
        ".fpu fpv4-sp-d16",
        // s11: 1/m_a. s12-s17: I_a^-1. s26-s28: v_a. s29-s31: w_a. s0-s2: r_a x -j.
        "add r12, r1, #{inverse}",
        "vldm r12, {{s11-s17}}",
        "vldm r1, {{s26-s31}}",
        "vmla.f32 s26, s23, s11",
        "vmla.f32 s27, s24, s11",
        "vmla.f32 s28, s25, s11",
        minor!("s0", "s6", "s25", "s7", "s24"),
        minor!("s1", "s7", "s23", "s5", "s25"),
        minor!("s2", "s5", "s24", "s6", "s23"),
        dot!("s3", ["s12", "s13", "s14"], ["s0", "s1", "s2"]),
        "vadd.f32 s29, s29, s3",
        dot!("s3", ["s13", "s15", "s16"], ["s0", "s1", "s2"]),
        "vadd.f32 s30, s30, s3",
        dot!("s3", ["s14", "s16", "s17"], ["s0", "s1", "s2"]),
        "vadd.f32 s31, s31, s3",
        "vstm r1, {{s26-s31}}",
        // The same of B, with r_b x j.
        "add r12, r2, #{inverse}",
        "vldm r12, {{s11-s17}}",
        "vldm r2, {{s26-s31}}",
        "vmls.f32 s26, s23, s11",
        "vmls.f32 s27, s24, s11",
        "vmls.f32 s28, s25, s11",
        minor!("s0", "s10", "s24", "s9", "s25"),
        minor!("s1", "s8", "s25", "s10", "s23"),
        minor!("s2", "s9", "s23", "s8", "s24"),
        dot!("s3", ["s12", "s13", "s14"], ["s0", "s1", "s2"]),
        "vadd.f32 s29, s29, s3",
        dot!("s3", ["s13", "s15", "s16"], ["s0", "s1", "s2"]),
        "vadd.f32 s30, s30, s3",
        dot!("s3", ["s14", "s16", "s17"], ["s0", "s1", "s2"]),
        "vadd.f32 s31, s31, s3",
        "vstm r2, {{s26-s31}}",
        "vpop {{s16-s31}}",
        "bx lr",
        inverse = const INVERSE - MOTION,
    )
}
