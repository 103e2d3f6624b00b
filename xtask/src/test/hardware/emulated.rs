//! The firmware of one board in QEMU, on a machine with a chip of the same family. What it prints goes into a buffer that a debug
//! probe would read: here it is read from the machine's memory.

use super::part::Part;
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::io::Write;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// An STM32F405: the chip of the Discovery without Ethernet and camera. Of its clocks QEMU has nothing, so that the firmware waits for
/// the first of them for ever; the bits come before that.
const MACHINE: &str = "netduinoplus2";
const LIMIT: Duration = Duration::from_secs(180);
/// Between two looks at the memory.
const PAUSE: Duration = Duration::from_millis(500);

const GOOD: &str = "\nthe same bits as elsewhere";
const BAD: &str = "\nNOT the same bits as elsewhere";

/// Runs the firmware until it has told of its bits; how many states are as pinned.
pub fn bits(part: &Part, elf: &Path) -> Result<usize> {
    let mut qemu = Command::new("qemu-system-arm");
    qemu.args(["-machine", MACHINE, "-display", "none", "-serial", "none", "-monitor", "stdio", "-kernel"]);
    let mut machine = qemu.arg(elf).stdin(Stdio::piped()).stdout(Stdio::null()).spawn().context("cannot run QEMU")?;
    let outcome = watch(&mut machine, part);
    // It would run for ever.
    machine.kill().context("QEMU cannot be stopped")?;
    machine.wait()?;
    outcome
}

fn watch(machine: &mut Child, part: &Part) -> Result<usize> {
    let file = workspace::target_dir().join("hardware-ram");
    // Another run's good news would pass for this one's.
    let _ = std::fs::remove_file(&file);
    let start = Instant::now();
    let monitor = machine.stdin.as_mut().context("QEMU has no monitor")?;
    while start.elapsed() < LIMIT {
        std::thread::sleep(PAUSE);
        let (from, size) = (part.ram.start, part.ram.end - part.ram.start);
        writeln!(monitor, "pmemsave {from:#x} {size:#x} \"{}\"", file.display()).context("QEMU has ended")?;
        let memory = std::fs::read(&file).unwrap_or_default();
        let text = String::from_utf8_lossy(&memory);
        if let Some(at) = text.find(BAD) {
            bail!("{} prints other bits in QEMU:\n{}", part.board, text[..at].rsplit('\0').next().unwrap_or_default());
        }
        if text.contains(GOOD) {
            return Ok(text.matches("  as pinned").count());
        }
    }
    bail!("{} has not told of its bits after {} s in QEMU", part.board, LIMIT.as_secs())
}
