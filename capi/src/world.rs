//! A world of any capacity and any set of shapes behind one face.

use carom::solver::Settings;
use carom::world::{Filter, Sight, Touching, WorldReport};
use carom::{Body, BodyHandle, HandleError, Material, Ray, World};

use crate::number::Number;
use crate::shape::{Piece, Set};
use crate::status::carom_status;

/// What C can ask of a world.
pub(crate) trait AnyWorld<N: Number> {
    fn insert(&mut self, body: Body<N>, shape: Piece<N>, material: Material<N>) -> Result<BodyHandle, carom_status>;
    fn remove(&mut self, handle: BodyHandle) -> Result<Body<N>, HandleError>;
    fn clear(&mut self);
    fn body(&self, handle: BodyHandle) -> Result<&Body<N>, HandleError>;
    fn body_mut(&mut self, handle: BodyHandle) -> Result<&mut Body<N>, HandleError>;
    fn set_shape(&mut self, handle: BodyHandle, shape: Piece<N>) -> Result<(), carom_status>;
    fn set_material(&mut self, handle: BodyHandle, material: Material<N>) -> Result<(), HandleError>;
    fn set_sensor(&mut self, handle: BodyHandle, sensor: bool) -> Result<(), HandleError>;
    fn set_filter(&mut self, handle: BodyHandle, filter: Filter) -> Result<(), HandleError>;
    fn is_asleep(&self, handle: BodyHandle) -> Result<bool, HandleError>;
    fn set_sleeping(&mut self, on: bool);
    fn step(&mut self, settings: &Settings<N>) -> WorldReport;
    /// Calls `tell` with everything that touches.
    fn contacts(&self, tell: &mut dyn FnMut(&Touching<N>));
    fn cast_ray(&self, ray: &Ray<N>, filter: Filter) -> Option<Sight<N>>;
    fn hash(&self) -> u64;
}

impl<N: Number, Sh: Set<N>, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize> AnyWorld<N>
    for World<N, Sh, BODIES, MANIFOLDS, POINTS>
{
    fn insert(&mut self, body: Body<N>, shape: Piece<N>, material: Material<N>) -> Result<BodyHandle, carom_status> {
        Ok(World::insert(self, body, Sh::of(shape)?, material)?)
    }

    fn remove(&mut self, handle: BodyHandle) -> Result<Body<N>, HandleError> {
        World::remove(self, handle)
    }

    fn clear(&mut self) {
        World::clear(self);
    }

    fn body(&self, handle: BodyHandle) -> Result<&Body<N>, HandleError> {
        World::body(self, handle)
    }

    fn body_mut(&mut self, handle: BodyHandle) -> Result<&mut Body<N>, HandleError> {
        World::body_mut(self, handle)
    }

    fn set_shape(&mut self, handle: BodyHandle, shape: Piece<N>) -> Result<(), carom_status> {
        Ok(World::set_shape(self, handle, Sh::of(shape)?)?)
    }

    fn set_material(&mut self, handle: BodyHandle, material: Material<N>) -> Result<(), HandleError> {
        World::set_material(self, handle, material)
    }

    fn set_sensor(&mut self, handle: BodyHandle, sensor: bool) -> Result<(), HandleError> {
        World::set_sensor(self, handle, sensor)
    }

    fn set_filter(&mut self, handle: BodyHandle, filter: Filter) -> Result<(), HandleError> {
        World::set_filter(self, handle, filter)
    }

    fn is_asleep(&self, handle: BodyHandle) -> Result<bool, HandleError> {
        World::is_asleep(self, handle)
    }

    fn set_sleeping(&mut self, on: bool) {
        World::set_sleeping(self, on);
    }

    fn step(&mut self, settings: &Settings<N>) -> WorldReport {
        World::step(self, settings)
    }

    fn contacts(&self, tell: &mut dyn FnMut(&Touching<N>)) {
        for touching in World::contacts(self) {
            tell(&touching);
        }
    }

    fn cast_ray(&self, ray: &Ray<N>, filter: Filter) -> Option<Sight<N>> {
        World::cast_ray(self, ray, filter)
    }

    fn hash(&self) -> u64 {
        World::hash(self)
    }
}
