//! A ray and a half-space.

use super::{CastLocal, LocalHit, LocalRay};
use crate::scalar::Scalar;
use crate::shape::HalfSpace;

impl<S: Scalar> CastLocal<S> for HalfSpace<S> {
    fn cast(&self, ray: &LocalRay<S>) -> Option<LocalHit<S>> {
        let normal = self.normal().get();
        let height = ray.origin.along(normal);
        if height <= S::ZERO {
            return ray.inside();
        }
        let falls = normal.dot(ray.direction).negated();
        // What it falls on the whole way; no division where that is not enough.
        if falls <= S::Unit::ZERO || ray.length.times_unit(falls) < height {
            return None;
        }
        let (distance, _) = S::from_scaled(height.to_scaled() / falls.to_scaled());
        ray.hit(distance, normal)
    }
}
