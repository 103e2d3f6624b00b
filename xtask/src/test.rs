//! `cargo xtask test`: everything, stage by stage, up to the first failure.

mod boards;
mod host;

use crate::elf;
use crate::setup;
use anyhow::{Context, Result};
use clap::ValueEnum;
use std::time::Instant;

/// A part of the test run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Stage {
    /// tests on this machine in all feature sets; every combination of features compiles
    Host,
    /// every example on every board, its text compared with this machine's
    Boards,
    /// what is in the linked firmware
    Elf,
}

/// Runs the stage, or all of them.
pub fn run(only: Option<Stage>, yes: bool) -> Result<()> {
    let start = Instant::now();
    let toolchain = setup::ensure(yes)?;
    for stage in [Stage::Host, Stage::Boards, Stage::Elf] {
        if only.unwrap_or(stage) != stage {
            continue;
        }
        let name = stage.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned());
        println!("\n== {name} ==");
        let begun = Instant::now();
        match stage {
            Stage::Host => host::run(&toolchain),
            Stage::Boards => boards::run(&toolchain),
            Stage::Elf => elf::run(&elf::Options::default()),
        }
        .with_context(|| format!("stage {name} failed (it alone: `cargo xtask test --only {name}`)"))?;
        println!("== {name}: passed in {} s ==", begun.elapsed().as_secs());
    }
    println!("\nall passed in {} s", start.elapsed().as_secs());
    Ok(())
}
