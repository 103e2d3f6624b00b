//! What of fixed point is written for one core: by the core's own instructions, or portably.

#[cfg(multiply = "long")]
mod mainline;
#[cfg(not(multiply = "long"))]
mod portable;

#[cfg(multiply = "long")]
pub(super) use mainline::*;
#[cfg(not(multiply = "long"))]
pub(super) use portable::*;
