//! Building and running the same examples on this machine, to compare with.

use crate::boards::Scalar;
use crate::cases;
use crate::process;
use crate::toolchain::own_cargo;
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};
use std::time::Duration;

/// How host programs are built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Optimised {
    Release,
    Debug,
}

/// Compiles the examples with the one feature and returns the programs, in the same order.
pub fn build(feature: &str, optimised: Optimised, examples: &[String]) -> Result<Vec<PathBuf>> {
    let mut cargo = own_cargo();
    cargo.args(["build", "--quiet", "--no-default-features", "--features", &cases::features(feature, examples)]);
    cargo.arg("--target-dir").arg(workspace::target_dir());
    let profile = match optimised {
        Optimised::Release => "quick-release",
        Optimised::Debug => "debug",
    };
    if optimised == Optimised::Release {
        cargo.args(["--profile", profile]);
    }
    for example in examples {
        workspace::check_example(example)?;
        cargo.args(["--example", example]);
    }
    process::run_watched(&mut cargo, &format!("compiling {} in {feature} for this machine", examples.join(", ")))?;

    // Cargo keeps one program of a name; copies stay while it is built again with another feature.
    let folder = workspace::target_dir().join("host-programs").join(feature).join(profile);
    std::fs::create_dir_all(&folder)?;
    let mut programs = Vec::new();
    for example in examples {
        let name = format!("{example}{}", std::env::consts::EXE_SUFFIX);
        let copy = folder.join(&name);
        let built = workspace::target_dir().join(profile).join("examples").join(&name);
        std::fs::copy(&built, &copy).with_context(|| format!("copying {}", built.display()))?;
        programs.push(copy);
    }
    Ok(programs)
}

/// Runs a program as a board would and returns what it printed.
pub fn capture(program: &Path, scalar: Scalar, arguments: &[String], limit: Duration) -> Result<(ExitStatus, Vec<u8>)> {
    let end = process::run_for(command(program, scalar, arguments).stdout(Stdio::piped()), limit)?;
    let status = end.status.map_or_else(|| too_slow(program, limit), Ok)?;
    Ok((status, end.stdout))
}

/// Runs a program as a board would, with our standard output.
pub fn stream(program: &Path, scalar: Scalar, arguments: &[String], limit: Duration) -> Result<ExitStatus> {
    let end = process::run_for(&mut command(program, scalar, arguments), limit)?;
    end.status.map_or_else(|| too_slow(program, limit), Ok)
}

fn command(program: &Path, scalar: Scalar, arguments: &[String]) -> Command {
    let mut command = Command::new(program);
    command.arg("--scalar").arg(scalar.to_string()).args(arguments);
    command
}

fn too_slow<T>(program: &Path, limit: Duration) -> Result<T> {
    bail!("{} did not end within {} s and was stopped", program.display(), limit.as_secs())
}
