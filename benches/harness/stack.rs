//! How deep a call goes: the stack below it is painted, and what is no longer paint was used.

use super::Call;

/// What is painted at most: far more than any operation takes.
const DEPTH: usize = 8 * 1024;
/// More than the frames between here and the paint.
const MARGIN: usize = 256;

core::arch::global_asm!(
    ".section .text.bench_stack, \"ax\"",
    ".syntax unified",
    ".global bench_stack",
    ".type bench_stack, %function",
    ".thumb_func",
    "bench_stack:",
    "push {{r4, r5, r6, lr}}",
    "mov r6, r0",
    // From `sp - depth` up to the stack pointer that the function is called with.
    "mov r4, sp",
    "subs r4, r4, r1",
    "mov r5, r4",
    "ldr r2, =0xC5A35AC3",
    "2: str r2, [r5]",
    "adds r5, #4",
    "cmp r5, sp",
    "blo 2b",
    "ldr r5, [r6, #16]",
    "ldr r0, [r6, #0]",
    "ldr r1, [r6, #4]",
    "ldr r2, [r6, #8]",
    "ldr r3, [r6, #12]",
    "blx r5",
    // The lowest word that is no longer paint.
    "ldr r2, =0xC5A35AC3",
    "3: cmp r4, sp",
    "bhs 4f",
    "ldr r3, [r4]",
    "cmp r3, r2",
    "bne 4f",
    "adds r4, #4",
    "b 3b",
    "4: mov r0, sp",
    "subs r0, r0, r4",
    "pop {{r4, r5, r6, pc}}",
    ".pool",
    ".size bench_stack, . - bench_stack",
);

unsafe extern "C" {
    fn bench_stack(call: *const Call, depth: usize) -> usize;
    /// Where statics end, as `cortex-m-rt` links them.
    static __euninit: u8;
}

/// Bytes of stack that a call uses below the stack pointer it is called with. `None` when it used all that is painted.
///
/// Never inlined, so that the frame between `here` and the paint is small.
#[inline(never)]
pub fn bytes(call: &Call) -> Option<u32> {
    let here = 0_u32;
    let free = (&raw const here).addr().checked_sub((&raw const __euninit).addr() + MARGIN)?;
    let depth = DEPTH.min(free) / 4 * 4;
    // SAFETY: what is painted lies below every frame in use and above the statics; else as for `counter::instructions`.
    let bytes = unsafe { bench_stack(call, depth) };
    (bytes < depth).then_some(bytes as u32)
}
