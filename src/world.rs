//! The world: bodies with shapes in memory of fixed size, and the stages of a step in their order.
//!
//! It is thin: the broad phase, the narrow phase and the [solver](crate::solver) work on slices, and can be used without it.

mod contacts;
mod cost;
mod filter;
mod handle;
mod islands;
mod look;
mod meet;
mod slot;
mod split;
mod step;
mod wake;
mod way;

use heapless::Vec;

pub use self::contacts::{Phase, Touching};
pub use self::cost::{StepCost, StepWork};
pub use self::filter::Filter;
pub use self::handle::BodyHandle;
pub use self::look::{Sight, Surface};
pub use self::split::SplitStep;
pub use self::step::WorldReport;

use self::contacts::{Entry, Key};
use self::slot::{Slot, State};
use crate::aabb::Aabb;
use crate::body::Body;
use crate::broad_phase::SweepAndPrune;
use crate::contact::Material;
use crate::error::{HandleError, InsertError};
use crate::hash::StateHash;
use crate::manifold::Manifold;
use crate::math::{Pose, UnitVec3, Vec3};
use crate::scalar::Scalar;
use crate::shape::Shape;
use crate::solver::{ManifoldConstraint, Motion, PointConstraint, WarmStart};

/// The places of bodies. (`enumerate` and `position` would count with a check.)
const PLACES: core::ops::Range<u16> = 0..u16::MAX;

/// Bodies with shapes, and what is between them: up to `BODIES` bodies, and in a step up to `MANIFOLDS` pairs of surfaces that touch
/// or are about to, with up to `POINTS` points in all: 65,535, 65,535 and 32,767 at most.
///
/// `Sh` is the type of the shapes: one of [`Sphere`](crate::Sphere), [`Cuboid`](crate::Cuboid) and so on, or a set of them made by
/// [`shapes!`](crate::shapes). Only the pairs of that type are linked.
///
/// [`new`](Self::new) is `const` and all its bits are zero: a world in a `static` costs no flash and never crosses the stack.
/// [`RAM`](Self::RAM) is its size in bytes.
///
/// ```
/// # #[cfg(feature = "f32")] {
/// use carom::solver::Settings;
/// use carom::{Body, Cuboid, HalfSpace, Material, Solid, UnitVec3, Vec3, World};
///
/// carom::shapes! { enum Piece<S> { Cuboid, HalfSpace } }
///
/// let mut world = World::<f32, Piece<f32>, 2, 4, 8>::new();
/// let wood = Material::new(0.3, 0.5)?;
/// world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), wood)?;
/// let half = Vec3::new(0.01, 0.01, 0.01);
/// let mut die = Body::dynamic(Solid::cuboid(half)?.with_mass(0.008)?);
/// die.position.z = 0.1;
/// let die = world.insert(die, Cuboid::new(half)?, wood)?;
///
/// let steps = Settings::new(Vec3::new(0.0, 0.0, -9.81), [1, 60], 4)?;
/// while world.step(&steps).asleep == 0 {}
/// assert!((world.body(die)?.position.z - 0.01).abs() < 1e-4);
/// # }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct World<S: Scalar, Sh, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize> {
    bodies: Vec<Body<S>, BODIES, u16>,
    slots: Vec<Slot<S>, BODIES, u16>,
    shapes: Vec<Sh, BODIES, u16>,
    materials: Vec<Material<S>, BODIES, u16>,
    poses: Vec<Pose<S>, BODIES, u16>,
    boxes: Vec<Aabb<S>, BODIES, u16>,
    sweep: SweepAndPrune<[u16; BODIES]>,
    /// The pairs of the last step.
    contacts: Vec<Entry<S>, MANIFOLDS, u16>,
    /// Those of the step before.
    before: Vec<Key, MANIFOLDS, u16>,
    warm: [WarmStart<S>; POINTS],
    motions: [Motion<S>; BODIES],
    manifolds: [ManifoldConstraint<S>; MANIFOLDS],
    points: [PointConstraint<S>; POINTS],
    /// The manifold at hand: here and not on the stack of a step.
    manifold: Manifold<S>,
    gravity: Vec3<S>,
    sleepless: bool,
}

