//! `cargo xtask bench`: what operations cost on the boards.

mod collect;
mod figures;
mod flash;
mod image;
mod impacts;
mod run;
mod table;

use crate::boards::{Board, Scalar};
use crate::setup;
use anyhow::Result;
use collect::{Measured, Sizes};
use figures::Figure;
use flash::Linker;
use image::{Opt, Recipe};

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
    /// Install what is missing without asking
    #[arg(long)]
    yes: bool,
}

/// The images of carom's firmware: a feature of it, and the number types that this brings.
const FAMILIES: [(&str, &[Scalar]); 2] =
    [("fixed", &[Scalar::I16F16, Scalar::I12F20, Scalar::I8F24]), ("float", &[Scalar::F32, Scalar::Micromath])];

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
    let mut targets: Vec<&'static str> = Board::ALL.iter().map(|board| board.target()).collect();
    targets.dedup();
    let mut figures = Vec::new();
    for target in targets {
        let boards: Vec<Board> = wanted(&options.board, Board::ALL).filter(|board| board.target() == target).collect();
        if boards.is_empty() {
            continue;
        }
        for (feature, scalars) in FAMILIES {
            let scalars: Vec<Scalar> = wanted(&options.scalar, scalars).collect();
            if scalars.is_empty() {
                continue;
            }
            for opt in wanted(&options.opt, &Opt::ALL) {
                let recipe = Recipe { target, feature, opt };
                eprintln!("bench: {recipe}");
                let image = recipe.build(&toolchain)?;
                let mut sizes = Sizes::new(Linker::new(&toolchain, target, &image)?);
                for &board in &boards {
                    for &scalar in &scalars {
                        let found = run::run(&image.elf, board, scalar, &input, &impacts)?;
                        let measured = Measured { board, scalar, opt, impacts: &impacts, found: &found };
                        figures.extend(measured.figures(&mut sizes)?);
                    }
                }
            }
        }
    }
    figures.sort_by(|a, b| a.key.cmp(&b.key));
    Ok(figures)
}

/// What was asked for, or all.
fn wanted<T: Copy + PartialEq>(asked: &[T], all: &[T]) -> impl Iterator<Item = T> {
    all.iter().copied().filter(move |one| asked.is_empty() || asked.contains(one))
}
