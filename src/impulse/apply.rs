//! Equations (2) and (3): impulses change velocities.

use super::lever::Column;
use crate::body::Body;
use crate::math::{Block, Vec3};
use crate::scalar::Scalar;

/// An impulse `j` along the column's direction, on B; the opposite on A.
#[inline(always)]
pub(super) fn apply_normal<S: Scalar>(a: &mut Body<S>, b: &mut Body<S>, column: &Column<S>, j: S::Scaled) -> bool {
    let ([away, direction], [lever_a, lever_b]) = (column.directions, column.levers);
    S::push(a, away, lever_a, j) | S::push(b, direction, lever_b, j)
}

/// An impulse in any direction on `b`, the opposite on `a`.
#[inline(always)]
pub(super) fn apply_block<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    r: [&Vec3<S>; 2],
    arms: [&S::Arm; 2],
    j: &Block<S>,
) -> bool {
    S::kick(a, r[0], arms[0], &j.opposite()) | S::kick(b, r[1], arms[1], j)
}
