//! The stage `c` of `cargo xtask test`: the header, the library, the examples and the package, as C programs meet them.

use super::gcc::{self, ARM_GCC, STRICT};
use super::pins::pin;
use super::{consumer, guide, header};
use crate::boards::{Board, Scalar};
use crate::elf;
use crate::process;
use crate::qemu;
use crate::toolchain::{Toolchain, own_cargo};
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::process::{Command, ExitStatus};
use std::time::{Duration, Instant};

/// Nothing that is run here should take a minute.
pub const LIMIT: Duration = Duration::from_secs(180);

/// The programs, and the number type that each computes in.
pub const EXAMPLES: [(&str, Scalar); 2] = [("dice", Scalar::I16F16), ("marble_maze", Scalar::F32)];

/// Where they run.
const BOARDS: [Board; 3] = [Board::M0, Board::M3, Board::M4f];

/// Runs the stage.
pub fn run(toolchain: &Toolchain) -> Result<()> {
    process::run(
        own_cargo().args(["test", "--quiet", "--package", "carom-capi", "--target-dir"]).arg(workspace::target_dir()),
    )?;
    header::check()?;
    compile_header()?;
    for board in BOARDS {
        for (example, scalar) in EXAMPLES {
            run_on_board(toolchain, example, scalar, board)?;
        }
    }
    guide::run_program()?;
    consumer::check(toolchain)
}

/// The header in the languages that firmware is written in, by this machine's compilers and by the one for Cortex-M.
fn compile_header() -> Result<()> {
    let examples = workspace::root().join("capi/examples");
    for (compiler, language, standards) in [
        ("gcc", "c", &["c99", "c17"][..]),
        ("g++", "c++", &["c++11", "c++20"]),
        (ARM_GCC, "c", &["c99"]),
        (ARM_GCC, "c++", &["c++11"]),
    ] {
        for standard in standards {
            let mut command = Command::new(compiler);
            command.args(["-x", language, &format!("-std={standard}"), "-ffreestanding", "-fsyntax-only"]);
            command.args(STRICT).arg(gcc::include()).arg(examples.join("header.c"));
            process::run(&mut command)?;
            println!("  carom.h is clean in {standard} ({compiler})");
        }
    }
    Ok(())
}

fn run_on_board(toolchain: &Toolchain, example: &str, scalar: Scalar, board: Board) -> Result<()> {
    let start = Instant::now();
    let elf = gcc::firmware(toolchain, example, board)?;
    let name = format!("{example}.c on {board}");
    let fixed = scalar.fraction_bits().is_some();
    let found = elf::check_names(&elf, fixed)?;
    if !found.is_empty() {
        bail!("{name} holds what it must not: {}", found.join(", "));
    }
    // Where there is no FPU, float firmware shows that the check sees what it looks for.
    if !fixed && board == Board::M0 && elf::check_names(&elf, true)?.is_empty() {
        bail!("the check of names finds no float routine in {name}: it finds nothing");
    }
    let run = qemu::Run { example, elf: &elf, board, scalar, arguments: &[], limit: LIMIT, icount: None };
    check_state(&name, example, scalar, run.capture()?)?;
    let [flash, ram] = gcc::sizes(&elf)?;
    if board == Board::M0 {
        guide::check_flash(example, flash)?;
    }
    let seconds = start.elapsed().as_secs_f32();
    println!(
        "  {name:<20} {scalar}: the pinned state; {flash} bytes of flash, {ram} of RAM and the stack, {seconds:.1} s"
    );
    Ok(())
}

/// A program ends well, and with the state that the Rust example of its name is pinned to.
pub fn check_state(name: &str, example: &str, scalar: Scalar, (status, text): (ExitStatus, Vec<u8>)) -> Result<()> {
    let text = String::from_utf8_lossy(&text);
    let pinned = pin(example, &scalar.to_string()).context("there is no such pin")?;
    if !status.success() || text.lines().last() != Some(&format!("state {pinned:016x}")) {
        bail!("{name} should end with the state {pinned:016x} of the Rust example ({status}):\n{text}");
    }
    Ok(())
}
