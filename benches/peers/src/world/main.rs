//! Plays others' worlds, as `benches/world` plays carom's: `--scalar f32`. Prints one line for each scene.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../../../../examples/board/mod.rs"]
mod board;
#[cfg(target_os = "none")]
#[path = "../../../harness/mod.rs"]
mod harness;
#[cfg(target_os = "none")]
mod heap;
#[cfg(target_os = "none")]
mod measure;
#[cfg(target_os = "none")]
mod with_3dgfx;
#[cfg(target_os = "none")]
mod with_he3d;

#[cfg(target_os = "none")]
board::entry!(run);

#[cfg(target_os = "none")]
fn run() -> board::Exit {
    heap::start();
    harness::run(measure::run)
}

/// Only boards are measured.
#[cfg(not(target_os = "none"))]
fn main() {}
