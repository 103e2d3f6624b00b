//! Pinball: three balls, three bumpers that kick, two flippers that a simple player uses. The score comes from the impacts.
//!
//! Prints the board with the way of the ball, what each ball scored, and the state hash.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod picture;
mod scenes;
mod trace;

use board::Exit;
use numbers::{Job, Number};
use picture::{Picture, verdict};
use scenes::pinball::{BUMPERS, DRAIN_PLACE, HALF_WIDTH, LENGTH, Pinball, RATE, Room, STEPS, SUB_STEPS};
use scenes::pins::pin;
use trace::look::Look;
use trace::{Clock, Trace};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Game)
}

struct Game;

type Board = Picture<41, 28>;

/// What the picture shows, in thousandths of a decimetre.
const BOUNDS: [[i32; 2]; 2] = [[-HALF_WIDTH, HALF_WIDTH], [0, LENGTH]];

impl Job for Game {
    const LARGE: bool = true;

    fn run<S: Number>(&self) -> Exit {
        let mut world = Room::<S>::new();
        let Some(mut pinball) = Pinball::new(&mut world) else {
            board::println!("the table cannot be set up");
            return Exit::Failure;
        };
        let look = |body| if body == DRAIN_PLACE { Look::Sensor } else { Look::Plain };
        let clock = Clock { rate: RATE, sub_steps: SUB_STEPS };
        let Some(mut trace) = Trace::start(pinball.world(), clock, pinball.settings(), look) else {
            return Exit::Failure;
        };
        board::println!("{}: steps of 1/{RATE} s", S::NAME);
        let mut picture = Board::new();
        let (mut steps, mut lost, mut going) = (0, 0, true);
        while going && steps < STEPS {
            going = pinball.step();
            trace.frame(pinball.world(), pinball.settings());
            steps = steps.wrapping_add(1);
            if steps % 4 == 0
                && let Some(ball) = pinball.ball()
            {
                picture.put([ball.x.milli(), ball.y.milli()], BOUNDS, b'.');
            }
            if pinball.balls_lost > lost || steps == STEPS {
                lost = pinball.balls_lost;
                print_board(&mut picture, &pinball);
                let ms = steps.wrapping_mul(1000) / u32::from(RATE);
                let (score, hits, flips) = (pinball.score, pinball.hits, pinball.flips);
                board::println!("after {ms} ms: {score} points by {hits} hits, {flips} flips, {lost} balls lost");
                picture = Board::new();
            }
        }
        if !trace.finish() {
            return Exit::Failure;
        }
        if pinball.dropped > 0 || pinball.saturated {
            board::println!("{} contacts found no room; saturated: {}", pinball.dropped, pinball.saturated);
            return Exit::Failure;
        }
        verdict(pin("pinball", S::NAME), pinball.hash())
    }
}

/// The bumpers `@`, the middles of the flippers `=`, and the ball's way.
fn print_board<S: Number>(picture: &mut Board, pinball: &Pinball<S>) {
    for bumper in BUMPERS {
        picture.put(bumper, BOUNDS, b'@');
    }
    for arm in pinball.arms() {
        picture.put([arm.x.milli(), arm.y.milli()], BOUNDS, b'=');
    }
    picture.print();
}
