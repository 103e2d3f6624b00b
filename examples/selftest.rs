//! Is this machine one of those with the same bits? Every pinned state beside what came of its scene here, and whether floats are
//! computed as they have to be.
//!
//! The worlds of all scenes do not fit 256 KB of flash and 16 KB of RAM, for which examples are linked: a build holds a few. For a
//! larger part, with a `memory.x` of its own, `CAROM_SELFTEST=all` in the environment of the build holds them all.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod scenes;

use board::Exit;
use carom::Scalar;
use numbers::{Job, Number};
use scenes::pins::{PINS, pin};
use scenes::{billiards, cradle, dice, edge, impacts, maze, pinball, shapes, stack, table};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&SelfTest)
}

struct SelfTest;

/// Whether the scenes are in that do not fit a small part. The RISC-V machine is none.
const ALL: bool = option_env!("CAROM_SELFTEST").is_some() || cfg!(target_arch = "riscv32");

impl Job for SelfTest {
    const LARGE: bool = !ALL;
    const EACH: bool = true;

    fn run<S: Number>(&self) -> Exit {
        board::println!("carom on this machine, in {}", S::NAME);
        let (mut wrong, mut left_out) = (u32::from(!float_environment()), 0u32);
        for (scene, _) in PINS {
            let Some(pinned) = pin(scene, S::NAME) else { continue };
            match state::<S>(scene) {
                Some(found) if found == pinned => board::println!("{scene:<15} {pinned:016x}  as pinned"),
                Some(found) => {
                    wrong = wrong.wrapping_add(1);
                    board::println!("{scene:<15} {pinned:016x}  pinned, but here {found:016x}");
                }
                None => {
                    left_out = left_out.wrapping_add(1);
                    board::println!("{scene:<15} {pinned:016x}  pinned, not in this build");
                }
            }
        }
        if left_out > 0 {
            board::println!("{left_out} scenes are not in this build; CAROM_SELFTEST=all holds them, on a larger part");
        }
        if wrong > 0 {
            board::println!("NOT the same bits as elsewhere");
            return Exit::Failure;
        }
        board::println!("the same bits as elsewhere");
        Exit::Success
    }
}

/// Says what is wrong with it, if something is.
fn float_environment() -> bool {
    #[cfg(feature = "f32")]
    if let Err(error) = carom::check_float_environment() {
        board::println!("{error}");
        return false;
    }
    true
}

/// What a scene comes to; `None` where it is not in this build.
fn state<S: Scalar>(scene: &str) -> Option<u64> {
    match scene {
        "impacts" => apart(impacts::hash::<S>),
        "billiard_break" => apart(table::hash::<S>),
        "edge" => apart(edge::hash::<S>),
        "newtons_cradle" if ALL => apart(cradle::hash::<S>),
        "dice" if ALL => apart(dice::hash::<S>),
        "marble_maze" if ALL => apart(maze::hash::<S>),
        "billiards" if ALL => apart(billiards::hash::<S>),
        "stack" if ALL => apart(stack::hash::<S>),
        "pinball" if ALL => apart(pinball::hash::<S>),
        "shapes" if ALL => apart(|| shapes::meet_all::<S>(&mut |_| ())),
        _ => None,
    }
}

/// In a frame of its own: what the scenes keep on the stack does not add up.
#[inline(never)]
fn apart(scene: impl FnOnce() -> Option<u64>) -> Option<u64> {
    scene()
}
