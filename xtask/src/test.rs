//! `cargo xtask test`: everything, stage by stage, up to the first failure.

mod boards;
mod hardware;
mod host;
mod interop;
mod riscv;
mod view;

use crate::capi;
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
    /// the C library: its tests, its header, C examples on boards
    C,
    /// what is in the linked firmware
    Elf,
    /// every pinned state on RISC-V, in QEMU
    Riscv,
    /// firmware with other crates: what it logs by defmt, decoded; tasks of RTIC and of Embassy
    Interop,
    /// firmware for real boards: it builds, fits, and holds what it may
    Hardware,
    /// traces of boards and of this machine, and the page made of one in a headless Chromium
    View,
}

/// Runs the stage, or all of them.
pub fn run(only: Option<Stage>, yes: bool) -> Result<()> {
    let start = Instant::now();
    for &stage in Stage::value_variants() {
        if only.unwrap_or(stage) != stage {
            continue;
        }
        let name = stage.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned());
        println!("\n== {name} ==");
        let begun = Instant::now();
        match stage {
            Stage::Host => setup::ensure(yes).and_then(|toolchain| host::run(&toolchain)),
            Stage::Boards => setup::ensure(yes).and_then(|toolchain| boards::run(&toolchain)),
            Stage::C => setup::ensure(yes).and_then(|toolchain| {
                setup::ensure_c(yes)?;
                capi::stage::run(&toolchain)
            }),
            Stage::Elf => elf::run(&elf::Options::everything(yes)),
            Stage::Riscv => riscv::run(yes),
            Stage::Interop => interop::run(yes),
            Stage::Hardware => hardware::run(yes),
            Stage::View => view::run(yes),
        }
        .with_context(|| format!("stage {name} failed (it alone: `cargo xtask test --only {name}`)"))?;
        println!("== {name}: passed in {} s ==", begun.elapsed().as_secs());
    }
    println!("\nall passed in {} s", start.elapsed().as_secs());
    Ok(())
}
