//! What a step costs on this chip, in cycles of its core.

use crate::cycles::{Cycles, Tally};
use crate::number::Real;
use crate::scenes::{cradle, dice, maze};
use rtt_target::rprintln;

/// Prints a line for each of three worlds.
pub fn print(cycles: &mut Cycles) {
    rprintln!("at {} MHz", cycles.mhz());
    if print_all(cycles).is_none() {
        rprintln!("a scene cannot be set up");
    }
}

fn print_all(cycles: &mut Cycles) -> Option<()> {
    let mut world = dice::Room::<Real>::new();
    let mut throw = dice::Throw::new(&mut world, dice::SEED)?;
    count("two dice", dice::STEPS, cycles, || throw.step());

    let mut world = cradle::Room::<Real>::new();
    let mut cradle = cradle::Cradle::new(&mut world)?;
    count("a cradle of five balls", cradle::STEPS, cycles, || {
        cradle.step();
        true
    });

    let mut world = maze::Room::<Real>::new();
    let mut maze = maze::Maze::new(&mut world)?;
    count("a marble in a maze", maze::STEPS, cycles, || {
        maze.step();
        true
    });
    Some(())
}

/// So many steps, or until one says that nothing moves any more.
fn count(what: &str, steps: u32, cycles: &mut Cycles, mut step: impl FnMut() -> bool) {
    let mut tally = Tally::new();
    for _ in 0..steps {
        let (moving, taken) = cycles.of(&mut step);
        tally.add(taken);
        if !moving {
            break;
        }
    }
    tally.print(what, cycles.mhz());
}
