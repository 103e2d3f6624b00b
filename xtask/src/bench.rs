//! `cargo xtask bench`: what operations cost on the boards.

mod bound;
mod chart;
mod check;
mod collect;
mod document;
mod figures;
mod flash;
mod grid;
pub mod image;
mod impacts;
mod markdown;
mod run;
mod snapshot;
mod table;
mod truth;
mod worlds;

use crate::boards::{Board, Scalar};
use crate::setup;
use crate::toolchain::Toolchain;
use anyhow::{Result, bail};
use collect::{Measured, Sizes, Truths};
use figures::{Figure, Key};
use flash::{Linker, Size};
use image::{Firmware, OWN, Opt, PEERS, PEERS_WORLD, Part, Recipe, WORLD};
use snapshot::Snapshot;

/// What to measure; everything that is not given means all.
#[derive(clap::Args, Default, PartialEq)]
pub struct Options {
    /// Only this board (may be given more than once)
    #[arg(long, value_parser = Board::cortex_m())]
    board: Vec<Board>,
    /// Only this number type (may be given more than once)
    #[arg(long)]
    scalar: Vec<Scalar>,
    /// Only this opt-level (may be given more than once)
    #[arg(long)]
    opt: Vec<Opt>,
    /// Only this part
    #[arg(long, value_name = "PART")]
    only: Option<Part>,
    /// Leave out the other libraries that carom is compared with
    #[arg(long)]
    without_peers: bool,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
    /// Keep the figures in the snapshot in benches/, and bring the tables and the chart of the documentation up to date
    ///
    /// What is not measured stays as it is; the snapshot has to be of the same compiler then.
    #[arg(long, conflicts_with = "check")]
    save: bool,
    /// Fail where a figure rose by more than 2 % over the snapshot, or the snapshot is out of date
    ///
    /// Figures depend on the compiler: with another one than the snapshot's, differences are printed only.
    #[arg(long)]
    check: bool,
    /// Install what is missing without asking
    #[arg(long)]
    yes: bool,
}

/// Measures, prints, and does with the figures what the options say.
pub fn run(options: &Options) -> Result<()> {
    let toolchain = setup::ensure(options.yes)?;
    let snapshot = Snapshot { rustc: toolchain.version()?, figures: measure(options, &toolchain)? };
    if options.json {
        print!("{}", snapshot.to_json()?);
    } else {
        println!("{}\n{}", snapshot.rustc, table::HEADER);
        table::print(&snapshot.figures);
    }
    if options.save {
        let saved = options.merge(&snapshot)?;
        saved.write()?;
        document::write(&saved)?;
        eprintln!("bench: saved {} figures of {}", snapshot.figures.len(), saved.figures.len());
    }
    if options.check {
        let mut saved = Snapshot::read()?;
        document::check(&saved)?;
        saved.figures.retain(|figure| options.ask_for(&figure.key));
        judge(&saved, &snapshot)?;
    }
    Ok(())
}

/// Tables and chart of the documentation from the snapshot, without measuring.
pub fn document() -> Result<()> {
    document::write(&Snapshot::read()?)
}

/// An error where the figures are not those of the snapshot, unless another compiler made them.
fn judge(saved: &Snapshot, measured: &Snapshot) -> Result<()> {
    let found = check::compare(&saved.figures, &measured.figures);
    for line in &found {
        eprintln!("bench: {line}");
    }
    if saved.rustc != measured.rustc {
        eprintln!("bench: not judged: the snapshot is of {}, these figures of {}", saved.rustc, measured.rustc);
    } else if !found.is_empty() {
        bail!("{} figures differ from the snapshot (if they are meant to: `cargo xtask bench --save`)", found.len());
    }
    Ok(())
}

impl Options {
    /// The snapshot in the repository with these figures in place of all that were asked for.
    fn merge(&self, measured: &Snapshot) -> Result<Snapshot> {
        if *self == (Self { json: self.json, save: true, yes: self.yes, ..Self::default() }) {
            return Ok(measured.clone());
        }
        let mut merged = Snapshot::read()?;
        merged.figures.retain(|figure| !self.ask_for(&figure.key));
        if merged.rustc != measured.rustc && !merged.figures.is_empty() {
            bail!("the snapshot is of {}, these figures of {}: measure everything", merged.rustc, measured.rustc);
        }
        merged.rustc.clone_from(&measured.rustc);
        merged.figures.extend_from_slice(&measured.figures);
        merged.figures.sort_by_cached_key(Figure::order);
        Ok(merged)
    }

