//! References for functions in assembly, which take pointers to words.
#![allow(unsafe_code)]

use core::mem::offset_of;
use core::ptr::from_ref;

use fixed::FixedI32;
use fixed::types::{I2F30, I32F0};

use super::lever_words;
use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::scalar::lever32::Lever32;
use crate::scalar::stored32;

/// Where functions in assembly find what of a body they read.
const _: () = {
    assert!(offset_of!(Body<I32F0>, linear_velocity) == 12);
    assert!(offset_of!(Body<I32F0>, angular_velocity) == 24);
    assert!(offset_of!(Body<I32F0>, inv_mass) == 48);
    assert!(offset_of!(Body<I32F0>, inv_inertia_world) == 56);
    assert!(offset_of!(Body<I32F0>, exponent) == 80);
};

/// A lever, as that of `portable.rs`.
#[inline(always)]
pub fn lever<F>(body: &Body<FixedI32<F>>, r: &Vec3<FixedI32<F>>, d: &Vec3<I2F30>) -> Lever32
where
    FixedI32<F>: Scalar,
{
    // SAFETY: two of the references are to three words each, one is to a body, laid out as the constants above say; the function
    // reads those, writes every field of the lever, which is `repr(C)`, and keeps to the calling convention.
    unsafe { lever_words(from_ref(r).cast(), from_ref(body).cast(), from_ref(d).cast()) }
}

/// For the few changes that `add_scaled` leaves alone. The format makes no difference.
#[cold]
pub(super) extern "C" fn add_far(x: &mut Vec3<I32F0>, d: &Vec3<I2F30>, k: i32, down: i32) -> bool {
    stored32::add_far(x, d, k, down)
}