impl<S: Scalar, Sh, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
    World<S, Sh, BODIES, MANIFOLDS, POINTS>
{
    /// The memory that it takes, in bytes.
    pub const RAM: usize = size_of::<Self>();

    /// No bodies.
    #[must_use]
    pub const fn new() -> Self {
        // Places are numbers of 16 bits, those of kept impulses too, of which there may be as many again.
        const { assert!(BODIES < 1 << 16 && MANIFOLDS < 1 << 16 && POINTS < 1 << 15, "a capacity is too large") };
        Self {
            bodies: Vec::new(),
            slots: Vec::new(),
            shapes: Vec::new(),
            materials: Vec::new(),
            poses: Vec::new(),
            boxes: Vec::new(),
            sweep: SweepAndPrune::new([0; BODIES]),
            contacts: Vec::new(),
            before: Vec::new(),
            warm: [WarmStart::NONE; POINTS],
            motions: [Motion::NEW; BODIES],
            manifolds: [ManifoldConstraint::NEW; MANIFOLDS],
            points: [PointConstraint::NEW; POINTS],
            manifold: Manifold::empty(UnitVec3::from_unit(Vec3::ZERO)),
            gravity: Vec3::ZERO,
            sleepless: false,
        }
    }

    /// Whether bodies that have been still for half a second fall asleep, each island of touching bodies as a whole, until something
    /// that moves comes near, gravity changes or the caller touches one of them. They do unless told otherwise.
    pub fn set_sleeping(&mut self, on: bool) {
        self.sleepless = !on;
        if self.sleepless {
            self.wake_all();
        }
    }

    /// Takes everything out. Handles given so far mean nothing afterwards.
    pub fn clear(&mut self) {
        for index in 0..self.slots.len() {
            self.vacate(index as u16);
        }
        self.contacts.clear();
        self.before.clear();
    }

    /// The bodies that are there, with their handles, in the order of their places.
    pub fn bodies(&self) -> impl Iterator<Item = (BodyHandle, &Body<S>)> {
        self.slots
            .iter()
            .zip(&self.bodies)
            .zip(PLACES)
            .filter(|((slot, _), _)| slot.state != State::Vacant)
            .map(|((slot, body), index)| (slot.handle(index), body))
    }

    /// The bodies with their shapes, in the same order: for whoever draws them.
    pub fn bodies_with_shapes(&self) -> impl Iterator<Item = (BodyHandle, &Body<S>, &Sh)> {
        let shape = |handle: BodyHandle| self.shapes.get(usize::from(handle.index));
        self.bodies().filter_map(move |(handle, body)| Some((handle, body, shape(handle)?)))
    }

    /// The body.
    ///
    /// # Errors
    /// [`HandleError`]: it is not there any more.
    pub fn body(&self, handle: BodyHandle) -> Result<&Body<S>, HandleError> {
        self.bodies.get(self.find(handle)?).ok_or(HandleError::Stale)
    }

    /// The body, to be moved, pushed or changed. It wakes up, with all that it touches.
    ///
    /// # Errors
    /// [`HandleError`]: it is not there any more.
    pub fn body_mut(&mut self, handle: BodyHandle) -> Result<&mut Body<S>, HandleError> {
        let index = self.touch(handle)?;
        self.bodies.get_mut(index).ok_or(HandleError::Stale)
    }

    /// Its shape.
    ///
    /// # Errors
    /// [`HandleError`]: the body is not there any more.
    pub fn shape(&self, handle: BodyHandle) -> Result<&Sh, HandleError> {
        self.shapes.get(self.find(handle)?).ok_or(HandleError::Stale)
    }

    /// Its material. Between two surfaces the geometric means of their coefficients count.
    ///
    /// # Errors
    /// [`HandleError`]: the body is not there any more.
    pub fn material(&self, handle: BodyHandle) -> Result<&Material<S>, HandleError> {
        self.materials.get(self.find(handle)?).ok_or(HandleError::Stale)
    }

    /// Gives it another material.
    ///
    /// # Errors
    /// [`HandleError`]: the body is not there any more.
    pub fn set_material(&mut self, handle: BodyHandle, material: Material<S>) -> Result<(), HandleError> {
        let index = self.touch(handle)?;
        *self.materials.get_mut(index).ok_or(HandleError::Stale)? = material;
        Ok(())
    }

    /// Says which bodies it meets.
    ///
    /// # Errors
    /// [`HandleError`]: the body is not there any more.
    pub fn set_filter(&mut self, handle: BodyHandle, filter: Filter) -> Result<(), HandleError> {
        self.slot_mut(handle)?.filter = filter;
        Ok(())
    }

    /// Makes a sensor of the body, or a body of the sensor: a sensor notices what overlaps it, and stops nothing.
    ///
    /// # Errors
    /// [`HandleError`]: the body is not there any more.
    pub fn set_sensor(&mut self, handle: BodyHandle, sensor: bool) -> Result<(), HandleError> {
        self.slot_mut(handle)?.sensor = sensor;
        Ok(())
    }

    /// Which bodies it meets.
    ///
    /// # Errors
    /// [`HandleError`]: the body is not there any more.
    pub fn filter(&self, handle: BodyHandle) -> Result<Filter, HandleError> {
        self.slots.get(self.find(handle)?).map(|slot| slot.filter).ok_or(HandleError::Stale)
    }

    /// Whether it is a sensor.
    ///
    /// # Errors
    /// [`HandleError`]: the body is not there any more.
    pub fn is_sensor(&self, handle: BodyHandle) -> Result<bool, HandleError> {
        self.slots.get(self.find(handle)?).map(|slot| slot.sensor).ok_or(HandleError::Stale)
    }

    /// Whether it sleeps.
    ///
    /// # Errors
    /// [`HandleError`]: the body is not there any more.
    pub fn is_asleep(&self, handle: BodyHandle) -> Result<bool, HandleError> {
        self.slots.get(self.find(handle)?).map(Slot::is_asleep).ok_or(HandleError::Stale)
    }

    /// Whether a number in it was not finite when the last step began, so that it took no part. It does again once the caller has
    /// mended it.
    ///
    /// # Errors
    /// [`HandleError`]: the body is not there any more.
    pub fn is_quarantined(&self, handle: BodyHandle) -> Result<bool, HandleError> {
        let slot = self.slots.get(self.find(handle)?).ok_or(HandleError::Stale)?;
        Ok(slot.state == State::Quarantined)
    }

    /// Takes a body out, and returns it as it is. What it touched wakes up. No end of its contacts is told.
    ///
    /// # Errors
    /// [`HandleError`]: it is not there any more.
    pub fn remove(&mut self, handle: BodyHandle) -> Result<Body<S>, HandleError> {
        let index = self.touch(handle)?;
        let body = *self.bodies.get(index).ok_or(HandleError::Stale)?;
        self.vacate(handle.index);
        self.contacts.retain(|entry| !entry.key.holds(handle.index));
        self.before.retain(|key| !key.holds(handle.index));
        Ok(body)
    }

    /// One number for the state of all bodies: equal on all machines after the same steps.
    pub fn hash(&self) -> u64 {
        let mut hash = StateHash::new();
        for (_, body) in self.bodies() {
            hash.add_body(body);
        }
        hash.get()
    }

    fn find(&self, handle: BodyHandle) -> Result<usize, HandleError> {
        let index = usize::from(handle.index);
        match self.slots.get(index) {
            Some(slot) if slot.generation == handle.generation && slot.state != State::Vacant => Ok(index),
            _ => Err(HandleError::Stale),
        }
    }

    fn slot_mut(&mut self, handle: BodyHandle) -> Result<&mut Slot<S>, HandleError> {
        let index = self.touch(handle)?;
        self.slots.get_mut(index).ok_or(HandleError::Stale)
    }

    /// Wakes a body with all that it touches.
    fn touch(&mut self, handle: BodyHandle) -> Result<usize, HandleError> {
        let index = self.find(handle)?;
        wake::wake(&mut self.slots, &self.contacts, handle.index);
        if let Some(slot) = self.slots.get_mut(index) {
            slot.touched = true;
            slot.still = 0;
        }
        Ok(index)
    }

    fn wake_all(&mut self) {
        for slot in &mut self.slots {
            slot.wake();
            slot.still = 0;
        }
    }

    fn vacate(&mut self, index: u16) {
        if let Some(slot) = self.slots.get_mut(usize::from(index)) {
            // Touched, so that the next step takes its box away.
            *slot = Slot { generation: slot.generation.wrapping_add(1), touched: true, ..Slot::VACANT };
        }
        if let Some(body) = self.bodies.get_mut(usize::from(index)) {
            *body = Body::immovable();
        }
    }
}

