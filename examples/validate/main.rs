//! Holds the kernel against files of impacts whose results are known: `validate --help`.
//!
//! A tool of the host; on boards it is an empty program.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;

#[cfg(target_os = "none")]
board::entry!(nothing);

#[cfg(target_os = "none")]
fn nothing() -> board::Exit {
    board::Exit::Success
}

// Every number type, whatever the features of this build.
#[cfg(not(target_os = "none"))]
extern crate every_scalar as carom;

#[cfg(not(target_os = "none"))]
mod host;
#[cfg(not(target_os = "none"))]
mod scalars;
#[cfg(not(target_os = "none"))]
mod tool;

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    let arguments = std::env::args_os();
    std::process::ExitCode::from(tool::commands::run(
        arguments,
        &mut std::io::stdout().lock(),
        &mut std::io::stderr().lock(),
    ))
}
