//! One test for each generic check and number type.

/// Makes a test of each generic function `fn check<S: Format>()` of the calling module, in every number type of a set:
/// `all`, `usual`, or `derived`, those that the derivation is shown in.
macro_rules! in_formats {
    (all $checks:tt) => {
        in_formats!(usual $checks);
        in_formats!(@ "fixed", i25f7, fixed::types::I25F7, $checks);
        in_formats!(@ "fixed", i2f30, fixed::types::I2F30, $checks);
    };
    (usual $checks:tt) => {
        in_formats!(derived $checks);
        in_formats!(@ "fixed", i16f16, fixed::types::I16F16, $checks);
        in_formats!(@ "fixed", i8f24, fixed::types::I8F24, $checks);
        in_formats!(@ "micromath", micromath_f32, micromath::F32, $checks);
    };
    (derived $checks:tt) => {
        in_formats!(@ "fixed", i12f20, fixed::types::I12F20, $checks);
        in_formats!(@ "f32", single, f32, $checks);
        in_formats!(@ "f64", double, f64, $checks);
    };
    (@ $feature:literal, $name:ident, $format:ty, { $($check:ident)+ }) => {
        #[cfg(feature = $feature)]
        mod $name {
            $(
                #[test]
                fn $check() {
                    super::$check::<$format>();
                }
            )+
        }
    };
}

pub(crate) use in_formats;
