//! A capsule and a half-space: a point below each end that is near it.

use super::{Placed, above, point};
use crate::manifold::Manifold;
use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Closest, HalfSpace};

/// The way from the middle to the end that is at the positive side of the axis, and how much higher it is.
#[inline(always)]
fn end<S: Scalar>((capsule, pose): Placed<'_, S, Capsule<S>>, up: Vec3<S::Unit>) -> (Vec3<S>, S) {
    let [_, _, axis] = pose.rotation.columns();
    let end = Vec3::of_length(capsule.half_length(), axis);
    (end, capsule.half_length().times_unit(axis.dot(up)))
}

pub(super) fn manifold<S: Scalar>(
    capsule: Placed<'_, S, Capsule<S>>,
    plane: Placed<'_, S, HalfSpace<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    let (up, height, d) = above(capsule.1, plane);
    let (end, rise) = end(capsule, up);
    let down = S::opposite(&up);
    let radius = capsule.0.radius();
    out.begin(down);
    for &(feature, end, rise) in &[(0, end, rise), (1, -end, rise.negated())] {
        let separation = height.plus(rise).minus(radius);
        if separation <= margin {
            let r = end + Vec3::of_length(radius.plus(separation.lowered_by(1)), down);
            out.push(point(r, d, separation, feature));
        }
    }
}

pub(super) fn closest<S: Scalar>(capsule: Placed<'_, S, Capsule<S>>, plane: Placed<'_, S, HalfSpace<S>>) -> Closest<S> {
    let (up, height, d) = above(capsule.1, plane);
    let (end, rise) = end(capsule, up);
    let (end, height) = if rise < S::ZERO { (end, height.plus(rise)) } else { (-end, height.minus(rise)) };
    let down = S::opposite(&up);
    let radius = capsule.0.radius();
    Closest {
        normal: UnitVec3::from_unit(down),
        separation: height.minus(radius),
        r_a: end + Vec3::of_length(radius, down),
        r_b: end + Vec3::of_length(height, down) - d,
    }
}
