//! The number types by name, and work that is done in one of them.

use std::fmt;

use clap::ValueEnum;

use crate::host::HostScalar;

/// A number type of the kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "lower")]
pub enum Number {
    /// single precision
    F32,
    /// double precision
    F64,
    /// 16 bits of fraction: +-32768 in steps of 1.5e-5
    I16F16,
    /// 20 bits of fraction: +-2048 in steps of 9.5e-7
    I12F20,
    /// 24 bits of fraction: +-128 in steps of 6.0e-8
    I8F24,
    /// single precision with micromath's approximate roots
    Micromath,
}

/// Work in any number type.
pub trait Job {
    type Output;
    fn run<S: HostScalar>(self) -> Self::Output;
}

impl Number {
    /// The rounding error of the numbers that the kernel computes with.
    pub fn precision(self) -> f64 {
        let bits: i32 = match self {
            Self::F32 | Self::Micromath => 24,
            Self::F64 => 53,
            Self::I16F16 | Self::I12F20 | Self::I8F24 => 30,
        };
        (-f64::from(bits)).exp2()
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::I16F16 => "i16f16",
            Self::I12F20 => "i12f20",
            Self::I8F24 => "i8f24",
            Self::Micromath => "micromath",
        })
    }
}
