//! `validate impulses`: impacts of two bodies in space, each with its exact result.

use std::path::Path;

use super::checker::{Case, Checker};
use super::closed_form;
use super::error::Result;
use super::kernel::{Found, Setup};
use super::number::{Job, Number};
use super::output::Output;
use super::problem::{Body, Mode, Problem, State};
use super::progress::each_row;
use super::report::{Report, report};
use super::table::{Row, Table, quoted};
use super::tolerances::File;
use super::vector::{Vector, norm, unit};
use crate::host::HostScalar;

/// A run over a file in one number type.
pub struct Impulses<'a> {
    pub file: &'a Path,
    pub number: Number,
    pub out: Option<&'a Path>,
}

const OUTPUT: [&str; 15] =
    ["id", "jn", "jt", "vp1x", "vp1y", "vp1z", "vp2x", "vp2y", "vp2z", "wp1x", "wp1y", "wp1z", "wp2x", "wp2y", "wp2z"];

impl Job for Impulses<'_> {
    type Output = Result<Report>;

    fn run<S: HostScalar>(self) -> Result<Report> {
        let checker = self.check::<S>(Setup::resolve)?;
        let mut report = report(File::Impulses, self.number, &checker);
        let title = format!("{}: impulses of two bodies in {}\n", self.file.display(), self.number);
        report.text.insert_str(0, &title);
        Ok(report)
    }
}

impl Impulses<'_> {
    /// Runs a kernel on every row, and writes the results.
    pub fn check<S: HostScalar>(&self, kernel: fn(Setup<S>) -> Found) -> Result<Checker<S>> {
        let mut output = self.out.map(|path| Output::create(path, self.file, &OUTPUT)).transpose()?;
        let mut checker = Checker::new(self.number, kernel, closed_form::resolve);
        read(self.file, |case| match (checker.check(&case), &mut output) {
            (Some(found), Some(output)) => output.row(&case.id, numbers(&found)),
            _ => Ok(()),
        })?;
        output.map_or(Ok(()), Output::finish)?;
        Ok(checker)
    }
}

/// Every row of a file.
pub fn read(file: &Path, mut each: impl FnMut(Case) -> Result<()>) -> Result<()> {
    let mut table = Table::open(file)?;
    let columns = Columns::find(&table)?;
    each_row(&mut table, |row| each(columns.read(row)?))
}

fn numbers(found: &Found) -> impl Iterator<Item = f64> {
    let State { velocity, spin, .. } = found.state;
    let impulse = [found.normal_impulse, norm(found.friction_impulse)];
    impulse.into_iter().chain(velocity.into_iter().chain(spin).flatten())
}

/// Where everything is.
struct Columns {
    id: usize,
    category: usize,
    q16: usize,
    bodies: [BodyColumns; 2],
    normal: [usize; 3],
    restitution: usize,
    friction: usize,
    /// Without them the closed form takes their place.
    results: Option<ResultColumns>,
}

struct BodyColumns {
    mass: usize,
    inertia: [usize; 3],
    orientation: [usize; 4],
    arm: [usize; 3],
    velocity: [usize; 3],
    spin: [usize; 3],
}

struct ResultColumns {
    mode: usize,
    impulse: [usize; 3],
    velocity: [[usize; 3]; 2],
    spin: [[usize; 3]; 2],
}

impl Columns {
    fn find(table: &Table) -> Result<Self> {
        let names = [
            "id", "cat", "q16", "nx", "ny", "nz", "e", "mu", // of the row
            "m1", "I1x", "I1y", "I1z", "q1w", "q1x", "q1y", "q1z", "r1x", "r1y", "r1z", // of body 1
            "v1x", "v1y", "v1z", "w1x", "w1y", "w1z", //
            "m2", "I2x", "I2y", "I2z", "q2w", "q2x", "q2y", "q2z", "r2x", "r2y", "r2z", // of body 2
            "v2x", "v2y", "v2z", "w2x", "w2y", "w2z",
        ];
        let c = table.columns(names)?;
        let body = |first: usize| {
            let at = |offset: usize| c[first + offset];
            BodyColumns {
                mass: at(0),
                inertia: [at(1), at(2), at(3)],
                orientation: [at(4), at(5), at(6), at(7)],
                arm: [at(8), at(9), at(10)],
                velocity: [at(11), at(12), at(13)],
                spin: [at(14), at(15), at(16)],
            }
        };
        Ok(Self {
            id: c[0],
            category: c[1],
            q16: c[2],
            normal: [c[3], c[4], c[5]],
            restitution: c[6],
            friction: c[7],
            bodies: [body(8), body(25)],
            results: ResultColumns::find(table)?,
        })
    }

