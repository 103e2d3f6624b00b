//! From what boards printed and the linker said to figures.

use super::figures::{Figure, Key, Spread};
use super::flash::{Linker, Size};
use super::image::Opt;
use super::impacts::{IMMOVABLE, Impact, REFERENCE};
use super::run::{Cost, Found};
use crate::boards::{Board, Scalar};
use anyhow::{Context, Result};
use std::collections::BTreeMap;

/// Everything that carom's firmware found out in one number type on one board.
pub struct Measured<'a> {
    pub board: Board,
    pub scalar: Scalar,
    pub opt: Opt,
    pub impacts: &'a [Impact],
    pub found: &'a Found,
}

/// The sizes of an image's operations, each linked once.
pub struct Sizes {
    linker: Linker,
    known: BTreeMap<String, Size>,
}

impl Sizes {
    pub fn new(linker: Linker) -> Self {
        Self { linker, known: BTreeMap::new() }
    }

    pub fn of(&mut self, operation: &str, scalar: Scalar) -> Result<Size> {
        let function = format!("kernel_{operation}_{scalar}");
        if let Some(size) = self.known.get(&function) {
            return Ok(*size);
        }
        let size = self.linker.size(&function)?;
        self.known.insert(function, size);
        Ok(size)
    }
}

impl Measured<'_> {
    pub fn figures(&self, sizes: &mut Sizes) -> Result<Vec<Figure>> {
        let mut figures = Vec::new();
        for (operation, cost) in &self.found.operations {
            figures.push(self.figure(operation, *cost, None, sizes.of(operation, self.scalar)?));
        }
        let (resolve, friction) = (sizes.of("resolve", self.scalar)?, sizes.of("friction", self.scalar)?);
        let rows = &self.found.rows;
        let [own, immovable] = [REFERENCE, IMMOVABLE].map(|index| rows[index]);
        let (own, immovable) = own.zip(immovable).context("the number type cannot hold the first impacts")?;
        figures.push(self.figure("resolve", own[0], None, resolve));
        figures.push(self.figure("resolve_immovable", immovable[0], None, resolve));
        figures.push(self.figure("friction", own[1], None, friction));
        let groups: [(&str, usize, &[&str], Size); 4] = [
            ("resolve_rows", 0, &["stick", "slip", "frictionless"], resolve),
            ("friction_stick", 1, &["stick"], friction),
            ("friction_slip", 1, &["slip"], friction),
            ("friction_none", 1, &["frictionless"], friction),
        ];
        for (operation, which, modes, size) in groups {
            let (cost, spread) = self.spread(which, modes).context("the number type can hold no row")?;
            figures.push(self.figure(operation, cost, Some(spread), size));
        }
        Ok(figures)
    }

    fn figure(&self, operation: &str, cost: Cost, spread: Option<Spread>, size: Size) -> Figure {
        let Measured { board, scalar, opt, .. } = *self;
        let key = Key { board, by: "carom".to_owned(), operation: operation.to_owned(), scalar, opt };
        let Cost { instructions, stack } = cost;
        Figure { key, instructions, spread, flash: size.flash, stack, ram: size.ram }
    }

    /// The median and the most stack of the table's rows in these modes, and how far they spread.
    fn spread(&self, which: usize, modes: &[&str]) -> Option<(Cost, Spread)> {
        let rows = self.impacts.iter().zip(&self.found.rows).skip(IMMOVABLE + 1);
        let chosen: Vec<_> = rows.filter(|(impact, _)| modes.contains(&impact.mode.as_str())).collect();
        let mut costs: Vec<(Cost, &str)> =
            chosen.iter().filter_map(|(impact, row)| row.map(|row| (row[which], impact.id.as_str()))).collect();
        costs.sort_by_key(|(cost, _)| cost.instructions);
        let (first, last) = (costs.first()?, costs.last()?);
        let median = costs[(costs.len() - 1) / 2].0.instructions;
        let stack = costs.iter().map(|(cost, _)| cost.stack).max()?;
        let spread = Spread {
            min: first.0.instructions,
            max: last.0.instructions,
            worst: last.1.to_owned(),
            rows: costs.len() as u32,
            skipped: (chosen.len() - costs.len()) as u32,
        };
        Some((Cost { instructions: median, stack }, spread))
    }
}
