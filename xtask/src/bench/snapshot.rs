//! The figures that the repository keeps: `benches/snapshot.json`, one line a figure.

use super::figures::{Figure, Key};
use super::image::Opt;
use crate::boards::{Board, Scalar};
use crate::workspace;
use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// Figures, and the compiler that they are of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// As `rustc --version` says.
    pub rustc: String,
    pub figures: Vec<Figure>,
}

impl Snapshot {
    /// The one in the repository.
    pub fn read() -> Result<Self> {
        let path = path();
        let text = std::fs::read_to_string(&path)
            .with_context(|| format!("reading {} (`cargo xtask bench --save` writes it)", path.display()))?;
        serde_json::from_str(&text).with_context(|| format!("reading {}", path.display()))
    }

    pub fn find(&self, board: Board, by: &str, operation: &str, scalar: Scalar, opt: Opt) -> Option<&Figure> {
        let key = Key { board, by: by.to_owned(), operation: operation.to_owned(), scalar, opt };
        self.figures.iter().find(|figure| figure.key == key)
    }

    /// Makes it the one in the repository.
    pub fn write(&self) -> Result<()> {
        let path = path();
        std::fs::write(&path, self.to_json()?).with_context(|| format!("writing {}", path.display()))
    }

    /// A line a figure, so that a difference shows which ones changed.
    pub fn to_json(&self) -> Result<String> {
        let lines: Vec<String> = self.figures.iter().map(serde_json::to_string).collect::<Result<_, _>>()?;
        Ok(format!("{{\n\"rustc\": {:?},\n\"figures\": [\n{}\n]\n}}\n", self.rustc, lines.join(",\n")))
    }
}

fn path() -> PathBuf {
    workspace::root().join("benches/snapshot.json")
}
