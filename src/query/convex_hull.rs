//! A ray and a hull.

use super::{CastLocal, LocalHit, LocalRay};
use crate::math::abs;
use crate::scalar::Scalar;
use crate::shape::ConvexHull;

impl<S: Scalar, const N: usize> CastLocal<S> for ConvexHull<S, N> {
    /// Behind each face's plane, the ray is from when it enters or until it leaves; it is in the hull while it is behind all.
    fn cast(&self, ray: &LocalRay<S>) -> Option<LocalHit<S>> {
        let (mut begin, mut end, mut normal) = (S::ZERO, ray.length, None);
        for face in self.faces() {
            let height = ray.origin.along(face.normal).minus(face.offset);
            let climb = face.normal.dot(ray.direction);
            let change = ray.length.times_unit(climb);
            if height > S::ZERO && height.plus(change) > S::ZERO {
                return None;
            }
            // Crossed on the way: no division elsewhere.
            if height > S::ZERO || height.plus(change) > S::ZERO {
                let (crossed, _) = S::from_scaled(abs(height).to_scaled() / abs(climb).to_scaled());
                if height > S::ZERO {
                    if crossed > begin || normal.is_none() {
                        (begin, normal) = (crossed, Some(face.normal));
                    }
                } else if crossed < end {
                    end = crossed;
                }
            }
        }
        match normal {
            None => ray.inside(),
            Some(normal) if begin <= end => ray.hit(begin, normal),
            Some(_) => None,
        }
    }
}
