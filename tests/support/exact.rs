//! The independent proof of the kernel: exact numbers, the formulas in them, and random cases to try them on.
//!
//! Nothing here computes with the kernel's arithmetic. A test hands the kernel a case, reads the bits of that case back as
//! exact numbers, and compares what the kernel did with what the formulas say.
#![allow(dead_code, unused_imports, unreachable_pub)]

pub mod balance;
pub mod cases;
pub mod format;
pub mod formats;
pub mod hand;
pub mod laws;
pub mod nearest;
pub mod number;
pub mod oracle;
pub mod random;
pub mod rotation;
pub mod strategy;
pub mod words;

pub use cases::{Case, random_case};
pub use format::Format;
pub(crate) use formats::in_formats;
pub use number::{Exact, Vector};
pub use oracle::Problem;
pub use random::Random;

/// The number of cases of a sweep: `short` in an ordinary run, `long` with `CAROM_LONG=1` in the environment, and with
/// any other number there, that number.
pub fn cases_to_run(short: u64, long: u64) -> u64 {
    match std::env::var("CAROM_LONG") {
        Ok(text) => match text.parse() {
            Ok(0) => short,
            Ok(1) | Err(_) => long,
            Ok(count) => count,
        },
        Err(_) => short,
    }
}

/// Calls `step` for each case and tells, in long runs, how far it is.
pub fn sweep(name: &str, count: u64, mut step: impl FnMut(u64)) {
    for i in 0..count {
        if i > 0 && i % 1_000_000 == 0 {
            eprintln!("{name}: {} of {} million", i / 1_000_000, count / 1_000_000);
        }
        step(i);
    }
}

/// The largest of the values seen, with the case that gave it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Worst {
    pub value: f64,
    pub case: u64,
}

impl Worst {
    pub fn see(&mut self, value: f64, case: u64) {
        assert!(!value.is_nan(), "case {case} gives no number");
        if value > self.value {
            *self = Self { value, case };
        }
    }
}

impl std::fmt::Display for Worst {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.3e} = 2^{:.2} (case {})", self.value, self.value.log2(), self.case)
    }
}

/// Fails unless `part` is at least `share` of `whole`: a sweep says how much it covered.
#[track_caller]
pub fn assert_share(what: &str, part: u64, whole: u64, share: f64) {
    assert!(part as f64 >= share * whole as f64, "only {part} of {whole} cases cover {what}");
}
