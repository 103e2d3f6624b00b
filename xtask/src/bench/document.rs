//! What of the documentation is made from the snapshot: tables between markers, and the chart.

use super::snapshot::Snapshot;
use super::{chart, markdown, worlds};
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};

/// Brings all of it up to date.
pub fn write(snapshot: &Snapshot) -> Result<()> {
    for (path, text) in documents(snapshot)? {
        std::fs::write(&path, text).with_context(|| format!("writing {}", path.display()))?;
    }
    Ok(())
}

/// An error names what is not up to date.
pub fn check(snapshot: &Snapshot) -> Result<()> {
    for (path, text) in documents(snapshot)? {
        if std::fs::read_to_string(&path).unwrap_or_default() != text {
            bail!("{} does not show the figures of the snapshot: `cargo xtask chart`", path.display());
        }
    }
    Ok(())
}

/// Each file with what it should hold.
fn documents(snapshot: &Snapshot) -> Result<Vec<(PathBuf, String)>> {
    let root = workspace::root();
    let readme = read(&root.join("README.md"))?;
    let cost = read(&root.join("docs/cost.md"))?;
    let cost = fill(&cost, "boards", &markdown::boards(snapshot))?;
    let cost = fill(&cost, "sizes", &markdown::sizes(snapshot))?;
    let cost = fill(&cost, "formats", &markdown::formats(snapshot, &readme)?)?;
    let cost = fill(&cost, "peers", &markdown::peers(snapshot))?;
    let cost = fill(&cost, "world", &worlds::steps(snapshot))?;
    let cost = fill(&cost, "stages", &worlds::stages(snapshot))?;
    let cost = fill(&cost, "bound", &worlds::bounds(snapshot))?;
    let cost = fill(&cost, "world sizes", &worlds::sizes(snapshot))?;
    let cost = fill(&cost, "world peers", &worlds::peers(snapshot))?;
    let cost = fill(&cost, "compiler", &format!("Compiled by {}.\n", snapshot.rustc))?;
    let short = fill(&readme, "cost", &markdown::short(snapshot))?;
    let short = fill(&short, "world", &worlds::short(snapshot))?;
    Ok(vec![
        (root.join("README.md"), short),
        (root.join("docs/cost.md"), cost),
        (root.join("docs/cost.svg"), chart::svg(snapshot)),
    ])
}

fn read(path: &Path) -> Result<String> {
    std::fs::read_to_string(path).with_context(|| format!("reading {}", path.display()))
}

/// The text with the part between the markers of that name replaced.
fn fill(text: &str, name: &str, part: &str) -> Result<String> {
    let (begin, end) = (format!("<!-- bench {name} -->\n"), "<!-- end of bench -->");
    let missing = || format!("the marker `{}` or its end is missing", begin.trim_end());
    let (before, rest) = text.split_once(&begin).with_context(missing)?;
    let (_, after) = rest.split_once(end).with_context(missing)?;
    Ok(format!("{before}{begin}\n{part}\n{end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_between_the_markers() {
        let text = "a\n<!-- bench x -->\nold\n<!-- end of bench -->\nb";
        assert_eq!(
            fill(text, "x", "new\n").expect("it is there"),
            "a\n<!-- bench x -->\n\nnew\n\n<!-- end of bench -->\nb"
        );
        assert!(fill(text, "y", "new").is_err());
    }

    #[test]
    fn the_documentation_shows_the_snapshot() {
        check(&Snapshot::read().expect("a snapshot")).expect("up to date");
    }
}
