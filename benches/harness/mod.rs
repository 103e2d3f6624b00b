//! Measures one call at a time on a board in QEMU: instructions, stack.
//!
//! Mounted by each benchmark firmware as `mod harness` beside `mod board` (`examples/board`).
//!
//! What is called takes up to four pointers and returns nothing, so that operands and results lie in memory, and it is
//! called from hand-written assembly: the optimiser sees neither who calls nor what is done with the results.

// Each firmware uses the part that it needs.
#![allow(dead_code, unused_imports, unused_macros)]

pub mod arena;
mod call;
pub mod counter;
pub mod input;
mod run;
pub mod scene;
pub mod stack;

pub use call::Call;
pub(crate) use call::call;
pub use run::run;
