//! `libcarom.a`, for a board's processor or for this machine.

use crate::process;
use crate::toolchain::{Toolchain, own_cargo};
use crate::workspace;
use anyhow::{Context, Result};
use std::path::PathBuf;

/// The archive alone: beside a library for Rust it would not be optimised as a whole.
const ARCHIVE: [&str; 8] =
    ["--quiet", "--profile", "capi", "--package", "carom-capi", "--lib", "--crate-type", "staticlib"];

/// Builds it for a target and returns where it is.
pub fn build(toolchain: &Toolchain, target: &str) -> Result<PathBuf> {
    let mut cargo = toolchain.cargo("rustc", target);
    process::run_watched(cargo.args(ARCHIVE), &format!("compiling libcarom.a for {target}"))?;
    keep(toolchain.target_dir().join(target).join("capi/libcarom_c.a"), target)
}

/// Builds it for this machine.
pub fn build_for_host() -> Result<PathBuf> {
    let mut cargo = own_cargo();
    cargo.arg("rustc").args(ARCHIVE).arg("--target-dir").arg(workspace::target_dir());
    process::run_watched(&mut cargo, "compiling libcarom.a for this machine")?;
    keep(workspace::target_dir().join("capi/libcarom_c.a"), "host")
}

/// Under the name that C programs link it by.
fn keep(built: PathBuf, name: &str) -> Result<PathBuf> {
    let folder = workspace::target_dir().join("capi").join(name);
    std::fs::create_dir_all(&folder)?;
    let archive = folder.join("libcarom.a");
    std::fs::copy(&built, &archive).with_context(|| format!("copying {}", built.display()))?;
    Ok(archive)
}
