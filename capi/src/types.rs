//! The plain structs of C, and their way to the kernel's types and back.

mod common;
mod convert;
mod structs;

pub use common::*;
pub use structs::*;
