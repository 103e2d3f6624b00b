//! Two dice are thrown, tumble, come to rest, and are read. `--seed N` throws others, `--trace FILE` writes what happens.
//!
//! Prints frames from the side, the faces and the state hash. Every number is the same on every machine.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod picture;
mod scenes;
mod trace;

use board::Exit;
use numbers::{Job, Number};
use picture::{Picture, verdict};
use scenes::dice::{DICE, RATE, Room, SEED, STEPS, SUB_STEPS, Throw};
use scenes::pins::pin;
use trace::look::Look;
use trace::{Clock, Trace};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Dice)
}

struct Dice;

/// Steps from frame to frame: a twelfth of a second.
const FRAME: u32 = RATE as u32 / 12;
/// What frames show, in thousandths of a decimetre: along the throw, and up.
const ACROSS: [i32; 2] = [-4000, 6000];
const UP: [i32; 2] = [0, 1600];

impl Job for Dice {
    const LARGE: bool = true;

    fn run<S: Number>(&self) -> Exit {
        let seed = board::option("--seed").and_then(|text| text.parse().ok()).unwrap_or(SEED);
        let mut world = Room::<S>::new();
        let Some(mut throw) = Throw::new(&mut world, seed) else {
            board::println!("the dice cannot be set up");
            return Exit::Failure;
        };
        let clock = Clock { rate: RATE, sub_steps: SUB_STEPS };
        let look = |body| if body == 0 { Look::Plain } else { Look::Die };
        let Some(mut trace) = Trace::start(throw.world(), clock, throw.settings(), look) else {
            return Exit::Failure;
        };
        board::println!("{}: {DICE} dice of 16 mm, seed {seed}", S::NAME);
        let mut shown = Frame::new();
        print_frame(&throw, 0, &mut shown);
        let mut steps = 0;
        while steps < STEPS && throw.step() {
            steps = steps.wrapping_add(1);
            trace.frame(throw.world(), throw.settings());
            if steps % FRAME == 0 {
                print_frame(&throw, steps, &mut shown);
            }
        }
        let ms = steps.wrapping_mul(1000) / u32::from(RATE);
        board::println!("at rest after {ms} ms and {} impacts", throw.impacts);
        print_faces(&throw);
        if !trace.finish() {
            return Exit::Failure;
        }
        if throw.dropped > 0 {
            board::println!("{} contacts found no room", throw.dropped);
            return Exit::Failure;
        }
        if seed != SEED {
            board::println!("state {:016x}", throw.hash());
            return Exit::Success;
        }
        verdict(pin("dice", S::NAME), throw.hash())
    }
}

type Frame = Picture<70, 6>;

/// The dice from the side, each as the number on top of it, unless that looks as before.
fn print_frame<S: Number>(throw: &Throw<S>, steps: u32, shown: &mut Frame) {
    let mut picture = Frame::new();
    for (position, face) in throw.dice() {
        picture.put([position.x.milli(), position.z.milli()], [ACROSS, UP], b'0'.wrapping_add(face));
    }
    if picture != *shown {
        board::println!("after {} ms", steps.wrapping_mul(1000) / u32::from(RATE));
        picture.print();
        *shown = picture;
    }
}

/// The pips of a face, row by row: the corners, the middle of the sides, the centre.
fn pips(face: u8, row: usize) -> &'static str {
    match (face, row) {
        (1, 1) | (3 | 5, 1) => "|   o   |",
        (2 | 3, 0) => "| o     |",
        (2 | 3, 2) => "|     o |",
        (4..=6, 0 | 2) | (6, 1) => "| o   o |",
        _ => "|       |",
    }
}

fn print_faces<S: Number>(throw: &Throw<S>) {
    let edge = || throw.faces().for_each(|_| board::print!("  +-------+"));
    edge();
    board::println!();
    for row in 0..3 {
        throw.faces().for_each(|face| board::print!("  {}", pips(face.unwrap_or(0), row)));
        board::println!();
    }
    edge();
    board::println!();
    for face in throw.faces() {
        match face {
            Some(face) => board::print!("      {face}    "),
            None => board::print!("   leans   "),
        }
    }
    let sum: u8 = throw.faces().flatten().fold(0, u8::wrapping_add);
    board::println!("  sum {sum}");
}
