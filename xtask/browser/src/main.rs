//! `carom-browser PAGE FOLDER`: opens a page of the dice in a headless Chromium, plays, scrubs, orbits, and looks at what is drawn.
//! Screenshots go into the folder.

mod checks;
mod chromium;
mod picture;
mod tab;

use anyhow::{Context, Result};
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
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let usage = "usage: carom-browser PAGE FOLDER";
    let (page, folder) = (arguments.next().context(usage)?, arguments.next().context(usage)?);
    let page = page.canonicalize().with_context(|| format!("there is no page {}", page.display()))?;
    std::fs::create_dir_all(&folder)?;
    let mut browser = chromium::Chromium::start()?;
    checks::all(&mut browser, &page, &folder)
}
