//! A check in each number type with limits that units can meet.

macro_rules! each_format {
    ($($check:ident),+ $(,)?) => {$(
        mod $check {
            #[cfg(feature = "f32")]
            #[test]
            fn f32() {
                super::$check::<f32>("f32");
            }
            #[cfg(feature = "micromath")]
            #[test]
            fn micromath() {
                super::$check::<micromath::F32>("micromath");
            }
            #[cfg(feature = "fixed")]
            #[test]
            fn i16f16() {
                super::$check::<fixed::types::I16F16>("i16f16");
            }
            #[cfg(feature = "fixed")]
            #[test]
            fn i12f20() {
                super::$check::<fixed::types::I12F20>("i12f20");
            }
            #[cfg(feature = "fixed")]
            #[test]
            fn i8f24() {
                super::$check::<fixed::types::I8F24>("i8f24");
            }
        }
    )+};
}
