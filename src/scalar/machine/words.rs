//! References for functions in assembly, which take pointers to words.
#![allow(unsafe_code)]

use core::ptr::{from_mut, from_ref};

use fixed::FixedI32;
use fixed::types::{I2F30, I32F0};

use super::{add_scaled_words, lever_words};
use crate::math::{SymMat3, Vec3};
use crate::scalar::lever32::Lever32;
use crate::scalar::stored32;

/// A lever, as that of `portable.rs`.
#[inline(always)]
pub fn lever<F>(
    r: &Vec3<FixedI32<F>>,
    w: &Vec3<FixedI32<F>>,
    d: &Vec3<I2F30>,
    inv_inertia: &SymMat3<I2F30>,
    exponent: i32,
) -> Lever32 {
    let (r, w, d, inv_inertia) =
        (from_ref(r).cast(), from_ref(w).cast(), from_ref(d).cast(), from_ref(inv_inertia).cast());
    // SAFETY: the references are to three words, or six, each; the function reads those, writes every field of the lever, which
    // is `repr(C)`, and keeps to the calling convention.
    unsafe { lever_words(r, w, d, inv_inertia, exponent) }
}

/// Adds `d k / 2^(32 + down)` to `x`, rounded once a component; whether a component met the end of the range. The upper half of
/// `d k` has 29 bits at most.
#[inline(always)]
pub fn add_scaled<F>(x: &mut Vec3<FixedI32<F>>, d: &Vec3<I2F30>, k: i32, down: i32) -> bool {
    // SAFETY: the references are to three words each; the function reads those, writes those of `x` or leaves it to `add_far`,
    // and keeps to the calling convention.
    unsafe { add_scaled_words(from_mut(x).cast(), from_ref(d).cast(), k, down) }
}

/// For the few changes that `add_scaled` leaves alone. The format makes no difference.
#[cold]
pub(super) extern "C" fn add_far(x: &mut Vec3<I32F0>, d: &Vec3<I2F30>, k: i32, down: i32) -> bool {
    stored32::add_far(x, d, k, down)
}
