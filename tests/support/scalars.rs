//! The number types of the features under test, by their names. For the crate's root, beside `mod tool`.

use crate::tool::number::{Job, Number};

/// Those that this build holds.
pub const NUMBERS: &[Number] = &[
    #[cfg(feature = "f32")]
    Number::F32,
    #[cfg(feature = "f64")]
    Number::F64,
    #[cfg(feature = "fixed")]
    Number::I16F16,
    #[cfg(feature = "fixed")]
    Number::I12F20,
    #[cfg(feature = "fixed")]
    Number::I8F24,
    #[cfg(feature = "micromath")]
    Number::Micromath,
];

/// Does the job in the number type of that name, which must be one of [`NUMBERS`].
pub fn run<J: Job>(number: Number, job: J) -> J::Output {
    match number {
        #[cfg(feature = "f32")]
        Number::F32 => job.run::<f32>(),
        #[cfg(feature = "f64")]
        Number::F64 => job.run::<f64>(),
        #[cfg(feature = "fixed")]
        Number::I16F16 => job.run::<fixed::types::I16F16>(),
        #[cfg(feature = "fixed")]
        Number::I12F20 => job.run::<fixed::types::I12F20>(),
        #[cfg(feature = "fixed")]
        Number::I8F24 => job.run::<fixed::types::I8F24>(),
        #[cfg(feature = "micromath")]
        Number::Micromath => job.run::<micromath::F32>(),
        #[allow(unreachable_patterns)]
        _ => unreachable!("{number} is not among the features under test"),
    }
}