impl<S: Scalar, Sh: Shape<S>, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
    World<S, Sh, BODIES, MANIFOLDS, POINTS>
{
    /// Puts a body with that shape and material into the world, at the place and with the velocity that it has.
    ///
    /// # Errors
    /// [`InsertError`]: there are `BODIES` already, or a number in the body is not finite.
    pub fn insert(
        &mut self,
        body: Body<S>,
        shape: impl Into<Sh>,
        material: Material<S>,
    ) -> Result<BodyHandle, InsertError> {
        body.check().map_err(|_| InsertError::NotFinite)?;
        let shape = shape.into();
        let vacant = self.slots.iter().zip(PLACES).find(|(slot, _)| slot.state == State::Vacant);
        let vacant = vacant.map(|(_, index)| usize::from(index));
        let index = vacant.unwrap_or(self.slots.len());
        if vacant.is_none() {
            self.slots.push(Slot::VACANT).map_err(|_| InsertError::Full)?;
            self.bodies.push(body).map_err(|_| InsertError::Full)?;
            self.shapes.push(shape).map_err(|_| InsertError::Full)?;
            self.materials.push(material).map_err(|_| InsertError::Full)?;
            self.poses.push(Pose::IDENTITY).map_err(|_| InsertError::Full)?;
            self.boxes.push(Aabb::NOTHING).map_err(|_| InsertError::Full)?;
        }
        let slot = self.slots.get_mut(index).ok_or(InsertError::Full)?;
        let generation = slot.generation;
        *slot = Slot {
            generation,
            state: State::Awake,
            touched: true,
            filter: Filter::ALL,
            size: shape.inner_radius(),
            ..Slot::VACANT
        };
        *self.bodies.get_mut(index).ok_or(InsertError::Full)? = body;
        *self.shapes.get_mut(index).ok_or(InsertError::Full)? = shape;
        *self.materials.get_mut(index).ok_or(InsertError::Full)? = material;
        Ok(BodyHandle { index: index as u16, generation })
    }

    /// Gives a body another shape.
    ///
    /// # Errors
    /// [`HandleError`]: the body is not there any more.
    pub fn set_shape(&mut self, handle: BodyHandle, shape: impl Into<Sh>) -> Result<(), HandleError> {
        let index = self.touch(handle)?;
        let shape = shape.into();
        if let Some(slot) = self.slots.get_mut(index) {
            slot.size = shape.inner_radius();
        }
        *self.shapes.get_mut(index).ok_or(HandleError::Stale)? = shape;
        Ok(())
    }
}

