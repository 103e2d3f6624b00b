//! `validate geometry`: pairs of shapes, each with its signed distance and normal.

mod checker;
mod shape;

use std::fmt::Write;
use std::path::Path;

#[allow(unused_imports)] // Tests have a use for all of them.
pub use self::checker::{Checker, Found, Kernel, Pair, kernel};
#[allow(unused_imports)] // Tests have a use for all of them.
pub use self::shape::{Placed, Shape, Solid, separation};

use super::error::Result;
use super::number::{Job, Number};
use super::output::Output;
use super::progress::each_row;
use super::report::{Report, failed, problem, tables, tolerances};
use super::table::{Row, Table, quoted};
use super::tolerances::File;
use super::units::Units;
use super::vector::{Vector, norm, unit};
use crate::host::HostScalar;

/// A run over a file in one number type.
pub struct Geometry<'a> {
    pub file: &'a Path,
    pub number: Number,
    pub out: Option<&'a Path>,
    /// The same rows a thousand times smaller.
    pub millimetres: bool,
    /// Which of the two shapes are computed as others that are equal to them: boxes as hulls, planes as flat height fields.
    pub disguised: [bool; 2],
}

impl Job for Geometry<'_> {
    type Output = Result<Report>;

    fn run<S: HostScalar>(self) -> Result<Report> {
        let checker = self.check::<S>(kernel)?;
        let mut text = format!("{}: pairs of shapes in {}\n", self.file.display(), self.number);
        if self.millimetres {
            let _ = writeln!(
                text,
                "a thousand times smaller, in units of {} m; errors in millimetres",
                self.units().length
            );
        }
        if self.disguised == [true; 2] {
            text.push_str("boxes as hulls of their corners, planes as flat height fields\n");
        }
        let Checker { rows, samples, not_representable, tied, failures, .. } = &checker;
        let _ = writeln!(
            text,
            "{rows} rows: {} compared, {not_representable} not representable, {} failed\nrows with another normal that \
             separates as well as the file's: {}",
            samples.len(),
            failures.len(),
            tied.len()
        );
        if !tied.is_empty() {
            let _ = writeln!(text, "  {}", tied.join(", "));
        }
        failed(&mut text, failures);
        tables(&mut text, samples);
        let exceeded = tolerances(&mut text, self.kind(), self.number, samples);
        Ok(Report { text, problem: problem(failures.len(), exceeded) })
    }
}

impl Geometry<'_> {
    fn kind(&self) -> File {
        if self.disguised == [false; 2] { File::Geometry } else { File::Disguised }
    }

    fn units(&self) -> Units {
        if self.millimetres { Units::of_millimetres(self.number) } else { Units::SI }
    }

    /// Runs a kernel on every row, and writes the results: in metres, whatever the units.
    pub fn check<S: HostScalar>(&self, kernel: Kernel<S>) -> Result<Checker<S>> {
        let header = ["id", "dist", "nx", "ny", "nz"];
        let mut output = self.out.map(|path| Output::create(path, self.file, &header)).transpose()?;
        let shrink = if self.millimetres { 1e-3 } else { 1.0 };
        let mut checker = Checker::new(kernel, self.disguised, shrink, self.units().length);
        read(self.file, |pair| match (checker.check(&pair), &mut output) {
            (Some(found), Some(output)) => {
                let [x, y, z] = found.normal;
                output.row(&pair.id, [found.distance * shrink, x, y, z])
            }
            _ => Ok(()),
        })?;
        output.map_or(Ok(()), Output::finish)?;
        Ok(checker)
    }
}

/// Every row of a file.
pub fn read(file: &Path, mut each: impl FnMut(Pair) -> Result<()>) -> Result<()> {
    let mut table = Table::open(file)?;
    let columns =
        Columns(table.columns(["id", "A", "B", "sizeA", "sizeB", "posA", "posB", "quatA", "quatB", "dist", "normal"])?);
    each_row(&mut table, |row| each(columns.read(row)?))
}

/// Where everything is.
struct Columns([usize; 11]);

impl Columns {
    fn read(&self, row: Row<'_>) -> Result<Pair> {
        let [id, kind_a, kind_b, size_a, size_b, place_a, place_b, turn_a, turn_b, distance, normal] = self.0;
        let placed = |kind, size, place, turn| {
            let orientation: [f64; 4] = numbers(row, turn)?;
            let length = orientation.iter().map(|x| x * x).sum::<f64>().sqrt();
            if length == 0.0 {
                return Err(row.refuse(turn, "the quaternion is zero"));
            }
            let orientation = orientation.map(|x| x / length);
            Ok(Placed { shape: shape(row, kind, size)?, position: numbers(row, place)?, orientation })
        };
        let right: Vector = numbers(row, normal)?;
        if (norm(right) - 1.0).abs() > 1e-3 {
            return Err(row.refuse(normal, format_args!("the normal is of length {}, not 1", norm(right))));
        }
        Ok(Pair {
            id: row.text(id)?.to_owned(),
            shapes: [placed(kind_a, size_a, place_a, turn_a)?, placed(kind_b, size_b, place_b, turn_b)?],
            distance: row.number(distance)?,
            normal: unit(right),
        })
    }
}

fn shape(row: Row<'_>, kind: usize, size: usize) -> Result<Shape> {
    let shape = match row.text(kind)? {
        "sphere" => {
            let [radius] = numbers(row, size)?;
            Shape::Sphere { radius }
        }
        "box" => Shape::Box { half: numbers(row, size)? },
        "capsule" => {
            let [radius, half] = numbers(row, size)?;
            Shape::Capsule { radius, half }
        }
        "plane" => Shape::Plane,
        other => {
            let problem = format_args!("{} is none of sphere, box, capsule, plane", quoted(other));
            return Err(row.refuse(kind, problem));
        }
    };
    if shape.sizes().iter().all(|&x| x > 0.0) { Ok(shape) } else { Err(row.refuse(size, "a size is not positive")) }
}

/// The numbers in a cell, with blanks between them.
fn numbers<const N: usize>(row: Row<'_>, column: usize) -> Result<[f64; N]> {
    let text = row.text(column)?;
    let parsed: Vec<f64> =
        text.split_whitespace().filter_map(|x| x.parse().ok().filter(|x: &f64| x.is_finite())).collect();
    match <[f64; N]>::try_from(parsed) {
        Ok(numbers) if text.split_whitespace().count() == N => Ok(numbers),
        _ => Err(row.refuse(column, format_args!("{} is not {N} finite numbers", quoted(text)))),
    }
}
