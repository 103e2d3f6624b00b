//! The functions that C calls. **This folder is the crate's only `unsafe` code.**
//!
//! What C must keep to is written once, at the top of the header: each pointer is null, or it leads to an object of its type
//! (or to as many as the count beside it says) that nobody else uses during the call. All that a pointer itself can show is
//! checked before it is used: null, alignment, size, and overlap of bodies with each other and with results. All access goes through the few functions
//! of [`pointer`] and, for worlds, of [`room`], each with its argument; the exported functions do nothing else with a pointer
//! than to hand it there.
#![allow(unsafe_code)]
// The contract is the same for all, and is the header's.
#![allow(clippy::missing_safety_doc)]

mod bodies;
mod capacities;
mod contacts;
pub mod pointer;
pub mod room;
mod solver;
mod worlds;

pub use bodies::*;
pub use capacities::*;
pub use contacts::*;
pub use solver::*;
pub use worlds::*;

use crate::status::text_of;
use core::ffi::c_char;

/// Makes functions for C of functions that may fail: with their name unmangled, answering with a status.
macro_rules! export {
    ($($(#[$meta:meta])* fn $name:ident($($argument:ident: $type:ty),* $(,)?) $body:block)+) => {$(
        $(#[$meta])*
        #[unsafe(no_mangle)]
        // What `?` returns from.
        #[allow(clippy::redundant_closure_call)]
        pub unsafe extern "C" fn $name($($argument: $type),*) -> carom_status {
            // SAFETY: what the header asks of the caller is what `pointer` and `room` ask of us.
            carom_status::from((|| -> Result<(), carom_status> { unsafe { $body } })())
        }
    )+};
}
use export;

/// What a status means and what to do about it: one sentence, in English, that ends with a zero and lives for ever. Any number may
/// be asked for.
#[unsafe(no_mangle)]
pub extern "C" fn carom_status_text(status: u32) -> *const c_char {
    text_of(status).as_ptr()
}
