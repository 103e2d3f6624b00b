//! Restitution that does not raise the energy: what contacts do to it is counted, and the rebound gives back no more.

use super::constraint::PointConstraint;
use super::motion::Pair;
use crate::math::Vec3;
use crate::scalar::{Scalar, Scaled, StepArithmetic};

impl<S: Scalar> PointConstraint<S> {
    /// Adds the work of the normal impulse since `speed` was noted, and notes the speed now. Impulses that act together do the
    /// work of each times the mean of its speeds before and after, whatever else acts meanwhile.
    ///
    /// Works are in units of half the second body's mass, times the step's square of a speed: one unit within a manifold.
    #[inline(never)]
    pub(super) fn count_work(&mut self, sum: S::Scaled, now: S) -> S::Scaled {
        let sum = sum + self.work(self.impulse[0], self.speed.to_scaled() + now.to_scaled());
        self.speed = now;
        sum
    }

    #[inline(always)]
    fn work(&self, impulse: S, speeds: S::Scaled) -> S::Scaled {
        let [_, column] = &self.normal;
        column.share.to_scaled() * impulse.to_scaled() * speeds
    }
}

/// Draws the rebounds of a manifold back to where their work and `done`, that of the impulses before, come to nothing.
///
/// Of rebounds by a part s the work is a s + b s^2, with a from the speeds before them and b > 0 from what they change.
#[inline(never)]
pub(super) fn draw_back<S: Scalar>(
    points: &mut [PointConstraint<S>],
    pair: &mut Pair<'_, S>,
    normal: &Vec3<S::Unit>,
    rebounds: &mut [Option<S>; 4],
    done: S::Scaled,
) {
    let (mut a, mut b) = (S::Scaled::ZERO, S::Scaled::ZERO);
    let mut changes = rebounds.iter();
    for point in points.iter() {
        let Some(change) = changes.next() else { break };
        if let Some(change) = change {
            let (before, after) = (point.speed.to_scaled(), point.normal_speed(pair, normal).to_scaled());
            a = a + point.work(*change, before + before);
            b = b + point.work(*change, after - before);
        }
    }
    if done + a + b <= S::Scaled::ZERO || b <= S::Scaled::ZERO {
        return;
    }
    let four = S::Scaled::ratio(4, 1);
    let part = if done < S::Scaled::ZERO { ((a * a - four * b * done).sqrt() - a) / (b + b) } else { S::Scaled::ZERO };
    let (part, _) = S::Unit::from_scaled(part);
    let mut changes = rebounds.iter_mut();
    for point in points {
        let Some(change) = changes.next() else { break };
        if let Some(change) = change {
            let kept = S::Step::times(*change, part);
            let back = kept.minus(*change);
            point.total = point.total.plus(back);
            point.push_normal(pair, normal, back);
            *change = kept;
        }
    }
}
