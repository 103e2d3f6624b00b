//! What docs/c.md shows is what is there: its programs run, and its sizes are those of the firmware.

use super::{archive, gcc};
use crate::process;
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::path::PathBuf;
use std::process::Command;

/// Behind the functions of the guide: a ball that has bounced for a second is above the floor and below where it began, and meets it
/// for the second time at 0.8 of the 6.1 m/s of its fall; a ball of 200 g that stops another at 2 m/s gives it 380 mN s.
const MAIN: &str = "
int main(void)
{
    carom_q16_body ball;
    carom_q16_impact hit;
    int32_t speed, fastest = 0;
    int step;
    if (drop(&ball) != CAROM_OK || ball.position.z <= CAROM_Q16(0.09) || ball.position.z >= CAROM_Q16(1.9)) {
        return 1;
    }
    for (step = 0; step < 90; step++) {
        if (carom_q16_world_step(world, NULL) != CAROM_OK || hardest(&speed) != CAROM_OK) {
            return 2;
        }
        fastest = speed > fastest ? speed : fastest;
    }
    if (fastest <= CAROM_Q16(4.7) || fastest >= CAROM_Q16(5.0)) {
        return 3;
    }
    return strike(&hit) == CAROM_OK && hit.normal_impulse > CAROM_Q16(0.379) && hit.normal_impulse < CAROM_Q16(0.381) ? 0 : 4;
}
";

fn page() -> Result<String> {
    let path: PathBuf = workspace::root().join("docs/c.md");
    std::fs::read_to_string(&path).with_context(|| format!("reading {}", path.display()))
}

/// Compiles and runs what is in C in the guide, one block behind the other.
pub fn run_program() -> Result<()> {
    let page = page()?;
    let blocks = page.split("```c\n").skip(1).filter_map(|rest| rest.split("```").next());
    let program: String = blocks.collect();
    let archive = archive::build_for_host()?;
    let (source, binary) = (archive.with_file_name("guide.c"), archive.with_file_name("guide"));
    std::fs::write(&source, format!("{program}{MAIN}"))?;
    let mut gcc = Command::new("gcc");
    gcc.arg("-std=c99").args(gcc::STRICT).arg(gcc::include()).arg(source).arg(archive).arg("-o").arg(&binary);
    process::run(&mut gcc)?;
    process::run(&mut Command::new(binary)).context("the programs in docs/c.md do not do what they say")?;
    println!("  the programs in docs/c.md run");
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
