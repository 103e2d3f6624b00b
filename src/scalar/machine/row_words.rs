//! References for the speeds of rows in assembly, which take pointers to words.
#![allow(unsafe_code)]

use core::mem::offset_of;
use core::ptr::from_ref;

use fixed::FixedI32;
use fixed::types::{I2F30, I32F0};

#[cfg(multiply = "short")]
use super::baseline::rows::{central_speed_words, lone_speed_words, pair_speed_words};
#[cfg(multiply = "long")]
use super::mainline::rows::{central_speed_words, lone_speed_words, pair_speed_words};
use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::scalar::step::{Column, Velocity};

/// From one column to the next.
pub(super) const COLUMN: usize = size_of::<Column<I32F0>>();

// Velocities are two vectors, a column begins with its arm. All are `repr(C)`.
const _: () = {
    assert!(offset_of!(Velocity<I32F0>, w) == 12 && size_of::<Velocity<I32F0>>() == 24);
    assert!(offset_of!(Column<I32F0>, arm) == 0 && COLUMN == 28);
};

/// The speed of a body's point along a direction.
#[inline(always)]
pub fn lone_speed<F>(d: &Vec3<I2F30>, body: &Velocity<FixedI32<F>>, column: &Column<FixedI32<F>>) -> FixedI32<F>
where
    FixedI32<F>: Scalar<Unit = I2F30>,
{
    // SAFETY: the references are to words laid out as above; the function reads them, and keeps to the calling convention.
    FixedI32::from_bits(unsafe { lone_speed_words(from_ref(d).cast(), from_ref(body).cast(), from_ref(column).cast()) })
}

/// The speed of the second body's point relative to the first's.
#[inline(always)]
pub fn pair_speed<F>(
    d: &Vec3<I2F30>,
    [a, b]: [&Velocity<FixedI32<F>>; 2],
    columns: &[Column<FixedI32<F>>; 2],
) -> FixedI32<F>
where
    FixedI32<F>: Scalar<Unit = I2F30>,
{
    // SAFETY: as above.
    FixedI32::from_bits(unsafe {
        pair_speed_words(from_ref(d).cast(), from_ref(a).cast(), from_ref(b).cast(), from_ref(columns).cast())
    })
}

/// The speed of the second body's centre relative to the first's.
#[inline(always)]
pub fn central_speed<F>(d: &Vec3<I2F30>, [a, b]: [&Vec3<FixedI32<F>>; 2]) -> FixedI32<F> {
    // SAFETY: as above.
    FixedI32::from_bits(unsafe { central_speed_words(from_ref(d).cast(), from_ref(a).cast(), from_ref(b).cast()) })
}
