//! `validate planar`: impacts of one body on a fixed plane, measured or computed.

mod ellipse;
mod laws;
pub mod newton;

use std::fmt::Write;
use std::path::Path;

use self::ellipse::Ellipse;
use self::laws::Laws;
use super::checker::{Case, Checker};
use super::error::{Error, Result};
use super::kernel::{Found, Setup};
use super::number::{Job, Number};
use super::output::Output;
use super::problem::{Body, Problem};
use super::progress::each_row;
use super::report::{Report, report};
use super::statistics::summary;
use super::table::{Row, Table};
use super::tolerances::File;
use super::units::Units;
use crate::host::HostScalar;

/// A run over a file in one number type.
pub struct Planar<'a> {
    pub file: &'a Path,
    pub number: Number,
    pub out: Option<&'a Path>,
    /// Of the ellipse, where not the usual ones.
    pub mu: Option<f64>,
    pub restitution: Option<f64>,
}

/// What a run over a file has found.
pub struct Findings<S: HostScalar> {
    pub checker: Checker<S>,
    pub units: Units,
    /// Rows without an impact in them.
    pub skipped: usize,
    /// Rows for which Newton's law with Coulomb's has no single solution.
    pub unsolved: usize,
    /// |v - v_measured| / |v_measured| by row, where something was measured.
    pub distances: Vec<(f64, String)>,
}

/// One row of a file.
enum Entry {
    /// An impact in SI, and the velocity that was measured after it.
    Impact(Box<Case>, Option<[f64; 2]>),
    /// No impact.
    Skipped,
    /// An impact for which there is nothing to compare with.
    Unsolved,
}

/// One of the two headers.
enum Source {
    Ellipse(Ellipse),
    Laws(Laws),
}

const OUTPUT: [&str; 6] = ["id", "jn", "jt", "vx", "vy", "w"];

impl Job for Planar<'_> {
    type Output = Result<Report>;

    fn run<S: HostScalar>(self) -> Result<Report> {
        let findings = self.check::<S>(Setup::resolve)?;
        let mut report = report(File::Planar, self.number, &findings.checker);
        let mut title = format!("{}: planar impacts in {}\n", self.file.display(), self.number);
        let _ = writeln!(title, "units of length, time and mass: {}", findings.units);
        let (skipped, unsolved) = (findings.skipped, findings.unsolved);
        let _ = writeln!(title, "rows without an impact: {skipped}; without a single solution: {unsolved}");
        if let Some(s) = summary(findings.distances.iter().map(|(distance, id)| (*distance, id.as_str()))) {
            let _ = writeln!(
                title,
                "distance to the measured velocity, |dv| / |v|: median {:.3}, p99 {:.3}, max {:.3}. This is how far the law is \
                 from the experiment, not a bar for the kernel: rigid laws miss by about half here.",
                s.median, s.p99, s.max
            );
        }
        report.text.insert_str(0, &title);
        Ok(report)
    }
}

impl Planar<'_> {
    /// Runs a kernel on every row, and writes the results.
    pub fn check<S: HostScalar>(&self, kernel: fn(Setup<S>) -> Found) -> Result<Findings<S>> {
        let (mut table, source) = self.open()?;
        let checker = Checker::new(self.number, kernel, newton::resolve);
        let units = source.units(self.number);
        let mut findings = Findings { checker, units, skipped: 0, unsolved: 0, distances: Vec::new() };
        let mut output = self.out.map(|path| Output::create(path, self.file, &OUTPUT)).transpose()?;
        each_row(&mut table, |row| {
            let entry = source.read(row)?;
            match entry {
                Entry::Impact(case, measured) => {
                    if let (Some((id, numbers)), Some(output)) = (findings.check(*case, measured), &mut output) {
                        output.row(&id, numbers)?;
                    }
                }
                Entry::Skipped => findings.skipped += 1,
                Entry::Unsolved => findings.unsolved += 1,
            }
            Ok(())
        })?;
        output.map_or(Ok(()), Output::finish)?;
        Ok(findings)
    }

    fn open(&self) -> Result<(Table, Source)> {
        let table = Table::open(self.file)?;
        let source = Source::find(&table, self)?;
        Ok((table, source))
    }
}

impl<S: HostScalar> Findings<S> {
    /// The row's name and the kernel's jn, jt, vx, vy, w in SI.
    fn check(&mut self, si: Case, measured: Option<[f64; 2]>) -> Option<(String, [f64; 5])> {
        let units = self.units;
        let expected = si.expected.map(|state| units.state(&state));
        let case = Case { problem: units.problem(&si.problem), expected, ..si };
        let found = self.checker.check(&case)?;
        let numbers = in_si(&found, &units);
        if let Some([x, y]) = measured {
            let distance = (numbers[2] - x).hypot(numbers[3] - y) / x.hypot(y);
            self.distances.push((distance, case.id.clone()));
        }
        Some((case.id, numbers))
    }
}

impl Source {
    fn find(table: &Table, run: &Planar<'_>) -> Result<Self> {
        match (table.has("Jn_w"), table.has("newton_jn")) {
            (true, _) => Ok(Self::Ellipse(Ellipse::find(table, run.mu, run.restitution)?)),
            (_, true) if run.mu.is_some() || run.restitution.is_some() => {
                let problem = "has columns mu and e: --mu and --restitution are for measured impacts";
                Err(Error::of_file(table.path(), problem))
            }
            (_, true) => Ok(Self::Laws(Laws::find(table)?)),
            (false, false) => {
                let problem = "header: neither column Jn_w of measured impacts nor column newton_jn of impact laws";
                Err(Error::of_file(table.path(), problem))
            }
        }
    }

    fn units(&self, number: Number) -> Units {
        match self {
            Self::Ellipse(_) => Units::of_the_ellipse(number),
            Self::Laws(_) => Units::of_the_laws(number),
        }
    }

    fn read(&self, row: Row<'_>) -> Result<Entry> {
        match self {
            Self::Ellipse(ellipse) => ellipse.read(row),
            Self::Laws(laws) => laws.read(row),
        }
    }
}

/// A body that strikes the ground: B, with the normal upwards. Motion and arm lie in the plane.
fn impact(body: Body, arm: [f64; 2], velocity: [f64; 2], spin: f64, restitution: f64, friction: f64) -> Problem {
    let body =
        Body { arm: [arm[0], arm[1], 0.0], velocity: [velocity[0], velocity[1], 0.0], spin: [0.0, 0.0, spin], ..body };
    Problem { bodies: [Body::immovable(), body], normal: [0.0, 1.0, 0.0], restitution, friction }
}

fn in_si(found: &Found, units: &Units) -> [f64; 5] {
    let [_, v] = found.state.velocity;
    let [_, w] = found.state.spin;
    let (impulse, velocity) = (units.impulse(), units.velocity());
    [
        found.normal_impulse * impulse,
        found.friction_impulse[0] * impulse,
        v[0] * velocity,
        v[1] * velocity,
        w[2] * units.spin(),
    ]
}
