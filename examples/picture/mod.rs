//! Pictures in characters, and how an example ends.

// Each example uses the part that it needs.
#![allow(dead_code)]

use crate::board::{self, Exit};

/// A field of characters.
#[derive(PartialEq)]
pub struct Picture<const COLUMNS: usize, const ROWS: usize> {
    cells: [[u8; COLUMNS]; ROWS],
}

/// The cell, of so many between `low` and `high`, in which `x` lies.
pub fn cell(x: i32, [low, high]: [i32; 2], cells: usize) -> Option<usize> {
    let part = x.wrapping_sub(low).wrapping_mul(cells as i32).checked_div(high.wrapping_sub(low))?;
    usize::try_from(part).ok().filter(|cell| x >= low && *cell < cells)
}

impl<const COLUMNS: usize, const ROWS: usize> Picture<COLUMNS, ROWS> {
    pub const fn new() -> Self {
        Self { cells: [[b' '; COLUMNS]; ROWS] }
    }

    /// Puts a character at a place of the rectangle that the picture shows: from the left, and from below.
    pub fn put(&mut self, [x, y]: [i32; 2], [across, up]: [[i32; 2]; 2], symbol: u8) {
        let (Some(column), Some(row)) = (cell(x, across, COLUMNS), cell(y, up, ROWS)) else { return };
        if let Some(cell) = self.cells.iter_mut().rev().nth(row).and_then(|row| row.get_mut(column)) {
            *cell = symbol;
        }
    }

    /// The uppermost line.
    pub fn line(&self) -> &str {
        self.cells.first().and_then(|row| core::str::from_utf8(row).ok()).unwrap_or("")
    }

    /// A frame around it, on the terminal.
    pub fn print(&self) {
        board::println!("  +{:-<COLUMNS$}+", "");
        for row in &self.cells {
            board::println!("  |{}|", core::str::from_utf8(row).unwrap_or(""));
        }
        board::println!("  +{:-<COLUMNS$}+", "");
    }
}

/// Says whether a state is the pinned one; if not, the example has failed.
pub fn verdict(pinned: Option<u64>, hash: u64) -> Exit {
    board::println!("state {hash:016x}");
    if pinned == Some(hash) {
        board::println!("the pinned state");
        Exit::Success
    } else {
        board::println!("NOT the pinned state");
        Exit::Failure
    }
}
