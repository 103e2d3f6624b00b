//! Equations (2) and (3): impulses change velocities.

use super::lever::Column;
use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::{Scalar, Scaled};

/// Changes the velocities of one body by a block of mantissas each, times a factor each.
#[inline(always)]
fn change<S: Scalar>(
    body: &mut Body<S>,
    linear: (Vec3<S::Unit>, S::Scaled),
    angular: (Vec3<S::Unit>, S::Scaled),
) -> bool {
    let (v, fast) = S::add_scaled3(body.linear_velocity.to_array(), linear.0.to_array(), linear.1);
    let (w, spinning) = S::add_scaled3(body.angular_velocity.to_array(), angular.0.to_array(), angular.1);
    body.linear_velocity = Vec3::from_array(v);
    body.angular_velocity = Vec3::from_array(w);
    fast | spinning
}

/// An impulse `j` along the column's direction, on B; the opposite on A.
#[inline(always)]
pub(super) fn apply_normal<S: Scalar>(a: &mut Body<S>, b: &mut Body<S>, column: &Column<S>, j: S::Scaled) -> bool {
    let d = column.direction.get();
    let (j_a, j_b) = (-(a.inv_mass * j), b.inv_mass * j);
    let clipped_a = change(a, (d, j_a), (column.a.turn, column.a.with_turn_exponent(-j)));
    let clipped_b = change(b, (d, j_b), (column.b.turn, column.b.with_turn_exponent(j)));
    clipped_a | clipped_b
}

/// Impulses along the normal and two tangents, on B; the opposite on A. Returns the tangential part as a vector.
#[inline(always)]
pub(super) fn apply_block<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    columns: &[Column<S>; 3],
    j: [S::Scaled; 3],
) -> (Vec3<S>, bool) {
    let (weights, exponent) = S::Scaled::align3(j);
    let [n, t1, t2] = columns;
    let sum = |n: Vec3<S::Unit>, t1: Vec3<S::Unit>, t2: Vec3<S::Unit>| {
        Vec3::new(
            S::Unit::dot3([n.x, t1.x, t2.x], weights),
            S::Unit::dot3([n.y, t1.y, t2.y], weights),
            S::Unit::dot3([n.z, t1.z, t2.z], weights),
        )
    };
    let impulse = sum(n.direction.get(), t1.direction.get(), t2.direction.get());
    let one = S::Scaled::ONE.raised(exponent);
    let turn_a = sum(n.a.turn, t1.a.turn, t2.a.turn);
    let turn_b = sum(n.b.turn, t1.b.turn, t2.b.turn);
    let (m_a, m_b) = (-a.inv_mass.raised(exponent), b.inv_mass.raised(exponent));
    let clipped_a = change(a, (impulse, m_a), (turn_a, n.a.with_turn_exponent(-one)));
    let clipped_b = change(b, (impulse, m_b), (turn_b, n.b.with_turn_exponent(one)));

    let tangential = sum(Vec3::ZERO, t1.direction.get(), t2.direction.get());
    let (friction, large) = S::add_scaled3([S::ZERO; 3], tangential.to_array(), one);
    (Vec3::from_array(friction), clipped_a | clipped_b | large)
}
