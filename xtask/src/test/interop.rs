//! The stage of what is built beside carom, with tools of its own: firmware that logs by defmt, decoded here, and
//! firmware of RTIC and of Embassy.

use crate::boards::{Board, Scalar};
use crate::process;
use crate::qemu;
use crate::setup;
use crate::toolchain::{Toolchain, own_cargo};
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::path::PathBuf;
use std::time::Duration;

const LIMIT: Duration = Duration::from_secs(60);

/// In fixed point, which must not link floats for it, and in f32 with an FPU.
const LOGS: [(Board, Scalar); 2] = [(Board::M3, Scalar::I12F20), (Board::M4f, Scalar::F32)];

/// Firmware with a task that steps a world a hundred times a second, and one that prints what it sends, in so many frames.
const TASKS: [&str; 2] = ["rtic", "embassy"];
const FRAMES: usize = 10;
/// An instruction takes 32 ns, so that time on the board does not depend on how busy this machine is.
const TIME: Option<u32> = Some(5);

/// Runs the stage.
pub fn run(yes: bool) -> Result<()> {
    let toolchain = setup::ensure(yes)?;
    for (board, scalar) in LOGS {
        let elf = build(&toolchain, "logging", board, scalar.feature())?;
        let run =
            qemu::Run { example: "logging", elf: &elf, board, scalar, arguments: &[], limit: LIMIT, icount: None };
        let (status, bytes) = run.capture()?;
        if !status.success() || bytes.is_empty() {
            bail!("the firmware in examples/logging failed on {board} ({status}), {} bytes of log", bytes.len());
        }
        let log = elf.with_extension("log");
        std::fs::write(&log, &bytes).with_context(|| format!("writing {}", log.display()))?;
        let mut test = own_cargo();
        test.args([
            "test",
            "--quiet",
            "--test",
            "decode",
            "--manifest-path",
            "examples/logging/Cargo.toml",
            "--target-dir",
        ]);
        test.arg(workspace::target_dir()).args(["--no-default-features", "--features", scalar.feature()]);
        process::run(test.env("CAROM_LOG_ELF", &elf).env("CAROM_LOG", &log))?;
        println!("  logging {scalar:<8} {board:<3}  {} bytes of log decoded", bytes.len());
    }
    for folder in TASKS {
        let (board, scalar) = (Board::M3, Scalar::I12F20);
        let elf = build(&toolchain, folder, board, scalar.feature())?;
        let run = qemu::Run { example: folder, elf: &elf, board, scalar, arguments: &[], limit: LIMIT, icount: TIME };
        let (status, text) = run.capture()?;
        let text = String::from_utf8_lossy(&text);
        let frames = text.lines().filter(|line| line.starts_with("step ")).count();
        if !status.success() || frames != FRAMES {
            print!("{text}");
            bail!("the firmware in examples/{folder} failed on {board} ({status}), {frames} of {FRAMES} frames");
        }
        println!("  {folder:<7} {scalar:<8} {board:<3}  {}", text.lines().last().unwrap_or_default());
    }
    Ok(())
}

/// Builds a package of its own under `examples/`; its firmware has the name `carom-FOLDER`.
fn build(toolchain: &Toolchain, folder: &str, board: Board, feature: &str) -> Result<PathBuf> {
    let mut cargo = toolchain.cargo("build", board.target());
    cargo.args(["--quiet", "--release", "--no-default-features", "--features", feature]);
    // Without it defmt compiles errors in, and nothing else.
    cargo.env("DEFMT_LOG", "debug");
    process::run(cargo.arg("--manifest-path").arg(format!("examples/{folder}/Cargo.toml")))?;
    Ok(toolchain.target_dir().join(board.target()).join("release").join(format!("carom-{folder}")))
}
