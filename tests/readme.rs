//! The accuracy tables of the README are what `validate` prints.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/host.rs"]
mod host;
#[path = "support/scalars.rs"]
mod scalars;
#[allow(dead_code)]
#[path = "../examples/validate/tool/mod.rs"]
mod tool;
#[path = "support/validation.rs"]
mod validation;

use std::path::Path;

use host::HostScalar;
use scalars::NUMBERS;
use tool::impulses::Impulses;
use tool::kernel::Setup;
use tool::number::{Job, Number};
use tool::report::report;
use tool::tolerances::File;
use tool::tosses::Tosses;

struct Report(Number);

impl Job for Report {
    type Output = String;
    fn run<S: HostScalar>(self) -> String {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/two_body_impulse_dev.csv");
        let run = Impulses { file: &file, number: self.0, out: None };
        report(File::Impulses, self.0, &run.check::<S>(Setup::resolve).expect("a good file")).text
    }
}

/// The line over all categories under a heading: rows, median, p99, max, row.
fn all<'a>(text: &'a str, heading: &str) -> Vec<&'a str> {
    let section = text.split_once(&format!("\n{heading}\n")).unwrap_or_else(|| panic!("no {heading} in\n{text}")).1;
    let line = section.lines().find(|line| line.trim_start().starts_with("all ")).expect("a line over all");
    line.split_whitespace().skip(1).collect()
}

#[test]
fn the_accuracy_table_is_what_validate_prints() {
    let readme = include_str!("../README.md");
    for &number in NUMBERS {
        let text = scalars::run(number, Report(number));
        let j = all(&text, "J: |dJ| / max(|J|, s/K)");
        let largest = |what: &str| all(&text, what)[3].to_owned();
        let row = format!(
            "| `{number}` | {} | {} | {} | {} | {} | {} | {} |",
            j[0],
            j[1],
            j[3],
            largest("v: largest component of dv"),
            largest("v: largest component of what rounding the inputs costs"),
            largest("w: largest component of dw"),
            largest("w: largest component of what rounding the inputs costs"),
        );
        assert!(readme.contains(&row), "the README's row should read\n{row}");
    }
}

struct Replay<'a>(Number, &'a Path);

impl Job for Replay<'_> {
    type Output = String;
    fn run<S: HostScalar>(self) -> String {
        let run = Tosses { file: self.1, number: self.0, out: None };
        let report = run.run::<S>().expect("a good file");
        assert_eq!(report.problem, None, "{}", report.text);
        report.text
    }
}

/// Position, rotation and face behind the words that a line begins with.
fn scores<'a>(text: &'a str, words: &str) -> [&'a str; 3] {
    let line = text.lines().find_map(|line| line.trim().strip_prefix(words)).expect("a line of scores");
    let cells: Vec<&str> = line.split_whitespace().collect();
    let after = |name| cells[1 + cells.iter().position(|cell| *cell == name).expect("a score")];
    ["position", "rotation", "face"].map(after)
}

/// What `validate tosses` prints in that number type, if it is there.
fn replayed(number: Number) -> Option<String> {
    let file = NUMBERS.contains(&number).then(|| validation::file("cube_tosses/cube_tosses_dev60.csv"))??;
    Some(scalars::run(number, Replay(number, &file)))
}

fn toss_row(number: Number) {
    let Some(text) = replayed(number) else { return };
    let [nominal, least, most] = ["parameters as given", "the least", "the most"].map(|words| scores(&text, words));
    let spread = [0, 1, 2].map(|i| format!("{} to {}", least[i], most[i]));
    let row = format!("| `{number}` | {} | {} |", nominal.join(" | "), spread.join(" | "));
    assert!(include_str!("../README.md").contains(&row), "the README's row should read\n{row}");
}

#[test]
fn the_tosses_in_f32() {
    toss_row(Number::F32);
}

#[test]
fn the_tosses_in_i16f16() {
    toss_row(Number::I16F16);
}

#[test]
fn the_tosses_in_i12f20() {
    toss_row(Number::I12F20);
}

#[test]
fn the_tosses_at_other_frictions() {
    let Some(text) = replayed(Number::F32) else { return };
    let positions = ["0.10", "0.14", "0.18", "0.22", "0.30"].map(|mu| scores(&text, &format!("friction {mu}"))[0]);
    let row = format!("| position in `f32` | {} |", positions.join(" | "));
    assert!(include_str!("../docs/validation.md").contains(&row), "docs/validation.md's row should read\n{row}");
}
