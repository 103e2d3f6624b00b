//! Shapes in pairs, brought together: how far apart they were, and where they meet. The same numbers on every machine, or this
//! fails.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod scenes;

use board::Exit;
use carom::Vec3;
use numbers::{Job, Number};
use scenes::pins::pin;
use scenes::shapes::{Meeting, meet_all};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Shapes)
}

struct Shapes;

impl Job for Shapes {
    const LARGE: bool = true;

    fn run<S: Number>(&self) -> Exit {
        board::println!("{}: in thousandths", S::NAME);
        let Some(hash) = meet_all::<S>(&mut print) else {
            board::println!("the scene cannot be built");
            return Exit::Failure;
        };
        board::println!("all of it {hash:016x}");
        if pin("shapes", S::NAME) == Some(hash) {
            board::println!("the pinned numbers");
            Exit::Success
        } else {
            board::println!("NOT the pinned numbers");
            Exit::Failure
        }
    }
}

fn print<S: Number>(meeting: &Meeting<S>) {
    let [a, b] = meeting.names;
    let Vec3 { x, y, z } = meeting.normal.get();
    let [x, y, z] = [x, y, z].map(|d| S::ONE.times_unit(d).milli());
    let (distance, separation) = (meeting.closest.separation.milli(), meeting.separation.milli());
    board::println!("{a} {b}: {distance} apart; then {} points, {separation} along {x} {y} {z}", meeting.points);
}
