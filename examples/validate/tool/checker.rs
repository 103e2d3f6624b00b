//! Runs the kernel on case after case and keeps what is to be said about them.

use std::collections::BTreeMap;

use carom::impulse::Outcome;

use super::closed_form::Solution;
use super::errors::Errors;
use super::kernel::{Found, Setup, holds};
use super::number::Number;
use super::problem::{Mode, Problem, State};
use super::vector::{dot, norm, scale, sub, unit};
use crate::host::HostScalar;

/// An impact and what is known of it.
#[derive(Clone, Debug)]
pub struct Case {
    pub id: String,
    pub category: String,
    /// Its inputs were drawn to suit Q16.16, and its masses are not extreme.
    pub suits_q16: bool,
    pub problem: Problem,
    /// What is right, where that is known.
    pub expected: Option<State>,
    pub mode: Option<Mode>,
}

/// The errors of one case.
#[derive(Clone, Debug)]
pub struct Sample {
    pub id: String,
    pub category: String,
    pub suits_q16: bool,
    pub errors: Errors,
}

/// A row that must not be: which, and why.
#[derive(Clone, Debug)]
pub struct Failure {
    pub id: String,
    pub reason: &'static str,
}

/// All about the cases so far, in one number type.
pub struct Checker<S: HostScalar> {
    number: Number,
    kernel: fn(Setup<S>) -> Found,
    /// The right solution for any numbers, independent of the kernel.
    exact: fn(&Problem) -> Option<Solution>,
    pub rows: usize,
    pub samples: Vec<Sample>,
    pub not_representable: BTreeMap<String, usize>,
    pub failures: Vec<Failure>,
    /// Rows whose outcome is not the one that was expected.
    pub other_outcome: usize,
    /// Rows for which the inputs as stored have no single solution.
    pub undetermined: usize,
}

/// Closer than this to the border between two outcomes, rounding decides which it is.
const BORDER: f64 = 1e-5;

impl<S: HostScalar> Checker<S> {
    pub fn new(number: Number, kernel: fn(Setup<S>) -> Found, exact: fn(&Problem) -> Option<Solution>) -> Self {
        Self {
            number,
            kernel,
            exact,
            rows: 0,
            samples: Vec::new(),
            not_representable: BTreeMap::new(),
            failures: Vec::new(),
            other_outcome: 0,
            undetermined: 0,
        }
    }

    /// What the kernel makes of the case; `None` where the format cannot hold the inputs or the results.
    pub fn check(&mut self, case: &Case) -> Option<Found> {
        self.rows += 1;
        let fits = case.expected.as_ref().is_none_or(|state| {
            // The parts along the normal and across are reported as well.
            let n = unit(case.problem.normal);
            let normal = dot(state.impulse, n);
            let tangential = norm(sub(state.impulse, scale(normal, n)));
            holds::<S>(state) && S::from_f64(normal).is_some() && S::from_f64(tangential).is_some()
        });
        let Some(setup) = fits.then(|| Setup::<S>::new(&case.problem)).flatten() else {
            *self.not_representable.entry(case.category.clone()).or_default() += 1;
            return None;
        };
        let found = (self.kernel)(setup);
        self.judge(case, &setup, &found);
        Some(found)
    }

    fn judge(&mut self, case: &Case, setup: &Setup<S>, found: &Found) {
        let mut fail = |reason| self.failures.push(Failure { id: case.id.clone(), reason });
        match found.outcome {
            Outcome::NotFinite => return fail("the kernel found something that is not finite"),
            _ if found.saturated => return fail("the kernel met the end of the format"),
            _ => {}
        }
        let mut errors = Errors::none();
        let given = (self.exact)(&case.problem);
        if let Some(expected) = &case.expected {
            errors.measure(&case.problem, expected, found, S::spacing);
            if let Some(given) = &given {
                errors.measure_law(&case.problem, expected, &given.state);
            }
        }
        let stored = setup.stored();
        match (self.exact)(&stored) {
            Some(exact) => {
                if !agrees(found.outcome, exact.mode) && exact.margin > BORDER {
                    fail("the outcome is not that of the numbers as stored");
                }
                errors.measure_stored(self.number, &stored, &exact, found, S::spacing);
                if let Some(given) = &given {
                    errors.measure_rounding(&given.state, &exact.state);
                }
            }
            None => self.undetermined += 1,
        }
        if case.mode.is_some_and(|mode| !agrees(found.outcome, mode)) {
            self.other_outcome += 1;
        }
        let Case { id, category, suits_q16, .. } = case;
        self.samples.push(Sample { id: id.clone(), category: category.clone(), suits_q16: *suits_q16, errors });
    }

    pub fn not_representable(&self) -> usize {
        self.not_representable.values().sum()
    }
}

fn agrees(outcome: Outcome, mode: Mode) -> bool {
    matches!(
        (outcome, mode),
        (Outcome::Separating | Outcome::Immovable, Mode::Separating)
            | (Outcome::Stuck, Mode::Stick)
            | (Outcome::Slid, Mode::Slip | Mode::Frictionless)
    )
}
