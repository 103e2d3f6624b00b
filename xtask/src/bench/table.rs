//! The figures for people: one table a board.

use super::figures::{Figure, Key, OWN};
use super::grid::Grid;
use super::image::Opt;
use super::worlds;
use crate::boards::Board;

/// What the figures are, before them.
pub const HEADER: &str = "\
Instructions, not cycles: QEMU executes the firmware with -icount, which advances its clock by the same time for every
instruction, and SysTick shows that clock. A figure is the instructions from the call to the return, both included: two
readings of the counter around the call, less the same with no call between them. A loop and a mixture of instructions of
known length are measured first and have to come out exactly.
Flash: code and constants of the operation linked alone, with all that it calls. Stack: bytes below the call that it wrote
to. Operands lie in memory. opt-level 3, s and z, fat LTO, one codegen unit. \"rows\" are those of
tests/data/two_body_impulse_dev.csv: the median, and the most with its row. Error: the largest of a velocity component after
the reference impact, against f64. \"most\", \"error\" and the share of carom's instructions are those at opt-level 3.
Scenes: 180 steps of 1/60 s in four sub-steps; step: the mean of the last 60; most: of all, and in which. Broad to keep: the
stages of the step after the last, counted with the public pieces that the world is made of; own: what is left of the step.
Flash: of a step alone; image: of firmware that plays and measures nothing. RAM: the smallest world that holds the scene.
";

/// One table a board, operation by operation, and one scene by scene.
pub fn print(figures: &[Figure]) {
    for board in Board::ALL {
        let here = figures.iter().filter(|figure| figure.key.board == *board);
        let (bounds, here): (Vec<&Figure>, Vec<&Figure>) = here.partition(|figure| figure.bound.is_some());
        let (scenes, operations): (Vec<&Figure>, Vec<&Figure>) =
            here.into_iter().partition(|figure| figure.scene.is_some());
        if !operations.is_empty() {
            println!("\n{board}\n{}", table(&operations));
        }
        if !scenes.is_empty() {
            println!("\n{board}, whole steps\n{}", worlds::table(&scenes));
        }
        if !bounds.is_empty() {
            println!("\n{board}, what a step takes at most\n{}", worlds::bound_table(&bounds));
        }
    }
}

fn table(figures: &[&Figure]) -> String {
    let per_opt = |name: &str| Opt::ALL.map(|opt| format!("{name}{opt}"));
    let names = ["operation", "by", "scalar"].map(str::to_owned).into_iter();
    let names = names.chain(per_opt("instr. ")).chain(["most", "row"].map(str::to_owned));
    let names = names.chain(per_opt("flash ")).chain(per_opt("stack "));
    let mut table = Grid::new(names.chain(["RAM", "error", "of carom's"].map(str::to_owned)));
    let mut lines: Vec<Vec<&Figure>> = Vec::new();
    for figure in figures {
        let name = |figure: &Figure| (figure.key.operation.clone(), figure.key.by.clone(), figure.key.scalar);
        match lines.iter_mut().find(|line| name(line[0]) == name(figure)) {
            Some(line) => line.push(figure),
            None => lines.push(vec![figure]),
        }
    }
    for line in lines {
        let each = |value: fn(&Figure) -> u32| {
            let cells = Opt::ALL.map(|opt| line.iter().find(|figure| figure.key.opt == opt));
            cells.map(|figure| figure.map_or_else(String::new, |figure| value(figure).to_string()))
        };
        let key = &line[0].key;
        let mut cells = vec![key.operation.clone(), key.by.clone(), key.scalar.to_string()];
        cells.extend(each(|figure| figure.instructions));
        let spread = line[0].spread.as_ref();
        cells.push(spread.map_or_else(String::new, |spread| spread.max.to_string()));
        cells.push(spread.map_or_else(String::new, |spread| spread.worst.clone()));
        cells.extend(each(|figure| figure.flash));
        cells.extend(each(|figure| figure.stack));
        cells.push(line.iter().map(|figure| figure.ram).max().unwrap_or_default().to_string());
        cells.push(line[0].error.map_or_else(String::new, |error| format!("{error:.1e}")));
        cells.push(ratio(line[0], figures).map_or_else(String::new, |ratio| format!("{ratio:.2}")));
        table.row(cells);
    }
    table.render()
}

/// Another library's instructions by carom's for the same.
pub fn ratio(figure: &Figure, all: &[&Figure]) -> Option<f64> {
    let own = Key { by: OWN.to_owned(), ..figure.key.clone() };
    let own = all.iter().find(|one| figure.key.by != OWN && one.key == own)?;
    Some(f64::from(figure.instructions) / f64::from(own.instructions))
}
