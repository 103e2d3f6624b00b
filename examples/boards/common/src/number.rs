//! The number type of the firmware: f32, or I12F20 where f32 is not asked for.

#[cfg(feature = "f32")]
mod chosen {
    pub type Real = f32;
    pub const NAME: &str = "f32";

    pub fn milli(x: Real) -> i32 {
        (x * 1000.0) as i32
    }
}

#[cfg(not(feature = "f32"))]
mod chosen {
    pub type Real = fixed::types::I12F20;
    pub const NAME: &str = "i12f20";

    pub fn milli(x: Real) -> i32 {
        // Times a thousand it would leave the format.
        ((i64::from(x.to_bits()) * 1000) >> Real::FRAC_NBITS) as i32
    }
}

pub use chosen::{NAME, Real, milli};
