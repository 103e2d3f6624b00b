//! The display's stage: a board draws the same frame as this machine and as the documentation, with firmware that cannot panic.

use crate::boards::Board;
use crate::drawing::{self, EXAMPLE, PICTURE, SHOWN};
use crate::elf;
use crate::firmware::{Build, Profile};
use crate::setup;
use crate::workspace;
use anyhow::{Result, bail};

const BOARD: Board = Board::M4f;

/// Runs the stage.
pub fn run(yes: bool) -> Result<()> {
    std::env::set_current_dir(workspace::root())?;
    let there = drawing::frame(Some(BOARD), SHOWN, yes)?;
    let here = drawing::frame(None, SHOWN, yes)?;
    if let Some(byte) = there.iter().zip(&here).position(|(there, here)| there != here) {
        let [row, column] = drawing::place(byte);
        bail!("in {SHOWN}, from row {row}, column {column} on {BOARD} draws another frame than this machine");
    }
    if drawing::read_png(&workspace::root().join(PICTURE))? != drawing::colours(&here) {
        bail!("{PICTURE} is another frame than the one drawn; `cargo xtask draw --png {PICTURE}` writes it anew");
    }
    println!("  {SHOWN} {BOARD}  a frame of {} bytes as on this machine and in {PICTURE}", here.len());
    check_firmware(yes)
}

fn check_firmware(yes: bool) -> Result<()> {
    let (target, feature) = (BOARD.target(), SHOWN.feature());
    let build = Build { target, feature, profile: Profile::Release };
    for file in build.run(&setup::ensure(yes)?, &[EXAMPLE.to_owned()])? {
        let found = elf::check_file(&file, SHOWN.fraction_bits().is_some(), target)?;
        if !found.is_empty() {
            bail!("what must not be in firmware is in {}:\n{}", file.display(), found.join("\n"));
        }
    }
    println!("  {SHOWN} {BOARD}  no panic, no allocator and no float in its firmware");
    Ok(())
}
