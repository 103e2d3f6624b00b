//! Several shapes on one body.

use crate::aabb::Aabb;
use crate::error::CompoundError;
use crate::math::{Pose, Vec3, min};
use crate::query::{Ray, RayHit, SurfacePoint};
use crate::scalar::Scalar;
use crate::shape::{Member, OutlineSink, Shape, at_most};

/// The most parts: they are counted in eight bits.
const MOST: usize = 255;

/// A shape, and where it sits on a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part<S: Scalar, P> {
    /// In the body's frame, whose origin is the centre of mass.
    pub pose: Pose<S>,
    /// What sits there.
    pub shape: P,
}

impl<S: Scalar, P> Part<S, P> {
    /// The same part in another frame of the same body, such as that of an [`Assembly`](crate::Assembly).
    #[must_use]
    pub fn seen_from(self, frame: &Pose<S>) -> Self {
        Self { pose: frame.inverse().times(&self.pose), shape: self.shape }
    }
}

/// Several shapes as one: a dumbbell, a table, the walls of a maze. The parts stay in memory of the caller's and may be shared
/// by many bodies; they may overlap each other.
///
/// The parts are of one type: where they differ, of a set made by [`shapes!`](crate::shapes). In a manifold's `part`
/// ([`ManifoldSink::take`](crate::ManifoldSink::take)) the top eight bits are the number of A's part in its slice, the next
/// eight that of B's, and the rest is what the two parts themselves tell. A compound may be part of another: of n parts, the
/// number k there and i in the inner one make i n + k.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compound<'a, S: Scalar, P> {
    parts: &'a [Part<S, P>],
    /// Of the box around all parts, in the compound's frame. Without end where a part has none.
    middle: Vec3<S>,
    half: Vec3<S>,
    /// The least inner radius.
    smallest: S,
}

impl<'a, S: Scalar, P: Shape<S>> Compound<'a, S, P> {
    /// A compound of 1 to 255 parts.
    ///
    /// # Errors
    /// [`CompoundError`] says what is wrong with the parts.
    pub fn new(parts: &'a [Part<S, P>]) -> Result<Self, CompoundError> {
        let [first, others @ ..] = parts else { return Err(CompoundError::Empty) };
        if parts.len() > MOST {
            return Err(CompoundError::TooMany);
        }
        if parts.iter().any(|part| !part.pose.is_finite()) {
            return Err(CompoundError::Pose);
        }
        let (mut bounds, mut smallest) = (first.shape.aabb(&first.pose), first.shape.inner_radius());
        for part in others {
            bounds = bounds.union(&part.shape.aabb(&part.pose));
            smallest = min(smallest, part.shape.inner_radius());
        }
        let endless = [Vec3::ZERO, Aabb::unbounded().max];
        let [middle, half] = if bounds.is_bounded() { bounds.middle_and_half() } else { endless };
        Ok(Self { parts, middle, half, smallest })
    }
}

impl<'a, S: Scalar, P> Compound<'a, S, P> {
    /// The parts, in the order of their numbers.
    #[inline(always)]
    pub const fn parts(&self) -> &'a [Part<S, P>] {
        self.parts
    }
}

impl<S: Scalar, P: Copy> Member for Compound<'_, S, P> {}

impl<S: Scalar, P: Shape<S>> Shape<S> for Compound<'_, S, P> {
    /// Around the box that holds all parts: its cost does not depend on how many there are.
    fn aabb(&self, pose: &Pose<S>) -> Aabb<S> {
        if self.half.x == S::LARGEST {
            Aabb::unbounded()
        } else {
            Aabb::of_box(pose.to_world(self.middle), self.half, &pose.rotation)
        }
    }

    /// Of the smallest part.
    #[inline(always)]
    fn inner_radius(&self) -> S {
        self.smallest
    }

    fn outer_radius(&self) -> S {
        if self.half.x == S::LARGEST { S::LARGEST } else { at_most(self.middle.magnitudes() + self.half) }
    }

    fn cast_ray(&self, pose: &Pose<S>, ray: &Ray<S>) -> Option<RayHit<S>> {
        let (mut first, mut rest) = (None, *ray);
        for part in self.parts {
            if let Some(hit) = part.shape.cast_ray(&pose.times(&part.pose), &rest) {
                // The next one has to come before that.
                if first.is_none() || hit.distance < rest.length {
                    (first, rest.length) = (Some(hit), hit.distance);
                }
            }
        }
        first
    }

    /// For a point inside: of the part that it is deepest in.
    fn closest_point(&self, pose: &Pose<S>, point: Vec3<S>) -> Option<SurfacePoint<S>> {
        let mut best: Option<SurfacePoint<S>> = None;
        for part in self.parts {
            if let Some(found) = part.shape.closest_point(&pose.times(&part.pose), point)
                && best.is_none_or(|best| found.separation < best.separation)
            {
                best = Some(found);
            }
        }
        best
    }

    fn outline<K: OutlineSink<S>>(&self, pose: &Pose<S>, sink: &mut K) {
        for part in self.parts {
            part.shape.outline(&pose.times(&part.pose), sink);
        }
    }
}
