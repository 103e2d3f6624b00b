//! What an arm does in any direction.

use core::arch::naked_asm;
use core::mem::MaybeUninit;
use core::ptr::from_ref;

use fixed::types::I2F30;

use crate::math::SymMat3;

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
        // On the stack: where the next row of W goes, where that of I^-1 is, the rows of I^-1, at 44 one of them, at 56 r.
        "sub sp, #68",
        "str r0, [sp]",
        "ldm r1!, {{r4, r5, r6}}",
        "add r0, sp, #56",
        "stm r0!, {{r4, r5, r6}}",
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
        "add r3, sp, #44",
        "stm r3!, {{r0, r1, r2}}",
        element!(48, 64, 52, 60, 0),
        element!(52, 56, 44, 64, 4),
        element!(44, 60, 48, 56, 8),
        "adds r1, #12",
        "str r1, [sp]",
        "ldr r0, [sp, #4]",
        "add r1, sp, #44",
        "cmp r0, r1",
        "beq 3f",
        "b 2b",
        "3:",
        "add sp, #68",
        "pop {{r4-r7, pc}}",
    )
}

/// The rows of I^-1 (r x .) without their last 29 places, as those of `machine/rows.rs`, for an arm within 2^30.
#[inline(always)]
pub fn turn_rows(r: &[i32; 3], inv_inertia: &SymMat3<I2F30>) -> [[i32; 3]; 3] {
    let mut rows = MaybeUninit::<[[i32; 3]; 3]>::uninit();
    // SAFETY: the references are to three words and to six; the function reads them, writes all nine of the rows, and keeps to the
    // calling convention.
    unsafe {
        turn_words(rows.as_mut_ptr().cast(), from_ref(r).cast(), from_ref(inv_inertia).cast());
        rows.assume_init()
    }
}
