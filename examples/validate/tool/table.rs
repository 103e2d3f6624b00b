//! Reading a CSV file: columns by name, numbers that are numbers, and errors that say where.

use std::fs::File;
use std::path::{Path, PathBuf};

use csv::{ByteRecord, Reader, ReaderBuilder, Trim};

use super::error::{Error, Result};

/// A CSV file, row by row.
pub struct Table {
    path: PathBuf,
    length: u64,
    reader: Reader<File>,
    headers: Vec<String>,
    record: ByteRecord,
    row: u64,
}

/// One row of it.
#[derive(Clone, Copy)]
pub struct Row<'a> {
    table: &'a Table,
}

impl Table {
    pub fn open(path: &Path) -> Result<Self> {
        let cannot = |problem: std::io::Error| Error::of_file(path, format_args!("cannot be read: {problem}"));
        let file = File::open(path).map_err(cannot)?;
        let length = file.metadata().map_err(cannot)?.len();
        // Rows of a wrong length are told with the column's name below.
        let reader = ReaderBuilder::new().has_headers(false).flexible(true).trim(Trim::All).from_reader(file);
        let mut table =
            Self { path: path.to_owned(), length, reader, headers: vec![], record: ByteRecord::new(), row: 0 };
        if !table.read_record()? {
            return Err(Error::of_file(path, "is empty: a header was expected"));
        }
        for (index, name) in table.record.iter().enumerate() {
            let name = String::from_utf8_lossy(name).into_owned();
            if table.headers.contains(&name) {
                let problem = format!("header: column {} is the second with the name {}", index + 1, quoted(&name));
                return Err(Error::of_file(path, problem));
            }
            table.headers.push(name);
        }
        Ok(table)
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// How much of the file has been read, of how much.
    pub fn position(&self) -> (u64, u64) {
        (self.reader.position().byte(), self.length)
    }

    pub fn has(&self, name: &str) -> bool {
        self.find(name).is_some()
    }

    /// Where the named columns are; an error names all that are missing.
    pub fn columns<const N: usize>(&self, names: [&str; N]) -> Result<[usize; N]> {
        let missing: Vec<&str> = names.into_iter().filter(|name| !self.has(name)).collect();
        if missing.is_empty() {
            return Ok(names.map(|name| self.find(name).unwrap_or_default()));
        }
        let plural = if missing.len() == 1 { "" } else { "s" };
        Err(Error::of_file(&self.path, format_args!("header: missing column{plural} {}", missing.join(", "))))
    }

    /// The next row; `None` at the end of the file.
    pub fn next_row(&mut self) -> Result<Option<Row<'_>>> {
        if !self.read_record()? {
            return Ok(None);
        }
        self.row += 1;
        let (fields, columns) = (self.record.len(), self.headers.len());
        if fields < columns {
            return Err(self.row().refuse(fields, "is missing: the row ends before it"));
        }
        if fields > columns {
            let problem = format_args!("{}, column {}: the header has only {columns}", self.place(), columns + 1);
            return Err(Error::of_file(&self.path, problem));
        }
        Ok(Some(self.row()))
    }

    fn row(&self) -> Row<'_> {
        Row { table: self }
    }

    fn find(&self, name: &str) -> Option<usize> {
        self.headers.iter().position(|header| header == name)
    }

    fn read_record(&mut self) -> Result<bool> {
        let problem = match self.reader.read_byte_record(&mut self.record) {
            Ok(more) => return Ok(more),
            Err(problem) => problem,
        };
        Err(Error::of_file(&self.path, format_args!("row {}: cannot be read: {problem}", self.row + 1)))
    }

    fn place(&self) -> String {
        let line = self.record.position().map_or(0, csv::Position::line);
        format!("row {} (line {line})", self.row)
    }
}

impl<'a> Row<'a> {
    /// The text of a column, which must not be empty.
    pub fn text(self, column: usize) -> Result<&'a str> {
        match self.cell(column)? {
            "" => Err(self.refuse(column, "is empty")),
            text => Ok(text),
        }
    }

    /// The text of a column.
    pub fn cell(self, column: usize) -> Result<&'a str> {
        let bytes = self.table.record.get(column).unwrap_or_default();
        std::str::from_utf8(bytes).map_err(|_| self.refuse(column, "is not UTF-8 text"))
    }

    /// The finite number in a column.
    pub fn number(self, column: usize) -> Result<f64> {
        let text = self.text(column)?;
        match text.parse::<f64>() {
            Ok(x) if x.is_finite() => Ok(x),
            Ok(_) => Err(self.refuse(column, format_args!("{} is not a finite number", quoted(text)))),
            Err(_) => Err(self.refuse(column, format_args!("{} is not a number", quoted(text)))),
        }
    }

    pub fn numbers<const N: usize>(self, columns: [usize; N]) -> Result<[f64; N]> {
        let mut numbers = [0.0; N];
        for (number, column) in numbers.iter_mut().zip(columns) {
            *number = self.number(column)?;
        }
        Ok(numbers)
    }

    /// A number with something wrong with it, if `good` says so.
    pub fn checked(self, column: usize, good: impl Fn(f64) -> bool, rule: &str) -> Result<f64> {
        let x = self.number(column)?;
        if good(x) { Ok(x) } else { Err(self.refuse(column, format_args!("{x} {rule}"))) }
    }

    /// An error about a column.
    pub fn refuse(self, column: usize, problem: impl std::fmt::Display) -> Error {
        let name = &self.table.headers[column];
        Error::of_file(&self.table.path, format_args!("{}, column {name}: {problem}", self.table.place()))
    }
}

/// The text in quotes, cut where it is long.
pub fn quoted(text: &str) -> String {
    const LONGEST: usize = 40;
    let mut short: String = text.chars().take(LONGEST).collect();
    if short.len() < text.len() {
        short.push_str("...");
    }
    format!("{short:?}")
}
