//! Text files line by line through a buffer of fixed size.

use super::system::File;
use core::fmt;

/// Longest line, in bytes, that a [`LineReader`] takes and that `println!` prints in one piece.
pub const LINE: usize = 512;

/// Why a file could not be read or written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileError {
    /// There is no such file, or it may not be opened.
    Open,
    /// Reading failed half-way.
    Read,
    /// Writing failed half-way.
    Write,
    /// A line is longer than [`LINE`] bytes.
    LineTooLong,
    /// A line is not UTF-8.
    NotText,
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            FileError::Open => "the file cannot be opened",
            FileError::Read => "the file cannot be read",
            FileError::Write => "the file cannot be written",
            FileError::LineTooLong => "a line is too long",
            FileError::NotText => "a line is not UTF-8 text",
        })
    }
}

/// Opens a text file for reading.
pub fn open(path: &str) -> Result<LineReader, FileError> {
    Ok(LineReader { file: File::open(path)?, buffer: [0; LINE + 2], start: 0, end: 0, at_end: false })
}

/// Creates a text file, or empties the one that is there.
pub fn create(path: &str) -> Result<LineWriter, FileError> {
    Ok(LineWriter { file: File::create(path)?, line: Line::new(), failed: false })
}

/// A text file being read; see [`open`].
pub struct LineReader {
    file: File,
    // One line with its line ending ("\r\n" at most) fits exactly.
    buffer: [u8; LINE + 2],
    // buffer[start..end] has been read from the file and not yet been handed out.
    start: usize,
    end: usize,
    at_end: bool,
}

impl LineReader {
    /// The next line without its line ending, or `None` at the end of the file.
    pub fn next_line(&mut self) -> Result<Option<&str>, FileError> {
        let length = loop {
            let pending = self.buffer.get(self.start..self.end).unwrap_or_default();
            match pending.iter().position(|&byte| byte == b'\n') {
                Some(newline) => break newline + 1,
                None if self.at_end && pending.is_empty() => return Ok(None),
                None if self.at_end => break pending.len(),
                None => self.fill()?,
            }
        };
        let from = self.start;
        self.start = from + length;
        let line = self.buffer.get(from..self.start).unwrap_or_default();
        let line = line.strip_suffix(b"\n").unwrap_or(line);
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        match core::str::from_utf8(line) {
            Ok(line) => Ok(Some(line)),
            Err(_) => Err(FileError::NotText),
        }
    }

    /// Moves what is pending to the front of the buffer and reads more behind it.
    fn fill(&mut self) -> Result<(), FileError> {
        let mut kept = 0;
        for index in self.start..self.end {
            // `copy_within` would do, but it can panic, and the panic would be linked in.
            if let Some(&byte) = self.buffer.get(index)
                && let Some(slot) = self.buffer.get_mut(kept)
            {
                *slot = byte;
                kept += 1;
            }
        }
        (self.start, self.end) = (0, kept);
        let free = self.buffer.get_mut(kept..).unwrap_or_default();
        if free.is_empty() {
            return Err(FileError::LineTooLong);
        }
        let count = self.file.read(free)?;
        self.at_end = count == 0;
        self.end = kept + count;
        Ok(())
    }
}

/// A text file being written; see [`create`]. Use it through `core::fmt::Write`, then call `finish`.
pub struct LineWriter {
    file: File,
    line: Line,
    failed: bool,
}

impl LineWriter {
    /// Writes out what is still buffered; tells of any write that failed on the way.
    pub fn finish(mut self) -> Result<(), FileError> {
        self.flush();
        if self.failed { Err(FileError::Write) } else { Ok(()) }
    }

    fn flush(&mut self) {
        self.failed |= self.file.write_all(self.line.bytes()).is_err();
        self.line.clear();
    }
}

impl fmt::Write for LineWriter {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            if !self.line.push(byte) {
                self.flush();
                self.line.push(byte);
            }
        }
        if self.failed { Err(fmt::Error) } else { Ok(()) }
    }
}

/// Bytes gathered up to [`LINE`] of them.
pub struct Line {
    buffer: [u8; LINE],
    length: usize,
}

impl Line {
    /// An empty line.
    pub const fn new() -> Self {
        Line { buffer: [0; LINE], length: 0 }
    }

    /// Adds one byte; false when the line is full.
    pub fn push(&mut self, byte: u8) -> bool {
        match self.buffer.get_mut(self.length) {
            Some(slot) => {
                *slot = byte;
                self.length += 1;
                true
            }
            None => false,
        }
    }

    /// What has been gathered.
    pub fn bytes(&self) -> &[u8] {
        self.buffer.get(..self.length).unwrap_or_default()
    }

    /// Forgets it.
    pub fn clear(&mut self) {
        self.length = 0;
    }
}
