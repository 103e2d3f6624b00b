//! The file of results: written beside its place and moved there when it is whole.

use std::fs::File;
use std::path::{Path, PathBuf};

use csv::Writer;

use super::error::{Error, Result};

/// A CSV file that comes into being at [`finish`](Self::finish), or never.
pub struct Output {
    path: PathBuf,
    partial: PathBuf,
    writer: Option<Writer<File>>,
}

impl Output {
    /// Refuses to replace the file that is being read, and anything that is not a file.
    pub fn create(path: &Path, input: &Path, header: &[&str]) -> Result<Self> {
        if path.metadata().is_ok_and(|there| !there.is_file()) {
            return Err(Error::of_file(path, "is there already and is not a file"));
        }
        // Through a link the file it leads to is replaced.
        let place = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        if input.canonicalize().is_ok_and(|input| input == place) {
            return Err(Error::of_file(path, "is the file to read: --out would replace it"));
        }
        let name = place.file_name().ok_or_else(|| Error::of_file(path, "is not a name for a file"))?;
        let partial = place.with_file_name(format!(".{}.{}.partial", name.to_string_lossy(), std::process::id()));
        let file = File::create(&partial)
            .map_err(|problem| Error::of_file(path, format_args!("cannot be written: {problem}")))?;
        let mut output = Self { path: place.clone(), partial, writer: Some(Writer::from_writer(file)) };
        output.record(header.iter().map(|name| (*name).to_owned()))?;
        Ok(output)
    }

    /// One row: numbers with as many digits as it takes to read the same number back.
    pub fn row(&mut self, id: &str, numbers: impl IntoIterator<Item = f64>) -> Result<()> {
        self.record([id.to_owned()].into_iter().chain(numbers.into_iter().map(|x| x.to_string())))
    }

    /// Puts the file in its place.
    pub fn finish(mut self) -> Result<()> {
        let flushed = self.writer.take().map_or(Ok(()), |mut writer| writer.flush());
        flushed.and_then(|()| std::fs::rename(&self.partial, &self.path)).map_err(|problem| self.cannot(problem))
    }

    fn record(&mut self, fields: impl Iterator<Item = String>) -> Result<()> {
        let Some(writer) = &mut self.writer else { return Ok(()) };
        writer.write_record(fields).map_err(|problem| self.cannot(problem))
    }

    fn cannot(&self, problem: impl std::fmt::Display) -> Error {
        Error::of_file(&self.path, format_args!("cannot be written: {problem}"))
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        // After `finish` there is nothing there.
        drop(self.writer.take());
        let _ = std::fs::remove_file(&self.partial);
    }
}
