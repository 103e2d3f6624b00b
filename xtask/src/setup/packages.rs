//! The system's package manager.

use crate::process;
use anyhow::{Context, Result, bail};
use std::process::Command;

/// Something to install, and what for.
#[derive(Clone, Debug)]
pub struct Package {
    pub name: String,
    pub why: &'static str,
}

/// A program that C programs are built with, and Debian's package with it.
#[derive(Clone, Copy, Debug)]
pub struct Tool {
    pub program: &'static str,
    pub debian: &'static str,
    why: &'static str,
}

/// What building, packaging and linking C programs takes.
pub const C_TOOLS: [Tool; 5] = [
    Tool { program: "arm-none-eabi-gcc", debian: "gcc-arm-none-eabi", why: "compiles C for the boards" },
    Tool { program: "gcc", debian: "gcc", why: "compiles C for this machine" },
    Tool { program: "g++", debian: "g++", why: "compiles C++ for this machine" },
    Tool { program: "cmake", debian: "cmake", why: "builds C projects" },
    Tool { program: "pkg-config", debian: "pkg-config", why: "tells C projects where libraries are" },
];

impl Tool {
    /// As something to install.
    pub fn package(self) -> Package {
        Package { name: self.debian.to_owned(), why: self.why }
    }
}

/// A package manager that we know how to talk to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Manager {
    Apt,
    Dnf,
    Pacman,
    Zypper,
    Apk,
    Brew,
}

const ALL: [Manager; 6] = [Manager::Apt, Manager::Dnf, Manager::Pacman, Manager::Zypper, Manager::Apk, Manager::Brew];

impl Manager {
    /// The one of this machine.
    pub fn find(wanted: &str) -> Result<Self> {
        ALL.into_iter().find(|manager| process::find(manager.program()).is_some()).with_context(|| {
            format!(
                "{wanted} is missing and so is any package manager to install it with \
                 (apt-get, dnf, pacman, zypper, apk, brew): put it on PATH and try again"
            )
        })
    }

    /// Its program.
    pub fn program(self) -> &'static str {
        match self {
            Manager::Apt => "apt-get",
            Manager::Dnf => "dnf",
            Manager::Pacman => "pacman",
            Manager::Zypper => "zypper",
            Manager::Apk => "apk",
            Manager::Brew => "brew",
        }
    }

    /// The package that brings an emulator.
    pub fn qemu(self, emulator: &str) -> Package {
        let name = match (self, emulator) {
            (Manager::Brew, _) => "qemu",
            (Manager::Zypper, "qemu-system-arm") => "qemu-arm",
            (Manager::Zypper, _) => "qemu-extra",
            // Debian has it among others, from release 13 on by itself.
            (Manager::Apt, "qemu-system-riscv32") if has_package("qemu-system-riscv") => "qemu-system-riscv",
            (Manager::Apt, "qemu-system-riscv32") => "qemu-system-misc",
            (Manager::Dnf | Manager::Pacman, "qemu-system-riscv32") => "qemu-system-riscv",
            (_, emulator) => emulator,
        };
        Package { name: name.to_owned(), why: "emulates the boards that firmware runs on" }
    }

    /// Installs, after refreshing the lists of packages if it does not go without.
    pub fn install(self, packages: &[Package]) -> Result<()> {
        let names: Vec<&str> = packages.iter().map(|package| package.name.as_str()).collect();
        let mut arguments = self.install_arguments().to_vec();
        arguments.extend(&names);
        let mut install = self.command(&arguments)?;
        let first_try = run(&mut install);
        if first_try.is_ok() || self != Manager::Apt {
            return first_try;
        }
        // Lists that are old or empty are the usual reason for apt-get to fail.
        self.refresh()?;
        run(&mut install)
    }

    /// Refreshes the lists of packages.
    pub fn refresh(self) -> Result<()> {
        match self {
            Manager::Apt => run(&mut self.command(&["update"])?),
            // The others do it as they install.
            _ => Ok(()),
        }
    }

    fn install_arguments(self) -> &'static [&'static str] {
        match self {
            // Never at the price of something that is there; after whoever else installs something, the system itself for one.
            Manager::Apt => {
                &["install", "-y", "--no-install-recommends", "--no-remove", "-o", "DPkg::Lock::Timeout=600"]
            }
            Manager::Dnf => &["install", "-y"],
            Manager::Pacman => &["-Sy", "--noconfirm", "--needed"],
            Manager::Zypper => &["--non-interactive", "install"],
            Manager::Apk => &["add"],
            Manager::Brew => &["install"],
        }
    }

    fn command(self, arguments: &[&str]) -> Result<Command> {
        // Homebrew refuses to run as root; the others need to.
        let mut command = if self == Manager::Brew || is_root() {
            Command::new(self.program())
        } else if process::find("sudo").is_some() {
            let mut sudo = Command::new("sudo");
            sudo.arg(self.program());
            sudo
        } else {
            bail!(
                "installing needs root and there is no sudo: run `{} {}` as root, then try again",
                self.program(),
                arguments.join(" ")
            );
        };
        command.args(arguments).env("DEBIAN_FRONTEND", "noninteractive");
        Ok(command)
    }
}

/// Whether apt's lists have it.
fn has_package(name: &str) -> bool {
    let policy = process::stdout_of(Command::new("apt-cache").args(["policy", name])).unwrap_or_default();
    policy.lines().any(|line| line.trim().starts_with("Candidate: ") && !line.contains("(none)"))
}

fn run(command: &mut Command) -> Result<()> {
    println!("setup: {}", process::show(command));
    process::run(command)
}

fn is_root() -> bool {
    process::stdout_of(Command::new("id").arg("-u")).is_some_and(|id| id.trim() == "0")
}
