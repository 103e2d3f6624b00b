//! Intermediate numbers of fixed point from f64.

use carom::Scaled;

/// The nearest number with a mantissa of 30 bits.
pub fn nearest_scaled<T: Scaled>(x: f64) -> T {
    if x == 0.0 {
        return T::ZERO;
    }
    let exponent = x.abs().log2().floor() as i32 - 29;
    T::from_parts((x / f64::from(exponent).exp2()).round() as i32, exponent)
}
