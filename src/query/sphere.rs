//! A ray and a sphere.

use super::{CastLocal, LocalHit, LocalRay, entry};
use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::shape::Sphere;

impl<S: Scalar> CastLocal<S> for Sphere<S> {
    fn cast(&self, ray: &LocalRay<S>) -> Option<LocalHit<S>> {
        ball(ray, Vec3::ZERO, self.radius())
    }
}

/// A ball around any centre.
pub(super) fn ball<S: Scalar>(ray: &LocalRay<S>, centre: Vec3<S>, radius: S) -> Option<LocalHit<S>> {
    let way = ray.origin - centre;
    let array = way.to_array();
    if S::wide_dot3(array, array) <= S::wide_product(radius, radius) {
        return ray.inside();
    }
    let along = way.along(ray.direction);
    let distance = entry(radius, way - Vec3::of_length(along, ray.direction), along)?;
    let (normal, _) = S::direction3((ray.at(distance) - centre).to_array())?;
    ray.hit(distance, Vec3::from_array(normal))
}
