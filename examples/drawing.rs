//! Two dice, thrown and drawn on a display of 240 x 240 pixels by `embedded-graphics`, in a memory that holds a few rows of it.
//! `--frame FILE` writes the frame, as bytes that a display in RGB565 takes.
//!
//! Prints the frame's hash. Every pixel is the same on every machine.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod display;
mod numbers;
mod scenes;

use board::Exit;
use display::dice::Picture;
use display::way::Way;
use display::{Band, SIDE};
use numbers::{Job, Number};
use scenes::dice::Room;

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Drawing)
}

struct Drawing;

impl Job for Drawing {
    const LARGE: bool = true;

    fn run<S: Number>(&self) -> Exit {
        let mut world = Room::<S>::new();
        let mut way = Way::new();
        if way.throw(&mut world).is_none() {
            board::println!("the dice cannot be thrown");
            return Exit::Failure;
        }
        show(&world, &way)
    }
}

/// In a function of its own: the throw needs its memory for other things.
#[inline(never)]
fn show<S: Number>(world: &Room<S>, way: &Way<S>) -> Exit {
    let Some(picture) = Picture::new(world, way) else {
        board::println!("the picture cannot be set up");
        return Exit::Failure;
    };
    let mut file = match board::option("--frame").map(board::create_binary).transpose() {
        Ok(file) => file,
        Err(error) => {
            board::println!("the frame: {error}; --frame wants a place that can be written");
            return Exit::Failure;
        }
    };
    let mut hash = NOTHING;
    let draw = |band: &mut Band| picture.draw(band).unwrap_or_else(|never| match never {});
    Band::new().draw_all(draw, |bytes| {
        hash = bytes.iter().fold(hash, hashed);
        if let Some(file) = &mut file {
            file.bytes(bytes);
        }
    });
    board::println!("{}: {SIDE} x {SIDE} pixels of 16 bits, hash {hash:016x}", S::NAME);
    match file.map(board::BinaryWriter::finish) {
        Some(Err(error)) => {
            board::println!("the frame: {error}; is the disk full?");
            Exit::Failure
        }
        _ => Exit::Success,
    }
}

/// FNV-1a over 64 bits, begun with [`NOTHING`].
fn hashed(hash: u64, byte: &u8) -> u64 {
    (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3)
}

const NOTHING: u64 = 0xcbf2_9ce4_8422_2325;
