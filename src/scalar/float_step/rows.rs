//! What a row of the solver asks of two bodies' velocities, and does to them.

use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::scalar::step::{Column, Velocity};

#[inline(always)]
pub fn lone_speed<S: Scalar<Unit = S>>(d: &Vec3<S>, body: &Velocity<S>, column: &Column<S>) -> S {
    body.v.dot(*d).plus(body.w.dot(column.arm))
}

#[inline(always)]
pub fn pair_speed<S: Scalar<Unit = S>>(d: &Vec3<S>, [a, b]: [&Velocity<S>; 2], columns: &[Column<S>; 2]) -> S {
    // The difference first: in a common drift, the speeds are large and their difference small.
    (b.v - a.v).dot(*d).plus(a.w.dot(columns[0].arm).plus(b.w.dot(columns[1].arm)))
}

#[inline(always)]
pub fn central_speed<S: Scalar<Unit = S>>(d: &Vec3<S>, [a, b]: [&Vec3<S>; 2]) -> S {
    (*b - *a).dot(*d)
}

#[inline(always)]
pub fn push<S: Scalar<Unit = S>>(body: &mut Velocity<S>, d: &Vec3<S>, column: &Column<S>, impulse: S) {
    body.v += *d * column.share.times(impulse);
    body.w += column.turn * impulse;
}

#[inline(always)]
pub fn push_pair<S: Scalar<Unit = S>>(
    [a, b]: [&mut Velocity<S>; 2],
    d: &Vec3<S>,
    columns: &[Column<S>; 2],
    impulse: S,
) {
    a.v -= *d * columns[0].share.times(impulse);
    a.w += columns[0].turn * impulse;
    push(b, d, &columns[1], impulse);
}

#[inline(always)]
pub fn thrust<S: Scalar<Unit = S>>(v: &mut Vec3<S>, d: &Vec3<S>, share: S, impulse: S) {
    *v += *d * share.times(impulse);
}
