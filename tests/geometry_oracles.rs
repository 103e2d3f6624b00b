//! Pairs of shapes whose distance and normal are known, with the code of the `validate` example: its tolerances, how much was
//! covered, and that each of them notices a fault. The file is not in the repository: CAROM_VALIDATION names its folder.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/host.rs"]
mod host;
#[path = "support/scalars.rs"]
mod scalars;
#[allow(dead_code)]
#[path = "../examples/validate/tool/mod.rs"]
mod tool;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use carom::Pose;
use host::HostScalar;
use scalars::NUMBERS;
use tool::checker::{Failure, Sample};
use tool::errors::Quantity;
use tool::geometry::{Checker, Found, Geometry, Solid, kernel, read, separation};
use tool::number::{Job, Number};
use tool::tolerances::{File, Origin, TABLE, Tolerance};

/// The pairs, or `None` where they are not at hand.
fn pairs_file() -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("CAROM_VALIDATION") else {
        assert!(std::env::var_os("CI").is_none(), "CAROM_VALIDATION must name the folder of pairs of shapes in CI");
        println!(
            "NOT RUN on pairs of shapes: they are not in the repository, and CAROM_VALIDATION does not name a folder with \
             oracles/geometry_pairs_dev.csv"
        );
        return None;
    };
    let file = PathBuf::from(folder).join("oracles/geometry_pairs_dev.csv");
    assert!(file.is_file(), "CAROM_VALIDATION is set, but there is no {}", file.display());
    Some(file)
}

/// What a run leaves, without its number type.
struct Outcome {
    rows: usize,
    not_representable: usize,
    samples: Vec<Sample>,
    tied: Vec<String>,
    failures: Vec<Failure>,
}

/// The second shape turned upside down.
fn upside_down<S: HostScalar>([a, (b, mut pose)]: [(Solid<'_, S>, Pose<S>); 2]) -> Option<Found> {
    let [x, y, z] = pose.rotation.rows;
    pose.rotation.rows = [y, z, x];
    kernel([a, (b, pose)])
}

struct OnPairs<'a> {
    number: Number,
    file: &'a Path,
    millimetres: bool,
    disguised: [bool; 2],
    flipped: bool,
}

impl Job for OnPairs<'_> {
    type Output = Outcome;
    fn run<S: HostScalar>(self) -> Outcome {
        let run = Geometry {
            file: self.file,
            number: self.number,
            out: None,
            millimetres: self.millimetres,
            disguised: self.disguised,
        };
        let checker = run.check::<S>(if self.flipped { upside_down } else { kernel }).expect("a good file");
        let Checker { rows, not_representable, samples, tied, failures, .. } = checker;
        Outcome { rows, not_representable, samples, tied, failures }
    }
}

fn on_pairs(number: Number, file: &Path, millimetres: bool) -> Outcome {
    scalars::run(number, OnPairs { number, file, millimetres, disguised: [false; 2], flipped: false })
}

#[test]
fn distances_and_normals_of_pairs_of_shapes() {
    let Some(file) = pairs_file() else { return };
    for &number in NUMBERS {
        for millimetres in [false, true] {
            let outcome = on_pairs(number, &file, millimetres);
            assert!(outcome.failures.is_empty(), "{number}: {:?}", outcome.failures);
            assert_eq!((outcome.rows, outcome.not_representable, outcome.samples.len()), (1800, 0, 1800), "{number}");
            // No row of this file has two normals that are equally right.
            assert!(outcome.tied.is_empty(), "{number}: {:?}", outcome.tied);
            let mut counts = BTreeMap::new();
            for sample in &outcome.samples {
                *counts.entry(sample.category.as_str()).or_insert(0) += 1;
            }
            assert_eq!(counts.into_values().collect::<Vec<_>>(), [200; 9], "{number}");
            for entry in Tolerance::of(File::Geometry, number) {
                let verdict = entry.judge(&outcome.samples).expect("rows of its kind");
                let (worst, row, bound) = (verdict.worst, verdict.row, entry.bound);
                assert!(verdict.met, "{number}, {:?}: {worst:e} of {bound:e} in row {row}", entry.quantity);
            }
        }
    }
}

