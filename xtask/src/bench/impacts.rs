//! The impacts that are measured: two of our own, and every row of the table of two-body impulses.

use crate::workspace;
use anyhow::{Context, Result};
use std::path::{Path, PathBuf};

/// Where the impacts of our own stand in the input.
pub const REFERENCE: usize = 0;
pub const IMMOVABLE: usize = 1;

/// One of two bodies that meet, in SI units.
#[derive(Clone, Copy, Debug, Default)]
pub struct Body {
    /// Zero where it is immovable.
    pub inv_mass: f64,
    pub inv_moments: [f64; 3],
    /// w, x, y, z
    pub orientation: [f64; 4],
    pub arm: [f64; 3],
    pub velocity: [f64; 3],
    pub spin: [f64; 3],
}

/// Two bodies that meet.
#[derive(Clone, Debug)]
pub struct Impact {
    pub id: String,
    /// `stick`, `slip`, `frictionless` or `separating`.
    pub mode: String,
    pub bodies: [Body; 2],
    pub normal: [f64; 3],
    pub restitution: f64,
    pub friction: f64,
}

/// Two boxes that turn and tumble: nothing about them is zero, equal or aligned. Their numbers are exact in every format
/// but for directions and inverses, so that an error of the result is the operation's own.
fn reference() -> Impact {
    let a = Body {
        inv_mass: 1.0 / 2.0,
        inv_moments: [1.0 / 0.5, 1.0 / 0.75, 1.0 / 0.875],
        orientation: unit([0.75, 0.25, -0.5, 0.375]),
        arm: [0.5, -0.25, 0.375],
        velocity: [2.5, 1.25, -0.75],
        spin: [1.5, -2.25, 0.5],
    };
    let b = Body {
        inv_mass: 1.0 / 3.0,
        inv_moments: [1.0 / 1.25, 1.0 / 0.625, 1.0 / 1.5],
        orientation: unit([0.5, -0.625, 0.25, 0.75]),
        arm: [-0.625, 0.125, -0.25],
        velocity: [-3.25, 0.5, 1.75],
        spin: [-0.75, 1.25, 2.5],
    };
    Impact {
        id: "reference".to_owned(),
        mode: "stick".to_owned(),
        bodies: [a, b],
        normal: unit([2.0, -1.0, 0.5]),
        restitution: 0.5,
        friction: 0.75,
    }
}

/// The impacts of our own, in the order of the constants above, and the table's.
pub fn all() -> Result<Vec<Impact>> {
    let reference = reference();
    let ground = Body { orientation: [1.0, 0.0, 0.0, 0.0], ..Body::default() };
    let immovable = Impact { id: "immovable".to_owned(), bodies: [ground, reference.bodies[1]], ..reference.clone() };
    let mut impacts = vec![reference, immovable];
    let path = workspace::root().join("tests/data/two_body_impulse_dev.csv");
    read(&path, &mut impacts).with_context(|| format!("reading {}", path.display()))?;
    Ok(impacts)
}

fn read(path: &Path, impacts: &mut Vec<Impact>) -> Result<()> {
    let mut table = csv::Reader::from_path(path)?;
    let headers = table.headers()?.clone();
    for row in table.records() {
        let row = row?;
        let text = |name: &str| {
            let column = headers.iter().position(|header| header == name);
            column.and_then(|column| row.get(column)).with_context(|| format!("there is no column {name}"))
        };
        let number = |name: &str| Ok::<f64, anyhow::Error>(text(name)?.parse()?);
        let vector = |name: &str| {
            Ok::<_, anyhow::Error>([
                number(&format!("{name}x"))?,
                number(&format!("{name}y"))?,
                number(&format!("{name}z"))?,
            ])
        };
        let body = |which: u8| {
            let mass = number(&format!("m{which}"))?;
            // A mass of zero stands for an immovable body.
            let inverse = |x: f64| if mass == 0.0 { 0.0 } else { 1.0 / x };
            let [x, y, z] = vector(&format!("q{which}"))?;
            Ok::<_, anyhow::Error>(Body {
                inv_mass: inverse(mass),
                inv_moments: vector(&format!("I{which}"))?.map(inverse),
                orientation: unit([number(&format!("q{which}w"))?, x, y, z]),
                arm: vector(&format!("r{which}"))?,
                velocity: vector(&format!("v{which}"))?,
                spin: vector(&format!("w{which}"))?,
            })
        };
        impacts.push(Impact {
            id: text("id")?.to_owned(),
            mode: text("mode")?.to_owned(),
            bodies: [body(1)?, body(2)?],
            normal: unit(vector("n")?),
            restitution: number("e")?,
            friction: number("mu")?,
        });
    }
    Ok(())
}

fn unit<const N: usize>(v: [f64; N]) -> [f64; N] {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

/// Writes the input of the firmware and says where it lies.
pub fn write(impacts: &[Impact]) -> Result<PathBuf> {
    let path = workspace::target_dir().join("bench-impacts.txt");
    let text: String = impacts.iter().map(|impact| line(impact) + "\n").collect();
    std::fs::write(&path, text).with_context(|| format!("writing {}", path.display()))?;
    Ok(path)
}

fn line(impact: &Impact) -> String {
    let mut numbers = Vec::new();
    for body in &impact.bodies {
        numbers.push(body.inv_mass);
        numbers.extend(body.inv_moments);
        numbers.extend(body.orientation);
        numbers.extend([body.arm, body.velocity, body.spin].concat());
    }
    numbers.extend(impact.normal);
    numbers.extend([impact.restitution, impact.friction]);
    numbers.into_iter().map(number).collect::<Vec<_>>().join(" ")
}

/// Thirty bits and a power of two, in hexadecimal, as `benches/harness/input.rs` reads it.
fn number(x: f64) -> String {
    let exponent = if x == 0.0 { 0 } else { x.abs().log2().floor() as i32 - 29 };
    let mantissa = (x / f64::from(exponent).exp2()).round() as i32;
    format!("{mantissa:08x}{:02x}", exponent as i8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_as_the_board_reads_them() {
        assert_eq!(number(0.0), "0000000000");
        assert_eq!(number(1.0), "20000000e3");
        assert_eq!(number(-0.75), "d0000000e2");
    }

    #[test]
    fn every_impact_fits_a_line() {
        let impacts = all().expect("the table is there");
        assert_eq!(impacts.len(), 1002);
        // `examples/board` reads lines of up to 512 bytes.
        assert!(impacts.iter().all(|impact| line(impact).len() == 39 * 11 - 1));
    }
}
