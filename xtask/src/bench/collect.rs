//! From what boards printed and the linker said to figures.

use super::bound::{Bound, Work};
use super::figures::{Figure, KINDS, Key, OWN, SCENES, Scene, Spread};
use super::flash::{Linker, Size};
use super::image::Opt;
use super::impacts::{IMMOVABLE, Impact, REFERENCE};
use super::run::{Cost, Found, Peer, Played, Words};
use super::truth;
use crate::boards::{Board, Scalar};
use anyhow::{Context, Result, bail};
use std::collections::BTreeMap;
use std::fmt::Display;

/// The steps of a scene.
const STEPS: u32 = 180;

/// What is right for the first impact, without friction and with it.
pub struct Truths {
    resolve: [f64; 12],
    friction: [f64; 12],
}

impl Truths {
    pub fn new(impacts: &[Impact]) -> Result<Self> {
        let reference = &impacts[REFERENCE];
        Ok(Self { resolve: truth::resolve(reference), friction: truth::stick(reference)? })
    }

    /// How far a result is from it.
    fn error(&self, operation: &str, words: &Words, scalar: Scalar) -> f64 {
        let truth = if operation == "friction" { &self.friction } else { &self.resolve };
        truth::error(truth, words, scalar)
    }
}

/// Everything that a firmware found out in one number type on one board.
pub struct Measured<'a> {
    pub board: Board,
    pub scalar: Scalar,
    pub opt: Opt,
    pub impacts: &'a [Impact],
    pub truths: &'a Truths,
    pub found: &'a Found,
    /// Bytes of flash of the firmware that does the same and measures nothing.
    pub image: Option<u32>,
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

    /// `operation` in the number type, or by the library, of that name.
    fn of(&mut self, operation: &str, name: impl Display) -> Result<Size> {
        let function = format!("kernel_{operation}_{name}");
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
        let mut figures = if self.found.rows.is_empty() { Vec::new() } else { self.own(sizes)? };
        for Peer { name, operation, cost, result } in &self.found.peers {
            let size = sizes.of(operation, name)?;
            let error = self.truths.error(operation, result, self.scalar);
            let figure = self.figure(operation, *cost, size);
            let key = Key { by: name.clone(), ..figure.key };
            figures.push(Figure { key, error: Some(error), ..figure });
        }
        for played in &self.found.scenes {
            figures.push(self.scene(played, sizes)?);
        }
        for (operation, kind, _, points) in KINDS {
            if self.found.samples.is_empty() {
                continue;
            }
            let bound = Bound::find(kind, &self.found.samples)
                .with_context(|| format!("{} in {} at opt-level {}", self.board, self.scalar, self.opt))?;
            let highest = Work { sub_steps: 4, bodies: 8, pairs: 8, points: 8 * points };
            let cost = Cost { instructions: bound.of(highest), stack: 0 };
            figures.push(Figure { bound: Some(bound), ..self.figure(operation, cost, Size::default()) });
        }
        Ok(figures)
    }

    fn scene(&self, played: &Played, sizes: &mut Sizes) -> Result<Figure> {
        let Played { by, name, cost, min, max, worst, ram, outcome } = played;
        let kind = SCENES.iter().find(|(scene, ..)| scene == name);
        let (_, kind, _) = kind.with_context(|| format!("nobody knows the scene {name}"))?;
        // Balls alone are weighed: our own as a firmware, others' as a function that does all of it.
        let image = |sizes: &mut Sizes| match self.image {
            Some(image) => Ok(image),
            None => sizes.of("play", by).map(|size| size.flash),
        };
        let (size, image) = if by == OWN {
            (sizes.of(kind, self.scalar)?, (*kind == "spheres").then(|| image(sizes)).transpose()?)
        } else {
            (sizes.of(kind, by)?, Some(image(sizes)?))
        };
        let stages = self.found.stages.iter().find(|(scene, _)| scene == name).map(|(_, stages)| *stages);
        // To a tenth of a millimetre: what is less moves with every rounding.
        let outcome = (truth::value(*outcome, self.scalar) * 1e4).round() / 1e4;
        let figure = self.figure(name, *cost, size);
        Ok(Figure {
            key: Key { by: by.clone(), ..figure.key },
            spread: Some(Spread { min: *min, max: *max, worst: worst.to_string(), rows: STEPS, skipped: 0 }),
            ram: *ram,
            scene: Some(Scene { outcome, image, stages }),
            ..figure
        })
    }

    fn own(&self, sizes: &mut Sizes) -> Result<Vec<Figure>> {
        let rows = &self.found.rows;
        if rows.len() != self.impacts.len() {
            bail!("{} measured {} impacts of {}", self.board, rows.len(), self.impacts.len());
        }
        let mut figures = Vec::new();
        for (operation, cost) in &self.found.operations {
            figures.push(self.figure(operation, *cost, sizes.of(operation, self.scalar)?));
        }
        let (resolve, friction) = (sizes.of("resolve", self.scalar)?, sizes.of("friction", self.scalar)?);
        let (own, immovable) =
            rows[REFERENCE].zip(rows[IMMOVABLE]).context("the number type cannot hold the first impacts")?;
        for (operation, cost, size) in [("resolve", own[0], resolve), ("friction", own[1], friction)] {
            let (_, words) =
                self.found.results.iter().find(|(name, _)| name == operation).context("a result is missing")?;
            let error = Some(self.truths.error(operation, words, self.scalar));
            figures.push(Figure { error, ..self.figure(operation, cost, size) });
        }
        figures.push(self.figure("resolve_immovable", immovable[0], resolve));
        let groups: [(&str, usize, &[&str], Size); 4] = [
            ("resolve_rows", 0, &["stick", "slip", "frictionless"], resolve),
            ("friction_none", 1, &["frictionless"], friction),
            ("friction_stick", 1, &["stick"], friction),
            ("friction_slip", 1, &["slip"], friction),
        ];
        for (operation, which, modes, size) in groups {
            let (cost, spread) = self.spread(which, modes).context("the number type can hold no row")?;
            figures.push(Figure { spread: Some(spread), ..self.figure(operation, cost, size) });
        }
        Ok(figures)
    }

    fn figure(&self, operation: &str, cost: Cost, size: Size) -> Figure {
        let Measured { board, scalar, opt, .. } = *self;
        let key = Key { board, by: OWN.to_owned(), operation: operation.to_owned(), scalar, opt };
        let Cost { instructions, stack } = cost;
        Figure {
            key,
            instructions,
            spread: None,
            flash: size.flash,
            stack,
            ram: size.ram,
            error: None,
            scene: None,
            bound: None,
        }
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
