//! A check in each number type of the features under test.

macro_rules! each_number {
    ($($check:ident),+ $(,)?) => {$(
        mod $check {
            #[cfg(feature = "f32")]
            #[test]
            fn f32() {
                super::$check::<f32>("f32");
            }
            #[cfg(feature = "f64")]
            #[test]
            fn f64() {
                super::$check::<f64>("f64");
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
