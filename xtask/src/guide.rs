//! `cargo xtask guide`: the book of `docs/`, and whether what its pages say of firmware is what is there.

use crate::boards::Board;
use crate::new::{self, Scene};
use crate::process;
use crate::toolchain::own_cargo;
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::process::Command;
use std::time::Duration;

/// The page that begins firmware, and the example that it goes through.
const PAGE: &str = "docs/guide/maze.md";
/// What firmware without the maze says of a ball of 2 cm, less what its contact sinks, that came to rest on its floor.
const RESTING: &str = "the ball is 0.01998";
/// A cold build of a small package takes most of it.
const LIMIT: Duration = Duration::from_secs(600);

/// Builds the book and says where it is.
pub fn build() -> Result<()> {
    process::run(own_cargo().args(["run", "--quiet", "--package", "carom-book", "--"]).arg(workspace::root()))
}

/// The stage `guide` of `cargo xtask test`.
pub fn test(yes: bool) -> Result<()> {
    // In the profile that the book is built with: mdBook is compiled once.
    process::run(own_cargo().args(["test", "--quiet", "--profile", "dev", "--package", "carom-book"]))?;
    build()?;
    let page = read(PAGE)?;
    check_fragments(&page)?;
    let (good, text) = begun(Board::M0, Scene::Maze, yes)?;
    let mut shown = block(&page, "text");
    let (Some(first), Some(last)) = (shown.next(), shown.next()) else { bail!("{PAGE} shows no output") };
    if !good || !text.starts_with(first) || !text.ends_with(last) {
        bail!("the firmware of `cargo xtask new` does not print what {PAGE} says:\n{text}");
    }
    println!("  {}", text.lines().last().unwrap_or_default());
    let (good, text) = begun(Board::M4f, Scene::Ball, yes)?;
    if !good || !text.starts_with(RESTING) {
        bail!("the firmware of `cargo xtask new --empty` does not end with `{RESTING}`:\n{text}");
    }
    println!("  {}", text.trim_end());
    Ok(())
}

/// Begins firmware for a board and runs it: whether it ended well, and what it printed.
fn begun(board: Board, scene: Scene, yes: bool) -> Result<(bool, String)> {
    let folder = tempfile::tempdir()?;
    let firmware = folder.path().join("my-firmware");
    new::run(&firmware, board, None, scene, yes)?;
    // As somebody would run it, who has set nothing.
    let mut cargo = Command::new("cargo");
    cargo.args(["run", "--quiet", "--release"]).current_dir(&firmware).stdout(std::process::Stdio::piped());
    for name in ["RUSTC", "RUSTFLAGS", "CARGO_TARGET_DIR", "CARGO_ENCODED_RUSTFLAGS", "RUSTUP_TOOLCHAIN"] {
        cargo.env_remove(name);
    }
    let end = process::run_for(&mut cargo, LIMIT)?;
    Ok((end.status.is_some_and(|status| status.success()), String::from_utf8_lossy(&end.stdout).into_owned()))
}

/// What the page shows of the firmware stands in it.
fn check_fragments(page: &str) -> Result<()> {
    let source = read("examples/template/src/main.rs")?;
    let mut fragments = block(page, "rust,ignore").peekable();
    if fragments.peek().is_none() {
        bail!("{PAGE} shows nothing of examples/template/src/main.rs");
    }
    for fragment in fragments {
        if !source.contains(fragment.trim_end()) {
            bail!("{PAGE} shows what is not in examples/template/src/main.rs:\n{fragment}");
        }
    }
    Ok(())
}

/// The fenced blocks of a language.
fn block<'a>(page: &'a str, language: &str) -> impl Iterator<Item = &'a str> {
    let fence = format!("```{language}\n");
    let parts: Vec<&str> = page.split(&fence).skip(1).collect();
    parts.into_iter().filter_map(|rest| rest.split("```").next())
}

fn read(file: &str) -> Result<String> {
    let path = workspace::root().join(file);
    std::fs::read_to_string(&path).with_context(|| format!("reading {}", path.display()))
}
