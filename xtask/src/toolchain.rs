//! The compiler that firmware is built with: the user's own, or Debian's with a private sysroot.

use crate::process;
use crate::workspace;
use anyhow::{Context, Result};
use std::path::PathBuf;
use std::process::Command;

/// What builds firmware.
#[derive(Clone, Debug)]
pub enum Toolchain {
    /// The cargo that runs us; its compiler has `core` for the thumb targets.
    Own,
    /// Debian's cargo and rustc with the `core` that the set-up built for them.
    Debian {
        /// Usually `/usr/bin/cargo`.
        cargo: PathBuf,
        /// Usually `/usr/bin/rustc`.
        rustc: PathBuf,
        /// The linker, one of Debian's versions of lld.
        linker: PathBuf,
        /// The folder that holds `lib/rustlib/TARGET/lib`.
        sysroot: PathBuf,
    },
}

/// The cargo that runs us, or the one on `PATH`.
pub fn own_cargo() -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(workspace::root());
    command
}

impl Toolchain {
    /// A cargo command that compiles for `target`; more arguments may follow.
    pub fn cargo(&self, subcommand: &str, target: &str) -> Command {
        let mut command = match self {
            Toolchain::Own => own_cargo(),
            // By its own name: cargo would look for it beside rustup's programs first.
            Toolchain::Debian { cargo, .. } if subcommand == "clippy" => {
                let mut clippy = debian_program(&cargo.with_file_name("cargo-clippy"));
                clippy.env("CARGO", cargo);
                clippy
            }
            Toolchain::Debian { cargo, .. } => debian_program(cargo),
        };
        // Flags from the environment would replace those of `.cargo/config.toml`, the linker script among them.
        command.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
        command.args([subcommand, "--target", target, "--target-dir"]);
        command.arg(self.target_dir());
        if let Toolchain::Debian { rustc, linker, sysroot, .. } = self {
            command.env("RUSTC", rustc);
            // `--config` adds to the flags that are there. `{:?}` quotes as TOML does. The target's name stays unquoted:
            // cargo takes `thumbv8m.main-...` apart at the dot when it looks it up.
            let sysroot = sysroot.display().to_string();
            let linker = linker.display().to_string();
            command.args(["--config", &format!("target.{target}.rustflags=['--sysroot',{sysroot:?}]")]);
            command.args(["--config", &format!("target.{target}.linker={linker:?}")]);
        }
        command
    }

    /// Its compiler for `target`, without cargo.
    pub fn rustc(&self, target: &str) -> Command {
        let mut command;
        match self {
            Toolchain::Own => {
                command = own_rustc();
            }
            Toolchain::Debian { rustc, linker, sysroot, .. } => {
                command = debian_program(rustc);
                command.arg("--sysroot").arg(sysroot);
                command.arg(format!("-Clinker={}", linker.display()));
            }
        }
        command.args(["--target", target]);
        command
    }

    /// What its compiler says of itself.
    pub fn version(&self) -> Result<String> {
        let mut rustc = match self {
            Toolchain::Own => own_rustc(),
            Toolchain::Debian { rustc, .. } => debian_program(rustc),
        };
        Ok(process::stdout_of(rustc.arg("--version")).context("rustc does not run")?.trim_end().to_owned())
    }

    /// The linker, without the compiler: it takes `-flavor gnu` first.
    pub fn linker(&self) -> Result<PathBuf> {
        match self {
            Toolchain::Own => {
                let libraries = self.library_folder(None)?;
                Ok(libraries.with_file_name("bin").join(format!("rust-lld{}", std::env::consts::EXE_SUFFIX)))
            }
            Toolchain::Debian { linker, .. } => Ok(linker.clone()),
        }
    }

    /// A library that comes with the compiler, compiled for `target`.
    pub fn library(&self, target: &str, name: &str) -> Result<PathBuf> {
        let folder = self.library_folder(Some(target))?;
        let start = format!("lib{name}-");
        let files = std::fs::read_dir(&folder).with_context(|| format!("reading {}", folder.display()))?;
        let mut paths = files.flatten().map(|file| file.path());
        let wanted = |path: &PathBuf| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with(&start) && name.ends_with(".rlib")
        };
        paths.find(wanted).with_context(|| format!("there is no {name} in {}", folder.display()))
    }

    /// `lib/rustlib/TARGET/lib`, by default for this machine.
    fn library_folder(&self, target: Option<&str>) -> Result<PathBuf> {
        let mut rustc = target.map_or_else(own_rustc, |target| self.rustc(target));
        let folder = process::stdout_of(rustc.args(["--print", "target-libdir"])).context("rustc has no libraries")?;
        Ok(PathBuf::from(folder.trim_end()))
    }

    /// Where its output goes: two compilers in one folder would rebuild each other's work for ever.
    pub fn target_dir(&self) -> PathBuf {
        match self {
            Toolchain::Own => workspace::target_dir(),
            Toolchain::Debian { .. } => workspace::target_dir().join("debian"),
        }
    }
}

fn own_rustc() -> Command {
    Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
}

/// A program of Debian's toolchain, run in the repository's root. When rustup's cargo runs us, the environment speaks
/// of rustup's toolchain: that must not reach Debian's.
pub fn debian_program(program: &std::path::Path) -> Command {
    let mut command = Command::new(program);
    command.current_dir(workspace::root());
    for (name, _) in std::env::vars_os() {
        let name = name.to_string_lossy().into_owned();
        let rustups = name.starts_with("RUSTUP_") || name.starts_with("CARGO_PKG_");
        if rustups || FOREIGN.contains(&name.as_str()) {
            command.env_remove(name);
        }
    }
    command
}

const FOREIGN: [&str; 11] = [
    "CARGO",
    "CARGO_BUILD_RUSTC",
    "CARGO_ENCODED_RUSTFLAGS",
    "CARGO_MANIFEST_DIR",
    "CARGO_MANIFEST_PATH",
    "LD_LIBRARY_PATH",
    "RUSTC",
    "RUSTC_WORKSPACE_WRAPPER",
    "RUSTDOC",
    "RUSTDOCFLAGS",
    "RUSTFLAGS",
];