    /// Whether such figures are measured.
    fn ask_for(&self, key: &Key) -> bool {
        let in_list = wanted(&self.board, &[key.board]).count() > 0
            && wanted(&self.scalar, &[key.scalar]).count() > 0
            && wanted(&self.opt, &[key.opt]).count() > 0
            && self.only.is_none_or(|part| part == figures::part(&key.operation));
        in_list && !(self.without_peers && key.by != figures::OWN)
    }
}

/// Every figure that the options ask for. The opt-levels go side by side: each compiles into a folder of its own, mostly
/// on one core, and counts do not depend on how fast QEMU is.
fn measure(options: &Options, toolchain: &Toolchain) -> Result<Vec<Figure>> {
    let impacts = impacts::all()?;
    let input = impacts::write(&impacts)?;
    let truths = Truths::new(&impacts)?;
    let recipes = recipes(options);
    let image = |recipe: &Recipe| -> Result<Vec<Figure>> {
        eprintln!("bench: {recipe}");
        let image = recipe.build(toolchain)?;
        let plain = recipe.build_plain(toolchain)?.map(|path| Size::of(&path)).transpose()?;
        let plain = plain.map(|size| size.flash);
        let mut sizes = Sizes::new(Linker::new(toolchain, recipe.target, &image)?);
        let mut figures = Vec::new();
        for board in wanted(&options.board, recipe.firmware.boards).filter(|board| board.target() == recipe.target) {
            for scalar in wanted(&options.scalar, recipe.firmware.scalars) {
                let found = run::run(&image.elf, board, scalar, &input)?;
                let opt = recipe.opt;
                let measured =
                    Measured { board, scalar, opt, impacts: &impacts, truths: &truths, found: &found, image: plain };
                figures.extend(measured.figures(&mut sizes)?);
            }
        }
        Ok(figures)
    };
    let level = |opt: Opt| recipes.iter().filter(|recipe| recipe.opt == opt).map(&image).collect::<Result<Vec<_>>>();
    let level = &level;
    let levels = std::thread::scope(|scope| {
        let threads = Opt::ALL.map(|opt| scope.spawn(move || level(opt)));
        threads.map(|thread| thread.join().expect("a thread of the benchmark panicked"))
    });
    let mut figures = Vec::new();
    for level in levels {
        figures.extend(level?.into_iter().flatten());
    }
    figures.sort_by_cached_key(Figure::order);
    Ok(figures)
}

/// The images that the options need.
fn recipes(options: &Options) -> Vec<Recipe> {
    let mut firmware: Vec<Firmware> = [OWN, WORLD].concat();
    if !options.without_peers {
        firmware.extend([PEERS, PEERS_WORLD]);
    }
    firmware.retain(|firmware| {
        options.only.is_none_or(|part| part == firmware.part)
            && wanted(&options.scalar, firmware.scalars).next().is_some()
    });
    let mut recipes = Vec::new();
    for firmware in firmware {
        let mut targets: Vec<&'static str> = wanted(&options.board, firmware.boards).map(Board::target).collect();
        targets.dedup();
        for target in targets {
            recipes.extend(wanted(&options.opt, &Opt::ALL).map(|opt| Recipe { firmware, target, opt }));
        }
    }
    recipes
}

/// What was asked for, or all.
fn wanted<T: Copy + PartialEq>(asked: &[T], all: &[T]) -> impl Iterator<Item = T> {
    all.iter().copied().filter(move |one| asked.is_empty() || asked.contains(one))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn snapshot(rustc: &str, instructions: u32) -> Snapshot {
        let json = format!(
            r#"{{"board":"m3","by":"carom","operation":"dot","scalar":"f32","opt":"3","instructions":{instructions},
                "flash":1,"stack":0,"ram":0}}"#
        );
        Snapshot { rustc: rustc.to_owned(), figures: vec![serde_json::from_str(&json).expect("a figure")] }
    }

    #[test]
    fn another_compiler_is_not_judged() {
        assert!(judge(&snapshot("rustc 1", 100), &snapshot("rustc 1", 100)).is_ok());
        assert!(judge(&snapshot("rustc 1", 100), &snapshot("rustc 1", 110)).is_err());
        assert!(judge(&snapshot("rustc 1", 110), &snapshot("rustc 1", 100)).is_err());
        assert!(judge(&snapshot("rustc 1", 100), &snapshot("rustc 2", 110)).is_ok());
    }

    #[test]
    fn a_snapshot_is_read_as_it_is_written() {
        let snapshot = snapshot("rustc 1", 100);
        let text = snapshot.to_json().expect("it can be written");
        assert_eq!(serde_json::from_str::<Snapshot>(&text).expect("it can be read"), snapshot);
        assert_eq!(text.lines().count(), 6);
    }
}
