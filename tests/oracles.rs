//! The kernel held against files of impacts whose results are known, with the code of the `validate` example: its table
//! of tolerances, how much was covered, and that each tolerance notices a fault.
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

use host::HostScalar;
use scalars::NUMBERS;
use tool::checker::{Checker, Failure, Sample};
use tool::closed_form;
use tool::errors::{Errors, Quantity};
use tool::impulses::{self, Impulses};
use tool::kernel::{Found, Setup};
use tool::number::{Job, Number};
use tool::planar::{Findings, Planar, newton};
use tool::problem::State;
use tool::tolerances::{File, Origin, Rows, TABLE, Tolerance};
use tool::units::Units;
use tool::vector::{norm, sub};

/// Impacts on which solving row after row never settles: sliding with strong coupling of normal and tangent.
const HARD: [&str; 4] = ["535", "678", "870", "977"];

fn impulses_file() -> PathBuf {
    data("two_body_impulse_dev.csv")
}

fn laws_file() -> PathBuf {
    data("planar_impact_laws.csv")
}

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

/// The measured impacts, which are not part of the repository: `docs/validation.md` tells where they come from.
fn measured_file() -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("CAROM_VALIDATION") else {
        assert!(std::env::var_os("CI").is_none(), "CAROM_VALIDATION must name the folder of measurements in CI");
        println!(
            "NOT RUN on the measured impacts of an ellipse: they are not in the repository, and CAROM_VALIDATION does not \
             name a folder with planar_impacts/ellipse_impacts_dev1000.csv"
        );
        return None;
    };
    let file = PathBuf::from(folder).join("planar_impacts/ellipse_impacts_dev1000.csv");
    assert!(file.is_file(), "CAROM_VALIDATION is set, but there is no {}", file.display());
    Some(file)
}

/// What a run leaves, without its number type.
struct Outcome {
    rows: usize,
    samples: Vec<Sample>,
    not_representable: BTreeMap<String, usize>,
    failures: Vec<Failure>,
    other_outcome: usize,
    undetermined: usize,
}

impl Outcome {
    fn of<S: HostScalar>(checker: Checker<S>) -> Self {
        let Checker { rows, samples, not_representable, failures, other_outcome, undetermined, .. } = checker;
        Self { rows, samples, not_representable, failures, other_outcome, undetermined }
    }

    fn categories(&self) -> BTreeMap<&str, usize> {
        let mut counts = BTreeMap::new();
        for sample in &self.samples {
            *counts.entry(sample.category.as_str()).or_default() += 1;
        }
        counts
    }

    /// No failure, the outcomes of the file, and every tolerance met.
    #[track_caller]
    fn assert_good(&self, file: File, number: Number) {
        assert!(self.failures.is_empty(), "{number}: {:?}", self.failures);
        assert_eq!((self.other_outcome, self.undetermined), (0, 0), "{number}");
        for entry in Tolerance::of(file, number) {
            let verdict = entry.judge(&self.samples).expect("rows of its kind");
            let (worst, row, bound) = (verdict.worst, verdict.row, entry.bound);
            assert!(verdict.met, "{number}, {:?}: {worst:e} of {bound:e} in row {row}", entry.quantity);
        }
    }
}

/// The kernel with the arm of body B turned round: v_r and r x n get a wrong sign.
fn turned_arm<S: HostScalar>(mut setup: Setup<S>) -> Found {
    setup.contact.r_b = -setup.contact.r_b;
    setup.resolve()
}

struct OnImpulses(Number, bool);

impl Job for OnImpulses {
    type Output = Outcome;
    fn run<S: HostScalar>(self) -> Outcome {
        let kernel: fn(Setup<S>) -> Found = if self.1 { turned_arm } else { Setup::resolve };
        let run = Impulses { file: &impulses_file(), number: self.0, out: None };
        Outcome::of(run.check(kernel).expect("a good file"))
    }
}

fn on_impulses(number: Number) -> Outcome {
    scalars::run(number, OnImpulses(number, false))
}

/// A planar run: its outcome, rows skipped, rows unsolved, and distances to what was measured.
struct Plane {
    outcome: Outcome,
    units: Units,
    skipped: usize,
    unsolved: usize,
    distances: Vec<f64>,
}

struct OnPlane<'a>(Number, &'a Path, bool);

impl Job for OnPlane<'_> {
    type Output = Plane;
    fn run<S: HostScalar>(self) -> Plane {
        let kernel: fn(Setup<S>) -> Found = if self.2 { turned_arm } else { Setup::resolve };
        let run = Planar { file: self.1, number: self.0, out: None, mu: None, restitution: None };
        let Findings { checker, units, skipped, unsolved, distances } = run.check(kernel).expect("a good file");
        let distances = distances.into_iter().map(|(distance, _)| distance).collect();
        Plane { outcome: Outcome::of(checker), units, skipped, unsolved, distances }
    }
}

