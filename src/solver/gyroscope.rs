//! Free rotation of bodies that are not the same about every axis.

use super::integrate::{half_angles, turn};
use crate::body::Body;
use crate::math::{Vec3, abs};
use crate::scalar::{Scalar, Scaled, StepArithmetic};

type Places<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Places;

/// Turns the body by the spin `w` over a sub-step, and returns how the spin changes.
///
/// Euler's equation in the body's frame, I_x w_x' = (I_y - I_z) w_y w_z and so on, by the midpoint rule; the orientation turns
/// by the spin in the middle, and the change comes to the world's frame as the mean of what it is in the old orientation and
/// in the new one. The error in attitude is of second order.
///
/// The implicit midpoint rule keeps energy and momentum, and its equation is solved by as many rounds as the angle of the
/// sub-step asks for. Beyond a radian a sub-step the rounds do not converge, and the spin stays as it is.
pub(super) fn spin<S: Scalar>(body: &mut Body<S>, w: Vec3<S>, h: S::SubStep, places: Places<S>) -> Vec3<S> {
    let before = body.orientation().to_mat3();
    let local = w.through(before.columns());
    let mut change = Vec3::ZERO;
    for _ in 0..rounds::<S>(half_angles(local, h, places)) {
        change = self::change(body.gyration, local + halved::<S>(change), h, places);
    }
    let half = halved::<S>(change);
    let mean = w + half.through(before.rows);
    body.set_orientation_alone(turn(body.orientation(), mean, h, places));
    let after = body.orientation().to_mat3();
    half.through(before.rows) + half.through(after.rows)
}

/// The rounds for half the angle of a sub-step: what is left falls by the angle with each.
#[inline(always)]
fn rounds<S: Scalar>(half_angle: Vec3<S::Unit>) -> u8 {
    let [x, y, z] = half_angle.to_array().map(abs);
    let sum = x.plus(y).plus(z);
    let below = |power| sum < S::Unit::from_scaled(S::Scaled::from_parts(1, power)).0;
    if below(-5) {
        2
    } else if below(-3) {
        4
    } else if below(-1) {
        8
    } else {
        0
    }
}

/// h w' in the body's frame.
#[inline(always)]
fn change<S: Scalar>(gyration: Vec3<S::Unit>, w: Vec3<S>, h: S::SubStep, places: Places<S>) -> Vec3<S> {
    let angle = |w| S::Step::half_angle(w, h, places);
    let twice = |x: S| x.plus(x);
    let (x, y, z) = (angle(w.x), angle(w.y), angle(w.z));
    Vec3::new(
        twice(S::Step::times(S::Step::times(w.y, z), gyration.x)),
        twice(S::Step::times(S::Step::times(w.z, x), gyration.y)),
        twice(S::Step::times(S::Step::times(w.x, y), gyration.z)),
    )
}

#[inline(always)]
fn halved<S: Scalar>(v: Vec3<S>) -> Vec3<S> {
    Vec3::new(S::Step::half(v.x), S::Step::half(v.y), S::Step::half(v.z))
}
