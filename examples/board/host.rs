//! The host's side of the shim: `std`.

use super::Exit;
use super::text::FileError;
use std::fmt;
use std::io::{Read, Write};

/// The program's arguments, without its name.
pub fn args() -> impl Iterator<Item = &'static str> {
    // Leaked so that host and board hand out the same type.
    std::env::args_os().skip(1).map(|arg| &*Box::leak(arg.to_string_lossy().into_owned().into_boxed_str()))
}

/// Ends the program.
pub fn exit(exit: Exit) -> ! {
    let _ = std::io::stdout().flush();
    std::process::exit(match exit {
        Exit::Success => 0,
        Exit::Failure => 1,
    })
}

/// `println!` without the macro.
pub fn println_fmt(arguments: fmt::Arguments<'_>) {
    std::println!("{arguments}");
}

/// `print!` without the macro.
pub fn print_fmt(arguments: fmt::Arguments<'_>) {
    std::print!("{arguments}");
}

/// An open file.
pub struct File(std::fs::File);

impl File {
    pub fn open(path: &str) -> Result<Self, FileError> {
        std::fs::File::open(path).map(File).map_err(|_| FileError::Open)
    }

    pub fn create(path: &str) -> Result<Self, FileError> {
        std::fs::File::create(path).map(File).map_err(|_| FileError::Open)
    }

    /// Reads some bytes; none means the end of the file.
    pub fn read(&mut self, buffer: &mut [u8]) -> Result<usize, FileError> {
        self.0.read(buffer).map_err(|_| FileError::Read)
    }

    pub fn write_all(&mut self, bytes: &[u8]) -> Result<(), FileError> {
        self.0.write_all(bytes).map_err(|_| FileError::Write)
    }
}
