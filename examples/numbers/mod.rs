//! The number types an example runs in: `--scalar NAME` picks one of those that the build's features hold.
//!
//! A firmware links only the types of its features, so that one built with `fixed` alone holds no float routine.

// Each example uses the part that it needs.
#![allow(dead_code)]

use carom::{Scalar, Scaled};

use crate::board::{self, Exit};

/// A number type with a name, as examples and their output need it.
pub trait Number: Scalar {
    /// As in `--scalar NAME`.
    const NAME: &'static str;

    /// The bits behind the point, in fixed point.
    const FRACTION: Option<u8> = None;

    /// In thousandths, cut off towards zero, for printing: boards print integers only.
    fn milli(self) -> i32;
}

#[cfg(feature = "f32")]
impl Number for f32 {
    const NAME: &'static str = "f32";

    fn milli(self) -> i32 {
        (self * 1000.0) as i32
    }
}

#[cfg(feature = "f64")]
impl Number for f64 {
    const NAME: &'static str = "f64";

    fn milli(self) -> i32 {
        (self * 1000.0) as i32
    }
}

#[cfg(feature = "micromath")]
impl Number for micromath::F32 {
    const NAME: &'static str = "micromath";

    fn milli(self) -> i32 {
        (self.0 * 1000.0) as i32
    }
}

#[cfg(feature = "fixed")]
macro_rules! fixed_number {
    ($($number:ty, $name:literal;)+) => {$(
        impl Number for $number {
            const NAME: &'static str = $name;
            const FRACTION: Option<u8> = Some(Self::FRAC_NBITS as u8);

            fn milli(self) -> i32 {
                // Towards zero, as for floats.
                let cut = (u64::from(self.to_bits().unsigned_abs()).wrapping_mul(1000) >> Self::FRAC_NBITS) as i32;
                if self < Self::ZERO { cut.wrapping_neg() } else { cut }
            }
        }
    )+};
}

#[cfg(feature = "fixed")]
fixed_number! {
    fixed::types::I16F16, "i16f16";
    fixed::types::I12F20, "i12f20";
    fixed::types::I8F24, "i8f24";
}

/// What an example does, in any number type.
pub trait Job {
    /// Three formats of it do not fit 256 KB of flash: firmware leaves I8F24 out.
    const LARGE: bool = false;
    /// Without a choice it runs in each number type of the build, not in the first.
    const EACH: bool = false;

    fn run<S: Number>(&self) -> Exit;
}

/// Runs the job in the type that `--scalar` names, or in the first one of the build, or in each.
pub fn dispatch<J: Job>(job: &J) -> Exit {
    let wanted = board::option("--scalar");
    let each = J::EACH && wanted.is_none();
    // A build without number types changes nothing here.
    #[allow(unused_mut)]
    let mut outcome = None;
    macro_rules! offer {
        ($($feature:literal: $($number:ty),+;)+) => {$($(
            #[cfg(feature = $feature)]
            if wanted.is_none_or(|name| name == <$number>::NAME) && !left_out::<_, $number>(job) {
                let exit = apart::<$number>(job);
                if !each {
                    return exit;
                }
                if outcome != Some(Exit::Failure) {
                    outcome = Some(exit);
                }
            }
        )+)+};
    }
    offer! {
        "f32": f32;
        "fixed": fixed::types::I16F16, fixed::types::I12F20, fixed::types::I8F24;
        "f64": f64;
        "micromath": micromath::F32;
    }
    if let Some(exit) = outcome {
        return exit;
    }
    let _ = (job, each);
    board::println!("this build does not hold the number type {}", wanted.unwrap_or("(none)"));
    if J::LARGE && cfg!(target_os = "none") {
        board::println!("firmware of this example leaves i8f24 out: three fixed-point formats do not fit the flash");
    }
    board::println!("the features f32, fixed, f64 and micromath bring theirs");
    Exit::Failure
}

/// Whether the number type is not in this firmware.
fn left_out<J: Job, S: Number>(_: &J) -> bool {
    J::LARGE && cfg!(target_os = "none") && S::STEP.to_scaled() == S::Scaled::from_parts(1, -24)
}

/// In a frame of its own: what the number types keep on the stack does not add up.
#[inline(never)]
fn apart<S: Number>(job: &impl Job) -> Exit {
    job.run::<S>()
}

/// A decimal number such as `-12.5` or `3e-4`, times `unit`, in the format; `None` where it is none or does not fit.
/// At most nine digits from the first that is not zero.
pub fn decimal<S: Scalar>(text: &str, unit: S::Scaled) -> Option<S> {
    let (mantissa_text, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (digits, negative) = match mantissa_text.strip_prefix('-') {
        Some(rest) => (rest, true),
        None => (mantissa_text.strip_prefix('+').unwrap_or(mantissa_text), false),
    };
    let (mut mantissa, mut places, mut seen_point, mut seen_digit) = (0i32, exponent, false, false);
    for byte in digits.bytes() {
        match byte {
            b'0'..=b'9' => {
                mantissa = mantissa.checked_mul(10)?.checked_add(i32::from(byte.wrapping_sub(b'0')))?;
                places = places.wrapping_sub(i32::from(seen_point));
                seen_digit = true;
            }
            b'.' if !seen_point => seen_point = true,
            _ => return None,
        }
    }
    if !seen_digit {
        return None;
    }
    let ten = S::Scaled::from_parts(10, 0);
    let power = (0..places.unsigned_abs().min(40)).fold(S::Scaled::ONE, |power, _| power * ten);
    let signed = S::Scaled::from_parts(if negative { mantissa.wrapping_neg() } else { mantissa }, 0);
    let value = if places < 0 { signed / power } else { signed * power };
    match S::from_scaled(value * unit) {
        (number, false) => Some(number),
        (_, true) => None,
    }
}
