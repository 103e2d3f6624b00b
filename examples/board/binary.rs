//! Binary files, written through a buffer of fixed size: a call over the debug channel is slow, whatever its length.

use super::system::File;
use super::text::{FileError, Line};

/// Creates a binary file, or empties the one that is there.
pub fn create_binary(path: &str) -> Result<BinaryWriter, FileError> {
    Ok(BinaryWriter { file: File::create(path)?, gathered: Line::new(), failed: false })
}

/// A binary file being written; see [`create_binary`]. Numbers go in with their lowest byte first. Call `finish` at the end.
pub struct BinaryWriter {
    file: File,
    gathered: Line,
    failed: bool,
}

impl BinaryWriter {
    pub fn bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            if !self.gathered.push(*byte) {
                self.flush();
                self.gathered.push(*byte);
            }
        }
    }

    /// Writes out what is still buffered; tells of any write that failed on the way.
    pub fn finish(mut self) -> Result<(), FileError> {
        self.flush();
        if self.failed { Err(FileError::Write) } else { Ok(()) }
    }

    fn flush(&mut self) {
        self.failed |= self.file.write_all(self.gathered.bytes()).is_err();
        self.gathered.clear();
    }
}
