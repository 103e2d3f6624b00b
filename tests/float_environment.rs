//! The check of how floats are computed, against a processor that is told to compute them otherwise.
#![cfg(all(feature = "f32", target_arch = "x86_64"))]

use carom::{FloatEnvironmentError, check_float_environment};
use std::arch::asm;

/// Bits of MXCSR: results flushed to zero; operands taken for zero; rounding down, up, towards zero.
const FLUSH: u32 = 1 << 15;
const ZEROS: u32 = 1 << 6;
const DOWN: u32 = 1 << 13;
const UP: u32 = 1 << 14;

/// The check under other settings of this thread.
fn under(settings: u32) -> Result<(), FloatEnvironmentError> {
    let (mut kept, mut changed) = (0u32, 0u32);
    // SAFETY: the control register is stored and put back; between the two nothing but the check runs, which computes with
    // numbers that the compiler cannot foresee.
    unsafe {
        asm!("stmxcsr [{}]", in(reg) &mut kept, options(nostack));
        changed |= kept | settings;
        asm!("ldmxcsr [{}]", in(reg) &changed, options(nostack));
        let found = check_float_environment();
        asm!("ldmxcsr [{}]", in(reg) &kept, options(nostack));
        found
    }
}

#[test]
fn settings_that_change_results_are_found() {
    assert_eq!(check_float_environment(), Ok(()));
    assert_eq!(under(0), Ok(()));
    assert_eq!(under(FLUSH), Err(FloatEnvironmentError::FlushToZero));
    assert_eq!(under(ZEROS), Err(FloatEnvironmentError::FlushToZero));
    for rounding in [DOWN, UP, DOWN | UP] {
        assert_eq!(under(rounding), Err(FloatEnvironmentError::Rounding), "{rounding:x}");
    }
    assert_eq!(check_float_environment(), Ok(()), "put back");
}

#[test]
fn errors_say_what_to_change() {
    for (error, word) in [
        (FloatEnvironmentError::FlushToZero, "FZ"),
        (FloatEnvironmentError::Rounding, "RMode"),
        (FloatEnvironmentError::DefaultNan, "DN"),
    ] {
        assert!(error.to_string().contains(word), "{error}");
    }
}