fn on_plane(number: Number, file: &Path) -> Plane {
    scalars::run(number, OnPlane(number, file, false))
}

#[test]
fn two_bodies_in_space() {
    for &number in NUMBERS {
        let outcome = on_impulses(number);
        outcome.assert_good(File::Impulses, number);
        assert_eq!(outcome.rows, 1000);
        // Inverse masses and tensors carry their own exponent: only velocities and impulses have to fit.
        let left_out: &[(&str, usize)] = match number {
            Number::I8F24 => &[("A", 6), ("C", 1)],
            _ => &[],
        };
        let left_out: BTreeMap<_, _> = left_out.iter().copied().collect();
        let missing: BTreeMap<_, _> = outcome.not_representable.iter().map(|(c, n)| (c.as_str(), *n)).collect();
        assert_eq!(missing, left_out, "{number}");
        for (category, count) in [("A", 250), ("B", 250), ("C", 300), ("D", 100), ("E", 100)] {
            let compared = outcome.categories()[category];
            assert_eq!(compared + missing.get(category).unwrap_or(&0), count, "{number}, {category}");
        }
    }
}

/// In this file the requirements hold on every row, those with a nearly cancelling approach speed included.
#[test]
fn no_row_of_the_file_is_excused() {
    for &number in NUMBERS {
        let outcome = on_impulses(number);
        for entry in Tolerance::of(File::Impulses, number).filter(|entry| entry.origin == Origin::Required) {
            if entry.rows == Rows::Q16 {
                let count = outcome.samples.iter().filter(|sample| entry.is_for(sample)).count();
                assert_eq!(count, 900, "{number}, {:?}", entry.quantity);
            } else if entry.rows == Rows::Clear {
                let every = Tolerance { rows: Rows::All, ..*entry };
                assert!(every.judge(&outcome.samples).expect("rows").met, "{number}, {:?}", entry.quantity);
            }
        }
    }
}

#[test]
fn rows_that_iteration_row_by_row_never_settles() {
    for &number in NUMBERS {
        let outcome = on_impulses(number);
        for id in HARD {
            let sample = outcome.samples.iter().find(|sample| sample.id == id).expect("the row was compared");
            for entry in Tolerance::of(File::Impulses, number).filter(|entry| entry.is_for(sample)) {
                let error = sample.errors.get(entry.quantity);
                assert!(error <= entry.bound, "{number}, row {id}, {:?}: {error:e}", entry.quantity);
            }
            // As good as any other row: in fixed point what the rounded inputs leave of it.
            let bound = match number {
                Number::F64 => 1e-14,
                Number::F32 | Number::I8F24 => 1e-6,
                Number::Micromath | Number::I12F20 => 1e-5,
                Number::I16F16 => 1e-4,
            };
            let error = sample.errors.get(Quantity::Impulse);
            assert!(error <= bound, "{number}, row {id}: {error:e}");
        }
    }
}

#[test]
fn planar_impacts_by_several_laws() {
    for &number in NUMBERS {
        let plane = on_plane(number, &laws_file());
        plane.outcome.assert_good(File::Planar, number);
        assert_eq!((plane.outcome.rows, plane.skipped, plane.unsolved), (230, 5, 0));
        let counts = BTreeMap::from([("rod", 150), ("square_corner", 50), ("sphere_planar", 30)]);
        assert_eq!(plane.outcome.categories(), counts, "{number}");
    }
}

#[test]
fn measured_impacts_of_an_ellipse() {
    let Some(file) = measured_file() else { return };
    for &number in NUMBERS {
        let mut plane = on_plane(number, &file);
        plane.outcome.assert_good(File::Planar, number);
        assert_eq!((plane.outcome.rows, plane.skipped, plane.unsolved), (1000, 0, 0));
        assert_eq!(plane.outcome.samples.len(), 1000, "{number}: all can be represented in {}", plane.units);
        // The law's distance from the experiment, the same in every number type.
        plane.distances.sort_by(f64::total_cmp);
        assert!((plane.distances[499] - 0.603).abs() < 1e-3, "{number}: {}", plane.distances[499]);
    }
}

/// A bound that was found, not required, has little to spare: the worst error is more than a third of it.
#[test]
fn no_tolerance_could_be_tighter() {
    let measured = measured_file();
    for entry in TABLE.iter().filter(|entry| entry.origin == Origin::Found) {
        let mut samples = Vec::new();
        for &number in NUMBERS.iter().filter(|number| entry.numbers.contains(number)) {
            if entry.files.contains(&File::Impulses) {
                samples.extend(on_impulses(number).samples);
            }
            if entry.files.contains(&File::Planar) {
                for file in [Some(laws_file()), measured.clone()].into_iter().flatten() {
                    samples.extend(on_plane(number, &file).outcome.samples);
                }
            }
        }
        // The bounds for the plane alone come from the measured impacts.
        if samples.is_empty() || (measured.is_none() && entry.files == [File::Planar]) {
            continue;
        }
        let worst = entry.judge(&samples).expect("rows of its kind").worst;
        println!("{:?} {:?}: {worst:.2e} of {:.2e}", entry.numbers, entry.quantity, entry.bound);
        assert!(worst <= entry.bound, "{:?} {:?}: {worst:e}", entry.numbers, entry.quantity);
        assert!(3.0 * worst > entry.bound, "{:?} {:?} could be tighter: {worst:e}", entry.numbers, entry.quantity);
    }
}

