//! Running firmware in QEMU.

use crate::boards::{Board, Scalar};
use crate::process;
use crate::setup::QEMU;
use anyhow::{Result, bail};
use std::path::Path;
use std::process::{Command, ExitStatus};
use std::time::Duration;

/// One run of an example on a board.
#[derive(Clone, Copy, Debug)]
pub struct Run<'a> {
    pub example: &'a str,
    pub elf: &'a Path,
    pub board: Board,
    pub scalar: Scalar,
    pub arguments: &'a [String],
    pub limit: Duration,
}

impl Run<'_> {
    /// Runs it with our standard output.
    pub fn stream(self) -> Result<ExitStatus> {
        let status = process::run_for(&mut self.command()?, self.limit)?;
        status.map_or_else(|| self.too_slow(), Ok)
    }

    /// Runs it and returns what it printed.
    pub fn capture(self) -> Result<(ExitStatus, Vec<u8>)> {
        let (status, text) = process::capture_for(&mut self.command()?, self.limit)?;
        Ok((status.map_or_else(|| self.too_slow(), Ok)?, text))
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
        let mut qemu = Command::new(QEMU);
        qemu.args(self.board.qemu_machine());
        // No window, no serial line, no prompt: QEMU leaves the terminal alone, and Ctrl-C ends it.
        qemu.args(["-display", "none", "-serial", "none", "-monitor", "none"]);
        let mut semihosting = "enable=on,target=native".to_owned();
        let scalar = self.scalar.to_string();
        let words = [self.example, "--scalar", &scalar];
        for word in words.into_iter().chain(self.arguments.iter().map(String::as_str)) {
            // QEMU joins the words with spaces, and the board takes them apart there.
            if word.is_empty() || word.contains(char::is_whitespace) {
                bail!("the argument `{word}` cannot reach a board: it is empty or has white space in it");
            }
            // A comma would end QEMU's own option; doubled it stands for itself.
            semihosting.push_str(",arg=");
            semihosting.push_str(&word.replace(',', ",,"));
        }
        qemu.args(["-semihosting-config", &semihosting]).arg("-kernel").arg(self.elf);
        Ok(qemu)
    }
}
