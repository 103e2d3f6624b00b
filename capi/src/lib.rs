//! carom for C and C++: what `include/carom.h` declares, over the same kernel.
//!
//! Each number type has the same functions under a prefix of its own, made by the macros of [`abi`]: `carom_f32_`, `carom_q16_`
//! (Q16.16) and `carom_q20_` (Q12.20). The header is generated from here: `cargo xtask capi header`.
//!
//! Everything that touches a pointer is in [`abi`], the one place with `unsafe` in it. Beside it are the numbers, the
//! plain structs and the status codes, all of it safe code.
#![cfg_attr(target_os = "none", no_std)]
#![deny(missing_docs)]
#![deny(unsafe_code)]
// The names of C.
#![allow(non_camel_case_types)]

#[cfg(not(any(feature = "f32", feature = "fixed")))]
compile_error!("a library without a number type has no functions: take the feature `f32` or `fixed`, or both");

pub mod abi;
mod number;
mod shape;
mod status;
mod types;
mod world;

pub use number::Number;
pub use shape::carom_shape_kind;
pub use status::*;
pub use types::*;

/// Nothing here panics, and the linker drops this; the compiler wants it all the same.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
