//! Bodies that nothing moves but their own velocity.

use super::integrate::turn;
use super::settings::Settings;
use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::{Scalar, StepArithmetic};

/// Moves an immovable body on by a step with the velocities that it has, as far as its contacts are told: a lift, a conveyor that
/// also goes somewhere, a flipper. [`Step::finish`](super::Step::finish) leaves such bodies where they are. Whether a position met the end
/// of the format.
pub fn drive<S: Scalar>(body: &mut Body<S>, settings: &Settings<S>) -> bool {
    let mut saturated = false;
    for _ in 0..settings.sub_steps {
        let velocity = body.linear_velocity.to_array();
        let mut place = body.position.to_array();
        for ((x, v), rest) in place.iter_mut().zip(velocity).zip(&mut body.rests.position) {
            let (after, clipped) = x.advance(v, settings.h, rest);
            *x = after;
            saturated |= clipped;
        }
        body.position = Vec3::from_array(place);
        if body.angular_velocity != Vec3::ZERO {
            body.set_orientation(turn(body.orientation(), body.angular_velocity, settings.h, S::Step::NO_PLACES));
        }
    }
    saturated
}
