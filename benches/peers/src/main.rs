//! Measures what others take for the impulse that carom is measured with: `--scalar NAME --input FILE`, as for
//! `benches/firmware`. Prints one line for each.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../../../examples/board/mod.rs"]
mod board;
#[cfg(target_os = "none")]
mod cheap;
#[cfg(target_os = "none")]
#[path = "../../harness/mod.rs"]
mod harness;
#[cfg(target_os = "none")]
mod measure;
#[cfg(target_os = "none")]
mod with_3dgfx;
#[cfg(target_os = "none")]
mod with_glam;
#[cfg(target_os = "none")]
mod with_nalgebra;

#[cfg(target_os = "none")]
board::entry!(run);

#[cfg(target_os = "none")]
fn run() -> board::Exit {
    harness::run(measure::run)
}

/// Only boards are measured.
#[cfg(not(target_os = "none"))]
fn main() {}
