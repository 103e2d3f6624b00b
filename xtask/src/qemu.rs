//! Running firmware in QEMU.

use crate::boards::{Board, Scalar};
use crate::process;
use anyhow::{Result, bail};
use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use std::time::Duration;

/// QEMU's lm3s6965evb says so of a timer that nobody uses.
const HARMLESS: &str = "Timer with period zero";

/// No window, no serial line, no prompt: QEMU leaves the terminal alone, and Ctrl-C ends it.
pub const QUIET: [&str; 6] = ["-display", "none", "-serial", "none", "-monitor", "none"];
/// The debug channel leads to this machine.
pub const SEMIHOSTING: &str = "enable=on,target=native";

/// The longest command line that `examples/board` takes, in bytes.
const COMMAND_LINE: usize = 256;

/// One run of an example on a board.
#[derive(Clone, Copy, Debug)]
pub struct Run<'a> {
    pub example: &'a str,
    pub elf: &'a Path,
    pub board: Board,
    pub scalar: Scalar,
    pub arguments: &'a [String],
    pub limit: Duration,
    /// Virtual time of one instruction, as a power of two in nanoseconds; without it, time is this machine's.
    pub icount: Option<u32>,
}

impl Run<'_> {
    /// Runs it with our standard output.
    pub fn stream(self) -> Result<ExitStatus> {
        self.run(&mut self.command()?).map(|(status, _)| status)
    }

    /// Runs it and returns what it printed.
    pub fn capture(self) -> Result<(ExitStatus, Vec<u8>)> {
        self.run(self.command()?.stdout(Stdio::piped()))
    }

    fn run(self, qemu: &mut Command) -> Result<(ExitStatus, Vec<u8>)> {
        let end = process::run_for(qemu.stderr(Stdio::piped()), self.limit)?;
        // Firmware prints to standard output: these are QEMU's own words.
        for line in String::from_utf8_lossy(&end.stderr).lines().filter(|line| !line.contains(HARMLESS)) {
            eprintln!("{line}");
        }
        Ok((end.status.map_or_else(|| self.too_slow(), Ok)?, end.stdout))
    }

    fn too_slow<T>(self) -> Result<T> {
        bail!(
            "{} on {} in {} did not end within {} s: QEMU was stopped (--timeout gives it longer)",
            self.example,
            self.board,
            self.scalar,
            self.limit.as_secs()
        )
    }

    fn command(self) -> Result<Command> {
        let mut qemu = Command::new(self.board.emulator());
        qemu.args(self.board.qemu_machine());
        if let Some(shift) = self.icount {
            qemu.args(["-icount", &format!("shift={shift}")]);
        }
        qemu.args(QUIET);
        let mut semihosting = SEMIHOSTING.to_owned();
        let scalar = self.scalar.to_string();
        let mut words = vec![self.example, "--scalar", &scalar];
        words.extend(self.arguments.iter().map(String::as_str));
        for word in &words {
            // QEMU joins the words with spaces, and the board takes them apart there.
            if word.is_empty() || word.contains(char::is_whitespace) {
                bail!("the argument `{word}` cannot reach a board: it is empty or has white space in it");
            }
            // A comma would end QEMU's own option; doubled it stands for itself.
            semihosting.push_str(",arg=");
            semihosting.push_str(&word.replace(',', ",,"));
        }
        let length = words.len() + words.iter().map(|word| word.len()).sum::<usize>();
        if length > COMMAND_LINE {
            bail!("the arguments are too long for a board: {length} bytes, it takes {COMMAND_LINE}");
        }
        qemu.args(["-semihosting-config", &semihosting]).arg("-kernel").arg(self.elf);
        Ok(qemu)
    }
}
