//! A ray and a capsule.

use super::sphere::ball;
use super::{CastLocal, LocalHit, LocalRay, entry};
use crate::math::{Vec3, abs, clamp};
use crate::scalar::Scalar;
use crate::shape::Capsule;

impl<S: Scalar> CastLocal<S> for Capsule<S> {
    /// What comes first: the side, or one of the round ends.
    fn cast(&self, ray: &LocalRay<S>) -> Option<LocalHit<S>> {
        let Vec3 { x, y, z } = ray.origin;
        let beyond = z.minus(clamp(z, self.half_length()));
        let way = [x, y, beyond];
        if S::wide_dot3(way, way) <= S::wide_product(self.radius(), self.radius()) {
            return ray.inside();
        }
        let end = Vec3::new(S::ZERO, S::ZERO, self.half_length());
        let ends = [ball(ray, end, self.radius()), ball(ray, -end, self.radius())];
        let mut first = side(self, ray);
        for hit in ends.iter().flatten() {
            if first.is_none_or(|first| hit.distance < first.distance) {
                first = Some(*hit);
            }
        }
        first
    }
}

/// Seen along the axis, the ray meets a circle; the way there is shorter by the sine of the angle to the axis.
fn side<S: Scalar>(capsule: &Capsule<S>, ray: &LocalRay<S>) -> Option<LocalHit<S>> {
    let Vec3 { x: u, y: v, .. } = ray.direction;
    let ([u, v, _], sine) = S::Unit::direction3([u, v, S::Unit::ZERO])?;
    let direction = Vec3::new(u, v, S::Unit::ZERO);
    let way = Vec3::new(ray.origin.x, ray.origin.y, S::ZERO);
    let along = way.along(direction);
    let seen = entry(capsule.radius(), way - Vec3::of_length(along, direction), along)?;
    if seen < S::ZERO || ray.length.times_unit(sine) < seen {
        return None;
    }
    let (distance, _) = S::from_scaled(seen.to_scaled() / sine.to_scaled());
    let place = ray.at(distance);
    if abs(place.z) > capsule.half_length() {
        return None;
    }
    let (normal, _) = S::direction3([place.x, place.y, S::ZERO])?;
    ray.hit(distance, Vec3::from_array(normal))
}
