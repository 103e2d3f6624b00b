//! Measures whole steps of worlds on a board: `--scalar NAME`. Prints one figure a line, for `cargo xtask bench` to read.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod balls;
#[cfg(target_os = "none")]
#[path = "../../../examples/board/mod.rs"]
mod board;
#[cfg(target_os = "none")]
mod bounds;
#[cfg(target_os = "none")]
mod bricks;
#[cfg(target_os = "none")]
#[path = "../../harness/mod.rs"]
mod harness;
#[cfg(target_os = "none")]
mod kernels;
#[cfg(target_os = "none")]
mod measure;
#[cfg(target_os = "none")]
mod room;
#[cfg(target_os = "none")]
mod stages;

#[cfg(target_os = "none")]
board::entry!(run);

#[cfg(target_os = "none")]
fn run() -> board::Exit {
    harness::run(kernels::run)
}

/// Only boards are measured.
#[cfg(not(target_os = "none"))]
fn main() {}
