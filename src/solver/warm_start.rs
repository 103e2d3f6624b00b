//! What is carried over from step to step, and how the points of the next one find theirs.

use super::constraint::PointConstraint;
use crate::manifold::{FeatureId, ManifoldPoint};
use crate::scalar::{Scalar, StepArithmetic};

/// The impulses of a contact point at the end of a step, to start the next one from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WarmStart<S: Scalar> {
    /// Which point.
    pub feature: FeatureId,
    /// Where it was, seen from body B.
    pub(super) bearing: [i8; 3],
    pub(super) places: <S::Step as StepArithmetic<S>>::Places,
    pub(super) impulse: [S; 3],
}

/// How far apart two bearings may be, squared: half the distance between two corners of a cube's face.
const NEAR: i32 = 60 * 60;

impl<S: Scalar> WarmStart<S> {
    /// Nothing to start from.
    pub const NONE: Self =
        Self { feature: FeatureId(0), bearing: [0; 3], places: S::Step::NO_PLACES, impulse: [S::ZERO; 3] };

    fn distance(&self, bearing: [i8; 3]) -> i32 {
        let [x, y, z] = self.bearing;
        let square = |a: i8, b: i8| {
            let d = i32::from(a).wrapping_sub(i32::from(b));
            d.wrapping_mul(d)
        };
        square(x, bearing[0]).wrapping_add(square(y, bearing[1])).wrapping_add(square(z, bearing[2]))
    }
}

impl<S: Scalar> PointConstraint<S> {
    /// What to start the next step from.
    #[inline(always)]
    pub(super) fn kept_impulses(&self, places: <S::Step as StepArithmetic<S>>::Places) -> WarmStart<S> {
        WarmStart { feature: self.feature, bearing: self.bearing, impulse: self.impulse, places }
    }
}

/// The impulses of the step before, handed out to the points of a manifold.
pub(super) struct Kept<'a, S: Scalar> {
    warm: &'a [WarmStart<S>],
    points: &'a [ManifoldPoint<S>],
    /// A bit for each that went to a point near it.
    taken: u8,
}

impl<'a, S: Scalar> Kept<'a, S> {
    pub fn new(warm: &'a [WarmStart<S>], points: &'a [ManifoldPoint<S>]) -> Self {
        Self { warm, points, taken: 0 }
    }

    /// Those of the same feature; where there is none, those of the nearest point whose feature is gone. Where faces of one size
    /// lie on each other, noise decides at each corner which body's edges make the point: a pile that lost its impulses with
    /// every such change would sway.
    pub fn find(&mut self, feature: FeatureId, bearing: [i8; 3]) -> WarmStart<S> {
        for warm in self.warm {
            if warm.feature == feature {
                return *warm;
            }
        }
        self.nearest(bearing)
    }

    #[inline(never)]
    fn nearest(&mut self, bearing: [i8; 3]) -> WarmStart<S> {
        let (mut found, mut least, mut mark, mut bit) = (WarmStart::NONE, NEAR, 0, 1u8);
        for warm in self.warm {
            let distance = warm.distance(bearing);
            if distance < least && self.taken & bit == 0 && !self.goes_on(warm.feature) {
                (found, least, mark) = (*warm, distance, bit);
            }
            bit = bit.wrapping_shl(1);
        }
        self.taken |= mark;
        found
    }

    fn goes_on(&self, feature: FeatureId) -> bool {
        for point in self.points {
            if point.feature == feature {
                return true;
            }
        }
        false
    }
}
