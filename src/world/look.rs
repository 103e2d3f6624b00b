//! Questions to the world: what a ray meets, what a shape overlaps, what is closest.

use super::filter::Filter;
use super::handle::BodyHandle;
use super::slot::State;
use super::{PLACES, World};
use crate::body::Body;
use crate::manifold::Manifold;
use crate::math::{Pose, UnitVec3, Vec3};
use crate::query::{Ray, RayHit, SurfacePoint};
use crate::scalar::Scalar;
use crate::shape::{Collide, ManifoldSink, Shape};

/// What a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight<S: Scalar> {
    /// The body.
    pub body: BodyHandle,
    /// Where.
    pub hit: RayHit<S>,
}

/// The surface that is closest to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<S: Scalar> {
    /// The body.
    pub body: BodyHandle,
    /// Where.
    pub point: SurfacePoint<S>,
}

impl<S: Scalar, Sh: Shape<S>, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
    World<S, Sh, BODIES, MANIFOLDS, POINTS>
{
    /// The first body that a ray meets, of those that the filter lets it meet. Bodies are where they are now, and sensors are
    /// looked through.
    pub fn cast_ray(&self, ray: &Ray<S>, filter: Filter) -> Option<Sight<S>> {
        let mut nearest: Option<Sight<S>> = None;
        for (body, shape, pose) in self.solid(filter) {
            let Some(hit) = shape.cast_ray(&pose, ray) else { continue };
            if nearest.is_none_or(|nearest| hit.distance < nearest.hit.distance) {
                nearest = Some(Sight { body, hit });
            }
        }
        nearest
    }

    /// The body whose surface is closest to a point (deepest around it, if it is in one).
    pub fn closest_point(&self, point: Vec3<S>, filter: Filter) -> Option<Surface<S>> {
        let mut nearest: Option<Surface<S>> = None;
        for (body, shape, pose) in self.solid(filter) {
            let Some(point) = shape.closest_point(&pose, point) else { continue };
            if nearest.is_none_or(|nearest| point.separation < nearest.point.separation) {
                nearest = Some(Surface { body, point });
            }
        }
        nearest
    }

    /// The bodies with a point in common with a shape somewhere, in the order of their places.
    pub fn overlapping<'a, Other>(
        &'a self,
        shape: &'a Other,
        pose: &'a Pose<S>,
        filter: Filter,
    ) -> impl Iterator<Item = BodyHandle>
    where
        Other: Collide<S, Sh>,
    {
        let solid = self.solid(filter);
        solid.filter(|(_, other, other_pose)| shape.overlaps(pose, other, other_pose)).map(|(body, ..)| body)
    }

    /// The solid bodies with their shapes, where they are now.
    fn solid(&self, filter: Filter) -> impl Iterator<Item = (BodyHandle, &Sh, Pose<S>)> {
        let bodies = self.slots.iter().zip(&self.bodies).zip(&self.shapes).zip(PLACES);
        bodies
            .filter(move |(((slot, _), _), _)| {
                let there = !matches!(slot.state, State::Vacant | State::Quarantined);
                there && !slot.sensor && filter.lets_meet(slot.filter)
            })
            .map(|(((slot, body), shape), index)| (slot.handle(index), shape, pose_of(body)))
    }
}

fn pose_of<S: Scalar>(body: &Body<S>) -> Pose<S> {
    Pose::new(body.position, body.orientation())
}

impl<S: Scalar, Sh: Collide<S, Sh>, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
    World<S, Sh, BODIES, MANIFOLDS, POINTS>
{
    /// Calls `show` with the points at which bodies touch where they are now, for those who want to see or hear them: they are
    /// computed anew, and kept nowhere.
    pub fn show_contacts(&self, mut show: impl FnMut([BodyHandle; 2], &Manifold<S>)) {
        for entry in self.contacts.iter().filter(|entry| entry.key.touching) {
            let (i, j) = (usize::from(entry.key.a), usize::from(entry.key.b));
            let (Some(a), Some(b)) = (self.bodies.get(i), self.bodies.get(j)) else { continue };
            let (Some(shape_a), Some(shape_b)) = (self.shapes.get(i), self.shapes.get(j)) else { continue };
            let (Some(slot_a), Some(slot_b)) = (self.slots.get(i), self.slots.get(j)) else { continue };
            let bodies = [slot_a.handle(entry.key.a), slot_b.handle(entry.key.b)];
            let part = entry.key.part;
            let mut sink = Show { show: &mut show, bodies, part, manifold: Manifold::empty(UnitVec3::Z) };
            let margin = super::meet::near(crate::math::min(slot_a.size, slot_b.size));
            shape_a.collide(&pose_of(a), shape_b, &pose_of(b), margin, &mut sink);
        }
    }
}

struct Show<'a, S: Scalar, F> {
    show: &'a mut F,
    bodies: [BodyHandle; 2],
    part: u32,
    manifold: Manifold<S>,
}

impl<S: Scalar, F: FnMut([BodyHandle; 2], &Manifold<S>)> ManifoldSink<S> for Show<'_, S, F> {
    fn place(&mut self) -> &mut Manifold<S> {
        &mut self.manifold
    }

    fn take(&mut self, part: u32) {
        if part == self.part {
            (self.show)(self.bodies, &self.manifold);
        }
    }
}
