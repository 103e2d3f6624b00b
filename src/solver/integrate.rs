//! Velocities and positions over a sub-step, and what is stored at the end.

use super::gyroscope::spin;
use super::motion::Motion;
use super::settings::Settings;
use crate::body::Body;
use crate::math::{Quat, Vec3, clamp};
use crate::scalar::{Scalar, Scaled, StepArithmetic, Velocity};

type Places<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Places;

/// The stored velocities in the units of the step.
pub(super) fn lift<S: Scalar>(body: &Body<S>, motion: &mut Motion<S>, places: Places<S>) {
    let turn_places = S::Step::more(places, motion.size);
    let lift = |v: Vec3<S>, [x, y, z]: [_; 3], places| {
        Vec3::new(S::Step::lift(v.x, x, places), S::Step::lift(v.y, y, places), S::Step::lift(v.z, z, places))
    };
    let v = lift(body.linear_velocity, body.rests.linear, places);
    let w = lift(body.angular_velocity, body.rests.angular, turn_places);
    motion.now = Velocity { v, w };
    motion.free = motion.now;
    motion.sum = Velocity::ZERO;
}

/// Gravity and damping over a sub-step, and once more what contacts did in the last one: they will do about the same again.
#[inline(always)]
pub(super) fn integrate_velocity<S: Scalar>(body: &Body<S>, motion: &mut Motion<S>, fall: &Vec3<S>, inv_h: S::Scaled) {
    let contacts = motion.now.minus(&motion.free);
    let fall = if body.gravity_scale == S::ONE { *fall } else { *fall * body.gravity_scale };
    motion.free = Velocity {
        v: damped(motion.now.v + fall, body.linear_damping, inv_h),
        w: damped(motion.now.w, body.angular_damping, inv_h),
    };
    motion.now = motion.free.plus(&contacts);
}

/// v / (1 + c h): implicit, so that no rate is too high.
#[inline(always)]
fn damped<S: Scalar>(v: Vec3<S>, rate: S, inv_h: S::Scaled) -> Vec3<S> {
    if rate == S::ZERO {
        return v;
    }
    let kept = S::Unit::from_scaled(inv_h / (inv_h + rate.to_scaled())).0;
    Vec3::new(S::Step::times(v.x, kept), S::Step::times(v.y, kept), S::Step::times(v.z, kept))
}

/// A sub-step's motion; of bodies whose orientation matters to it, the orientation too.
#[inline(always)]
pub(super) fn integrate_position<S: Scalar>(
    body: &mut Body<S>,
    motion: &mut Motion<S>,
    h: S::SubStep,
    places: Places<S>,
) {
    motion.sum = motion.sum.plus(&motion.now);
    if motion.uneven {
        let change = spin(body, motion.now.w, h, S::Step::more(places, motion.size));
        motion.now.w += change;
        motion.free.w += change;
    }
}

/// Where the body is after the step, and its velocities; whether one met the end of its range.
#[inline(never)]
pub(super) fn store<S: Scalar>(
    body: &mut Body<S>,
    motion: &Motion<S>,
    settings: &Settings<S>,
    places: Places<S>,
) -> bool {
    let (h, turn_places) = (settings.h, S::Step::more(places, motion.size));
    let (place, moved, [rest_x, rest_y, rest_z]) = (body.position, motion.sum.v, &mut body.rests.position);
    let (x, clipped_x) = S::Step::travel(place.x, moved.x, h, places, rest_x);
    let (y, clipped_y) = S::Step::travel(place.y, moved.y, h, places, rest_y);
    let (z, clipped_z) = S::Step::travel(place.z, moved.z, h, places, rest_z);
    body.position = Vec3::new(x, y, z);
    let saturated = clipped_x | clipped_y | clipped_z;
    if motion.uneven {
        body.set_orientation(body.orientation());
    } else if motion.sum.w != Vec3::ZERO {
        body.set_orientation_alone(turn(body.orientation(), motion.sum.w, h, turn_places));
    }
    saturated | store_velocity(body, motion, places)
}

/// The orientation after a sum of spins: in one rotation or, where that is a large one, in up to eight of about a radian each; there
/// what is beyond is left out.
#[inline(always)]
pub(super) fn turn<S: Scalar>(orientation: Quat<S>, sum: Vec3<S>, h: S::SubStep, places: Places<S>) -> Quat<S> {
    let half = S::Unit::from_scaled(S::Scaled::from_parts(1, -1)).0;
    let (mut sum, mut rotations) = (sum, 1);
    let mut u = half_angles(sum, h, places);
    while rotations < 8 && u.to_array().iter().any(|x| *x > half || x.negated() > half) {
        sum = Vec3::new(S::Step::half(sum.x), S::Step::half(sum.y), S::Step::half(sum.z));
        u = half_angles(sum, h, places);
        rotations *= 2;
    }
    let u = Vec3::new(clamp(u.x, half), clamp(u.y, half), clamp(u.z, half));
    let mut after = orientation;
    while rotations > 0 {
        after = turned(after, u);
        rotations -= 1;
    }
    after
}

#[inline(always)]
pub(super) fn half_angles<S: Scalar>(w: Vec3<S>, h: S::SubStep, places: Places<S>) -> Vec3<S::Unit> {
    let angle = |w| S::Step::half_angle(w, h, places);
    Vec3::new(angle(w.x), angle(w.y), angle(w.z))
}

/// The velocities alone; whether one met the end of its range.
pub(super) fn store_velocity<S: Scalar>(body: &mut Body<S>, motion: &Motion<S>, places: Places<S>) -> bool {
    let (v, rests, clipped_v) = lowered(motion.now.v, places);
    let (w, rests_w, clipped_w) = lowered(motion.now.w, S::Step::more(places, motion.size));
    body.linear_velocity = v;
    body.rests.linear = rests;
    body.angular_velocity = w;
    body.rests.angular = rests_w;
    clipped_v | clipped_w
}

type Rest<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Rest;

#[inline(always)]
fn lowered<S: Scalar>(v: Vec3<S>, places: Places<S>) -> (Vec3<S>, [Rest<S>; 3], bool) {
    let (x, rest_x, clipped_x) = S::Step::lower(v.x, places);
    let (y, rest_y, clipped_y) = S::Step::lower(v.y, places);
    let (z, rest_z, clipped_z) = S::Step::lower(v.z, places);
    (Vec3::new(x, y, z), [rest_x, rest_y, rest_z], clipped_x | clipped_y | clipped_z)
}

/// The orientation after a rotation by `u`, which is half the angle.
#[inline(always)]
pub(super) fn turned<S: Scalar>(orientation: Quat<S>, u: Vec3<S::Unit>) -> Quat<S> {
    if u == Vec3::ZERO { orientation } else { orientation.turned(u) }
}
