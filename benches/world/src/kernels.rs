//! A step of each kind of world, as a user's firmware calls it, in the number type of the build.
//!
//! Each is a function of its own, `kernel_KIND_SCALAR`, that the optimiser cannot look into from outside. By that name
//! `cargo xtask` links it alone, and follows what it calls.

use crate::balls::Ball;
use crate::board;
use crate::bricks::Brick;
use crate::measure::run as measure;
use crate::room::{MOST, Piece, Room};
use carom::Scalar;
use carom::solver::Settings;
use carom::world::WorldReport;

/// Points between balls.
pub const OF_BALLS: usize = MOST;
/// Points between boxes: the micro:bit has no room for those of eight.
pub const OF_BRICKS: usize = 4 * if cfg!(small) { 4 } else { MOST };

/// A kind of piece with the step of its world.
pub trait Stepped<S: Scalar, const POINTS: usize>: Piece<S> {
    /// The address of an `extern "C"` function of a room, settings and a report.
    fn step() -> *const ();
}

macro_rules! kernels {
    ($($feature:literal: $scalar:ty, $name:literal;)+) => {
        $(
            #[cfg(feature = $feature)]
            kernels!(@step $scalar, concat!("kernel_spheres_", $name), Ball, OF_BALLS);
            #[cfg(feature = $feature)]
            kernels!(@step $scalar, concat!("kernel_boxes_", $name), Brick, OF_BRICKS);
        )+

        /// Measures in the number type that `--scalar` names.
        pub fn run() -> Result<(), &'static str> {
            match board::option("--scalar").ok_or("--scalar NAME is missing")? {
                $(
                    #[cfg(feature = $feature)]
                    $name => measure::<$scalar>(),
                )+
                _ => Err("this build does not hold that number type"),
            }
        }
    };
    (@step $scalar:ty, $name:expr, $piece:ident, $points:ident) => {
        const _: () = {
            type S = $scalar;

            #[unsafe(export_name = $name)]
            extern "C" fn step(
                room: &mut Room<S, $piece<S>, $points>,
                settings: &Settings<S>,
                report: &mut WorldReport,
            ) {
                *report = room.step(settings);
            }

            impl Stepped<S, $points> for $piece<S> {
                fn step() -> *const () {
                    step as *const ()
                }
            }
        };
    };
}

kernels! {
    "float": f32, "f32";
    "fixed": fixed::types::I16F16, "i16f16";
}
