//! Whether floats are computed as IEEE 754 has it: an RTOS, a library or a fast-math flag may have switched that off.

use core::error::Error;
use core::fmt::{Display, Formatter};
use core::hint::black_box;

/// How floats are computed otherwise than carom's results in f32 rest on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FloatEnvironmentError {
    /// Numbers below 2^-126 are taken for zero, or results so small are made zero.
    FlushToZero,
    /// Sums are not rounded to the nearest, ties to even.
    Rounding,
    /// A NaN loses its bits in a sum: states that hold one hash otherwise than elsewhere. Finite ones are the same.
    DefaultNan,
}

impl Display for FloatEnvironmentError {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::FlushToZero => {
                "floats: subnormal numbers are flushed to zero; on Cortex-M clear FZ, bit 24 of FPSCR, and of FPDSCR, with \
                 which interrupts and new tasks begin"
            }
            Self::Rounding => {
                "floats: results are not rounded to the nearest; on Cortex-M clear RMode, bits 22 and 23 of FPSCR, and of FPDSCR"
            }
            Self::DefaultNan => {
                "floats: NaNs lose their bits; on Cortex-M clear DN, bit 25 of FPSCR, and of FPDSCR"
            }
        })
    }
}

impl Error for FloatEnvironmentError {}

#[cfg(feature = "defmt")]
impl defmt::Format for FloatEnvironmentError {
    fn format(&self, f: defmt::Formatter<'_>) {
        match self {
            Self::FlushToZero => {
                defmt::write!(f, "floats: subnormal numbers are flushed to zero: clear FZ in FPSCR and FPDSCR")
            }
            Self::Rounding => defmt::write!(f, "floats: not rounded to the nearest: clear RMode in FPSCR and FPDSCR"),
            Self::DefaultNan => defmt::write!(f, "floats: NaNs lose their bits: clear DN in FPSCR and FPDSCR"),
        }
    }
}

/// Whether f32 is computed here as on the machines where the same bits were seen: subnormal numbers kept, results rounded to the
/// nearest, NaNs passed on.
///
/// Found out by computing, so that it works on any core, with or without an FPU, and for the task and the interrupt that asks: each
/// may have settings of its own. Call it once where the world is stepped. A dozen sums and products.
///
/// # Errors
/// [`FloatEnvironmentError`] says what to change. RISC-V cores with an FPU always make default NaNs; there that is not looked at.
pub fn check_float_environment() -> Result<(), FloatEnvironmentError> {
    let (one, half) = (black_box(1.0f32), black_box(0.5f32));
    let smallest = black_box(f32::MIN_POSITIVE);
    // A result below the normal numbers, and an operand there.
    let below = black_box(smallest * half);
    if below.to_bits() == 0 || black_box(below + below).to_bits() != smallest.to_bits() {
        return Err(FloatEnvironmentError::FlushToZero);
    }
    // Half a unit of the last place of one, and a little more: a tie goes to the even number, more goes up, with either sign.
    let tie = black_box(f32::EPSILON * 0.5);
    let more = black_box(tie * (one + f32::EPSILON));
    let up = one + f32::EPSILON;
    let rounds = |sign: f32| {
        let (one, tie, more) = (black_box(sign), black_box(sign * tie), black_box(sign * more));
        black_box(one + tie) == one && black_box(one + more) == black_box(sign * up)
    };
    if !(rounds(1.0) && rounds(-1.0)) {
        return Err(FloatEnvironmentError::Rounding);
    }
    let nan = black_box(f32::from_bits(0x7fc0_0001));
    if !cfg!(any(target_arch = "riscv32", target_arch = "riscv64")) && black_box(nan + one).to_bits() != nan.to_bits() {
        return Err(FloatEnvironmentError::DefaultNan);
    }
    Ok(())
}
