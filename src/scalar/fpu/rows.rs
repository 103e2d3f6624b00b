//! What `float_step/rows.rs` does, for `f32` in the instructions of the floating-point unit: the same operations in the same order.
//!
//! The compiler loads and stores one number at a time; here a vector or two, or what of a column belongs together, is one
//! instruction. Products are added as they stand, each rounded by itself (`vmla` is not fused), so that every bit is the same:
//! the pinned states of the worlds say so, which the host computes by the portable form.

use core::arch::asm;
use core::mem::offset_of;
use core::ptr::{from_mut, from_ref};

use crate::math::Vec3;
use crate::scalar::step::{Column, Velocity};

// Three numbers each; a velocity is two such, a column an arm, a turn and a share. All are `repr(C)`.
const _: () = {
    assert!(size_of::<Velocity<f32>>() == 24 && size_of::<Column<f32>>() == 28);
    assert!(TURN == 12 && offset_of!(Column<f32>, share) == 24);
};

/// A turn is followed by the share.
const TURN: usize = offset_of!(Column<f32>, turn);

#[inline(always)]
pub fn lone_speed(d: &Vec3<f32>, body: &Velocity<f32>, column: &Column<f32>) -> f32 {
    let speed: u32;
    // SAFETY: reads the numbers that the references point to, and writes the declared registers.
    unsafe {
        asm!(
            "vldm {body}, {{s0-s5}}",
            "vldm {d}, {{s6-s8}}",
            "vldm {arm}, {{s9-s11}}",
            "vmul.f32 s0, s0, s6",
            "vmla.f32 s0, s1, s7",
            "vmla.f32 s0, s2, s8",
            "vmul.f32 s3, s3, s9",
            "vmla.f32 s3, s4, s10",
            "vmla.f32 s3, s5, s11",
            "vadd.f32 s0, s0, s3",
            "vmov {speed}, s0",
            body = in(reg) from_ref(body),
            d = in(reg) from_ref(d),
            arm = in(reg) from_ref(&column.arm),
            speed = lateout(reg) speed,
            out("s0") _, out("s1") _, out("s2") _, out("s3") _, out("s4") _, out("s5") _,
            out("s6") _, out("s7") _, out("s8") _, out("s9") _, out("s10") _, out("s11") _,
            options(pure, readonly, nostack, preserves_flags),
        );
    }
    f32::from_bits(speed)
}

#[inline(always)]
pub fn pair_speed(d: &Vec3<f32>, [a, b]: [&Velocity<f32>; 2], columns: &[Column<f32>; 2]) -> f32 {
    let speed: u32;
    // SAFETY: as above.
    unsafe {
        asm!(
            "vldm {a}, {{s0-s5}}",
            "vldm {b}, {{s6-s11}}",
            "vldm {d}, {{s12-s14}}",
            "vsub.f32 s0, s6, s0",
            "vsub.f32 s1, s7, s1",
            "vsub.f32 s2, s8, s2",
            "vmul.f32 s0, s0, s12",
            "vmla.f32 s0, s1, s13",
            "vmla.f32 s0, s2, s14",
            "vldm {arm_a}, {{s12-s14}}",
            "vmul.f32 s3, s3, s12",
            "vmla.f32 s3, s4, s13",
            "vmla.f32 s3, s5, s14",
            "vldm {arm_b}, {{s12-s14}}",
            "vmul.f32 s9, s9, s12",
            "vmla.f32 s9, s10, s13",
            "vmla.f32 s9, s11, s14",
            "vadd.f32 s3, s3, s9",
            "vadd.f32 s0, s0, s3",
            "vmov {speed}, s0",
            a = in(reg) from_ref(a),
            b = in(reg) from_ref(b),
            d = in(reg) from_ref(d),
            arm_a = in(reg) from_ref(&columns[0].arm),
            arm_b = in(reg) from_ref(&columns[1].arm),
            speed = lateout(reg) speed,
            out("s0") _, out("s1") _, out("s2") _, out("s3") _, out("s4") _, out("s5") _,
            out("s6") _, out("s7") _, out("s8") _, out("s9") _, out("s10") _, out("s11") _,
            out("s12") _, out("s13") _, out("s14") _,
            options(pure, readonly, nostack, preserves_flags),
        );
    }
    f32::from_bits(speed)
}

