//! Measures carom's operations on a board: `--scalar NAME --input FILE`, the file as `cargo xtask bench` writes it.
//! Prints one figure a line, for `cargo xtask bench` to read.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../../../examples/board/mod.rs"]
mod board;
#[cfg(target_os = "none")]
#[path = "../../harness/mod.rs"]
mod harness;
#[cfg(target_os = "none")]
mod measure;
#[cfg(target_os = "none")]
mod operands;
#[cfg(target_os = "none")]
mod operations;
#[cfg(target_os = "none")]
mod scalars;

#[cfg(target_os = "none")]
board::entry!(run);

#[cfg(target_os = "none")]
fn run() -> board::Exit {
    harness::run(scalars::run)
}

/// Only boards are measured.
#[cfg(not(target_os = "none"))]
fn main() {}
