//! Newton's cradle: five balls, the first drawn aside. The last one leaves with its speed, and so on, to and fro.
//!
//! Prints the balls from the side, their momentum and energy, and the state hash. How they hang is told in `scenes/cradle.rs`.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod picture;
mod scenes;
mod trace;

use board::Exit;
use numbers::{Job, Number};
use picture::{Picture, verdict};
use scenes::cradle::{BALLS, Cradle, RATE, Room, STEPS, SUB_STEPS};
use scenes::pins::pin;
use trace::look::Look;
use trace::{Clock, Trace};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Swings)
}

struct Swings;

/// What frames show along the balls, in thousandths of a decimetre.
const ACROSS: [i32; 2] = [-3200, 3200];

impl Job for Swings {
    const LARGE: bool = true;

    fn run<S: Number>(&self) -> Exit {
        let mut world = Room::<S>::new();
        let Some(mut cradle) = Cradle::new(&mut world) else {
            board::println!("the cradle cannot be set up");
            return Exit::Failure;
        };
        let clock = Clock { rate: RATE, sub_steps: SUB_STEPS };
        let Some(mut trace) = Trace::start(cradle.world(), clock, cradle.settings(), |_| Look::Plain) else {
            return Exit::Failure;
        };
        board::println!("{}: {BALLS} balls, {STEPS} steps of 1/{RATE} s", S::NAME);
        board::println!("  time    momentum    energy");
        print_frame(&cradle, 0);
        for step in 1..=STEPS {
            cradle.step();
            trace.frame(cradle.world(), cradle.settings());
            if step % (u32::from(RATE) / 4) == 0 {
                print_frame(&cradle, step);
            }
        }
        if !trace.finish() {
            return Exit::Failure;
        }
        let [first, last] = cradle.fastest.map(Number::milli).map(|speed| speed / 10);
        board::println!(
            "{} blows; the first ball struck at {first} mm/s, the last one left at {last} mm/s",
            cradle.impacts
        );
        verdict(pin("newtons_cradle", S::NAME), cradle.hash())
    }
}

/// Time, momentum in ball masses times mm/s, energy in thousandths of what was given, and the balls along their line.
fn print_frame<S: Number>(cradle: &Cradle<S>, step: u32) {
    let mut picture = Picture::<64, 1>::new();
    for (position, _) in cradle.balls() {
        picture.put([position.milli(), 0], [ACROSS, [0, 1]], b'O');
    }
    let (momentum, energy) = (cradle.momentum().milli() / 10, cradle.energy().milli());
    board::println!(
        "  {:4} ms {momentum:5} mm/s  {energy:6}   |{}|",
        step.wrapping_mul(1000) / u32::from(RATE),
        picture.line()
    );
}
