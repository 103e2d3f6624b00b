//! `cargo xtask demo`: dice thrown on boards and on this machine, compared.

use crate::boards::{Board, Scalar};
use crate::firmware::{Build, Profile};
use crate::host::{self, Optimised};
use crate::qemu;
use crate::setup;
use anyhow::{Context, Result, bail};
use std::io::Write;
use std::time::Duration;

const EXAMPLE: &str = "dice";
const LIMIT: Duration = Duration::from_secs(120);

/// Where they are thrown: fixed point on the smallest board, f32 on one with an FPU.
const TABLES: [(Board, Scalar); 2] = [(Board::M0, Scalar::I16F16), (Board::M4f, Scalar::F32)];

/// Sets up, runs, shows, compares.
pub fn run(yes: bool) -> Result<()> {
    println!("1. Set-up: QEMU and the Rust targets of the boards");
    let toolchain = setup::ensure(yes)?;
    println!("   all there");

    let examples = [EXAMPLE.to_owned()];
    let mut all_equal = true;
    for (step, (board, scalar)) in (2..).zip(TABLES) {
        println!("\n{step}. {EXAMPLE} in {scalar} on {board} (QEMU) and on this machine");
        println!("   building firmware for {} ...", board.target());
        let build = Build { target: board.target(), feature: scalar.feature(), profile: Profile::Release };
        let elf = build.run(&toolchain, &examples)?.remove(0);
        println!("   building for this machine ...");
        let program = host::build(scalar.feature(), Optimised::Release, &examples)?.remove(0);
        let size = flash_size(&elf)?;
        println!("   running on {board}, {size} bytes of code and constants:\n");

        let run = qemu::Run { example: EXAMPLE, elf: &elf, board, scalar, arguments: &[], limit: LIMIT, icount: None };
        let (board_status, board_text) = run.capture()?;
        std::io::stdout().write_all(&board_text)?;
        let (host_status, host_text) = host::capture(&program, scalar, &[], LIMIT)?;
        if !board_status.success() || !host_status.success() {
            bail!("{EXAMPLE} failed: {board} ended with {board_status}, this machine with {host_status}");
        }
        if board_text == host_text {
            println!("\n   => {board} and this machine agree in {scalar}, byte for byte");
        } else {
            all_equal = false;
            println!("\n   => {board} and this machine DIFFER in {scalar}; this machine printed:\n");
            std::io::stdout().write_all(&host_text)?;
        }
    }
    if !all_equal {
        bail!("a board and this machine differ");
    }
    Ok(())
}

/// What the firmware takes of the flash.
fn flash_size(elf: &std::path::Path) -> Result<u64> {
    use object::{Object, ObjectSection, SectionKind};
    let bytes = std::fs::read(elf)?;
    let file = object::File::parse(&*bytes).context("not an ELF file")?;
    let in_flash = |kind| matches!(kind, SectionKind::Text | SectionKind::ReadOnlyData | SectionKind::Data);
    Ok(file.sections().filter(|section| in_flash(section.kind())).map(|section| section.size()).sum())
}
