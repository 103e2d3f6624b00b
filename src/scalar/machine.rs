//! What of fixed point is written for one core: by the core's own instructions, or portably.

#[cfg(multiply = "short")]
mod baseline;
#[cfg(not(multiply = "short"))]
mod impulses;
#[cfg(multiply = "long")]
mod mainline;
#[cfg(not(any(multiply = "long", multiply = "short")))]
mod portable;
#[cfg(any(multiply = "long", multiply = "short"))]
mod row_words;
#[cfg(not(multiply = "short"))]
mod rows;
#[cfg(not(multiply = "long"))]
mod shifts;
#[cfg(not(multiply = "long"))]
mod speeds;
#[cfg(any(multiply = "long", multiply = "short"))]
mod words;

#[cfg(multiply = "short")]
pub(super) use baseline::*;
#[cfg(not(multiply = "short"))]
pub(super) use impulses::*;
#[cfg(multiply = "long")]
pub(super) use mainline::*;
#[cfg(not(any(multiply = "long", multiply = "short")))]
pub(super) use portable::*;
#[cfg(any(multiply = "long", multiply = "short"))]
pub(super) use row_words::*;
#[cfg(not(multiply = "short"))]
pub(super) use rows::*;
#[cfg(not(multiply = "long"))]
pub(super) use shifts::*;
#[cfg(not(any(multiply = "long", multiply = "short")))]
pub(super) use speeds::*;
#[cfg(any(multiply = "long", multiply = "short"))]
pub(super) use words::*;
