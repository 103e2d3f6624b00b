//! Scenes that examples and tests share.

// Each user needs its own part.
#![allow(dead_code)]

pub mod billiards;
pub mod cradle;
pub mod dice;
pub mod edge;
pub mod impacts;
pub mod make;
pub mod maze;
pub mod pinball;
pub mod pins;
pub mod random;
pub mod shapes;
pub mod stack;
pub mod table;
pub mod tilt;
pub mod toss;
