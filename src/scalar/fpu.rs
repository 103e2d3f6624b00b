//! The floating-point unit's own instructions, an island of `unsafe`: its square root, and rows of the solver.
#![allow(unsafe_code)]

pub(super) mod rows;

use core::arch::asm;

/// The square root of `x` by the FPU's own instruction, correctly rounded; NaN for negative numbers.
///
/// The operand passes through a core register, since rustc takes no `f32` operands in FPU registers here.
#[inline(always)]
pub(super) fn sqrt(x: f32) -> f32 {
    let mut bits = x.to_bits();
    // SAFETY: hard-float targets have an FPU that the start-up code has enabled, or no `f32` operation would run. The
    // instructions read and write the one core register and `s0`, both declared, and touch neither memory nor stack.
    unsafe {
        asm!(
            "vmov s0, {bits}",
            "vsqrt.f32 s0, s0",
            "vmov {bits}, s0",
            bits = inlateout(reg) bits,
            out("s0") _,
            options(pure, nomem, nostack, preserves_flags),
        );
    }
    f32::from_bits(bits)
}
