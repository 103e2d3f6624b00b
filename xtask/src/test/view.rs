//! The view's stage: boards write the same trace as this machine, byte for byte, and the page made of one works in a browser.

use crate::boards::{Board, Scalar};
use crate::process;
use crate::setup;
use crate::toolchain::own_cargo;
use crate::view::{self, Options, Progress, TRACE};
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::path::Path;

/// What is compared: each kind of shape, fixed point and floating point, a core without an FPU and one with.
const TRACES: [(&str, Board, Scalar); 3] = [
    ("dice", Board::M0, Scalar::I16F16),
    ("marble_maze", Board::M3, Scalar::I12F20),
    ("pinball", Board::M4f, Scalar::F32),
];

/// A throw whose ghost goes another way.
const SEED: &str = "603";

/// Runs the stage.
pub fn run(yes: bool) -> Result<()> {
    setup::ensure_browser(yes)?;
    process::run(own_cargo().args(["test", "--quiet", "--package", "carom-view"]))?;
    std::env::set_current_dir(workspace::root())?;
    for (example, board, scalar) in TRACES {
        compare(example, board, scalar, yes)?;
    }
    let folder = workspace::target_dir().join("view");
    let page = folder.join("dice.html");
    let mut options = Options::new("dice", Some(Board::M0), Scalar::I16F16, yes);
    options.compare = Some(Scalar::F64);
    options.out = Some(page.clone());
    options.args = vec!["--seed".to_owned(), SEED.to_owned()];
    view::run(&options)?;
    try_page(&page, &folder)
}

fn compare(example: &str, board: Board, scalar: Scalar, yes: bool) -> Result<()> {
    let options = Options::new(example, Some(board), scalar, yes);
    let progress = Progress::new(4);
    let there = view::record(&options, TRACE, Some(board), scalar, &progress)?;
    let here = view::record(&options, TRACE, None, scalar, &progress)?;
    let trace = carom_view::Trace::read(&here)?;
    if let Some(byte) = (0..there.len().max(here.len())).find(|byte| there.get(*byte) != here.get(*byte)) {
        bail!("{example} in {scalar}: from byte {byte} on the trace of {board} is another than that of this machine");
    }
    let (frames, bytes) = (trace.frames.len(), here.len());
    println!("  {example:<16} {scalar:<9} {board:<3}  {frames} frames in {bytes} bytes as on this machine");
    Ok(())
}

/// In a package of its own: nobody else builds what drives a browser.
fn try_page(page: &Path, folder: &Path) -> Result<()> {
    let mut cargo = own_cargo();
    cargo.args(["run", "--quiet", "--package", "carom-browser", "--"]).arg(page).arg(folder);
    process::run(&mut cargo).with_context(|| format!("the page {} in Chromium", page.display()))
}
