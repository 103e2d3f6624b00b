//! `cargo xtask setup`: installs what building and running firmware needs, and nothing that is there already.

mod debian;
mod own;
mod packages;

use crate::boards::{Board, RISCV_TARGET, TARGETS};
use crate::process;
use crate::toolchain::Toolchain;
use anyhow::{Context, Result, bail};
use packages::{Manager, Package};
use std::io::{IsTerminal, Write};

/// What firmware of one kind of processor needs.
#[derive(Clone, Copy)]
struct Kit {
    targets: &'static [&'static str],
    emulator: &'static str,
}

impl Kit {
    const CORTEX_M: Self = Self { targets: &TARGETS, emulator: "qemu-system-arm" };
    const RISCV: Self = Self { targets: &[RISCV_TARGET], emulator: "qemu-system-riscv32" };

    /// For one target: a newcomer with one board waits for one.
    fn of(target: &str) -> Result<Self> {
        let one_of = |kit: Self| {
            kit.targets.iter().position(|one| *one == target).map(|at| Self { targets: &kit.targets[at..=at], ..kit })
        };
        let kits = [Self::CORTEX_M, Self::RISCV];
        kits.into_iter().find_map(one_of).with_context(|| format!("{target} is the target of no board here"))
    }

    /// The targets, as one names them on a command line.
    fn target_list(self) -> String {
        self.targets.join(" ")
    }
}

/// The names of Chromium and its kin; `xtask/browser` knows them too.
const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

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

/// Makes sure that everything for the Cortex-M boards is there and returns the compiler for firmware. Fast when there is nothing
/// to do.
pub fn ensure(yes: bool) -> Result<Toolchain> {
    ensure_kit(Kit::CORTEX_M, yes)
}

/// The same for one board, which may be another kind of processor.
pub fn ensure_for(board: Board, yes: bool) -> Result<Toolchain> {
    ensure_target(board.target(), yes)
}

/// The same for one target.
pub fn ensure_target(target: &str, yes: bool) -> Result<Toolchain> {
    ensure_kit(Kit::of(target)?, yes)
}

fn ensure_kit(kit: Kit, yes: bool) -> Result<Toolchain> {
    let way = Way::chosen()?;
    let qemu_missing = process::find(kit.emulator).is_none();
    let mut toolchain = installed(way, kit);

    if toolchain.is_none() && way == Way::Any && own::has_rustup() {
        toolchain = own::add_targets(kit, yes)?;
        if toolchain.is_none() {
            eprintln!("setup: rustup could not add the targets; looking for another way");
        }
    }

    let mut missing = Vec::new();
    if qemu_missing {
        missing.push(Manager::find(kit.emulator)?.qemu(kit.emulator));
    }
    if toolchain.is_none() {
        missing.extend(debian::missing_packages(way, kit)?);
    }
    install(&missing, yes)?;

    if qemu_missing && process::find(kit.emulator).is_none() {
        let emulator = kit.emulator;
        bail!("the package manager installed no {emulator}: put it on PATH (it is part of QEMU) and try again");
    }
    match toolchain {
        Some(toolchain) => Ok(toolchain),
        None => debian::build(kit),
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

/// Makes sure that C programs can be built, for this machine and for the boards.
pub fn ensure_c(yes: bool) -> Result<()> {
    let missing = || packages::C_TOOLS.into_iter().filter(|tool| process::find(tool.program).is_none());
    let names: Vec<&str> = missing().map(|tool| tool.program).collect();
    if names.is_empty() {
        return Ok(());
    }
    let programs = names.join(", ");
    if !matches!(Manager::find(&programs), Ok(Manager::Apt)) {
        bail!("C programs need {programs}: install what brings them on this system, so that they are on PATH");
    }
    install(&missing().map(|tool| tool.package()).collect::<Vec<_>>(), yes)?;
    match missing().next() {
        None => Ok(()),
        Some(tool) => bail!("the package {} brought no {}: put it on PATH and try again", tool.debian, tool.program),
    }
}

/// Makes sure that there is a Chromium, which the page of `cargo xtask view` is tried in.
pub fn ensure_browser(yes: bool) -> Result<()> {
    if BROWSERS.iter().any(|name| process::find(name).is_some()) {
        return Ok(());
    }
    let package = Package { name: "chromium".to_owned(), why: "opens the page of `cargo xtask view`, to test it" };
    install(&[package], yes)?;
    if BROWSERS.iter().all(|name| process::find(name).is_none()) {
        bail!("the package manager installed none of {}: put one on PATH and try again", BROWSERS.join(", "));
    }
    Ok(())
}

/// The compiler for firmware, if one is complete already.
fn installed(way: Way, kit: Kit) -> Option<Toolchain> {
    if way == Way::Any && own::missing_targets(kit).is_empty() {
        return Some(Toolchain::Own);
    }
    debian::ready(kit)
}

/// Says what is missing and why, asks, and has it installed.
fn install(missing: &[Package], yes: bool) -> Result<()> {
    if missing.is_empty() {
        return Ok(());
    }
    let manager = Manager::find(&missing[0].name)?;
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
