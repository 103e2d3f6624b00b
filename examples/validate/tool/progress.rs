//! A bar on the terminal, for files that take longer than a second.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use super::error::{Error, Result};
use super::table::{Row, Table};

const PATIENCE: Duration = Duration::from_secs(1);

/// Nothing for the first second.
struct Progress {
    start: Instant,
    bar: Option<ProgressBar>,
    rows: u64,
}

impl Progress {
    fn new() -> Self {
        Self { start: Instant::now(), bar: None, rows: 0 }
    }

    /// Another row of that file was done.
    fn advance(&mut self, table: &Table) {
        self.rows += 1;
        if !self.rows.is_multiple_of(64) || self.start.elapsed() < PATIENCE {
            return;
        }
        let (read, length) = table.position();
        let bar = self.bar.get_or_insert_with(|| {
            let style = ProgressStyle::with_template("{wide_bar} {percent} % of the file, {eta} left");
            // On a stream that is no terminal it draws nothing.
            ProgressBar::new(length).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        });
        bar.set_position(read);
    }
}

/// Every row of a file, of which there must be one; a bar shows how far it is.
pub fn each_row(table: &mut Table, mut each: impl FnMut(Row<'_>) -> Result<()>) -> Result<()> {
    let mut progress = Progress::new();
    while let Some(row) = table.next_row()? {
        each(row)?;
        progress.advance(table);
    }
    if progress.rows == 0 { Err(Error::of_file(table.path(), "has no rows")) } else { Ok(()) }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
