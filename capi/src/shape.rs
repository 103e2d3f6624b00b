//! Shapes: C's description of one, checked, as one of the kernel's.

use carom::{Body, Capsule, Collide, Cuboid, HalfSpace, Solid, Sphere, UnitVec3, Vec3};

use crate::number::Number;
use crate::status::carom_status;

carom::shapes! {
    /// What the worlds hold.
    #[allow(unreachable_pub)]
    pub enum Piece<S> { Sphere, Cuboid, Capsule, HalfSpace }
}

carom::shapes! {
    /// What worlds of balls hold, with less code for it.
    #[allow(unreachable_pub)]
    pub enum Round<S> { Sphere, HalfSpace }
}

/// A set of shapes that a world holds.
pub(crate) trait Set<N: Number>: Collide<N, Self> {
    /// The shape as one of this set, if it is.
    fn of(piece: Piece<N>) -> Result<Self, carom_status>;
}

impl<N: Number> Set<N> for Piece<N> {
    fn of(piece: Piece<N>) -> Result<Self, carom_status> {
        Ok(piece)
    }
}

impl<N: Number> Set<N> for Round<N> {
    fn of(piece: Piece<N>) -> Result<Self, carom_status> {
        match piece {
            Piece::Sphere(sphere) => Ok(sphere.into()),
            Piece::HalfSpace(half_space) => Ok(half_space.into()),
            Piece::Cuboid(_) | Piece::Capsule(_) => Err(carom_status::CAROM_SHAPE),
        }
    }
}

/// What a body looks like. The numbers of carom_shape_kind.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum carom_shape_kind {
    /// A ball: its radius.
    CAROM_SPHERE = 1,
    /// A box: its half extents.
    CAROM_CUBOID = 2,
    /// A rod with round ends along the local z axis: its radius, and half the length of the segment without the round ends.
    CAROM_CAPSULE = 3,
    /// All that lies behind the plane through the body's position: its normal, out of it. It belongs on an immovable body.
    CAROM_HALF_SPACE = 4,
}

/// A shape as C gives it, its numbers taken over and nothing checked.
pub(crate) struct Raw<N: Number> {
    pub kind: u32,
    pub radius: N,
    pub half_length: N,
    pub half_extents: Vec3<N>,
    pub normal: [N::Raw; 3],
}

impl<N: Number> Raw<N> {
    pub fn piece(&self) -> Result<Piece<N>, carom_status> {
        use carom_shape_kind::*;
        match self.kind {
            kind if kind == CAROM_SPHERE as u32 => Ok(Sphere::new(self.radius)?.into()),
            kind if kind == CAROM_CUBOID as u32 => Ok(Cuboid::new(self.half_extents)?.into()),
            kind if kind == CAROM_CAPSULE as u32 => Ok(Capsule::new(self.radius, self.half_length)?.into()),
            kind if kind == CAROM_HALF_SPACE as u32 => {
                let normal: UnitVec3<N> = crate::number::unit_vec3(self.normal)?;
                Ok(HalfSpace::new(normal).into())
            }
            _ => Err(carom_status::CAROM_SHAPE),
        }
    }

    /// A homogeneous body of that shape.
    pub fn body(&self, mass: N) -> Result<Body<N>, carom_status> {
        let solid = match self.piece()? {
            Piece::Sphere(sphere) => sphere.solid()?,
            Piece::Cuboid(cuboid) => cuboid.solid()?,
            Piece::Capsule(capsule) => Solid::capsule(capsule.radius(), capsule.half_length())?,
            Piece::HalfSpace(_) => return Err(carom_status::CAROM_SHAPE),
        };
        Ok(Body::dynamic(solid.with_mass(mass)?))
    }
}
