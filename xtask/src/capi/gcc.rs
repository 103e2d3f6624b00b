//! The C compilers: this machine's, and the one for Cortex-M.

use super::archive;
use crate::boards::Board;
use crate::process;
use crate::toolchain::Toolchain;
use crate::workspace;
use anyhow::{Result, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

/// The compiler for Cortex-M.
pub const ARM_GCC: &str = "arm-none-eabi-gcc";

/// A header or a program of ours that makes a compiler say a word is wrong.
pub const STRICT: [&str; 4] = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"];

/// Where the header is.
pub fn include() -> String {
    format!("-I{}", workspace::root().join("capi/include").display())
}

/// What makes code of the board's processor.
fn processor(board: Board) -> Result<&'static [&'static str]> {
    Ok(match board {
        Board::M0 => &["-mcpu=cortex-m0"],
        Board::M3 => &["-mcpu=cortex-m3"],
        Board::M4f => &["-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"],
        Board::M7 => &["-mcpu=cortex-m7", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"],
        Board::M33 => &["-mcpu=cortex-m33", "-mfloat-abi=hard", "-mfpu=fpv5-sp-d16"],
        Board::Rv32 => bail!("C firmware is built for Cortex-M"),
    })
}

/// Builds an example of capi/examples as firmware for the board.
pub fn firmware(toolchain: &Toolchain, example: &str, board: Board) -> Result<PathBuf> {
    let archive = archive::build(toolchain, board.target())?;
    let source = workspace::root().join("capi/examples");
    let elf = archive.with_file_name(format!("{example}-{board}.elf"));
    let mut gcc = Command::new(ARM_GCC);
    gcc.args(["-std=c99", "-ffreestanding", "-Os", "-mthumb", "-ffunction-sections", "-fdata-sections"]);
    gcc.args(processor(board)?).args(STRICT).arg(include());
    gcc.args([&format!("{example}.c"), "print.c", "board.c"].map(|file| source.join(file)));
    // No C library, and of carom only what is called.
    gcc.args(["-nostdlib", "-Wl,--gc-sections,-z,noexecstack", "-T"]).arg(source.join("board.ld"));
    gcc.arg(archive).arg("-lgcc").arg("-o").arg(&elf);
    process::run(&mut gcc)?;
    Ok(elf)
}

/// Flash and RAM of firmware, without the stack, in bytes.
pub fn sizes(elf: &Path) -> Result<[u64; 2]> {
    use object::{Object, ObjectSegment};
    let bytes = std::fs::read(elf)?;
    let file = object::File::parse(&*bytes)?;
    let (mut flash, mut ram) = (0, 0);
    for segment in file.segments() {
        let (_, in_file) = segment.file_range();
        flash += in_file;
        ram += if segment.address() >= 0x2000_0000 { segment.size() } else { 0 };
    }
    Ok([flash, ram])
}
