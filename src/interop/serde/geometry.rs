//! Directions, orientations, materials and shapes.

use ::serde::{Deserialize, Serialize};

use super::as_data;
use crate::contact::{Material, RestitutionLaw};
use crate::error::{DirectionError, MaterialError, OrientationError, ShapeError};
use crate::math::{Quat, UnitVec3, Vec3};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Cuboid, HalfSpace, Sphere};

#[derive(Serialize, Deserialize)]
#[serde(rename = "UnitVec3", transparent)]
struct Direction<U>(Vec3<U>);

impl<S: Scalar> From<UnitVec3<S>> for Direction<S::Unit> {
    fn from(direction: UnitVec3<S>) -> Self {
        Self(direction.get())
    }
}

impl<S: Scalar> TryFrom<Direction<S::Unit>> for UnitVec3<S> {
    type Error = DirectionError;

    fn try_from(Direction(components): Direction<S::Unit>) -> Result<Self, DirectionError> {
        Self::new(components)
    }
}

as_data!(UnitVec3 as Direction<S::Unit>: S::Unit);

#[derive(Serialize, Deserialize)]
#[serde(rename = "Quat")]
struct Orientation<U> {
    w: U,
    x: U,
    y: U,
    z: U,
}

impl<S: Scalar> From<Quat<S>> for Orientation<S::Unit> {
    fn from(orientation: Quat<S>) -> Self {
        let [w, x, y, z] = orientation.to_array();
        Self { w, x, y, z }
    }
}

impl<S: Scalar> TryFrom<Orientation<S::Unit>> for Quat<S> {
    type Error = OrientationError;

    fn try_from(Orientation { w, x, y, z }: Orientation<S::Unit>) -> Result<Self, OrientationError> {
        Self::new(w, x, y, z)
    }
}

as_data!(Quat as Orientation<S::Unit>: S::Unit);

#[derive(Serialize, Deserialize)]
#[serde(rename = "Material")]
struct Surface<S> {
    restitution: S,
    friction: S,
    law: RestitutionLaw,
}

impl<S: Scalar> From<Material<S>> for Surface<S> {
    fn from(material: Material<S>) -> Self {
        Self { restitution: material.restitution(), friction: material.friction(), law: material.law }
    }
}

impl<S: Scalar> TryFrom<Surface<S>> for Material<S> {
    type Error = MaterialError;

    fn try_from(Surface { restitution, friction, law }: Surface<S>) -> Result<Self, MaterialError> {
        Ok(Self::new(restitution, friction)?.with_law(law))
    }
}

as_data!(Material as Surface<S>: S);

#[derive(Serialize, Deserialize)]
#[serde(rename = "Sphere")]
struct Ball<S> {
    radius: S,
}

impl<S: Scalar> From<Sphere<S>> for Ball<S> {
    fn from(sphere: Sphere<S>) -> Self {
        Self { radius: sphere.radius() }
    }
}

impl<S: Scalar> TryFrom<Ball<S>> for Sphere<S> {
    type Error = ShapeError;

    fn try_from(Ball { radius }: Ball<S>) -> Result<Self, ShapeError> {
        Self::new(radius)
    }
}

as_data!(Sphere as Ball<S>: S);

#[derive(Serialize, Deserialize)]
#[serde(rename = "Cuboid")]
struct Brick<S> {
    half_extents: Vec3<S>,
}

impl<S: Scalar> From<Cuboid<S>> for Brick<S> {
    fn from(cuboid: Cuboid<S>) -> Self {
        Self { half_extents: cuboid.half_extents() }
    }
}

impl<S: Scalar> TryFrom<Brick<S>> for Cuboid<S> {
    type Error = ShapeError;

    fn try_from(Brick { half_extents }: Brick<S>) -> Result<Self, ShapeError> {
        Self::new(half_extents)
    }
}

as_data!(Cuboid as Brick<S>: S);

#[derive(Serialize, Deserialize)]
#[serde(rename = "Capsule")]
struct Rod<S> {
    radius: S,
    half_length: S,
}

impl<S: Scalar> From<Capsule<S>> for Rod<S> {
    fn from(capsule: Capsule<S>) -> Self {
        Self { radius: capsule.radius(), half_length: capsule.half_length() }
    }
}

impl<S: Scalar> TryFrom<Rod<S>> for Capsule<S> {
    type Error = ShapeError;

    fn try_from(Rod { radius, half_length }: Rod<S>) -> Result<Self, ShapeError> {
        Self::new(radius, half_length)
    }
}

as_data!(Capsule as Rod<S>: S);

/// Valid by its direction.
#[derive(Serialize, Deserialize)]
#[serde(rename = "HalfSpace")]
struct Ground<U> {
    normal: Direction<U>,
}

impl<S: Scalar> From<HalfSpace<S>> for Ground<S::Unit> {
    fn from(ground: HalfSpace<S>) -> Self {
        Self { normal: ground.normal().into() }
    }
}

impl<S: Scalar> TryFrom<Ground<S::Unit>> for HalfSpace<S> {
    type Error = DirectionError;

    fn try_from(Ground { normal }: Ground<S::Unit>) -> Result<Self, DirectionError> {
        normal.try_into().map(Self::new)
    }
}

as_data!(HalfSpace as Ground<S::Unit>: S::Unit);
