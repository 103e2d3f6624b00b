//! A point and a box, in the box's frame.

use crate::math::{Vec3, abs, clamp};
use crate::scalar::Scalar;

/// From the nearest point of the box to the point: zero inside.
#[inline(always)]
pub(super) fn outside<S: Scalar>(p: Vec3<S>, half: Vec3<S>) -> Vec3<S> {
    let beyond = |x: S, h: S| x.minus(clamp(x, h));
    Vec3::new(beyond(p.x, half.x), beyond(p.y, half.y), beyond(p.z, half.z))
}

/// The face that a point inside is nearest to: its outward normal, and the height above it, which is not positive.
#[inline]
pub(super) fn nearest_face<S: Scalar>(p: Vec3<S>, half: Vec3<S>) -> (Vec3<S::Unit>, S) {
    let heights = p.magnitudes() - half;
    let (one, zero) = (S::Unit::ONE, S::Unit::ZERO);
    let signed = |x: S| if x < S::ZERO { one.negated() } else { one };
    if heights.x >= heights.y && heights.x >= heights.z {
        (Vec3::new(signed(p.x), zero, zero), heights.x)
    } else if heights.y >= heights.z {
        (Vec3::new(zero, signed(p.y), zero), heights.y)
    } else {
        (Vec3::new(zero, zero, signed(p.z)), heights.z)
    }
}

/// The direction of a vector and its length, without a root where it lies along an axis. `None` of no length.
#[inline]
pub(super) fn direction<S: Scalar>(v: Vec3<S>) -> Option<(Vec3<S::Unit>, S)> {
    let zero = S::ZERO;
    let (one, nil) = (S::Unit::ONE, S::Unit::ZERO);
    let signed = |x: S| if x < zero { one.negated() } else { one };
    match (v.x == zero, v.y == zero, v.z == zero) {
        (true, true, true) => None,
        (false, true, true) => Some((Vec3::new(signed(v.x), nil, nil), abs(v.x))),
        (true, false, true) => Some((Vec3::new(nil, signed(v.y), nil), abs(v.y))),
        (true, true, false) => Some((Vec3::new(nil, nil, signed(v.z)), abs(v.z))),
        _ => S::direction3(v.to_array()).map(|(d, length)| (Vec3::from_array(d), length)),
    }
}
