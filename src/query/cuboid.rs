//! A ray and a box.

use super::{CastLocal, LocalHit, LocalRay};
use crate::math::{Vec3, abs};
use crate::scalar::Scalar;
use crate::shape::Cuboid;

impl<S: Scalar> CastLocal<S> for Cuboid<S> {
    /// The ray is between both faces across an axis from when it passes one to when it passes the other; it is in the box while
    /// it is between all three.
    fn cast(&self, ray: &LocalRay<S>) -> Option<LocalHit<S>> {
        let (o, d, h) = (ray.origin, ray.direction, self.half_extents());
        let mut range = [S::ZERO, ray.length];
        let mut normal = None;
        let (one, nil) = (S::Unit::ONE, S::Unit::ZERO);
        let axes = [Vec3::new(one, nil, nil), Vec3::new(nil, one, nil), Vec3::new(nil, nil, one)];
        let [x, y, z] = axes;
        for &(o, d, h, axis) in &[(o.x, d.x, h.x, x), (o.y, d.y, h.y, y), (o.z, d.z, h.z, z)] {
            // As if it came from the positive side.
            let against = if d > nil { S::opposite(&axis) } else { axis };
            let o = if d > nil { o.negated() } else { o };
            let speed = abs(d);
            let travelled = ray.length.times_unit(speed);
            if o < h.negated() || o.minus(travelled) > h {
                return None;
            }
            if o > h {
                let (enters, _) = S::from_scaled(o.minus(h).to_scaled() / speed.to_scaled());
                if enters > range[0] || normal.is_none() {
                    (range[0], normal) = (enters, Some(against));
                }
            }
            if o.minus(travelled) < h.negated() {
                let (leaves, _) = S::from_scaled(o.plus(h).to_scaled() / speed.to_scaled());
                if leaves < range[1] {
                    range[1] = leaves;
                }
            }
        }
        match normal {
            None => ray.inside(),
            Some(normal) if range[0] <= range[1] => ray.hit(range[0], normal),
            Some(_) => None,
        }
    }
}
