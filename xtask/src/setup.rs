//! `cargo xtask setup`: installs what building and running firmware needs, and nothing that is there already.

mod debian;
mod own;
mod packages;

use crate::boards::TARGETS;
use crate::process;
use crate::toolchain::Toolchain;
use anyhow::{Result, bail};
use packages::{Manager, Package};
use std::io::{IsTerminal, Write};

/// The emulator of the boards.
pub const QEMU: &str = "qemu-system-arm";

/// The way that `CAROM_THUMB` asks for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    /// The active compiler, rustup, or Debian: what works first.
    Any,
    /// Debian's compiler, even where rustup could do.
    Debian,
}

impl Way {
    fn chosen() -> Result<Self> {
        match std::env::var("CAROM_THUMB").as_deref() {
            Err(_) | Ok("") => Ok(Way::Any),
            Ok("debian") => Ok(Way::Debian),
            Ok(other) => bail!("CAROM_THUMB is `{other}`; it can be `debian`, or unset"),
        }
    }
}

/// Makes sure that everything is there and returns the compiler for firmware. Fast when there is nothing to do.
pub fn ensure(yes: bool) -> Result<Toolchain> {
    let way = Way::chosen()?;
    let qemu_missing = process::find(QEMU).is_none();
    let mut toolchain = installed(way);

    if toolchain.is_none() && way == Way::Any && own::has_rustup() {
        toolchain = own::add_targets(yes)?;
        if toolchain.is_none() {
            eprintln!("setup: rustup could not add the targets; looking for another way");
        }
    }

    let mut missing = Vec::new();
    if qemu_missing {
        missing.push(Manager::find()?.qemu());
    }
    if toolchain.is_none() {
        missing.extend(debian::missing_packages(way)?);
    }
    install(&missing, yes)?;

    if qemu_missing && process::find(QEMU).is_none() {
        bail!("the package manager installed no {QEMU}: put QEMU for Arm on PATH and try again");
    }
    match toolchain {
        Some(toolchain) => Ok(toolchain),
        None => debian::build(),
    }
}

/// Makes sure that the compiler for firmware has its clippy too.
pub fn ensure_clippy(yes: bool) -> Result<Toolchain> {
    let toolchain = ensure(yes)?;
    if let Toolchain::Debian { .. } = toolchain {
        install(&debian::missing_clippy()?, yes)?;
    }
    Ok(toolchain)
}

/// The compiler for firmware, if one is complete already.
fn installed(way: Way) -> Option<Toolchain> {
    if way == Way::Any && own::missing_targets().is_empty() {
        return Some(Toolchain::Own);
    }
    debian::ready()
}

/// Says what is missing and why, asks, and has it installed.
fn install(missing: &[Package], yes: bool) -> Result<()> {
    if missing.is_empty() {
        return Ok(());
    }
    let manager = Manager::find()?;
    println!("setup: to install with {}:", manager.program());
    for package in missing {
        println!("  {:<18} {}", package.name, package.why);
    }
    ask(yes)?;
    manager.install(missing)
}

/// Waits for a yes when somebody is there to give it.
fn ask(yes: bool) -> Result<()> {
    if yes || !std::io::stdin().is_terminal() {
        return Ok(());
    }
    print!("setup: go on? [Y/n] ");
    std::io::stdout().flush()?;
    let mut answer = String::new();
    std::io::stdin().read_line(&mut answer)?;
    match answer.trim().to_ascii_lowercase().as_str() {
        "" | "y" | "yes" => Ok(()),
        _ => bail!("nothing was installed, as you said"),
    }
}

/// The targets, as one names them on a command line.
fn target_list() -> String {
    TARGETS.join(" ")
}