#[inline(always)]
pub fn central_speed(d: &Vec3<f32>, [a, b]: [&Vec3<f32>; 2]) -> f32 {
    let speed: u32;
    // SAFETY: as above.
    unsafe {
        asm!(
            "vldm {a}, {{s0-s2}}",
            "vldm {b}, {{s3-s5}}",
            "vldm {d}, {{s6-s8}}",
            "vsub.f32 s0, s3, s0",
            "vsub.f32 s1, s4, s1",
            "vsub.f32 s2, s5, s2",
            "vmul.f32 s0, s0, s6",
            "vmla.f32 s0, s1, s7",
            "vmla.f32 s0, s2, s8",
            "vmov {speed}, s0",
            a = in(reg) from_ref(a),
            b = in(reg) from_ref(b),
            d = in(reg) from_ref(d),
            speed = lateout(reg) speed,
            out("s0") _, out("s1") _, out("s2") _, out("s3") _, out("s4") _, out("s5") _,
            out("s6") _, out("s7") _, out("s8") _,
            options(pure, readonly, nostack, preserves_flags),
        );
    }
    f32::from_bits(speed)
}

#[inline(always)]
pub fn push(body: &mut Velocity<f32>, d: &Vec3<f32>, column: &Column<f32>, impulse: f32) {
    // SAFETY: reads what the references point to, writes the velocity and the declared registers.
    unsafe {
        asm!(
            "vmov s13, {impulse}",
            "vldm {body}, {{s0-s5}}",
            "vldm {d}, {{s6-s8}}",
            "vldm {turn}, {{s9-s12}}",
            "vmul.f32 s12, s12, s13",
            "vmla.f32 s0, s6, s12",
            "vmla.f32 s1, s7, s12",
            "vmla.f32 s2, s8, s12",
            "vmla.f32 s3, s9, s13",
            "vmla.f32 s4, s10, s13",
            "vmla.f32 s5, s11, s13",
            "vstm {body}, {{s0-s5}}",
            body = in(reg) from_mut(body),
            d = in(reg) from_ref(d),
            turn = in(reg) from_ref(column).wrapping_byte_add(TURN),
            impulse = in(reg) impulse.to_bits(),
            out("s0") _, out("s1") _, out("s2") _, out("s3") _, out("s4") _, out("s5") _,
            out("s6") _, out("s7") _, out("s8") _, out("s9") _, out("s10") _, out("s11") _,
            out("s12") _, out("s13") _,
            options(nostack, preserves_flags),
        );
    }
}

#[inline(always)]
pub fn push_pair([a, b]: [&mut Velocity<f32>; 2], d: &Vec3<f32>, columns: &[Column<f32>; 2], impulse: f32) {
    // SAFETY: as above, for two velocities.
    unsafe {
        asm!(
            "vmov s13, {impulse}",
            "vldm {d}, {{s6-s8}}",
            "vldm {a}, {{s0-s5}}",
            "vldm {turn_a}, {{s9-s12}}",
            "vmul.f32 s12, s12, s13",
            "vmls.f32 s0, s6, s12",
            "vmls.f32 s1, s7, s12",
            "vmls.f32 s2, s8, s12",
            "vmla.f32 s3, s9, s13",
            "vmla.f32 s4, s10, s13",
            "vmla.f32 s5, s11, s13",
            "vstm {a}, {{s0-s5}}",
            "vldm {b}, {{s0-s5}}",
            "vldm {turn_b}, {{s9-s12}}",
            "vmul.f32 s12, s12, s13",
            "vmla.f32 s0, s6, s12",
            "vmla.f32 s1, s7, s12",
            "vmla.f32 s2, s8, s12",
            "vmla.f32 s3, s9, s13",
            "vmla.f32 s4, s10, s13",
            "vmla.f32 s5, s11, s13",
            "vstm {b}, {{s0-s5}}",
            a = in(reg) from_mut(a),
            b = in(reg) from_mut(b),
            d = in(reg) from_ref(d),
            turn_a = in(reg) from_ref(&columns[0]).wrapping_byte_add(TURN),
            turn_b = in(reg) from_ref(&columns[1]).wrapping_byte_add(TURN),
            impulse = in(reg) impulse.to_bits(),
            out("s0") _, out("s1") _, out("s2") _, out("s3") _, out("s4") _, out("s5") _,
            out("s6") _, out("s7") _, out("s8") _, out("s9") _, out("s10") _, out("s11") _,
            out("s12") _, out("s13") _,
            options(nostack, preserves_flags),
        );
    }
}

#[inline(always)]
pub fn thrust(v: &mut Vec3<f32>, d: &Vec3<f32>, share: f32, impulse: f32) {
    let k = share * impulse;
    // SAFETY: as above.
    unsafe {
        asm!(
            "vmov s6, {k}",
            "vldm {v}, {{s0-s2}}",
            "vldm {d}, {{s3-s5}}",
            "vmla.f32 s0, s3, s6",
            "vmla.f32 s1, s4, s6",
            "vmla.f32 s2, s5, s6",
            "vstm {v}, {{s0-s2}}",
            v = in(reg) from_mut(v),
            d = in(reg) from_ref(d),
            k = in(reg) k.to_bits(),
            out("s0") _, out("s1") _, out("s2") _, out("s3") _, out("s4") _, out("s5") _, out("s6") _,
            options(nostack, preserves_flags),
        );
    }
}