impl<S: Scalar, Sh: Copy, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
    World<S, Sh, BODIES, MANIFOLDS, POINTS>
{
    /// Becomes as `other` is, without a copy on the stack: to keep a state, and to return to it. What follows is the same, bit for bit,
    /// as often as it is run from there. Handles keep their meaning.
    pub fn copy_from(&mut self, other: &Self) {
        fn copy<T: Copy, const N: usize>(to: &mut Vec<T, N, u16>, from: &Vec<T, N, u16>) {
            to.clear();
            for item in from {
                // As long as the other, which has as much room.
                let _ = to.push(*item);
            }
        }
        copy(&mut self.bodies, &other.bodies);
        copy(&mut self.slots, &other.slots);
        copy(&mut self.shapes, &other.shapes);
        copy(&mut self.materials, &other.materials);
        copy(&mut self.poses, &other.poses);
        copy(&mut self.boxes, &other.boxes);
        copy(&mut self.contacts, &other.contacts);
        copy(&mut self.before, &other.before);
        self.sweep.clone_from(&other.sweep);
        self.warm = other.warm;
        self.gravity = other.gravity;
        self.sleepless = other.sleepless;
    }
}

impl<S: Scalar, Sh, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize> Default
    for World<S, Sh, BODIES, MANIFOLDS, POINTS>
{
    fn default() -> Self {
        Self::new()
    }
}
