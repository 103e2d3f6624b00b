//! A project that finds the installed library: by CMake, for this machine and for a board, and by pkg-config.

use super::stage::{EXAMPLES, LIMIT, check_state};
use super::{gcc, package};
use crate::boards::{Board, Scalar};
use crate::process;
use crate::qemu;
use crate::toolchain::Toolchain;
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The board that the project is built for, by its toolchain file.
const BOARD: Board = Board::M0;

/// Installs the library, and builds and runs programs against it.
pub fn check(toolchain: &Toolchain) -> Result<()> {
    let prefix = workspace::target_dir().join("capi/installed");
    println!("  installing:");
    package::install(&prefix, Some((toolchain, &[BOARD.target().to_owned()])))?;

    let here = cmake(&prefix, "host", None)?;
    let there = cmake(&prefix, "m0", Some("cortex-m0.cmake"))?;
    for (example, scalar) in EXAMPLES {
        run_here(&format!("{example}.c, found by CMake"), &here.join(example), example, scalar)?;
        let elf = there.join(example);
        let run = qemu::Run { example, elf: &elf, board: BOARD, scalar, arguments: &[], limit: LIMIT, icount: None };
        check_state(&format!("{example}.c, found by CMake, on {BOARD}"), example, scalar, run.capture()?)?;
        println!("  {example}.c, found by CMake: the pinned state here and on {BOARD}");
    }
    refuse_unknown_processor(&prefix)?;
    by_pkg_config(&prefix)
}

/// Configures and builds the project in capi/examples, and says where its programs are.
fn cmake(prefix: &Path, name: &str, toolchain_file: Option<&str>) -> Result<PathBuf> {
    let folder = fresh(name)?;
    let mut configure = configure(prefix, &folder);
    configure.args(toolchain_file.map(|file| format!("-DCMAKE_TOOLCHAIN_FILE={file}")));
    process::run(configure.stdout(Stdio::null()))?;
    process::run(Command::new("cmake").arg("--build").arg(&folder).stdout(Stdio::null()))?;
    Ok(folder)
}

fn configure(prefix: &Path, folder: &Path) -> Command {
    let mut cmake = Command::new("cmake");
    cmake.arg("-S").arg(workspace::root().join("capi/examples")).arg("-B").arg(folder);
    cmake.arg(format!("-DCMAKE_PREFIX_PATH={}", prefix.display()));
    cmake
}

/// A folder for a build that nothing is left in.
fn fresh(name: &str) -> Result<PathBuf> {
    let folder = workspace::target_dir().join("capi/projects").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).with_context(|| format!("making {}", folder.display()))?;
    Ok(folder)
}

fn run_here(name: &str, program: &Path, example: &str, scalar: Scalar) -> Result<()> {
    let end = process::run_for(Command::new(program).stdout(Stdio::piped()), LIMIT)?;
    let status = end.status.with_context(|| format!("{name} does not end"))?;
    check_state(name, example, scalar, (status, end.stdout))
}

/// A processor whose archive is not installed is refused with the command that installs it.
fn refuse_unknown_processor(prefix: &Path) -> Result<()> {
    let mut configure = configure(prefix, &fresh("refused")?);
    let output = configure.arg("-DCAROM_TARGET=thumbv7m-none-eabi").output().context("cmake does not run")?;
    let text = String::from_utf8_lossy(&output.stderr);
    if output.status.success() || !text.contains("cargo xtask capi install --prefix") {
        bail!("CMake should refuse a processor without an archive, and say how to install it:\n{text}");
    }
    println!("  CMake refuses a processor whose archive is not there");
    Ok(())
}

fn by_pkg_config(prefix: &Path) -> Result<()> {
    let mut config = Command::new("pkg-config");
    config.env("PKG_CONFIG_PATH", prefix.join("lib/pkgconfig")).args(["--cflags", "--libs", "carom"]);
    let flags = process::stdout_of(&mut config).context("pkg-config does not find carom.pc")?;
    let source = workspace::root().join("capi/examples");
    for (example, scalar) in EXAMPLES {
        let program = fresh("pkg-config")?.join(example);
        let mut gcc = Command::new("gcc");
        gcc.arg("-std=c99").args(gcc::STRICT).arg("-o").arg(&program);
        gcc.args([&format!("{example}.c"), "print.c", "host.c"].map(|file| source.join(file)));
        process::run(gcc.args(flags.split_whitespace()))?;
        run_here(&format!("{example}.c, found by pkg-config"), &program, example, scalar)?;
        println!("  {example}.c, found by pkg-config: the pinned state");
    }
    Ok(())
}
