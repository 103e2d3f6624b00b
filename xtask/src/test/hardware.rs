//! The stage of the firmware in `examples/boards`: it builds, it fits, and what can be read from the files is right. One of them
//! runs in QEMU as far as that knows its chip.

mod emulated;
mod part;
#[cfg(test)]
mod tests;

use crate::elf;
use crate::process;
use crate::setup;
use crate::toolchain::Toolchain;
use anyhow::{Context, Result, bail};
use part::{PARTS, Part};
use std::path::PathBuf;

/// Runs the stage.
pub fn run(yes: bool) -> Result<()> {
    let toolchain = setup::ensure(yes)?;
    for part in &PARTS {
        for &feature in part.features {
            let file = build(&toolchain, part, feature)?;
            let bytes = std::fs::read(&file).with_context(|| format!("reading {}", file.display()))?;
            let name = format!("examples/boards/{} in {feature}", part.board);
            let sizes = part.weigh(&bytes).with_context(|| name.clone())?;
            let found = elf::check_file(&file, feature == "fixed", part.target)?;
            if !found.is_empty() {
                bail!("{name} must not look like this:\n  {}", found.join("\n  "));
            }
            println!("  {:<17} {feature:<5} {sizes}", part.board);
            if part.emulated {
                println!("  {:<17} {feature:<5} {} states as pinned in QEMU", part.board, emulated::bits(part, &file)?);
            }
        }
    }
    Ok(())
}

/// Its firmware has the name `carom-BOARD`.
fn build(toolchain: &Toolchain, part: &Part, feature: &str) -> Result<PathBuf> {
    let Part { board, target, .. } = part;
    let mut cargo = toolchain.cargo("build", target);
    cargo.args(["--quiet", "--locked", "--release", "--no-default-features", "--features", feature]);
    process::run(cargo.arg("--manifest-path").arg(format!("examples/boards/{board}/Cargo.toml")))?;
    Ok(toolchain.target_dir().join(target).join("release").join(format!("carom-{board}")))
}
