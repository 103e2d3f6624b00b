//! Builds the book of `docs/`, after a look at the links of all pages.
//!
//! `carom-book ROOT`: the root of the repository.

mod links;
mod outside;
mod page;

use anyhow::{Context, Result, bail};
use mdbook_driver::MDBook;
use outside::Outside;
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<()> {
    let root: PathBuf = std::env::args_os().nth(1).context("usage: carom-book ROOT")?.into();
    let links = links::check(&root)?;
    if !links.broken.is_empty() {
        bail!("{} links lead nowhere:\n  {}", links.broken.len(), links.broken.join("\n  "));
    }
    println!("{} links in {} pages lead somewhere", links.good, links.pages);

    let mut book = MDBook::load(root.join("docs"))?;
    let unlisted = links::unlisted(&root.join("docs"), &book)?;
    if !unlisted.is_empty() {
        bail!("docs/SUMMARY.md leaves out: {}", unlisted.join(", "));
    }
    book.with_preprocessor(Outside);
    book.build()?;
    let index = book.build_dir_for("html").join("index.html");
    println!("{}", index.canonicalize().unwrap_or(index).display());
    Ok(())
}
