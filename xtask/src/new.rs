//! `cargo xtask new`: firmware of one's own to begin with, in a folder outside this clone.

use crate::boards::Board;
use crate::qemu;
use crate::setup;
use crate::toolchain::Toolchain;
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::fs;
use std::path::{Path, PathBuf};

/// How the template names itself, and where it finds carom.
const NAME: &str = "my-firmware";
const PATH: &str = "\"../..\"";

/// What the firmware begins with.
#[derive(Clone, Copy)]
pub enum Scene {
    Maze,
    Ball,
}

/// The template's folder.
pub fn template() -> PathBuf {
    workspace::root().join("examples/template")
}

/// Writes the package.
pub fn run(folder: &Path, board: Board, scene: Scene, yes: bool) -> Result<()> {
    let folder = resolved(folder)?;
    if folder.starts_with(workspace::root().canonicalize()?) {
        bail!("{} lies in carom's own folder, whose settings would reach it: name one outside", folder.display());
    }
    if fs::read_dir(&folder).is_ok_and(|mut entries| entries.next().is_some()) {
        bail!("{} is there and not empty: name another folder", folder.display());
    }
    let toolchain = setup::ensure_for(board, yes)?;
    let (main, what) = match scene {
        Scene::Maze => ("src/main.rs", "a marble maze"),
        Scene::Ball => ("src/bin/empty.rs", "a ball on a floor"),
    };
    put(&folder.join("memory.x"), &read("memory.x")?)?;
    put(&folder.join("src/main.rs"), &read(main)?)?;
    put(&folder.join("Cargo.toml"), &manifest(&folder)?)?;
    put(&folder.join(".cargo/config.toml"), &config(&toolchain, board))?;
    put(&folder.join(".gitignore"), "/target\n")?;
    println!("{what} for {board}: `cd {} && cargo run --release`", folder.display());
    Ok(())
}

/// Where the folder is or will be, without `..` and links in what is there already.
fn resolved(folder: &Path) -> Result<PathBuf> {
    let folder = std::path::absolute(folder)?;
    match (folder.canonicalize(), folder.parent(), folder.file_name()) {
        (Ok(there), ..) => Ok(there),
        (Err(_), Some(parent), Some(name)) => Ok(resolved(parent)?.join(name)),
        (Err(error), ..) => Err(error).with_context(|| format!("looking for {}", folder.display())),
    }
}

/// The manifest with the folder's name, as far as packages may have it, and the place of this clone.
fn manifest(folder: &Path) -> Result<String> {
    let text = read("Cargo.toml")?;
    if !text.contains(NAME) || !text.contains(PATH) {
        bail!("examples/template/Cargo.toml has no {NAME} or no path {PATH}");
    }
    let name = folder.file_name().and_then(|name| name.to_str()).unwrap_or(NAME);
    let letter = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    let fits = name.starts_with(|c: char| c.is_ascii_alphabetic()) && name.chars().all(letter);
    let root = workspace::root().display().to_string();
    // What is said of the template is not true of its copy.
    let text = text.trim_start_matches(|c| c != '[');
    Ok(text.replace(NAME, if fits { name } else { NAME }).replace(PATH, &format!("{root:?}")))
}

/// Cargo's settings: the target, QEMU as its runner, and the compiler, where it is not cargo's own.
fn config(toolchain: &Toolchain, board: Board) -> String {
    let target = board.target();
    let runner = [&[board.emulator()], board.qemu_machine(), &qemu::QUIET, &["-semihosting-config", qemu::SEMIHOSTING]];
    let runner = runner.concat().join(" ");
    let mut flags = vec!["-C".to_owned(), "link-arg=-Tlink.x".to_owned()];
    let (mut rustc, mut linker) = (String::new(), String::new());
    if let Toolchain::Debian { rustc: program, linker: lld, sysroot, .. } = toolchain {
        flags.extend(["--sysroot".to_owned(), sysroot.display().to_string()]);
        rustc = format!("rustc = {program:?}\n");
        linker = format!("linker = {lld:?}\n");
    }
    format!(
        "[build]\ntarget = \"{target}\"\n{rustc}\n[target.{target}]\nrunner = \"{runner} -kernel\"\n{linker}rustflags = {flags:?}\n"
    )
}

fn read(file: &str) -> Result<String> {
    let path = template().join(file);
    fs::read_to_string(&path).with_context(|| format!("reading {}", path.display()))
}

fn put(path: &Path, text: &str) -> Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).with_context(|| format!("making {}", folder.display()))?;
    }
    fs::write(path, text).with_context(|| format!("writing {}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::resolved;
    use crate::workspace;

    #[test]
    fn beside_the_clone_is_outside() {
        let root = workspace::root().canonicalize().expect("a folder");
        let resolved = |path: &str| resolved(&root.join(path)).expect("a place");
        assert_eq!(resolved("../my-marble-that-is-not-there"), root.with_file_name("my-marble-that-is-not-there"));
        assert_eq!(resolved("src/../not/there"), root.join("not/there"));
        assert_eq!(resolved("src"), root.join("src"));
    }
}
