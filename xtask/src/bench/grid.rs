//! Tables in Markdown that are aligned as text too: for the terminal and for the documentation.

/// A table under construction.
pub struct Grid {
    rows: Vec<Vec<String>>,
}

impl Grid {
    pub fn new(header: impl IntoIterator<Item = impl Into<String>>) -> Self {
        let mut grid = Self { rows: Vec::new() };
        grid.row(header);
        grid
    }

    pub fn row(&mut self, cells: impl IntoIterator<Item = impl Into<String>>) {
        self.rows.push(cells.into_iter().map(Into::into).collect());
    }

    /// Columns in which there are only numbers are aligned to the right.
    pub fn render(&self) -> String {
        let mut lines = vec![String::new(); self.rows.len() + 1];
        for column in 0..self.rows[0].len() {
            let cells: Vec<&str> = self.rows.iter().map(|row| row[column].as_str()).collect();
            let numeric =
                cells[1..].iter().all(|cell| cell.is_empty() || cell.starts_with(|c: char| c.is_ascii_digit()));
            let width = cells.iter().map(|cell| cell.chars().count()).max().unwrap_or_default().max(3);
            let rule = if numeric { format!("{}:", "-".repeat(width - 1)) } else { "-".repeat(width) };
            let cells = [cells[0], &rule].into_iter().chain(cells[1..].iter().copied());
            for (line, cell) in lines.iter_mut().zip(cells) {
                let padded = if numeric { format!("{cell:>width$}") } else { format!("{cell:<width$}") };
                line.push_str(&format!("| {padded} "));
            }
        }
        lines.iter().map(|line| format!("{line}|\n")).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Grid;

    #[test]
    fn numbers_to_the_right() {
        let mut grid = Grid::new(["name", "n"]);
        grid.row(["a", "1,000"]);
        grid.row(["b", ""]);
        assert_eq!(grid.render(), "| name |     n |\n| ---- | ----: |\n| a    | 1,000 |\n| b    |       |\n");
    }
}
