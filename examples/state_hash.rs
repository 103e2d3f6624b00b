//! Ten thousand impacts, and one number for all that came of them: the same on every machine, or this fails.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod scenes;

use board::Exit;
use numbers::{Job, Number};
use scenes::impacts::{IMPACTS, Scene};
use scenes::pins::pin;

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Impacts)
}

struct Impacts;

impl Job for Impacts {
    fn run<S: Number>(&self) -> Exit {
        let Some(mut scene) = Scene::<S>::new() else {
            board::println!("the scene cannot be built");
            return Exit::Failure;
        };
        for count in 1..=IMPACTS {
            if scene.step().is_none() {
                board::println!("impact {count} cannot be built");
                return Exit::Failure;
            }
            if count % 1000 == 0 {
                board::println!("{} {count} impacts: state {:016x}", S::NAME, scene.hash());
            }
        }
        let (stuck, slid, apart, saturated) = (scene.stuck, scene.slid, scene.apart, scene.saturated);
        board::println!("{stuck} stuck, {slid} slid, {apart} apart, {saturated} saturated");
        if pin("impacts", S::NAME) == Some(scene.hash()) {
            board::println!("the pinned state");
            Exit::Success
        } else {
            board::println!("NOT the pinned state");
            Exit::Failure
        }
    }
}