/// A box is the hull of its corners, and a half-space a flat height field, in either place of the pair.
#[test]
fn shapes_that_are_equal_have_equal_distances() {
    let Some(file) = pairs_file() else { return };
    for &number in NUMBERS {
        for disguised in [[true, true], [true, false], [false, true]] {
            let run = OnPairs { number, file: &file, millimetres: false, disguised, flipped: false };
            let outcome = scalars::run(number, run);
            assert!(outcome.failures.is_empty(), "{number}: {:?}", outcome.failures);
            assert_eq!((outcome.samples.len(), outcome.tied.len()), (1800, 0), "{number}");
            for entry in Tolerance::of(File::Disguised, number) {
                let verdict = entry.judge(&outcome.samples).expect("rows of its kind");
                let (worst, row, bound) = (verdict.worst, verdict.row, entry.bound);
                assert!(verdict.met, "{number}, {:?}: {worst:e} of {bound:e} in row {row}", entry.quantity);
            }
        }
    }
}

/// A bound that was found, not required, has little to spare: the worst error is more than a third of it.
#[test]
fn no_tolerance_could_be_tighter() {
    let Some(file) = pairs_file() else { return };
    for entry in TABLE.iter().filter(|entry| entry.files.contains(&File::Geometry) && entry.origin == Origin::Found) {
        let numbers = NUMBERS.iter().filter(|number| entry.numbers.contains(number));
        let samples: Vec<_> = numbers.flat_map(|&number| on_pairs(number, &file, false).samples).collect();
        if samples.is_empty() {
            continue;
        }
        let worst = entry.judge(&samples).expect("rows of its kind").worst;
        println!("{:?} {:?}: {worst:.2e} of {:.2e}", entry.numbers, entry.quantity, entry.bound);
        assert!(3.0 * worst > entry.bound, "{:?} {:?} could be tighter: {worst:e}", entry.numbers, entry.quantity);
    }
}

#[test]
fn the_readme_has_these_figures() {
    let Some(file) = pairs_file() else { return };
    let readme = include_str!("../README.md");
    for &number in NUMBERS {
        let samples = on_pairs(number, &file, false).samples;
        let largest = |quantity| samples.iter().map(|sample| sample.errors.get(quantity)).fold(0.0, f64::max);
        let [distance, normal] = [Quantity::Distance, Quantity::Normal].map(largest);
        let row = format!("| `{number}` | {distance:.1e} | {normal:.1e} |");
        assert!(readme.contains(&row), "the README's row should read\n{row}");
    }
}

#[test]
fn a_shape_that_is_turned_exceeds_every_tolerance() {
    let Some(file) = pairs_file() else { return };
    for &number in NUMBERS {
        let outcome = scalars::run(
            number,
            OnPairs { number, file: &file, millimetres: false, disguised: [false; 2], flipped: true },
        );
        for entry in Tolerance::of(File::Geometry, number) {
            let verdict = entry.judge(&outcome.samples).expect("rows of its kind");
            assert!(!verdict.met, "{number}, {:?}: {:e}", entry.quantity, verdict.worst);
        }
    }
}

/// The file itself: along its normal the shapes are as far apart as it says, by the reach of each, in f64.
#[test]
fn the_file_agrees_with_the_reach_of_its_shapes() {
    let Some(file) = pairs_file() else { return };
    let mut rows = 0;
    read(&file, |pair| {
        let along = separation(&pair.shapes, pair.normal);
        assert!((along - pair.distance).abs() < 1e-10, "row {}: {along} of {}", pair.id, pair.distance);
        rows += 1;
        Ok(())
    })
    .expect("a good file");
    assert_eq!(rows, 1800);
}
