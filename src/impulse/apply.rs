//! Equations (2) and (3): impulses change velocities.

use super::lever::Column;
use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::{Scalar, Scaled};

/// An impulse `j` along a direction as the body sees it.
#[inline(always)]
fn push<S: Scalar>(body: &mut Body<S>, direction: &Vec3<S::Unit>, lever: &S::Lever, j: S::Scaled) -> bool {
    S::push(&mut body.linear_velocity, &mut body.angular_velocity, (direction, body.inv_mass), lever, j)
}

/// An impulse `j` along the column's direction, on B; the opposite on A.
#[inline(always)]
pub(super) fn apply_normal<S: Scalar>(a: &mut Body<S>, b: &mut Body<S>, column: &Column<S>, j: S::Scaled) -> bool {
    push(a, &column.opposite, &column.a, j) | push(b, &column.direction, &column.b, j)
}

/// The sum of three vectors times a factor each.
#[inline(always)]
fn sum<U: Scalar>(v: [Vec3<U>; 3], factors: [U; 3]) -> Vec3<U> {
    let [n, t1, t2] = v;
    Vec3::new(
        U::dot3([n.x, t1.x, t2.x], factors),
        U::dot3([n.y, t1.y, t2.y], factors),
        U::dot3([n.z, t1.z, t2.z], factors),
    )
}

/// Impulses along the normal and two tangents, on B; the opposite on A. Returns the tangential part as a vector.
#[inline(always)]
pub(super) fn apply_block<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    columns: &[Column<S>; 3],
    j: [S::Scaled; 3],
) -> (Vec3<S>, bool) {
    let (j, exponent) = S::Scaled::align3(j);
    let one = S::Scaled::ONE.raised(exponent);
    let [n, t1, t2] = columns;
    let impulse = sum([n.opposite, t1.opposite, t2.opposite], j);
    let clipped_a = push(a, &impulse, &S::blend([&n.a, &t1.a, &t2.a], j), one);
    let impulse = sum([n.direction, t1.direction, t2.direction], j);
    let clipped_b = push(b, &impulse, &S::blend([&n.b, &t1.b, &t2.b], j), one);

    let tangential = sum([Vec3::ZERO, t1.direction, t2.direction], j).to_array();
    let [x, y, z] = tangential.map(|x| S::from_scaled(x.to_scaled() * one));
    (Vec3::new(x.0, y.0, z.0), clipped_a | clipped_b | x.1 | y.1 | z.1)
}
