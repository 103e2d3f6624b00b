//! Scenes that examples and tests share.

// Each user needs its own part.
#![allow(dead_code)]

pub mod impacts;
pub mod pins;
pub mod shapes;
pub mod table;
