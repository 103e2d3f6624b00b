//! Counts instructions exactly: under `-icount shift=N` QEMU's clock advances by 2^N ns an instruction, and SysTick shows
//! that clock. How many ticks make an instruction is found at run time, with a loop of known length, because the boards
//! clock SysTick differently; N is large enough that one instruction is several ticks.

use super::Call;
use core::ptr::write_volatile;
use core::sync::atomic::{AtomicU32, Ordering};

const CONTROL: *mut u32 = 0xE000_E010 as *mut u32;
const RELOAD: *mut u32 = 0xE000_E014 as *mut u32;
const CURRENT: *mut u32 = 0xE000_E018 as *mut u32;
/// SysTick counts down from here.
const TOP: u32 = 0x00FF_FFFF;
/// It has reached zero since the last look.
const COUNTFLAG: u32 = 1 << 16;

/// Turns of the loop that calibrates.
const TURNS: u32 = 150_000;

/// Ticks of the calibration, and of the empty measurement.
static TICKS: AtomicU32 = AtomicU32::new(0);
static EMPTY: AtomicU32 = AtomicU32::new(0);

// Two readings of SysTick around a call, and around nothing. Between the readings of `bench_count` there is one `blx`, the
// function to its return, and the step from one reading to the next, which is all there is in `bench_count_nothing`.
core::arch::global_asm!(
    ".section .text.bench_count, \"ax\"",
    ".syntax unified",
    ".global bench_count",
    ".type bench_count, %function",
    ".thumb_func",
    "bench_count:",
    "push {{r4, r5, r6, lr}}",
    "mov r6, r0",
    "ldr r4, [r6, #16]",
    "ldr r5, =0xE000E018",
    "ldr r0, [r6, #0]",
    "ldr r1, [r6, #4]",
    "ldr r2, [r6, #8]",
    "ldr r3, [r6, #12]",
    "ldr r6, [r5]",
    "blx r4",
    "ldr r5, [r5]",
    "subs r0, r6, r5",
    "pop {{r4, r5, r6, pc}}",
    ".pool",
    ".size bench_count, . - bench_count",
    ".section .text.bench_count_nothing, \"ax\"",
    ".global bench_count_nothing",
    ".type bench_count_nothing, %function",
    ".thumb_func",
    "bench_count_nothing:",
    "push {{r4, r5, r6, lr}}",
    "ldr r5, =0xE000E018",
    "ldr r6, [r5]",
    "ldr r5, [r5]",
    "subs r0, r6, r5",
    "pop {{r4, r5, r6, pc}}",
    ".pool",
    ".size bench_count_nothing, . - bench_count_nothing",
    // Called with n: 2 n + 2 instructions from the call to the return, both included.
    ".section .text.bench_loop, \"ax\"",
    ".global bench_loop",
    ".type bench_loop, %function",
    ".thumb_func",
    "bench_loop:",
    "subs r0, #1",
    "bne bench_loop",
    "bx lr",
    ".size bench_loop, . - bench_loop",
    // Nine instructions from the call to the return, of the kinds that functions are made of.
    ".section .text.bench_mixture, \"ax\"",
    ".global bench_mixture",
    ".type bench_mixture, %function",
    ".thumb_func",
    "bench_mixture:",
    "push {{r3, r4, r5, lr}}",
    "movs r4, #3",
    "muls r4, r4, r4",
    "str r4, [sp]",
    "ldr r0, [sp]",
    "b 2f",
    "nop",
    "2: nop",
    "pop {{r3, r4, r5, pc}}",
    ".size bench_mixture, . - bench_mixture",
);

unsafe extern "C" {
    fn bench_count(call: *const Call) -> u32;
    fn bench_count_nothing() -> u32;
    fn bench_loop(turns: usize);
    fn bench_mixture();
}

/// Starts the counter, calibrates it, and measures what is known: false when that does not come out exactly.
pub fn start() -> bool {
    // SAFETY: SysTick is there on every Cortex-M that QEMU emulates, and nobody else uses it here.
    unsafe {
        write_volatile(RELOAD, TOP);
        write_volatile(CURRENT, 0);
        // Enabled, without an interrupt, at the processor's clock.
        write_volatile(CONTROL, 0b101);
    }
    restart();
    // SAFETY: it only reads the counter.
    EMPTY.store(unsafe { bench_count_nothing() }, Ordering::Relaxed);
    let Some(ticks) = ticks(&turns(TURNS)) else { return false };
    TICKS.store(ticks, Ordering::Relaxed);
    is_exact()
}

/// Whether what is known comes out exactly.
pub fn is_exact() -> bool {
    let loops = [1, 2, 3, 10, 1_000, 65_537].into_iter().all(|n| instructions(&turns(n)) == Some(2 * n + 2));
    loops && instructions(&Call::new(bench_mixture as *const (), [])) == Some(9)
}

/// Instructions between two readings with nothing between them: subtracted from every count.
pub fn empty() -> u32 {
    to_instructions(EMPTY.load(Ordering::Relaxed))
}

/// Ticks of SysTick for a thousand instructions.
pub fn ticks_per_thousand() -> u32 {
    (u64::from(TICKS.load(Ordering::Relaxed)) * 1000 / u64::from(2 * TURNS + 2)) as u32
}

/// Instructions of a call, from the call to the return, both included; `None` when the counter ran out.
pub fn instructions(call: &Call) -> Option<u32> {
    ticks(call).map(to_instructions)
}

/// The nearest whole number: an instruction is several ticks, and a reading is off by less than one.
fn to_instructions(ticks: u32) -> u32 {
    let calibration = u64::from(TICKS.load(Ordering::Relaxed));
    ((u64::from(ticks) * u64::from(2 * TURNS + 2) + calibration / 2) / calibration) as u32
}

fn ticks(call: &Call) -> Option<u32> {
    restart();
    // SAFETY: `Call` says that the function takes these arguments, and its maker that they are valid.
    let ticks = unsafe { bench_count(call) };
    // SAFETY: as in `start`.
    let ran_out = unsafe { core::ptr::read_volatile(CONTROL) } & COUNTFLAG != 0;
    (!ran_out).then(|| ticks.wrapping_sub(EMPTY.load(Ordering::Relaxed)))
}

/// Back to the top, so that no count passes zero.
fn restart() {
    // SAFETY: as in `start`. Any value sets zero, from where the next tick leads to the top and leaves the flag clear.
    unsafe { write_volatile(CURRENT, 0) };
    // SAFETY: it only counts down.
    unsafe { bench_loop(10) };
}

fn turns(turns: u32) -> Call {
    Call::new(bench_loop as *const (), [core::ptr::without_provenance_mut(turns as usize)])
}
