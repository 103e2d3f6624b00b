//! `cargo xtask bench`: what operations cost on the boards.

mod collect;
mod figures;
mod flash;
mod image;
mod impacts;
mod run;
mod table;
mod truth;

use crate::boards::{Board, Scalar};
use crate::setup;
use anyhow::Result;
use collect::{Measured, Sizes, Truths};
use figures::Figure;
use flash::Linker;
use image::{Firmware, OWN, Opt, PEERS, Recipe};

/// What to measure; everything that is not given means all.
#[derive(clap::Args, Default)]
pub struct Options {
    /// Only this board (may be given more than once)
    #[arg(long)]
    board: Vec<Board>,
    /// Only this number type (may be given more than once)
    #[arg(long)]
    scalar: Vec<Scalar>,
    /// Only this opt-level (may be given more than once)
    #[arg(long)]
    opt: Vec<Opt>,
    /// Leave out the other libraries that carom is compared with
    #[arg(long)]
    without_peers: bool,
    /// Install what is missing without asking
    #[arg(long)]
    yes: bool,
}

/// Measures and prints.
pub fn run(options: &Options) -> Result<()> {
    let figures = measure(options)?;
    print!("{}", table::HEADER);
    table::print(&figures);
    Ok(())
}

fn measure(options: &Options) -> Result<Vec<Figure>> {
    let toolchain = setup::ensure(options.yes)?;
    let impacts = impacts::all()?;
    let input = impacts::write(&impacts)?;
    let truths = Truths::new(&impacts)?;
    let mut figures = Vec::new();
    for recipe in recipes(options) {
        eprintln!("bench: {recipe}");
        let image = recipe.build(&toolchain)?;
        let mut sizes = Sizes::new(Linker::new(&toolchain, recipe.target, &image)?);
        for board in wanted(&options.board, Board::ALL).filter(|board| board.target() == recipe.target) {
            for scalar in wanted(&options.scalar, recipe.firmware.scalars) {
                let found = run::run(&image.elf, board, scalar, &input)?;
                let Recipe { opt, .. } = recipe;
                let measured = Measured { board, scalar, opt, impacts: &impacts, truths: &truths, found: &found };
                figures.extend(measured.figures(&mut sizes)?);
            }
        }
    }
    figures.sort_by_cached_key(Figure::order);
    Ok(figures)
}

/// The images that the options need.
fn recipes(options: &Options) -> Vec<Recipe> {
    let mut targets: Vec<&'static str> = wanted(&options.board, Board::ALL).map(Board::target).collect();
    targets.dedup();
    let mut firmware: Vec<Firmware> = OWN.into();
    if !options.without_peers {
        firmware.push(PEERS);
    }
    firmware.retain(|firmware| wanted(&options.scalar, firmware.scalars).next().is_some());
    let mut recipes = Vec::new();
    for target in targets {
        for opt in wanted(&options.opt, &Opt::ALL) {
            recipes.extend(firmware.iter().map(|&firmware| Recipe { firmware, target, opt }));
        }
    }
    recipes
}

/// What was asked for, or all.
fn wanted<T: Copy + PartialEq>(asked: &[T], all: &[T]) -> impl Iterator<Item = T> {
    all.iter().copied().filter(move |one| asked.is_empty() || asked.contains(one))
}
