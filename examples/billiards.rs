//! A break of six balls in a world: the cue ball slides, rolls, scatters the rack; balls run off the cushions and roll out.
//!
//! Prints the table before and after, blows, energy, how many balls roll without slipping, and the state hash.
//! `billiard_break` plays one with the impulse kernel alone.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod picture;
mod scenes;
mod trace;

use board::Exit;
use numbers::{Job, Number};
use picture::{Picture, verdict};
use scenes::billiards::{BALLS, Billiards, HALF, RATE, Room, STEPS, SUB_STEPS};
use scenes::pins::pin;
use trace::look::Look;
use trace::{Clock, Trace};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Break)
}

struct Break;

impl Job for Break {
    const LARGE: bool = true;

    fn run<S: Number>(&self) -> Exit {
        let mut world = Room::<S>::new();
        let Some(mut billiards) = Billiards::new(&mut world) else {
            board::println!("the table cannot be set up");
            return Exit::Failure;
        };
        let clock = Clock { rate: RATE, sub_steps: SUB_STEPS };
        let Some(mut trace) = Trace::start(billiards.world(), clock, billiards.settings(), |_| Look::Plain) else {
            return Exit::Failure;
        };
        board::println!("{}: {BALLS} balls, {STEPS} steps of 1/{RATE} s", S::NAME);
        print_table(&billiards);
        for step in 1..=STEPS {
            billiards.step();
            trace.frame(billiards.world(), billiards.settings());
            if step % (STEPS / 8) == 0 {
                let ms = step.wrapping_mul(1000) / u32::from(RATE);
                let (energy, rolling) = (billiards.energy().milli(), billiards.rolling());
                board::println!("  {ms:4} ms: {energy:4} thousandths of the energy, {rolling} balls roll or rest");
            }
        }
        if !trace.finish() {
            return Exit::Failure;
        }
        print_table(&billiards);
        let (balls, cushions) = (billiards.ball_impacts, billiards.cushion_impacts);
        board::println!("{balls} blows between balls, {cushions} on cushions");
        if billiards.dropped > 0 || billiards.saturated {
            board::println!("{} contacts found no room; saturated: {}", billiards.dropped, billiards.saturated);
            return Exit::Failure;
        }
        verdict(pin("billiards", S::NAME), billiards.hash())
    }
}

/// The table from above: the cue ball `o`, the others by their numbers.
fn print_table<S: Number>(billiards: &Billiards<S>) {
    let mut picture = Picture::<64, 16>::new();
    let [across, up] = HALF.map(|half| [-half, half]);
    for (body, symbol) in billiards.balls().zip(*b"o123456") {
        picture.put([body.position.x.milli(), body.position.y.milli()], [across, up], symbol);
    }
    picture.print();
}