/// With the sign of r_b flipped in the kernel's input, each tolerance is exceeded; that of the file itself, where the
/// kernel has no part, with the sign of an impulse in the file flipped.
#[test]
fn a_flipped_sign_exceeds_every_tolerance() {
    for &number in NUMBERS {
        let impulses = scalars::run(number, OnImpulses(number, true));
        let plane = scalars::run(number, OnPlane(number, &laws_file(), true)).outcome;
        for (file, outcome) in [(File::Impulses, impulses), (File::Planar, plane)] {
            assert!(outcome.other_outcome > 0 && !outcome.failures.is_empty(), "{number}: the outcomes notice it");
            for entry in Tolerance::of(file, number).filter(|entry| entry.quantity != Quantity::Law) {
                let verdict = entry.judge(&outcome.samples).expect("rows of its kind");
                assert!(!verdict.met, "{number}, {file:?}, {:?}: {:e}", entry.quantity, verdict.worst);
            }
        }
    }
}

#[test]
fn a_flipped_sign_in_the_file_exceeds_the_tolerance_of_the_file() {
    let mut rows = 0;
    impulses::read(&impulses_file(), |case| {
        let expected = case.expected.expect("the file has results");
        let exact = closed_form::resolve(&case.problem).expect("a single solution").state;
        let law = |file: State| {
            let mut errors = Errors::none();
            errors.measure_law(&case.problem, &file, &exact);
            errors.get(Quantity::Law)
        };
        let entry = TABLE.iter().find(|entry| entry.quantity == Quantity::Law).expect("an entry");
        assert!(law(expected) <= entry.bound);
        for component in 0..3 {
            let (mut impulse, mut velocity, mut spin) = (expected, expected, expected);
            impulse.impulse[component] *= -1.0;
            velocity.velocity[1][component] *= -1.0;
            spin.spin[0][component] *= -1.0;
            for (file, flipped) in [
                (impulse, expected.impulse[component]),
                (velocity, expected.velocity[1][component]),
                (spin, expected.spin[0][component]),
            ] {
                assert_eq!(law(file) > entry.bound, flipped != 0.0, "row {}", case.id);
            }
        }
        rows += 1;
        Ok(())
    })
    .expect("a good file");
    assert_eq!(rows, 1000);
}

/// The closed form that errors are measured against is itself right: it gives the file's results, computed at 60 digits.
#[test]
fn the_closed_form_agrees_with_the_file() {
    let mut rows = 0;
    impulses::read(&impulses_file(), |case| {
        rows += 1;
        let expected = case.expected.expect("the file has results");
        let solution = closed_form::resolve(&case.problem).expect("a single solution");
        assert_eq!(Some(solution.mode), case.mode, "row {}", case.id);
        let floor = case.problem.speed() / case.problem.inverse_mass();
        let error = norm(sub(solution.state.impulse, expected.impulse)) / norm(expected.impulse).max(floor);
        assert!(error < 1e-13, "row {}: {error:e}", case.id);
        assert!(distance(&solution.state, &expected) < 1e-12, "row {}", case.id);
        Ok(())
    })
    .expect("a good file");
    assert_eq!(rows, 1000);
}

/// The two closed forms, in space and in the plane, have nothing in common but the law.
#[test]
fn the_closed_forms_agree_with_each_other() {
    for &number in NUMBERS {
        assert_eq!(scalars::run(number, InBoth(number)), 230, "{number}");
    }
}

struct InBoth(Number);

impl Job for InBoth {
    type Output = usize;
    fn run<S: HostScalar>(self) -> usize {
        let both = |setup: Setup<S>| {
            let problem = setup.stored();
            let plane = newton::resolve(&problem).expect("a single solution");
            let space = closed_form::resolve(&problem).expect("a single solution");
            assert_eq!(plane.mode, space.mode);
            let error = norm(sub(plane.state.impulse, space.state.impulse)) / norm(plane.state.impulse);
            assert!(error < 1e-13, "{error:e}");
            setup.resolve()
        };
        let run = Planar { file: &laws_file(), number: self.0, out: None, mu: None, restitution: None };
        run.check::<S>(both).expect("a good file").checker.rows
    }
}

/// The largest distance between velocities.
fn distance(a: &State, b: &State) -> f64 {
    (0..2).map(|k| norm(sub(a.velocity[k], b.velocity[k])).max(norm(sub(a.spin[k], b.spin[k])))).fold(0.0, f64::max)
}
