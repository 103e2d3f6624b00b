//! carom
#![no_std]
#![deny(unsafe_code)]
mod body; mod contact; mod mass;
mod error;
mod math;
mod scalar;
pub mod impulse;
pub use body::*;
pub use contact::*;
pub use mass::*;
pub use error::*;
pub use math::*;
pub use scalar::*;
