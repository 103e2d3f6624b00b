//! The points of each shape, and what of it is closest to an edge.

use super::{Beside, OverSurface, Polytope, Segment};
use crate::math::Vec3;
use crate::narrow_phase::capsule_hull::{core, part_along_face};
use crate::narrow_phase::rod::Core;
use crate::narrow_phase::segment::between;
use crate::scalar::Scalar;
use crate::shape::{Capsule, ConvexHull, Cuboid, Sphere};

/// One place of the edge.
fn one<S: Scalar>(direction: Vec3<S::Unit>, place: Vec3<S>, distance: S) -> Option<Beside<S>> {
    Some(Beside { direction, ends: [(place, distance), (place, S::LARGEST)] })
}

impl<S: Scalar> OverSurface<S> for Sphere<S> {
    fn point(&self, index: u8) -> Option<Vec3<S>> {
        if index == 0 { Some(Vec3::ZERO) } else { None }
    }

    fn radius(&self) -> S {
        Sphere::radius(self)
    }

    fn beside(&self, edge: &Segment<S>) -> Option<Beside<S>> {
        let place = edge.at(edge.project(Vec3::ZERO));
        let (direction, distance) = S::direction3(place.to_array())?;
        one(Vec3::from_array(direction), place, distance)
    }
}

impl<S: Scalar> OverSurface<S> for Capsule<S> {
    fn point(&self, index: u8) -> Option<Vec3<S>> {
        let half = self.half_length();
        match index {
            0 => Some(Vec3::new(S::ZERO, S::ZERO, half)),
            1 => Some(Vec3::new(S::ZERO, S::ZERO, half.negated())),
            _ => None,
        }
    }

    fn radius(&self) -> S {
        Capsule::radius(self)
    }

    fn beside(&self, edge: &Segment<S>) -> Option<Beside<S>> {
        let axis = Vec3::new(S::Unit::ZERO, S::Unit::ZERO, S::Unit::ONE);
        let own = Segment { middle: Vec3::ZERO, axis, half: self.half_length() };
        let places = own.closest(edge);
        let (direction, distance) = between(&own, edge, places)?;
        // Pierced by the edge, the core is below the surface on one side: its ends tell how deep.
        if distance <= S::ZERO { None } else { one(direction, edge.at(places[1]), distance) }
    }
}

/// The edge as a capsule without a radius.
fn beside_polytope<S: Scalar>(polytope: &impl Polytope<S>, edge: &Segment<S>) -> Option<Beside<S>> {
    let Core { normal, height, place } = core(polytope, edge);
    match part_along_face(polytope, edge, normal) {
        Some((plane, [low, high])) => {
            let end = |s: S| {
                let place = edge.at(s);
                (place, place.along(plane.normal).minus(plane.offset))
            };
            Some(Beside { direction: plane.normal, ends: [end(low), end(high)] })
        }
        None => one(normal, place, height),
    }
}

impl<S: Scalar> OverSurface<S> for Cuboid<S> {
    fn point(&self, index: u8) -> Option<Vec3<S>> {
        self.corner(index)
    }

    fn radius(&self) -> S {
        S::ZERO
    }

    fn beside(&self, edge: &Segment<S>) -> Option<Beside<S>> {
        beside_polytope(self, edge)
    }
}

impl<S: Scalar, const N: usize> OverSurface<S> for &ConvexHull<S, N> {
    fn point(&self, index: u8) -> Option<Vec3<S>> {
        self.corner(index)
    }

    fn radius(&self) -> S {
        S::ZERO
    }

    fn beside(&self, edge: &Segment<S>) -> Option<Beside<S>> {
        beside_polytope(*self, edge)
    }
}
