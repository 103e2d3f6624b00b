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

/// Armv6-M and Armv8-M Baseline: from four products of halves.
#[cfg(multiply = "short")]
#[allow(unsafe_code)]
mod short {
    use core::arch::asm;

    #[inline(always)]
    pub fn multiply(a: i32, b: i32) -> i64 {
        add_product(0, a, b)
    }

    #[inline(never)]
    pub fn add_product(sum: i64, a: i32, b: i32) -> i64 {
        let (mut low, mut high) = (sum as u32, (sum >> 32) as i32);
        // SAFETY: reads and writes the declared registers and the flags, and touches neither memory nor stack.
        unsafe {
            asm!(
                // With a = 2^16 a1 + a0 and b = 2^16 b1 + b0, a0 and b0 not negative:
                "uxth {s}, {a}",
                "uxth {t}, {b}",
                "muls {s}, {t}, {s}", // a0 b0
                "mov r12, {a}",
                "asrs {a}, {a}, #16",
                "muls {t}, {a}, {t}", // a1 b0
                "asrs {b}, {b}, #16",
                "muls {a}, {b}, {a}", // a1 b1
                "adds {low}, {low}, {s}",
                "adcs {high}, {a}",
                "mov {s}, r12",
                "uxth {s}, {s}",
                "muls {s}, {b}, {s}", // a0 b1
                "lsls {a}, {t}, #16",
                "asrs {t}, {t}, #16",
                "adds {low}, {low}, {a}",
                "adcs {high}, {t}",
                "lsls {a}, {s}, #16",
                "asrs {s}, {s}, #16",
                "adds {low}, {low}, {a}",
                "adcs {high}, {s}",
                low = inout(reg) low,
                high = inout(reg) high,
                a = inout(reg) a => _,
                b = inout(reg) b => _,
                s = out(reg) _,
                t = out(reg) _,
                out("r12") _,
                options(pure, nomem, nostack),
            );
        }
        (high as i64) << 32 | low as i64
    }

    /// `a b`
    #[inline(never)]
    pub fn unsigned_product(a: u32, b: u32) -> u64 {
        let (low, high): (u32, u32);
        // SAFETY: reads and writes the declared registers and the flags, and touches neither memory nor stack.
        unsafe {
            asm!(
                "uxth {u}, {a}", // a0
                "uxth {t}, {b}", // b0
                "mov {s}, {u}",
                "muls {s}, {t}, {s}", // a0 b0
                "lsrs {a}, {a}, #16",
                "muls {t}, {a}, {t}", // a1 b0
                "lsrs {b}, {b}, #16",
                "muls {u}, {b}, {u}", // a0 b1
                "muls {a}, {b}, {a}", // a1 b1
                "lsls {b}, {t}, #16",
                "lsrs {t}, {t}, #16",
                "adds {s}, {s}, {b}",
                "adcs {a}, {t}",
                "lsls {b}, {u}, #16",
                "lsrs {u}, {u}, #16",
                "adds {s}, {s}, {b}",
                "adcs {a}, {u}",
                a = inout(reg) a => high,
                b = inout(reg) b => _,
                s = out(reg) low,
                t = out(reg) _,
                u = out(reg) _,
                options(pure, nomem, nostack),
            );
        }
        (high as u64) << 32 | low as u64
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
