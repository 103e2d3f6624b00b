//! A billiard break, told by the impulse kernel alone: sixteen balls, four cushions, chains of two-body impulses.
//!
//! Prints the table, momentum, energy and the state hash before and after. Every number is the same on every machine.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod scenes;

use board::Exit;
use numbers::{Job, Number};
use scenes::pins::pin;
use scenes::table::{BALLS, HEIGHT, STEPS, Table, WIDTH};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Break)
}

struct Break;

impl Job for Break {
    fn run<S: Number>(&self) -> Exit {
        let Some(mut table) = Table::<S>::new() else {
            board::println!("the table cannot be set up");
            return Exit::Failure;
        };
        board::println!("{}: {BALLS} balls, {STEPS} steps of 1/480 s", S::NAME);
        print_state("before", &table);
        for _ in 0..STEPS {
            table.step();
        }
        print_state("after", &table);
        board::println!("{} impacts between balls, {} on cushions", table.ball_impacts, table.cushion_impacts);
        if pin("billiard_break", S::NAME) != Some(table.hash()) {
            board::println!("NOT the pinned state");
            return Exit::Failure;
        }
        board::println!("the pinned state");
        Exit::Success
    }
}

fn print_state<S: Number>(when: &str, table: &Table<S>) {
    let (balls, cushions) = (table.momentum().map(Number::milli), table.given().map(Number::milli));
    board::println!("{when}:");
    print_picture(table);
    board::println!("  momentum of the balls     {:6} {:6} g m/s", balls[0], balls[1]);
    board::println!("  given to the cushions     {:6} {:6} g m/s", cushions[0], cushions[1]);
    board::println!("  sum                       {:6} {:6} g m/s", balls[0] + cushions[0], balls[1] + cushions[1]);
    board::println!("  kinetic energy            {:6} mJ", table.energy().milli());
    board::println!("  state                     {:016x}", table.hash());
}

const COLUMNS: usize = 64;
const ROWS: usize = 16;

/// The table from above: the cue ball `o`, the others as letters.
fn print_picture<S: Number>(table: &Table<S>) {
    let mut cells = [[b' '; COLUMNS]; ROWS];
    for (ball, symbol) in table.bodies().zip(*b"oabcdefghijklmno") {
        let cell = |x: S, size: i32, cells: usize| {
            // Thousandths of a decimetre over the size of the table, in cells.
            (x.milli().max(0) as usize).wrapping_mul(cells) / (size.unsigned_abs() as usize).max(1)
        };
        let column = cell(ball.position.x, WIDTH, COLUMNS);
        let row = cell(ball.position.y, HEIGHT, ROWS);
        if let Some(cell) = cells.get_mut(row).and_then(|row| row.get_mut(column)) {
            *cell = symbol;
        }
    }
    board::println!("  +{:-<64}+", "");
    for row in &cells {
        board::println!("  |{}|", core::str::from_utf8(row).unwrap_or(""));
    }
    board::println!("  +{:-<64}+", "");
}
