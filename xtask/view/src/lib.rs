//! What happened in a world, made visible: a trace of `examples/trace` becomes a page, or a picture without a browser.

mod algebra;
mod compare;
mod contact;
mod cursor;
mod energy;
mod extent;
pub mod image;
mod mesh;
mod page;
mod raster;
mod replay;
mod sight;
mod stage;
#[cfg(test)]
mod tests;
mod trace;

pub use compare::Comparison;
pub use contact::{Push, pushes};
pub use cursor::Format;
pub use energy::Balance;
pub use page::page;
pub use replay::{Replay, Words};
pub use trace::{Frame, Look, Motion, Shape, Subject, Touch, Trace};
