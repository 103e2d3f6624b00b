//! What the firmware of all boards shares: the scenes of the examples, one number type, and what a chip tells of itself.
#![no_std]

pub mod bits;
pub mod costs;
pub mod cycles;
pub mod number;
#[path = "../../../scenes/mod.rs"]
pub mod scenes;
pub mod throws;
