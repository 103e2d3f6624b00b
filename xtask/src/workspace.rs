//! Where things are in the repository.

use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};

/// The root of the repository.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("xtask/ lies in the repository")
}

/// Where everything that is built goes: `target/`, or `CARGO_TARGET_DIR` when that is set.
pub fn target_dir() -> PathBuf {
    match std::env::var_os("CARGO_TARGET_DIR") {
        Some(dir) if !dir.is_empty() => std::path::absolute(&dir).unwrap_or_else(|_| PathBuf::from(dir)),
        _ => root().join("target"),
    }
}

/// The names of all examples, sorted: files, and folders with a `main.rs` in them.
pub fn examples() -> Result<Vec<String>> {
    let dir = root().join("examples");
    let mut names = Vec::new();
    for entry in std::fs::read_dir(&dir).with_context(|| format!("reading {}", dir.display()))? {
        let path = entry?.path();
        let is_file = path.extension().is_some_and(|extension| extension == "rs");
        if (is_file || path.join("main.rs").is_file())
            && let Some(name) = path.file_stem().and_then(|name| name.to_str())
        {
            names.push(name.to_owned());
        }
    }
    names.sort();
    Ok(names)
}

/// The names of the examples that do something on a board.
pub fn board_examples() -> Result<Vec<String>> {
    let mut names = examples()?;
    // A host tool: its firmware is an empty main.
    names.retain(|name| name != "validate");
    Ok(names)
}

/// Complains, with the list of examples, when there is no such example.
pub fn check_example(name: &str) -> Result<()> {
    let names = examples()?;
    if !names.iter().any(|known| known == name) {
        bail!("there is no example `{name}`; the examples are: {}", names.join(", "));
    }
    Ok(())
}
