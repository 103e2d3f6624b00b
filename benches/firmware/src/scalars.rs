//! Every number type of the build, by its name.

use crate::board;
use crate::measure::run as measure;
use crate::operations::operations;

macro_rules! scalars {
    ($($feature:literal: $scalar:ty, $name:literal;)+) => {
        $(
            #[cfg(feature = $feature)]
            operations!($scalar, $name);
        )+

        /// Measures in the number type that `--scalar` names.
        pub fn run() -> Result<(), &'static str> {
            match board::option("--scalar").ok_or("--scalar NAME is missing")? {
                $(
                    #[cfg(feature = $feature)]
                    $name => measure::<$scalar>(),
                )+
                _ => Err("this build does not hold that number type"),
            }
        }
    };
}

scalars! {
    "float": f32, "f32";
    "float": micromath::F32, "micromath";
    "fixed": fixed::types::I16F16, "i16f16";
    "fixed": fixed::types::I12F20, "i12f20";
    "fixed": fixed::types::I8F24, "i8f24";
}
