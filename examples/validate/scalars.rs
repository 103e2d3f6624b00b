//! Every number type by its name.

use crate::tool::number::{Job, Number};

/// Does the job in the number type of that name.
pub fn run<J: Job>(number: Number, job: J) -> J::Output {
    match number {
        Number::F32 => job.run::<f32>(),
        Number::F64 => job.run::<f64>(),
        Number::I16F16 => job.run::<fixed::types::I16F16>(),
        Number::I12F20 => job.run::<fixed::types::I12F20>(),
        Number::I8F24 => job.run::<fixed::types::I8F24>(),
        Number::Micromath => job.run::<micromath::F32>(),
    }
}
