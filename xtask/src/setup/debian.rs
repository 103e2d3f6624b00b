//! Firmware without rustup: Debian's compiler, and `core` for the thumb targets built from Debian's source package
//! into a private sysroot under `target/`. Nothing but packages comes from outside, nothing outside is changed but by
//! the package manager.

use super::packages::{Manager, Package};
use super::{Kit, Way, own};
use crate::process;
use crate::toolchain::{Toolchain, debian_program};
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

const CARGO: &str = "/usr/bin/cargo";
const RUSTC: &str = "/usr/bin/rustc";

/// Compiler, cargo and source, as Debian names them: `-web` is the current compiler in a stable release.
const FAMILIES: [[&str; 3]; 2] = [["rustc-web", "cargo-web", "rust-web-src"], ["rustc", "cargo", "rust-src"]];

const WHYS: [&str; 3] =
    ["compiles firmware", "drives the compiler", "the source of `core`, to be built for the boards"];

/// The finished toolchain, if the one that was built still fits the compiler.
pub fn ready(kit: Kit) -> Option<Toolchain> {
    if !has_apt() || !Path::new(CARGO).is_file() {
        return None;
    }
    let current = std::fs::read_to_string(stamp_file()).ok()? == compiler_version()?;
    let complete = kit.targets.iter().all(|target| own::has_core(&sysroot(), target));
    (current && complete).then(toolchain).flatten()
}

/// The packages that this way still needs.
pub fn missing_packages(way: Way, kit: Kit) -> Result<Vec<Package>> {
    if !has_apt() {
        let reason = match way {
            Way::Debian => "CAROM_THUMB=debian needs Debian's package manager, and it is not here",
            Way::Any if process::find("rustup").is_some() => "rustup did not add them",
            Way::Any => "there is no rustup to add them",
        };
        bail!(
            "the Rust targets for the boards are missing ({reason}): run `rustup target add {}` on this machine \
             (rustup is at https://rustup.rs), then try again",
            kit.target_list()
        );
    }
    let family = family(kit)?;
    let mut missing = Vec::new();
    if family.iter().any(|name| !is_installed(name)) || compiler_release() < Some(oldest_rust()?) {
        // All three, so that they are of one version.
        missing.extend(family.iter().zip(WHYS).map(|(name, why)| Package { name: (*name).to_owned(), why }));
    }
    if linker().is_none() {
        missing.push(Package { name: newest_lld(), why: "links firmware" });
    }
    Ok(missing)
}

/// The package with the compiler's clippy, unless it is there.
pub fn missing_clippy() -> Result<Vec<Package>> {
    let name = if family(Kit::CORTEX_M)?[0] == "rustc-web" { "rust-web-clippy" } else { "rust-clippy" };
    if is_installed(name) {
        return Ok(Vec::new());
    }
    Ok(vec![Package { name: name.to_owned(), why: "checks the firmware's source" }])
}

/// Builds `core` and `alloc` for the targets into the private sysroot, beside those that an older call built with this compiler.
pub fn build(kit: Kit) -> Result<Toolchain> {
    let version = compiler_version().with_context(|| format!("{RUSTC} does not run"))?;
    let current = std::fs::read_to_string(stamp_file()).is_ok_and(|stamp| stamp == version);
    let missing: Vec<&str> =
        kit.targets.iter().copied().filter(|target| !current || !own::has_core(&sysroot(), target)).collect();
    let scratch = workspace::target_dir().join("thumb-sysroot-build");
    let output = scratch.join("target");
    std::fs::create_dir_all(scratch.join("src"))?;
    std::fs::write(scratch.join("src/lib.rs"), "#![no_std]\n")?;
    std::fs::write(
        scratch.join("Cargo.toml"),
        "[package]\nname = \"scratch\"\nversion = \"0.0.0\"\nedition = \"2021\"\n\n[workspace]\n",
    )?;

    println!("setup: building `core` from Debian's source, half a minute each, only once: {}", missing.join(" "));
    let mut cargo = debian_program(Path::new(CARGO));
    cargo.current_dir(&scratch);
    // `-Zbuild-std` is for nightly compilers; this lets a stable one take it. Bitcode is for firmware's link-time
    // optimisation. Flags given here keep the linker script of `.cargo/config.toml` out.
    cargo.env("RUSTC", RUSTC).env("RUSTC_BOOTSTRAP", "1").env("RUSTFLAGS", "-Cembed-bitcode=yes");
    cargo.args(["build", "--release", "--target-dir"]).arg(&output);
    cargo.args(["-Zbuild-std=core,alloc,compiler_builtins", "-Zbuild-std-features=compiler-builtins-mem"]);
    for target in &missing {
        cargo.args(["--target", target]);
    }
    // The source package holds its dependencies: nothing is downloaded.
    let vendored = library_source()?.join("vendor");
    if vendored.is_dir() {
        let vendored = vendored.display().to_string();
        cargo.args(["--offline", "--config", "source.crates-io.replace-with='vendored'"]);
        cargo.args(["--config", &format!("source.vendored.directory={vendored:?}")]);
    }
    process::run(&mut cargo).context("building `core` from Debian's source")?;

    // The stamp goes first and comes last: a sysroot without it is not trusted.
    if current {
        std::fs::remove_file(stamp_file())?;
    } else {
        let _ = std::fs::remove_dir_all(sysroot());
    }
    for target in missing {
        copy_libraries(&output.join(target).join("release/deps"), target)?;
    }
    std::fs::write(stamp_file(), version)?;
    let _ = std::fs::remove_dir_all(&scratch);
    toolchain().context("no linker was found: install Debian's package `lld` and try again")
}

