//! What docs/c.md shows is what is there: its program runs, and its sizes are those of the firmware.

use super::{archive, gcc};
use crate::process;
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::path::PathBuf;
use std::process::Command;

/// Behind the program of the guide: a ball that has bounced for a second is above the floor and below where it began.
const MAIN: &str = "
int main(void)
{
    carom_q16_body ball;
    return drop(&ball) == CAROM_OK && ball.position.z > CAROM_Q16(0.09) && ball.position.z < CAROM_Q16(1.9) ? 0 : 1;
}
";

fn page() -> Result<String> {
    let path: PathBuf = workspace::root().join("docs/c.md");
    std::fs::read_to_string(&path).with_context(|| format!("reading {}", path.display()))
}

/// Compiles and runs the program in the guide.
pub fn run_program() -> Result<()> {
    let page = page()?;
    let program = page.split("```c\n").nth(1).and_then(|rest| rest.split("```").next());
    let program = program.context("docs/c.md has no program in C")?;
    let archive = archive::build_for_host()?;
    let (source, binary) = (archive.with_file_name("guide.c"), archive.with_file_name("guide"));
    std::fs::write(&source, format!("{program}{MAIN}"))?;
    let mut gcc = Command::new("gcc");
    gcc.arg("-std=c99").args(gcc::STRICT).arg(gcc::include()).arg(source).arg(archive).arg("-o").arg(&binary);
    process::run(&mut gcc)?;
    process::run(&mut Command::new(binary)).context("the program in docs/c.md does not do what it says")?;
    println!("  the program in docs/c.md runs");
    Ok(())
}

/// The flash of an example on the M0 is what the guide says, to within a tenth.
pub fn check_flash(example: &str, bytes: u64) -> Result<()> {
    let page = page()?;
    let row = page.lines().find(|line| line.starts_with(&format!("| `{example}.c`")));
    let cell = row.and_then(|row| row.split('|').nth(2)).context("docs/c.md has no row for the example")?;
    let told: u64 = cell.trim().replace(',', "").parse().with_context(|| format!("`{cell}` is no number"))?;
    if told.abs_diff(bytes) > told / 10 {
        bail!("docs/c.md says that {example}.c takes {told} bytes of flash on the M0; it takes {bytes}: write that");
    }
    Ok(())
}
