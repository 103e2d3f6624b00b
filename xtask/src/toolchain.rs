//! The compiler that firmware is built with: the user's own, or Debian's with a private sysroot.

use crate::workspace;
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
                command = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
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

    /// Where its output goes: two compilers in one folder would rebuild each other's work for ever.
    pub fn target_dir(&self) -> PathBuf {
        match self {
            Toolchain::Own => workspace::target_dir(),
            Toolchain::Debian { .. } => workspace::target_dir().join("debian"),
        }
    }
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
