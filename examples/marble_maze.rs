//! A marble finds its way through a maze that a hand tilts, by the trace of an accelerometer.
//!
//! Prints the map with the way so far and the marble `O` every three seconds, when the goal is reached, and the state hash.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod picture;
mod scenes;
mod trace;

use board::Exit;
use numbers::{Job, Number};
use picture::{Picture, verdict};
use scenes::maze::{GOAL, GOAL_PLACE, Maze, RATE, Room, SIZE, STEPS, SUB_STEPS, WALLS};
use scenes::pins::pin;
use trace::look::Look;
use trace::{Clock, Trace};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&MarbleMaze)
}

struct MarbleMaze;

/// Steps from map to map, and from dot to dot of the way.
const FRAME: u32 = RATE as u32 * 3;
const DOT: u32 = RATE as u32 / 12;

type Map = Picture<21, 17>;

impl Job for MarbleMaze {
    const LARGE: bool = true;

    fn run<S: Number>(&self) -> Exit {
        let mut world = Room::<S>::new();
        let Some(mut maze) = Maze::new(&mut world) else {
            board::println!("the maze cannot be set up");
            return Exit::Failure;
        };
        let look = |body| if body == GOAL_PLACE { Look::Sensor } else { Look::Plain };
        let clock = Clock { rate: RATE, sub_steps: SUB_STEPS };
        let Some(mut trace) = Trace::start(maze.world(), clock, maze.settings(), look) else {
            return Exit::Failure;
        };
        board::println!("{}: a maze of 20 by 16 cm, {STEPS} steps of 1/{RATE} s", S::NAME);
        let mut map = drawn();
        print_map(&mut map, &maze, 0);
        for step in 1..=STEPS {
            maze.step();
            trace.frame(maze.world(), maze.settings());
            if step % DOT == 0 {
                mark(&mut map, &maze, b'.');
            }
            if step % FRAME == 0 {
                print_map(&mut map, &maze, step);
            }
        }
        print_map(&mut map, &maze, STEPS);
        if !trace.finish() {
            return Exit::Failure;
        }
        if maze.dropped > 0 {
            board::println!("{} contacts found no room", maze.dropped);
            return Exit::Failure;
        }
        let Some(step) = maze.reached else {
            board::println!("the marble does NOT reach the goal");
            return Exit::Failure;
        };
        board::println!("the marble reaches the goal after {} ms", step.wrapping_mul(1000) / u32::from(RATE));
        verdict(pin("marble_maze", S::NAME), maze.hash())
    }
}

/// What the map shows: a character a centimetre, walls in the middle of theirs.
fn bounds() -> [[i32; 2]; 2] {
    SIZE.map(|size| [-50 * size - 50, 50 * size + 50])
}

fn put(map: &mut Map, [x, y]: [i32; 2], symbol: u8) {
    map.put([100 * x - 50 * SIZE[0], 100 * y - 50 * SIZE[1]], bounds(), symbol);
}

fn drawn() -> Map {
    let mut map = Map::new();
    let [right, upper] = SIZE;
    let outside = [[[0, 0], [right, 0]], [[0, upper], SIZE], [[0, 0], [0, upper]], [[right, 0], SIZE]];
    for [from, to] in WALLS.into_iter().chain(outside) {
        for x in from[0]..=to[0] {
            (from[1]..=to[1]).for_each(|y| put(&mut map, [x, y], b'#'));
        }
    }
    put(&mut map, GOAL, b'x');
    map
}

fn mark<S: Number>(map: &mut Map, maze: &Maze<S>, symbol: u8) {
    if let Some(marble) = maze.marble() {
        map.put([marble.x.milli(), marble.y.milli()], bounds(), symbol);
    }
}

fn print_map<S: Number>(map: &mut Map, maze: &Maze<S>, step: u32) {
    board::println!("after {} ms", step.wrapping_mul(1000) / u32::from(RATE));
    mark(map, maze, b'O');
    map.print();
    mark(map, maze, b'.');
}
