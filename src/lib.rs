//! carom
#![no_std]
#![deny(unsafe_code)]
mod body;
mod contact;
mod error;
pub mod impulse;
mod mass;
mod math;
mod scalar;
pub use body::*;
pub use contact::*;
pub use error::*;
pub use mass::*;
pub use math::*;
pub use scalar::*;
mod hash;
pub use hash::*;
