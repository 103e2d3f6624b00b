//! `cargo xtask test`: everything, stage by stage, up to the first failure.

mod boards;
mod display;
mod hardware;
mod host;
mod interop;
mod readme;
mod riscv;
mod view;

use crate::capi;
use crate::elf;
use crate::guide;
use crate::setup;
use crate::workspace;
use anyhow::{Context, Result};
use clap::ValueEnum;
use std::time::Instant;

/// A part of the test run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Stage {
    /// tests on this machine in all feature sets; every combination of features compiles
    Host,
    /// the C library: its tests, its header, C examples on boards
    C,
    /// every pinned state on RISC-V, in QEMU
    Riscv,
    /// firmware with other crates: what it logs by defmt, decoded; tasks of RTIC and of Embassy
    Interop,
    /// firmware for real boards: it builds, fits, and holds what it may
    Hardware,
    /// a frame for a display, drawn on a board: as on this machine, and as in the documentation
    Display,
    /// traces of boards and of this machine, and the page made of one in a headless Chromium
    View,
    /// the README's programs in both number types, the book of docs/, the links of all pages, and the firmware that `cargo xtask new`
    /// begins
    Guide,
    /// every example on every board, its text compared with this machine's
    Boards,
    /// what is in the linked firmware
    Elf,
}

/// Runs the stage, or all of them; with `tidy`, what one has built goes when nothing after it uses it.
pub fn run(only: Option<Stage>, yes: bool, tidy: bool) -> Result<()> {
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
            Stage::Display => display::run(yes),
            Stage::View => view::run(yes),
            Stage::Guide => readme::run().and_then(|()| guide::test(yes)),
        }
        .with_context(|| format!("stage {name} failed (it alone: `cargo xtask test --only {name}`)"))?;
        println!("== {name}: passed in {} s ==", begun.elapsed().as_secs());
        // What others go on with stays: programs of this machine for the display and the view, firmware of the boards for the ELF
        // stage, and what is left at the end for the benchmark.
        if tidy && matches!(stage, Stage::Host | Stage::C | Stage::Hardware | Stage::Guide) {
            clear()?;
        }
    }
    println!("\nall passed in {} s", start.elapsed().as_secs());
    Ok(())
}

/// Removes firmware and release builds of this machine, without what is slow to make anew: the boards' `core` and ourselves.
fn clear() -> Result<()> {
    for folder in ["debian", "quick-release", "release"].map(|name| workspace::target_dir().join(name)) {
        if folder.is_dir() {
            std::fs::remove_dir_all(&folder).with_context(|| format!("removing {}", folder.display()))?;
        }
    }
    Ok(())
}
