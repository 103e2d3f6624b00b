//! Products of 32-bit numbers in 64 bits, and sums of them; the caller knows that a sum fits.
//!
//! On Cortex-M an island of `unsafe`: left to itself, the compiler often no longer sees that a factor has 32 bits and makes
//! four instructions of one (Armv7-M), or calls a 64-bit multiplication (Armv6-M). The instructions take and give numbers in
//! registers and compute what `portable` does; `examples/products.rs` compares sums of products, and products of them, with 128-bit arithmetic on the board.

#[cfg(multiply = "long")]
use long::{add_product, multiply};
#[cfg(not(any(multiply = "long", multiply = "short")))]
use portable::{add_product, multiply};
#[cfg(multiply = "short")]
use short::{add_product, multiply};

#[cfg(multiply = "short")]
pub(super) use short::unsigned_product;

#[cfg(not(any(multiply = "long", multiply = "short")))]
mod portable {
    #[inline(always)]
    pub const fn multiply(a: i32, b: i32) -> i64 {
        (a as i64).wrapping_mul(b as i64)
    }

    #[inline(always)]
    pub const fn add_product(sum: i64, a: i32, b: i32) -> i64 {
        sum.wrapping_add(multiply(a, b))
    }
}

/// Armv7-M and Armv8-M Mainline: one instruction each.
#[cfg(multiply = "long")]
#[allow(unsafe_code)]
mod long {
    use core::arch::asm;

    #[inline(always)]
    pub fn multiply(a: i32, b: i32) -> i64 {
        let (low, high): (u32, i32);
        // SAFETY: reads and writes the declared registers, and touches neither memory, stack nor flags.
        unsafe {
            asm!(
                "smull {low}, {high}, {a}, {b}",
                low = lateout(reg) low,
                high = lateout(reg) high,
                a = in(reg) a,
                b = in(reg) b,
                options(pure, nomem, nostack, preserves_flags),
            );
        }
        (high as i64) << 32 | low as i64
    }

    #[inline(always)]
    pub fn add_product(sum: i64, a: i32, b: i32) -> i64 {
        let (mut low, mut high) = (sum as u32, (sum >> 32) as i32);
        // SAFETY: reads and writes the declared registers, and touches neither memory, stack nor flags.
        unsafe {
            asm!(
                "smlal {low}, {high}, {a}, {b}",
                low = inlateout(reg) low,
                high = inlateout(reg) high,
                a = in(reg) a,
                b = in(reg) b,
                options(pure, nomem, nostack, preserves_flags),
            );
        }
        (high as i64) << 32 | low as i64
    }
}

/// Armv6-M and Armv8-M Baseline: from four products of halves, of which the two middle ones most often fit a word together.
#[cfg(multiply = "short")]
#[allow(unsafe_code)]
mod short {
    use core::arch::{asm, naked_asm};

    // Called from assembly, which tells the compiler that memory is left alone.

    #[inline(always)]
    pub fn multiply(a: i32, b: i32) -> i64 {
        let (low, high): (u32, i32);
        // SAFETY: a call with the numbers in the registers where the function takes and leaves them; the others that it changes
        // are declared.
        unsafe {
            asm!(
                "bl {signed}",
                signed = sym signed,
                inout("r0") a => low,
                inout("r1") b => high,
                out("r2") _,
                out("r3") _,
                out("lr") _,
                options(pure, nomem),
            );
        }
        (high as i64) << 32 | low as i64
    }

    #[inline(always)]
    pub fn add_product(sum: i64, a: i32, b: i32) -> i64 {
        let (mut low, mut high) = (sum as u32, (sum >> 32) as i32);
        // SAFETY: as above.
        unsafe {
            asm!(
                "bl {add}",
                add = sym add,
                inout("r0") low,
                inout("r1") high,
                inout("r2") a => _,
                inout("r3") b => _,
                out("r12") _,
                out("lr") _,
                options(pure, nomem),
            );
        }
        (high as i64) << 32 | low as i64
    }

    /// `a b`
    #[inline(always)]
    pub fn unsigned_product(a: u32, b: u32) -> u64 {
        let (low, high): (u32, u32);
        // SAFETY: as above.
        unsafe {
            asm!(
                "bl {unsigned}",
                unsigned = sym unsigned,
                inout("r0") a => low,
                inout("r1") b => high,
                out("r2") _,
                out("r3") _,
                out("lr") _,
                options(pure, nomem),
            );
        }
        (high as u64) << 32 | low as u64
    }

