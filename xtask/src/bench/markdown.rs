//! The figures as the documentation shows them.

use super::figures::{Figure, Key, OPERATIONS, OWN};
use super::grid::Grid;
use super::image::Opt;
use super::snapshot::Snapshot;
use super::table::ratio;
use crate::boards::{Board, Scalar};
use anyhow::{Context, Result};

/// The number types in the order of the tables.
const SCALARS: [Scalar; 5] = [Scalar::F32, Scalar::Micromath, Scalar::I16F16, Scalar::I12F20, Scalar::I8F24];

/// For the README: an impulse on every board, and what it takes of the memory.
pub fn short(snapshot: &Snapshot) -> String {
    let instructions: fn(&Figure) -> u32 = |figure| figure.instructions;
    let flash: fn(&Figure) -> u32 = |figure| figure.flash;
    let stack: fn(&Figure) -> u32 = |figure| figure.stack;
    let rows = [
        ("impulse, `f32`", OWN, "resolve", Scalar::F32),
        ("impulse, `I16F16`", OWN, "resolve", Scalar::I16F16),
        ("with friction that sticks, `f32`", OWN, "friction_stick", Scalar::F32),
        ("with friction that sticks, `I16F16`", OWN, "friction_stick", Scalar::I16F16),
        ("with friction that slides, `f32`", OWN, "friction_slip", Scalar::F32),
        ("with friction that slides, `I16F16`", OWN, "friction_slip", Scalar::I16F16),
        ("*impulse by hand with glam, `f32`*", "glam", "resolve", Scalar::F32),
        ("*impulse by hand in plain `I16F16`, which cuts off and wraps*", "fixed", "resolve", Scalar::I16F16),
    ];
    let bytes = [
        ("bytes of flash, `I16F16` without friction", "resolve", flash),
        ("bytes of flash, `I16F16` with friction", "friction_slip", flash),
        ("bytes of stack, `I16F16` without friction", "resolve", stack),
        ("bytes of stack, `I16F16` with friction", "friction_slip", stack),
    ];
    let rows = rows.map(|(name, by, operation, scalar)| (name, by, operation, scalar, instructions)).into_iter();
    let bytes = bytes.map(|(name, operation, of)| (name, OWN, operation, Scalar::I16F16, of));
    let mut table = Grid::new(["instructions", "M0", "M3", "M4F", "M7", "M33"]);
    for (name, by, operation, scalar, of) in rows.chain(bytes) {
        let cells = Board::ALL.iter().map(|&board| {
            let figure = snapshot.find(board, by, operation, scalar, Opt::Speed);
            figure.map_or_else(String::new, |figure| grouped(of(figure)))
        });
        table.row([name.to_owned()].into_iter().chain(cells));
    }
    table.render()
}

/// Every operation on every board at opt-level 3.
pub fn boards(snapshot: &Snapshot) -> String {
    let mut text = String::new();
    for &board in Board::ALL {
        let names = ["operation", "`f32`", "`micromath`", "`I16F16`", "`I12F20`", "`I8F24`"];
        let mut table = Grid::new(names);
        for (operation, words) in OPERATIONS {
            let cells = SCALARS.map(|scalar| {
                let figure = snapshot.find(board, OWN, operation, scalar, Opt::Speed);
                figure.map_or_else(String::new, with_most)
            });
            table.row([words.to_owned()].into_iter().chain(cells));
        }
        text += &format!("**{}**\n\n{}\n", board.name(), table.render());
    }
    text.trim_end().to_owned() + "\n"
}

