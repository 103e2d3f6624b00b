//! The pose: where a frame is, and how it is turned.

use super::{Mat3, Quat, UnitVec3, Vec3};
use crate::scalar::Scalar;

/// Position and orientation of a body or of a shape on it.
///
/// The orientation is kept as a matrix, so that it is computed once a step, however many pairs of shapes and points need it.
/// 48 bytes in f32 and in fixed point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "S: serde::Serialize, S::Unit: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de>, S::Unit: serde::Deserialize<'de>"
    ))
)]
#[repr(C)]
pub struct Pose<S: Scalar> {
    /// The origin of the frame in the world's, m.
    pub position: Vec3<S>,
    /// From the frame to the world's.
    pub rotation: Mat3<S::Unit>,
}

impl<S: Scalar> Pose<S> {
    /// The world's own frame.
    pub const IDENTITY: Self = Self::at(Vec3::ZERO);

    /// A frame at that place with the world's axes.
    pub const fn at(position: Vec3<S>) -> Self {
        Self { position, rotation: Mat3::IDENTITY }
    }

    /// A frame with that orientation: of a body, `Pose::new(body.position, body.orientation())`.
    #[inline]
    pub fn new(position: Vec3<S>, orientation: Quat<S>) -> Self {
        Self { position, rotation: orientation.to_mat3() }
    }

    /// A vector of the frame in the world's axes. In fixed point rounded once a component.
    #[inline(always)]
    #[must_use]
    pub fn rotate(&self, v: Vec3<S>) -> Vec3<S> {
        v.through(self.rotation.rows)
    }

    /// A vector of the world in the frame's axes. In fixed point rounded once a component.
    #[inline(always)]
    #[must_use]
    pub fn unrotate(&self, v: Vec3<S>) -> Vec3<S> {
        v.through(self.rotation.columns())
    }

    /// A direction of the frame in the world's axes.
    #[inline(always)]
    #[must_use]
    pub fn rotate_direction(&self, d: UnitVec3<S>) -> UnitVec3<S> {
        UnitVec3::from_unit(self.rotation.times(d.get()))
    }

    /// A point of the frame in the world.
    #[inline]
    #[must_use]
    pub fn to_world(&self, point: Vec3<S>) -> Vec3<S> {
        self.position + self.rotate(point)
    }

    /// A point of the world in the frame. The positions are subtracted first: far from the origin nothing more is lost.
    #[inline]
    #[must_use]
    pub fn to_local(&self, point: Vec3<S>) -> Vec3<S> {
        self.unrotate(point - self.position)
    }

    /// A frame that is given in this one, in the world: of a shape that sits somewhere on a body.
    #[must_use]
    pub fn times(&self, local: &Self) -> Self {
        self.times_at(self.rotate(local.position), local)
    }

    /// The same, for the way to the frame's origin in the world's axes.
    #[inline]
    pub(crate) fn times_at(&self, way: Vec3<S>, local: &Self) -> Self {
        // Most parts stand straight on their body.
        let straight = local.rotation == Mat3::IDENTITY;
        let rotation = if straight { self.rotation } else { self.rotation.times_mat3(&local.rotation) };
        Self { position: self.position + way, rotation }
    }

    /// The way back: what is given in the world, in this frame, is `self.inverse().times(..)`.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { position: -self.unrotate(self.position), rotation: self.rotation.transposed() }
    }

    /// No component is an infinity or NaN; always true in fixed point.
    pub fn is_finite(&self) -> bool {
        let [x, y, z] = self.rotation.rows;
        self.position.is_finite() && x.is_finite() && y.is_finite() && z.is_finite()
    }
}