fn copy_libraries(from: &Path, target: &str) -> Result<()> {
    let to = sysroot().join("lib/rustlib").join(target).join("lib");
    std::fs::create_dir_all(&to)?;
    for file in std::fs::read_dir(from)? {
        let file = file?;
        let name = file.file_name();
        let text = name.to_string_lossy();
        let wanted = ["libcore-", "liballoc-", "libcompiler_builtins-"];
        if text.ends_with(".rlib") && wanted.iter().any(|start| text.starts_with(start)) {
            std::fs::copy(file.path(), to.join(&name))?;
        }
    }
    Ok(())
}

fn toolchain() -> Option<Toolchain> {
    Some(Toolchain::Debian { cargo: CARGO.into(), rustc: RUSTC.into(), linker: linker()?, sysroot: sysroot() })
}

fn sysroot() -> PathBuf {
    workspace::target_dir().join("thumb-sysroot")
}

fn stamp_file() -> PathBuf {
    sysroot().join("built-by.txt")
}

fn library_source() -> Result<PathBuf> {
    let mut rustc = debian_program(Path::new(RUSTC));
    let root = process::stdout_of(rustc.args(["--print", "sysroot"])).context("rustc has no sysroot")?;
    Ok(Path::new(root.trim_end()).join("lib/rustlib/src/rust/library"))
}

fn compiler_version() -> Option<String> {
    process::stdout_of(debian_program(Path::new(RUSTC)).arg("-vV"))
}

/// Minor version of Debian's compiler.
fn compiler_release() -> Option<u32> {
    let version = compiler_version()?;
    minor(version.lines().find_map(|line| line.strip_prefix("release: "))?)
}

/// The newest lld that is installed: plain, or with the version in its name.
fn linker() -> Option<PathBuf> {
    let numbered = (14..100).rev().map(|number| format!("lld-{number}"));
    numbered.chain(["ld.lld".to_owned()]).find_map(|name| process::find(&name))
}

fn newest_lld() -> String {
    let names = process::stdout_of(Command::new("apt-cache").args(["pkgnames", "lld-"])).unwrap_or_default();
    let numbers = names.lines().filter_map(|name| name.strip_prefix("lld-")?.parse::<u32>().ok());
    // Some are only names that other packages speak of.
    let mut numbers: Vec<u32> = numbers.filter(|n| candidate(&format!("lld-{n}")).is_some()).collect();
    numbers.sort_unstable();
    match numbers.last() {
        Some(number) => format!("lld-{number}"),
        // The lists are empty; they are refreshed before anything is installed.
        None => "lld".to_owned(),
    }
}

/// The packages to use: what is installed if it is new enough, else the newest.
fn family(kit: Kit) -> Result<[&'static str; 3]> {
    let oldest = oldest_rust()?;
    if compiler_release() >= Some(oldest)
        && let Some(family) = FAMILIES.into_iter().find(|family| is_installed(family[0]))
    {
        return Ok(family);
    }
    let newest = || FAMILIES.into_iter().max_by_key(|family| candidate(family[0]));
    let new_enough = |family: &[&'static str; 3]| candidate(family[0]) >= Some(oldest);
    if let Some(family) = newest().filter(new_enough) {
        return Ok(family);
    }
    Manager::Apt.refresh()?;
    newest().filter(new_enough).with_context(|| {
        format!(
            "neither rustup nor a Debian package brings Rust 1.{oldest} or newer for the boards: \
             install rustup from https://rustup.rs, run `rustup target add {}`, and try again",
            kit.target_list()
        )
    })
}

/// Minor version that a package would be installed in.
fn candidate(package: &str) -> Option<u32> {
    let policy = process::stdout_of(Command::new("apt-cache").args(["policy", package]))?;
    let version = policy.lines().find_map(|line| line.trim().strip_prefix("Candidate: "))?;
    minor(version.split_once(':').map_or(version, |(_epoch, version)| version))
}

fn is_installed(package: &str) -> bool {
    let mut query = Command::new("dpkg-query");
    query.args(["--show", "--showformat=${db:Status-Status}", package]);
    process::stdout_of(&mut query).is_some_and(|status| status == "installed")
}

fn has_apt() -> bool {
    ["apt-get", "apt-cache", "dpkg-query"].iter().all(|program| process::find(program).is_some())
}

/// Minor version of the oldest Rust that carom takes.
fn oldest_rust() -> Result<u32> {
    let manifest = std::fs::read_to_string(workspace::root().join("Cargo.toml"))?;
    let line = manifest.lines().find_map(|line| line.strip_prefix("rust-version = \""));
    line.and_then(|line| minor(line.trim_end_matches('"'))).context("Cargo.toml states no rust-version")
}

/// The 85 of "1.85.0".
fn minor(version: &str) -> Option<u32> {
    let mut parts = version.split(|c: char| !c.is_ascii_digit());
    parts.next()?;
    parts.next()?.parse().ok()
}