/// Instructions, flash and stack at each opt-level.
pub fn sizes(snapshot: &Snapshot) -> String {
    let names = ["operation", "", "board", "instr. 3", "s", "z", "flash 3", "s", "z", "stack 3", "s", "z"];
    let mut table = Grid::new(names);
    for (operation, words) in [("resolve", "impulse"), ("friction_slip", "friction, sliding")] {
        for (scalar, name) in [(Scalar::F32, "`f32`"), (Scalar::I16F16, "`I16F16`")] {
            for &board in Board::ALL {
                let figures = Opt::ALL.map(|opt| snapshot.find(board, OWN, operation, scalar, opt));
                let each = |value: fn(&Figure) -> u32| {
                    figures.map(|figure| figure.map_or_else(String::new, |figure| grouped(value(figure))))
                };
                let cells = [words, name, board.name()].map(str::to_owned).into_iter();
                let cells = cells.chain(each(|figure| figure.instructions)).chain(each(|figure| figure.flash));
                table.row(cells.chain(each(|figure| figure.stack)));
            }
        }
    }
    table.render()
}

/// The README's table of accuracy has this in its head, and no other.
const HEAD: &str = "rows that fit";

/// Accuracy, from the README's own table, beside cost.
pub fn formats(snapshot: &Snapshot, readme: &str) -> Result<String> {
    let names = ["", "J, median", "v, largest", "impulse M0", "M3", "M4F", "with sliding friction M0", "M3", "M4F"];
    let mut table = Grid::new(names);
    for scalar in SCALARS {
        let start = format!("| `{scalar}` | ");
        let line = readme.lines().skip_while(|line| !line.contains(HEAD)).find_map(|line| line.strip_prefix(&start));
        let line = line.with_context(|| format!("the README states no accuracy of {scalar}"))?;
        // Behind the name: rows, median of J, largest of J, largest of v.
        let accuracy: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, median, _, velocity, ..] = accuracy[..] else {
            anyhow::bail!("the README's line on {scalar} is too short");
        };
        let cells = ["resolve", "friction_slip"].into_iter().flat_map(|operation| {
            [Board::M0, Board::M3, Board::M4f].map(|board| {
                let figure = snapshot.find(board, OWN, operation, scalar, Opt::Speed);
                figure.map_or_else(String::new, |figure| grouped(figure.instructions))
            })
        });
        let first = [format!("`{scalar}`"), median.to_owned(), format!("{velocity} m/s")];
        table.row(first.into_iter().chain(cells));
    }
    Ok(table.render())
}

/// Other libraries beside carom.
pub fn peers(snapshot: &Snapshot) -> String {
    let mut table = Grid::new(["", "", "board", "instructions", "s", "z", "of carom's", "flash", "stack", "error"]);
    let all: Vec<&Figure> = snapshot.figures.iter().collect();
    for operation in ["resolve", "friction"] {
        for figure in &all {
            let Key { board, by, scalar, opt, .. } = &figure.key;
            let compared = *scalar == Scalar::F32 || *scalar == Scalar::I16F16;
            if figure.key.operation != operation || *opt != Opt::Speed || !compared {
                continue;
            }
            let at = |opt| {
                let figure = snapshot.find(*board, by, operation, *scalar, opt);
                figure.map_or_else(String::new, |figure| grouped(figure.instructions))
            };
            table.row([
                if operation == "resolve" { "impulse".to_owned() } else { "with friction".to_owned() },
                format!("{by} `{scalar}`"),
                board.name().to_owned(),
                grouped(figure.instructions),
                at(Opt::S),
                at(Opt::Z),
                ratio(figure, &all).map_or_else(String::new, |ratio| format!("{ratio:.2}")),
                grouped(figure.flash),
                grouped(figure.stack),
                figure.error.map_or_else(String::new, |error| format!("{error:.0e}")),
            ]);
        }
    }
    table.render()
}

/// The most of many in brackets.
pub fn with_most(figure: &Figure) -> String {
    let most = figure.spread.as_ref().map(|spread| format!(" ({})", grouped(spread.max)));
    grouped(figure.instructions) + &most.unwrap_or_default()
}

/// Thousands apart.
pub fn grouped(number: u32) -> String {
    let digits = number.to_string();
    let groups: Vec<_> = digits.as_bytes().rchunks(3).rev().map(String::from_utf8_lossy).collect();
    groups.join(",")
}