    fn read(&self, row: Row<'_>) -> Result<Case> {
        let category = row.text(self.category)?;
        let q16 = row.checked(self.q16, |x| x == 0.0 || x == 1.0, "is neither 0 nor 1")?;
        let normal: Vector = row.numbers(self.normal)?;
        let length = norm(normal);
        if (length - 1.0).abs() > 1e-3 {
            return Err(row.refuse(self.normal[0], format_args!("the normal is of length {length}, not 1")));
        }
        let [a, b] = &self.bodies;
        let problem = Problem {
            bodies: [a.read(row)?, b.read(row)?],
            normal: unit(normal),
            restitution: row.checked(self.restitution, |x| (0.0..=1.0).contains(&x), "is outside 0 to 1")?,
            friction: row.checked(self.friction, |x| x >= 0.0, "is negative")?,
        };
        let results = match &self.results {
            Some(results) => Some(results.read(row)?),
            None => closed_form::resolve(&problem).map(|solution| (solution.state, solution.mode)),
        };
        Ok(Case {
            id: row.text(self.id)?.to_owned(),
            category: category.to_owned(),
            suits_q16: q16 == 1.0 && ["A", "B", "C", "D"].contains(&category),
            problem,
            expected: results.map(|(state, _)| state),
            mode: results.map(|(_, mode)| mode),
        })
    }
}

impl BodyColumns {
    fn read(&self, row: Row<'_>) -> Result<Body> {
        let mass =
            row.checked(self.mass, |x| x >= 0.0, "is negative: a mass is positive, or 0 for an immovable body")?;
        let inertia: Vector = row.numbers(self.inertia)?;
        let orientation = row.numbers(self.orientation)?;
        if orientation == [0.0; 4] {
            return Err(row.refuse(self.orientation[0], "the quaternion is zero"));
        }
        let body = if mass == 0.0 {
            Body::immovable()
        } else {
            self.check_inertia(row, inertia)?;
            Body::new(1.0 / mass, inertia.map(|x| 1.0 / x), orientation)
        };
        Ok(Body {
            arm: row.numbers(self.arm)?,
            velocity: row.numbers(self.velocity)?,
            spin: row.numbers(self.spin)?,
            ..body
        })
    }

    fn check_inertia(&self, row: Row<'_>, inertia: Vector) -> Result<()> {
        let sum: f64 = inertia.iter().sum();
        for (moment, column) in inertia.into_iter().zip(self.inertia) {
            if moment <= 0.0 {
                return Err(row.refuse(column, format_args!("{moment} is not positive, as the mass is")));
            }
            // The library's own allowance for rounded input.
            if moment > (sum - moment) * (1.0 + 1.0 / 4096.0) {
                return Err(row.refuse(column, format_args!("{moment} exceeds the sum of the other two moments")));
            }
        }
        Ok(())
    }
}

impl ResultColumns {
    /// `None` where the file has none of them.
    fn find(table: &Table) -> Result<Option<Self>> {
        let names = [
            "mode", "Jx", "Jy", "Jz", "vp1x", "vp1y", "vp1z", "vp2x", "vp2y", "vp2z", "wp1x", "wp1y", "wp1z", "wp2x",
            "wp2y", "wp2z",
        ];
        if !names.iter().any(|name| table.has(name)) {
            return Ok(None);
        }
        let c = table.columns(names)?;
        let vector = |first: usize| [c[first], c[first + 1], c[first + 2]];
        Ok(Some(Self {
            mode: c[0],
            impulse: vector(1),
            velocity: [vector(4), vector(7)],
            spin: [vector(10), vector(13)],
        }))
    }

    fn read(&self, row: Row<'_>) -> Result<(State, Mode)> {
        let mode = match row.text(self.mode)? {
            "separating" => Mode::Separating,
            "frictionless" => Mode::Frictionless,
            "stick" => Mode::Stick,
            "slip" => Mode::Slip,
            other => {
                let problem = format!("{} is none of separating, frictionless, stick, slip", quoted(other));
                return Err(row.refuse(self.mode, problem));
            }
        };
        let pair = |[a, b]: [[usize; 3]; 2]| Ok([row.numbers(a)?, row.numbers(b)?]);
        let state =
            State { impulse: row.numbers(self.impulse)?, velocity: pair(self.velocity)?, spin: pair(self.spin)? };
        Ok((state, mode))
    }
}
