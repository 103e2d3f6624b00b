//! Ten boxes of 10 cm stand on each other for ten seconds, and none of them may sleep.
//!
//! Prints by how much each has sunk and moved aside, and the state hash.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod picture;
mod scenes;
mod trace;

use board::Exit;
use numbers::{Job, Number};
use picture::verdict;
use scenes::make::hundredfold;
use scenes::pins::pin;
use scenes::stack::{BOXES, RATE, Room, STEPS, SUB_STEPS, Stack};
use trace::look::Look;
use trace::{Clock, Trace};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Boxes)
}

struct Boxes;

/// A tenth of an edge, in micrometres: a stack that is off by more does not stand any more.
const MOST: i32 = 10_000;

impl Job for Boxes {
    const LARGE: bool = true;

    fn run<S: Number>(&self) -> Exit {
        let mut world = Room::<S>::new();
        let Some(mut stack) = Stack::new(&mut world) else {
            board::println!("the boxes cannot be set up");
            return Exit::Failure;
        };
        let clock = Clock { rate: RATE, sub_steps: SUB_STEPS };
        let Some(mut trace) = Trace::start(stack.world(), clock, stack.settings(), |_| Look::Plain) else {
            return Exit::Failure;
        };
        board::println!("{}: {BOXES} boxes of 10 cm, {STEPS} steps of 1/{RATE} s", S::NAME);
        for _ in 0..STEPS {
            stack.step();
            trace.frame(stack.world(), stack.settings());
        }
        if !trace.finish() {
            return Exit::Failure;
        }
        let mut stands = true;
        for (number, moved) in (1..).zip(stack.moved()) {
            // In decimetres; the first and second beside its place, the third below it.
            let [x, y, sunk] = moved.map(|part| hundredfold(part).milli());
            stands &= [x, y, sunk].iter().all(|part| part.wrapping_abs() < MOST);
            board::println!("  box {number:2}: sunk by {sunk:6} um, aside by {x:6} and {y:6} um");
        }
        board::println!(
            "{} after {} s",
            if stands { "it stands" } else { "it does NOT stand" },
            STEPS / u32::from(RATE)
        );
        match verdict(pin("stack", S::NAME), stack.hash()) {
            Exit::Success if stands && stack.dropped == 0 => Exit::Success,
            _ => Exit::Failure,
        }
    }
}
