//! A check in each number type of the features under test.
#![allow(unused_macros)]

/// In f32, f64 and the fixed formats.
macro_rules! each_number {
    ($($check:ident),+ $(,)?) => {$(
        mod $check {
            check_in!($check, "f32", f32, f32);
            check_in!($check, "f64", f64, f64);
            check_in!($check, "fixed", i16f16, fixed::types::I16F16);
            check_in!($check, "fixed", i12f20, fixed::types::I12F20);
            check_in!($check, "fixed", i8f24, fixed::types::I8F24);
        }
    )+};
}

/// In those with limits that units can meet.
macro_rules! each_format {
    ($($check:ident),+ $(,)?) => {$(
        mod $check {
            check_in!($check, "f32", f32, f32);
            check_in!($check, "micromath", micromath, micromath::F32);
            check_in!($check, "fixed", i16f16, fixed::types::I16F16);
            check_in!($check, "fixed", i12f20, fixed::types::I12F20);
            check_in!($check, "fixed", i8f24, fixed::types::I8F24);
        }
    )+};
}

macro_rules! check_in {
    ($check:ident, $feature:literal, $name:ident, $number:ty) => {
        #[cfg(feature = $feature)]
        #[test]
        fn $name() {
            super::$check::<$number>(stringify!($name));
        }
    };
}
