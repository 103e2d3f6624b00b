//! Board shim: lets one example file run on the host and, unchanged, on a Cortex-M board (in QEMU or under a
//! debugger, through semihosting). Nothing here allocates on the board.
//!
//! ```ignore
//! #![cfg_attr(target_os = "none", no_std, no_main)]
//!
//! mod board;
//! use board::Exit;
//!
//! board::entry!(run); // defines `main` (host) or the reset entry point (board)
//!
//! fn run() -> Exit {
//!     board::println!("{} bodies", 2);
//!     Exit::Success
//! }
//! ```
//!
//! - [`entry!`]`(path)`: `path` is a `fn() -> Exit`.
//! - [`Exit`]: `Success` ends with status 0, `Failure` with status 1, on the host and in QEMU alike. On a board a
//!   panic, a hard fault and any unexpected exception end the run with status 1 as well.
//! - `println!(...)` and `print!(...)`: to standard output. A board makes one semihosting call per `println!` (of up
//!   to [`LINE`] bytes). Print integers on boards: float formatting costs tens of kilobytes of flash.
//! - [`args`]`()`: the arguments without the program's name, an iterator of `&'static str`. On a board they come from
//!   the semihosting command line and cannot contain white space.
//! - [`option`]`("--scalar")`: the value that follows that name on the command line, if it is there.
//! - [`open`]`(path)`: reads a text file, `reader.next_line() -> Result<Option<&str>, FileError>`; lines come without
//!   their line ending and may have up to [`LINE`] bytes.
//! - [`create`]`(path)`: writes one, `writeln!(writer, ...)` with `core::fmt::Write` in scope, then
//!   `writer.finish() -> Result<(), FileError>`.
//! - [`create_binary`]`(path)`: writes a file of bytes, `writer.bytes(&[..])`, then `writer.finish()`.
//! - [`FileError`]: what went wrong; it prints itself as one sentence.

// Each example uses the part of the shim that it needs.
#![allow(dead_code, unused_imports, unused_macros)]

mod binary;
mod text;

// The system below: files, standard output, arguments, the entry point.
#[cfg(target_os = "none")]
#[path = "semihosting.rs"]
mod system;
#[cfg(not(target_os = "none"))]
#[path = "host.rs"]
mod system;

pub use binary::{BinaryWriter, create_binary};
pub use system::{args, exit, print_fmt, println_fmt};
pub use text::{FileError, LINE, LineReader, LineWriter, create, open};

/// How a run ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// Status 0.
    Success,
    /// Status 1.
    Failure,
}

/// The value that follows `name` on the command line.
pub fn option(name: &str) -> Option<&'static str> {
    let mut args = args();
    args.find(|arg| *arg == name)?;
    args.next()
}

/// Makes `$run`, a `fn() -> Exit`, the program.
macro_rules! entry {
    ($run:path) => {
        #[cfg(not(target_os = "none"))]
        fn main() {
            $crate::board::exit($run())
        }

        // `cortex_m_rt::entry` names the reset code's `main`; it starts with the FPU on where the target has one.
        #[cfg(target_os = "none")]
        #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
        #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
        fn main() -> ! {
            $crate::board::exit($run())
        }
    };
}

macro_rules! board_println {
    () => { $crate::board::println_fmt(format_args!("")) };
    ($($arg:tt)*) => { $crate::board::println_fmt(format_args!($($arg)*)) };
}

macro_rules! board_print {
    ($($arg:tt)*) => { $crate::board::print_fmt(format_args!($($arg)*)) };
}

pub(crate) use board_print as print;
pub(crate) use board_println as println;
pub(crate) use entry;
