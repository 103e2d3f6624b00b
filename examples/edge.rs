//! A box of 10 cm on its edge, half a degree to a hundredth of a degree past the point of balance: how long until it lies?
//!
//! Prints the times beside those of f64, which are a table in the scene, and the state hash. Engines whose small numbers are
//! rounded to zero leave such a box standing on its edge.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod picture;
mod scenes;

use board::Exit;
use numbers::{Job, Number};
use picture::verdict;
use scenes::edge::{Room, STARTS, chained, fall};
use scenes::pins::pin;

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Edge)
}

struct Edge;

impl Job for Edge {
    const LARGE: bool = true;

    fn run<S: Number>(&self) -> Exit {
        let mut world = Room::<S>::new();
        board::println!("{}: a box of 10 cm on its edge", S::NAME);
        board::println!("  past the edge   lies after   in f64");
        let (mut hash, mut all) = (0, true);
        for start in &STARTS {
            let Some((time, state)) = fall(&mut world, start) else {
                board::println!("the box cannot be set up");
                return Exit::Failure;
            };
            hash = chained(hash, state);
            let (past, in_f64) = (start.past, start.in_f64);
            match time {
                Some(ms) => board::println!("  0.{past:02} degrees    {ms:7} ms  {in_f64:4} ms"),
                None => board::println!("  0.{past:02} degrees         never  {in_f64:4} ms"),
            }
            all &= time.is_some();
        }
        match verdict(pin("edge", S::NAME), hash) {
            Exit::Success if all => Exit::Success,
            _ => Exit::Failure,
        }
    }
}