    #[unsafe(naked)]
    extern "C" fn signed(a: i32, b: i32) -> i64 {
        naked_asm!(
            "push {{r4, lr}}",
            // With a = 2^16 a1 + a0 and b = 2^16 b1 + b0, a0 and b0 not negative:
            "uxth r2, r0",
            "uxth r3, r1",
            "asrs r0, r0, #16",
            "asrs r1, r1, #16",
            "mov r4, r2",
            "muls r4, r3, r4", // a0 b0
            "muls r3, r0, r3", // a1 b0
            "muls r2, r1, r2", // a0 b1
            "muls r1, r0, r1", // a1 b1
            "adds r2, r2, r3",
            "bvs 3f",
            "2:",
            "lsls r0, r2, #16",
            "asrs r2, r2, #16",
            "adds r0, r0, r4",
            "adcs r1, r2",
            "pop {{r4, pc}}",
            // Of the other sign, and 2^32 from what it should be.
            "3:",
            "movs r3, #1",
            "lsls r3, r3, #16",
            "cmp r2, #0",
            "blt 4f",
            "subs r1, r1, r3",
            "b 2b",
            "4:",
            "adds r1, r1, r3",
            "b 2b",
        )
    }

    #[unsafe(naked)]
    extern "C" fn add(sum: i64, a: i32, b: i32) -> i64 {
        naked_asm!(
            "push {{r4, r5, lr}}",
            "uxth r4, r2", // a0
            "uxth r5, r3", // b0
            "mov r12, r4",
            "muls r4, r5, r4", // a0 b0
            "asrs r2, r2, #16",
            "muls r5, r2, r5", // a1 b0
            "asrs r3, r3, #16",
            "muls r2, r3, r2", // a1 b1
            "adds r0, r0, r4",
            "adcs r1, r2",
            "mov r4, r12",
            "muls r4, r3, r4", // a0 b1
            "adds r5, r5, r4",
            "bvs 3f",
            "2:",
            "lsls r4, r5, #16",
            "asrs r5, r5, #16",
            "adds r0, r0, r4",
            "adcs r1, r5",
            "pop {{r4, r5, pc}}",
            // As in `signed`.
            "3:",
            "movs r4, #1",
            "lsls r4, r4, #16",
            "cmp r5, #0",
            "blt 4f",
            "subs r1, r1, r4",
            "b 2b",
            "4:",
            "adds r1, r1, r4",
            "b 2b",
        )
    }

    #[unsafe(naked)]
    extern "C" fn unsigned(a: u32, b: u32) -> u64 {
        naked_asm!(
            "push {{r4, lr}}",
            "uxth r2, r0", // a0
            "uxth r3, r1", // b0
            "lsrs r0, r0, #16",
            "lsrs r1, r1, #16",
            "mov r4, r2",
            "muls r4, r3, r4", // a0 b0
            "muls r3, r0, r3", // a1 b0
            "muls r2, r1, r2", // a0 b1
            "muls r1, r0, r1", // a1 b1
            "adds r2, r2, r3",
            "bcs 3f",
            "2:",
            "lsls r0, r2, #16",
            "lsrs r2, r2, #16",
            "adds r0, r0, r4",
            "adcs r1, r2",
            "pop {{r4, pc}}",
            "3:",
            "movs r3, #1",
            "lsls r3, r3, #16",
            "adds r1, r1, r3",
            "b 2b",
        )
    }
}

/// `a b`
#[cfg(not(multiply = "short"))]
#[inline(always)]
pub(super) const fn unsigned_product(a: u32, b: u32) -> u64 {
    (a as u64).wrapping_mul(b as u64)
}

/// `a b`
#[inline(always)]
pub(super) fn product(a: i32, b: i32) -> i64 {
    multiply(a, b)
}

/// `a0 b0 + a1 b1`
#[inline(always)]
pub(super) fn dot2(a: [i32; 2], b: [i32; 2]) -> i64 {
    add_product(multiply(a[0], b[0]), a[1], b[1])
}

/// `a0 b0 + a1 b1 + a2 b2`
#[inline(always)]
pub(super) fn dot(a: [i32; 3], b: [i32; 3]) -> i64 {
    add_product(dot2([a[0], a[1]], [b[0], b[1]]), a[2], b[2])
}

/// `sum + a0 b0 + a1 b1 + a2 b2`
#[inline(always)]
pub(super) fn add_dot(sum: i64, a: [i32; 3], b: [i32; 3]) -> i64 {
    add_product(add_dot2(sum, [a[0], a[1]], [b[0], b[1]]), a[2], b[2])
}

/// `sum + a0 b0 + a1 b1`
#[inline(always)]
pub(super) fn add_dot2(sum: i64, a: [i32; 2], b: [i32; 2]) -> i64 {
    add_product(add_product(sum, a[0], b[0]), a[1], b[1])
}

/// `(b - a) 2^places` for `places` in `0..=30`.
#[cfg(not(multiply = "short"))]
#[inline(always)]
pub(super) fn raised_difference(b: i32, a: i32, places: u32) -> i64 {
    let one = 1i32.wrapping_shl(places);
    dot2([b, a], [one, one.wrapping_neg()])
}

/// `(b - a) 2^places` for `places` in `0..=30`; a shift, where products are dear.
#[cfg(multiply = "short")]
#[inline(always)]
pub(super) fn raised_difference(b: i32, a: i32, places: u32) -> i64 {
    (b as i64).wrapping_sub(a as i64).wrapping_shl(places)
}
