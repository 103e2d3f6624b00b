//! The RISC-V stage: every pinned state in every number type on another family of processors.

use crate::boards::{Board, FEATURES, Scalar};
use crate::firmware::{Build, Profile};
use crate::qemu;
use crate::setup;
use anyhow::{Context, Result, bail};
use std::time::{Duration, Instant};

const SELFTEST: &str = "selftest";
/// Its slowest number type takes a third of that.
const LIMIT: Duration = Duration::from_secs(180);

/// Runs the stage.
pub fn run(yes: bool) -> Result<()> {
    let board = Board::Rv32;
    let toolchain = setup::ensure_for(board, yes)?;
    for feature in FEATURES {
        let build = Build { target: board.target(), feature, profile: Profile::Release };
        let elf = &build.run(&toolchain, &[SELFTEST.to_owned()])?[0];
        for &scalar in Scalar::ALL.iter().filter(|scalar| scalar.feature() == feature) {
            let start = Instant::now();
            let run = qemu::Run { example: SELFTEST, elf, board, scalar, arguments: &[], limit: LIMIT, icount: None };
            let again = format!("cargo xtask qemu {SELFTEST} --board {board} --scalar {scalar}");
            let (status, text) = run.capture().with_context(|| format!("repeat with `{again}`"))?;
            let text = String::from_utf8_lossy(&text);
            let states = text.lines().filter(|line| line.ends_with("as pinned")).count();
            if !status.success() || text.contains("not in this build") || states == 0 {
                print!("{text}");
                bail!("{SELFTEST} in {scalar} failed on {board} ({status}); repeat with `{again}`");
            }
            println!("  {scalar:<9} {board}  {states} states as pinned, {:.1} s", start.elapsed().as_secs_f32());
        }
    }
    Ok(())
}
