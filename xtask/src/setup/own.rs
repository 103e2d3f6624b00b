//! The compiler of the cargo that runs us, and rustup, which can add targets to it.

use super::{Kit, ask};
use crate::process;
use crate::toolchain::Toolchain;
use crate::workspace;
use anyhow::Result;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The targets that the compiler has no `core` for.
pub fn missing_targets(kit: Kit) -> Vec<&'static str> {
    let Some(sysroot) = sysroot() else {
        return kit.targets.to_vec();
    };
    let missing = |target: &&&str| !has_core(&sysroot, target);
    kit.targets.iter().filter(missing).copied().collect()
}

/// Whether there is a compiled `core` for the target in this sysroot.
pub fn has_core(sysroot: &Path, target: &str) -> bool {
    let lib = sysroot.join("lib/rustlib").join(target).join("lib");
    let Ok(files) = std::fs::read_dir(lib) else {
        return false;
    };
    files.flatten().any(|file| {
        let name = file.file_name();
        let name = name.to_string_lossy();
        name.starts_with("libcore-") && name.ends_with(".rlib")
    })
}

/// Whether rustup is there and the compiler is one of its toolchains (one that it merely links to cannot grow).
pub fn has_rustup() -> bool {
    let managed = |sysroot: PathBuf| {
        let folder = sysroot.parent().and_then(Path::file_name);
        folder.is_some_and(|folder| folder == "toolchains")
    };
    process::find("rustup").is_some() && sysroot().is_some_and(managed)
}

/// Has rustup add the missing targets; `None` when it cannot.
pub fn add_targets(kit: Kit, yes: bool) -> Result<Option<Toolchain>> {
    println!("setup: to add to the Rust toolchain, so that it compiles firmware: {}", kit.target_list());
    println!("  rustup target add {}", kit.target_list());
    ask(yes)?;
    let mut rustup = Command::new("rustup");
    rustup.args(["target", "add"]).args(kit.targets).current_dir(workspace::root());
    if let Err(error) = process::run(&mut rustup) {
        eprintln!("setup: {error:#}");
        return Ok(None);
    }
    Ok(missing_targets(kit).is_empty().then_some(Toolchain::Own))
}

fn sysroot() -> Option<PathBuf> {
    let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    rustc.args(["--print", "sysroot"]).current_dir(workspace::root());
    Some(PathBuf::from(process::stdout_of(&mut rustc)?.trim_end()))
}
