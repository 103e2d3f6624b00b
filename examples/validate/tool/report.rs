//! What is printed at the end.

use std::fmt::Write;

use super::checker::{Checker, Failure, Sample};
use super::errors::QUANTITIES;
use super::number::Number;
use super::statistics::summary;
use super::tolerances::{File, Origin, Rows, Tolerance, Verdict};
use crate::host::HostScalar;

/// The text, and whether all is well.
pub struct Report {
    pub text: String,
    /// Why the run fails, if it does.
    pub problem: Option<String>,
}

/// Rows that are named before the rest is only counted.
const NAMED: usize = 10;

/// What the letters of the measures stand for.
const LEGEND: &str = "
s = |v1| + |v2| + |w1||r1| + |w2||r2|; K: the denominator of (10). Vectors v and w: the larger of before and after.
Inputs as rounded: the kernel alone, against the closed form in f64 for the numbers it was given. What is beyond rounding
the result is in units of u (L |J| + (1 + e) s) / k and its image in v and w: u = 2^-24 in f32, 2^-53 in f64, 2^-30 in
fixed point; L = 1/m1 + 1/m2 + tr I1^-1 |r1|^2 + tr I2^-1 |r2|^2; k: K without friction, with it the least eigenvalue of
the 3x3 inverse mass or, where that is less, what divides on the edge of the cone.
";

/// Tables and verdicts of a run.
pub fn report<S: HostScalar>(file: File, number: Number, checker: &Checker<S>) -> Report {
    let mut text = String::new();
    counts(&mut text, checker);
    tables(&mut text, &checker.samples);
    text.push_str(LEGEND);
    let exceeded = tolerances(&mut text, file, number, &checker.samples);
    Report { text, problem: problem(checker.failures.len(), exceeded) }
}

/// What is wrong with a run, if anything is.
pub fn problem(failed: usize, exceeded: usize) -> Option<String> {
    match (failed, exceeded) {
        (0, 0) => None,
        (0, exceeded) => Some(format!("{exceeded} of the tolerances exceeded")),
        (failed, 0) => Some(format!("{failed} rows failed")),
        (failed, exceeded) => Some(format!("{failed} rows failed, {exceeded} of the tolerances exceeded")),
    }
}

fn counts<S: HostScalar>(text: &mut String, checker: &Checker<S>) {
    let Checker { rows, samples, failures, other_outcome, undetermined, .. } = checker;
    let _ = writeln!(
        text,
        "{rows} rows: {} compared, {} not representable, {} failed",
        samples.len(),
        checker.not_representable(),
        failures.len()
    );
    if !checker.not_representable.is_empty() {
        let list: Vec<_> = checker.not_representable.iter().map(|(category, n)| format!("{category}: {n}")).collect();
        let _ = writeln!(text, "not representable by category: {}", list.join(", "));
    }
    failed(text, failures);
    let _ = writeln!(text, "outcome (separating, stuck, slid) other than expected: {other_outcome}");
    if *undetermined > 0 {
        let _ = writeln!(text, "without a single solution for the numbers as stored: {undetermined}");
    }
}

/// The first of the rows that must not be.
pub fn failed(text: &mut String, failures: &[Failure]) {
    for failure in failures.iter().take(NAMED) {
        let _ = writeln!(text, "failed: row {}: {}", failure.id, failure.reason);
    }
    if failures.len() > NAMED {
        let _ = writeln!(text, "failed: and {} more", failures.len() - NAMED);
    }
}

/// Errors by quantity and category.
pub fn tables(text: &mut String, samples: &[Sample]) {
    let mut categories: Vec<&str> = samples.iter().map(|sample| sample.category.as_str()).collect();
    categories.sort_unstable();
    categories.dedup();
    for quantity in QUANTITIES {
        let line = |text: &mut String, name: &str, all: bool| {
            let chosen = samples.iter().filter(|sample| all || sample.category == name);
            let errors = chosen.map(|sample| (sample.errors.get(quantity), sample.id.as_str()));
            if let Some(s) = summary(errors) {
                let (count, row) = (s.count, &s.row);
                let _ =
                    writeln!(text, "  {name:14} {count:>8} {:>9.1e} {:>9.1e} {:>9.1e}  {row}", s.median, s.p99, s.max);
            }
        };
        let mut lines = String::new();
        for category in &categories {
            line(&mut lines, category, false);
        }
        line(&mut lines, "all", true);
        if !lines.is_empty() {
            let _ = writeln!(text, "\n{}", quantity.label());
            let _ = writeln!(text, "  category           rows    median       p99       max  in row");
            text.push_str(&lines);
        }
    }
}

/// The verdicts; returns how many tolerances were exceeded.
pub fn tolerances(text: &mut String, file: File, number: Number, samples: &[Sample]) -> usize {
    let mut exceeded = 0;
    let _ = writeln!(text, "\ntolerances of {number}\n               worst    bound  in row");
    for entry in Tolerance::of(file, number) {
        let Some(Verdict { worst, row, met }) = entry.judge(samples) else { continue };
        exceeded += usize::from(!met);
        let verdict = if met { "met" } else { "EXCEEDED" };
        let origin = match entry.origin {
            Origin::Required => "required",
            Origin::Found => "found",
        };
        let (measure, rows, bound, reason) = (entry.quantity.label(), rows(entry.rows), entry.bound, entry.reason);
        let _ =
            writeln!(text, "  {verdict:8} {worst:>9.1e} {bound:>8.1e}  {row:6} {measure}{rows}; {origin}: {reason}");
    }
    exceeded
}

fn rows(rows: Rows) -> String {
    match rows {
        Rows::All => String::new(),
        Rows::Clear => " (where |J| > 0.01 s/K)".to_owned(),
        Rows::Q16 => " (rows A to D with q16 = 1)".to_owned(),
        Rows::Most(share) => format!(" (on {} % of the rows)", 100.0 * share),
    }
}
