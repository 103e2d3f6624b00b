//! Values as bytes, and back: an island of `unsafe`.
#![allow(unsafe_code)]

#[cfg(any(feature = "f32", feature = "f64", feature = "fixed"))]
mod bodies;

use ::bytemuck::{CheckedBitPattern, NoUninit, Pod, Zeroable};

use crate::math::{Mat3, Quat, SymMat3, UnitVec3, Vec3};
use crate::scalar::Scalar;

macro_rules! plain {
    ($($type:ident)+) => {$(
        // SAFETY: `repr(C)`, and numbers of one type alone: no padding, and all bits are valid if those of the numbers are.
        unsafe impl<S: Zeroable> Zeroable for $type<S> {}
        // SAFETY: as above.
        unsafe impl<S: Pod> Pod for $type<S> {}
    )+};
}

plain!(Vec3 Mat3 SymMat3);

macro_rules! checked {
    ($($type:ident of $count:literal: $make:expr;)+) => {$(
        // SAFETY: `repr(C)` or transparent, and numbers of one type alone: no padding.
        unsafe impl<S: Scalar<Unit: NoUninit>> NoUninit for $type<S> {}

        // SAFETY: the layout of an array of the same numbers; `$make` says which of them make a value.
        unsafe impl<S: Scalar<Unit: Pod>> CheckedBitPattern for $type<S> {
            type Bits = [S::Unit; $count];

            fn is_valid_bit_pattern(bits: &Self::Bits) -> bool {
                let make: fn([S::Unit; $count]) -> bool = $make;
                make(*bits)
            }
        }
    )+};
}

checked! {
    UnitVec3 of 3: |components| Self::new(Vec3::from_array(components)).is_ok();
    Quat of 4: |[w, x, y, z]| Self::new(w, x, y, z).is_ok();
}
