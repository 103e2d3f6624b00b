//! The smaller and the larger of two numbers: the traits of floats and of fixed point name them differently.

use crate::scalar::Scalar;

#[inline(always)]
pub(crate) fn min<S: Scalar>(a: S, b: S) -> S {
    if b < a { b } else { a }
}

#[inline(always)]
pub(crate) fn max<S: Scalar>(a: S, b: S) -> S {
    if a < b { b } else { a }
}

#[inline(always)]
pub(crate) fn abs<S: Scalar>(x: S) -> S {
    if x < S::ZERO { x.negated() } else { x }
}

/// The nearest number to `x` in `-limit` to `limit`.
#[inline(always)]
pub(crate) fn clamp<S: Scalar>(x: S, limit: S) -> S {
    if limit < x {
        limit
    } else if x < limit.negated() {
        limit.negated()
    } else {
        x
    }
}
