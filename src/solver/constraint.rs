//! A manifold prepared for a step, and its normal impulses.

use core::ops::Range;

use super::motion::Pair;
use super::softness::Softness;
use crate::manifold::FeatureId;
use crate::math::Vec3;
use crate::scalar::{Column, Scalar, StepArithmetic};

/// A manifold prepared for a step: working space that the caller lends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ManifoldConstraint<S: Scalar> {
    /// `None`: a body that does not move.
    pub(super) a: Option<u16>,
    pub(super) b: u16,
    /// The index of the first point.
    pub(super) first: u16,
    pub(super) points: u8,
    pub(super) hard: bool,
    pub(super) bounces: bool,
    pub(super) normal: Vec3<S::Unit>,
    pub(super) tangents: [Vec3<S::Unit>; 2],
    pub(super) restitution: S::Unit,
    /// Where the rebound must not raise the energy: the work of the normal impulses so far.
    pub(super) work: Option<S::Scaled>,
}

/// A contact point prepared for a step: working space that the caller lends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointConstraint<S: Scalar> {
    pub(super) normal: [Column<S>; 2],
    pub(super) tangents: [[Column<S>; 2]; 2],
    /// The inverse of the tangents' 2x2 inverse mass, in units of the larger mass.
    pub(super) block: [<S::Step as StepArithmetic<S>>::Ratio; 3],
    /// mu in units of tangent impulses for normal ones.
    pub(super) friction: <S::Step as StepArithmetic<S>>::Ratio,
    /// The gap at the start of the step, as the speed that closes it in a sub-step; later less what the surfaces move.
    pub(super) gap: S,
    /// The speed of an immovable body's surface, seen from the other: along the normal and the tangents.
    pub(super) drive: [S; 3],
    /// Along the normal and the tangents.
    pub(super) impulse: [S; 3],
    /// The sum of the normal impulses over the sub-steps so far.
    pub(super) total: S,
    pub(super) approach: S,
    pub(super) change: S,
    pub(super) gap_struck: S,
    /// When work was last counted.
    pub(super) speed: S,
    pub(super) feature: FeatureId,
    pub(super) bearing: [i8; 3],
    /// With an impulse in the step before.
    pub(super) lasting: bool,
    pub(super) struck: bool,
    /// The normal goes through the centres of mass: it turns neither body.
    pub(super) central: bool,
    /// Not yet in touch in this sub-step.
    pub(super) apart: bool,
}

impl<S: Scalar> ManifoldConstraint<S> {
    /// Working space for one manifold.
    pub const NEW: Self = Self {
        a: None,
        b: 0,
        first: 0,
        points: 0,
        hard: false,
        bounces: false,
        normal: Vec3::ZERO,
        tangents: [Vec3::ZERO; 2],
        restitution: <S::Unit as Scalar>::ZERO,
        work: None,
    };

    /// Which points are its own.
    #[inline(always)]
    pub(super) fn range(&self) -> Range<usize> {
        let first = usize::from(self.first);
        first..first.wrapping_add(usize::from(self.points))
    }
}

impl<S: Scalar> PointConstraint<S> {
    /// Working space for one point.
    pub const NEW: Self = Self {
        normal: [Column::NONE; 2],
        tangents: [[Column::NONE; 2]; 2],
        block: [S::Step::NO_RATIO; 3],
        friction: S::Step::NO_RATIO,
        gap: S::ZERO,
        drive: [S::ZERO; 3],
        impulse: [S::ZERO; 3],
        total: S::ZERO,
        approach: S::ZERO,
        change: S::ZERO,
        gap_struck: S::ZERO,
        speed: S::ZERO,
        feature: FeatureId(0),
        bearing: [0; 3],
        lasting: false,
        struck: false,
        central: false,
        apart: false,
    };

    #[inline(always)]
    pub(super) fn normal_speed(&self, pair: &Pair<'_, S>, normal: &Vec3<S::Unit>) -> S {
        let speed = if self.central { pair.central_speed(normal) } else { pair.speed(normal, &self.normal) };
        speed.plus(self.drive[0])
    }

    /// The gap as it is now.
    #[inline(always)]
    pub(super) fn gap(&self, pair: &Pair<'_, S>, normal: &Vec3<S::Unit>) -> S {
        let way = if self.central { pair.central_way(normal) } else { pair.way(normal, &self.normal) };
        self.gap.plus(way)
    }

    #[inline(always)]
    pub(super) fn push_normal(&self, pair: &mut Pair<'_, S>, normal: &Vec3<S::Unit>, impulse: S) {
        if self.central {
            pair.push_centrally(normal, &self.normal, impulse);
        } else {
            pair.push(normal, &self.normal, impulse);
        }
    }

    /// The impulse that was there before, on the bodies.
    #[inline(always)]
    pub(super) fn warm_start(&self, pair: &mut Pair<'_, S>, normal: &Vec3<S::Unit>, tangents: &[Vec3<S::Unit>; 2]) {
        self.push_normal(pair, normal, self.impulse[0]);
        pair.push(&tangents[0], &self.tangents[0], self.impulse[1]);
        pair.push(&tangents[1], &self.tangents[1], self.impulse[2]);
    }

    /// The normal impulse of a soft contact. Across a gap just enough that it is closed and no more.
    #[inline(always)]
    pub(super) fn solve_normal(
        &mut self,
        pair: &mut Pair<'_, S>,
        normal: &Vec3<S::Unit>,
        softness: &Softness<S>,
        push_out_speed: S,
    ) {
        let speed = self.normal_speed(pair, normal);
        let gap = self.gap(pair, normal);
        self.apart = gap > S::ZERO;
        let before = self.impulse[0];
        let after = if self.apart {
            before.minus(speed.plus(gap))
        } else {
            let bias = S::Step::times(gap, softness.bias);
            let bias = if bias.plus(push_out_speed) < S::ZERO { push_out_speed.negated() } else { bias };
            let rigid = S::Step::times(speed.plus(bias), softness.mass);
            before.minus(rigid).minus(S::Step::times(before, softness.relaxed))
        };
        let after = if after > S::ZERO { after } else { S::ZERO };
        self.note_impact(after, speed, gap);
        self.impulse[0] = after;
        self.push_normal(pair, normal, after.minus(before));
    }

    /// The normal impulse of a rigid contact: takes back the speed that undoing the overlap gave. Across a gap it may only
    /// become less: what is still on its way keeps its speed.
    #[inline(always)]
    pub(super) fn relax_normal(&mut self, pair: &mut Pair<'_, S>, normal: &Vec3<S::Unit>) {
        let speed = self.normal_speed(pair, normal);
        let before = self.impulse[0];
        let after = before.minus(speed);
        let after = if after > S::ZERO { after } else { S::ZERO };
        let after = if self.apart && after > before { before } else { after };
        self.impulse[0] = after;
        self.push_normal(pair, normal, after.minus(before));
    }
}
