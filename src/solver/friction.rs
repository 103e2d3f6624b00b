//! Friction of a point: a disc in the tangent plane.

use super::constraint::PointConstraint;
use super::motion::Pair;
use crate::math::Vec3;
use crate::scalar::{Scalar, StepArithmetic};

impl<S: Scalar> PointConstraint<S> {
    /// The friction that stops the points where that is within the disc: both directions at once. Else each direction with
    /// the mass of the heavier, cut to the disc's radius: a block's impulse, cut, would turn the sliding aside.
    #[inline(always)]
    pub(super) fn solve_friction(&mut self, pair: &mut Pair<'_, S>, tangents: &[Vec3<S::Unit>; 2], normal_impulse: S) {
        let [_, before_x, before_y] = self.impulse;
        if normal_impulse == S::ZERO && before_x == S::ZERO && before_y == S::ZERO {
            return;
        }
        let x = pair.speed(&tangents[0], &self.tangents[0]).plus(self.drive[1]);
        let y = pair.speed(&tangents[1], &self.tangents[1]).plus(self.drive[2]);
        if x == S::ZERO && y == S::ZERO && before_x == S::ZERO && before_y == S::ZERO {
            return;
        }
        let limit = S::Step::by_ratio(normal_impulse, self.friction);
        let [stop_x, stop_y] = S::Step::by_block([x, y], self.block);
        let mut after = [before_x.minus(stop_x), before_y.minus(stop_y)];
        if !S::Step::is_within(after, limit) {
            after = [before_x.minus(x), before_y.minus(y)];
            if !S::Step::is_within(after, limit) {
                after = S::Step::shortened(after, limit);
            }
        }
        self.rub(pair, tangents, after);
    }

    /// Where a hard blow is over, its friction is, too: what is left of it goes into the disc again, or it would shift the
    /// bodies for a sub-step, at the friction's part of the blow's speed.
    #[cold]
    #[inline(never)]
    pub(super) fn let_go(&mut self, pair: &mut Pair<'_, S>, tangents: &[Vec3<S::Unit>; 2]) {
        let [normal, before_x, before_y] = self.impulse;
        let limit = S::Step::by_ratio(normal, self.friction);
        if S::Step::is_within([before_x, before_y], limit) {
            return;
        }
        let after = S::Step::shortened([before_x, before_y], limit);
        self.rub(pair, tangents, after);
    }

    /// Friction becomes that.
    #[inline(always)]
    fn rub(&mut self, pair: &mut Pair<'_, S>, tangents: &[Vec3<S::Unit>; 2], [x, y]: [S; 2]) {
        let [normal, before_x, before_y] = self.impulse;
        self.impulse = [normal, x, y];
        pair.push(&tangents[0], &self.tangents[0], x.minus(before_x));
        pair.push(&tangents[1], &self.tangents[1], y.minus(before_y));
    }
}
