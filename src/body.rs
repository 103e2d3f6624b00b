//! The rigid body.

mod push;

use crate::error::BodyError;
use crate::mass::MassProperties;
use crate::math::{Quat, SymMat3, Vec3};
use crate::scalar::{Scalar, Scaled, StepArithmetic};

/// A rigid body: where it is, how it moves, and how hard it is to move.
///
/// Positions and velocities are plain fields. Mass and inertia are set together, through [`MassProperties`], and the
/// orientation through [`set_orientation`](Self::set_orientation), which keeps the world-frame tensor R I^-1 R^T up to
/// date. What the format cannot hold of a motion is carried from step to step, so that the slowest arrives in the end.
/// 140 bytes in f32; in fixed point 156.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Body<S: Scalar> {
    /// The centre of mass in the world's frame, m. The kernel does not read it.
    pub position: Vec3<S>,
    /// The velocity of the centre of mass in the world's frame, m/s.
    pub linear_velocity: Vec3<S>,
    /// The angular velocity in the world's frame, rad/s.
    pub angular_velocity: Vec3<S>,
    /// By how much gravity acts on the body: 1 as on others, 0 not at all.
    pub gravity_scale: S,
    /// The rate at which the velocity decays, 1/s: v' = -c v.
    pub linear_damping: S,
    /// The rate at which the angular velocity decays, 1/s.
    pub angular_damping: S,
    pub(crate) inv_mass: S::Scaled,
    pub(crate) inv_inertia_world: SymMat3<S::Unit>,
    pub(crate) exponent: S::Exponent,
    inv_inertia_local: SymMat3<S::Unit>,
    orientation: Quat<S>,
    pub(crate) gyration: Vec3<S::Unit>,
    pub(crate) rests: Rests<S>,
}

/// What the formats cannot hold of a body's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(crate) struct Rests<S: Scalar> {
    pub position: [S::Remainder; 3],
    pub linear: [<S::Step as StepArithmetic<S>>::Rest; 3],
    pub angular: [<S::Step as StepArithmetic<S>>::Rest; 3],
    /// Zero, where padding would be.
    pub fill: <S::Step as StepArithmetic<S>>::Rest,
}

impl<S: Scalar> Rests<S> {
    pub const NONE: Self = Self {
        position: [S::NO_REMAINDER; 3],
        linear: [S::Step::NO_REST; 3],
        angular: [S::Step::NO_REST; 3],
        fill: S::Step::NO_REST,
    };
}

impl<S: Scalar> Body<S> {
    /// A body that nothing moves: the ground, a wall. With a velocity set it is kinematic: it strikes, and is not
    /// deflected.
    pub const fn immovable() -> Self {
        Self {
            position: Vec3::ZERO,
            linear_velocity: Vec3::ZERO,
            angular_velocity: Vec3::ZERO,
            gravity_scale: S::ONE,
            linear_damping: S::ZERO,
            angular_damping: S::ZERO,
            inv_mass: S::Scaled::ZERO,
            inv_inertia_world: SymMat3::ZERO,
            exponent: S::NO_EXPONENT,
            inv_inertia_local: SymMat3::ZERO,
            orientation: Quat::IDENTITY,
            gyration: Vec3::ZERO,
            rests: Rests::NONE,
        }
    }

    /// A body with the given mass and inertia, at rest at the origin.
    pub const fn dynamic(mass: MassProperties<S>) -> Self {
        Self {
            inv_mass: mass.inv_mass,
            inv_inertia_world: mass.inv_inertia,
            exponent: mass.exponent,
            inv_inertia_local: mass.inv_inertia,
            gyration: mass.gyration,
            ..Self::immovable()
        }
    }

    /// The body at that place, m.
    #[must_use]
    pub const fn at(mut self, position: Vec3<S>) -> Self {
        self.position = position;
        self
    }

    /// The body with that velocity, m/s.
    #[must_use]
    pub const fn moving(mut self, linear_velocity: Vec3<S>) -> Self {
        self.linear_velocity = linear_velocity;
        self
    }

    /// Takes all motion from it.
    pub(crate) fn halt(&mut self) {
        (self.linear_velocity, self.angular_velocity) = (Vec3::ZERO, Vec3::ZERO);
        self.rests = Rests::NONE;
    }

    /// The orientation.
    #[inline(always)]
    pub const fn orientation(&self) -> Quat<S> {
        self.orientation
    }

    /// Turns the body, and its inertia tensor with it.
    ///
    /// Each entry of the tensor R I^-1 R^T is within 8 u of the exact one in units of the trace, for a precision u of
    /// 2^-29 in fixed point, 2^-23 in f32 and 2^-52 in f64; a multiple of the unit matrix stays as it is, bit for bit.
    /// Some sixty multiplications, no division and no root.
    pub fn set_orientation(&mut self, orientation: Quat<S>) {
        self.orientation = orientation;
        self.inv_inertia_world = self.inv_inertia_local.rotated(&orientation.to_mat3());
    }

    /// The orientation alone: the tensor in the world's frame is as before.
    #[inline(always)]
    pub(crate) fn set_orientation_alone(&mut self, orientation: Quat<S>) {
        self.orientation = orientation;
    }

    /// Whether the inertia is the same about every axis, so that the orientation makes no difference to any motion.
    #[inline(always)]
    pub(crate) fn is_isotropic(&self) -> bool {
        let SymMat3 { xx, xy, xz, yy, yz, zz } = self.inv_inertia_local;
        let zero = S::Unit::ZERO;
        xx == yy && yy == zz && xy == zero && xz == zero && yz == zero
    }

    /// Whether impulses leave the body as it is: its inverse mass and inertia are zero.
    #[inline(always)]
    pub fn is_immovable(&self) -> bool {
        self.inv_mass == S::Scaled::ZERO && self.inv_inertia_local == SymMat3::ZERO
    }

    /// The inverse mass, 1/kg; zero where the body is immovable.
    #[inline(always)]
    pub fn inv_mass(&self) -> S::Scaled {
        self.inv_mass
    }

    /// The inverse inertia tensor in the body's frame, 1/(kg m^2): xx, xy, xz, yy, yz, zz.
    pub fn inv_inertia_local(&self) -> [S::Scaled; 6] {
        self.unblocked(&self.inv_inertia_local)
    }

    /// The inverse inertia tensor in the world's frame, R I^-1 R^T, 1/(kg m^2): xx, xy, xz, yy, yz, zz.
    pub fn inv_inertia_world(&self) -> [S::Scaled; 6] {
        self.unblocked(&self.inv_inertia_world)
    }

    /// No number on which the motion depends is an infinity or NaN.
    #[inline(always)]
    pub(crate) fn is_finite(&self) -> bool {
        let [w, x, y, z] = self.orientation.to_array();
        self.position.is_finite()
            && self.linear_velocity.is_finite()
            && self.angular_velocity.is_finite()
            && (w.is_finite() && x.is_finite() && y.is_finite() && z.is_finite())
            && (self.gravity_scale.is_finite() && self.linear_damping.is_finite() && self.angular_damping.is_finite())
    }

    /// What it was made from.
    #[cfg(any(feature = "serde", all(feature = "bytemuck", any(feature = "f32", feature = "f64", feature = "fixed"))))]
    pub(crate) const fn mass_properties(&self) -> MassProperties<S> {
        let Self { inv_mass, inv_inertia_local: inv_inertia, exponent, gyration, .. } = *self;
        MassProperties { inv_mass, inv_inertia, exponent, gyration }
    }

    fn unblocked(&self, m: &SymMat3<S::Unit>) -> [S::Scaled; 6] {
        [m.xx, m.xy, m.xz, m.yy, m.yz, m.zz].map(|x| x.to_scaled().raised(self.exponent))
    }

    /// The point of the body's frame (m) in the world's frame, seen from the centre of mass: an arm for a contact. As
    /// accurate as [`Quat::rotate`].
    #[must_use]
    pub fn arm(&self, local_point: Vec3<S>) -> Vec3<S> {
        self.orientation.rotate(local_point)
    }

    /// Every number on which the motion depends is finite; always so in fixed point.
    ///
    /// # Errors
    /// [`BodyError`] names the first field with an infinity or NaN in it.
    pub fn check(&self) -> Result<(), BodyError> {
        self.check_motion()?;
        if !self.orientation.is_finite() {
            return Err(BodyError::Orientation);
        }
        if !self.gravity_scale.is_finite() {
            return Err(BodyError::GravityScale);
        }
        if !(self.linear_damping.is_finite() && self.angular_damping.is_finite()) {
            return Err(BodyError::Damping);
        }
        Ok(())
    }

    /// The same of its place and velocities.
    pub(crate) fn check_motion(&self) -> Result<(), BodyError> {
        if !self.position.is_finite() {
            return Err(BodyError::Position);
        }
        if !self.linear_velocity.is_finite() {
            return Err(BodyError::LinearVelocity);
        }
        if !self.angular_velocity.is_finite() {
            return Err(BodyError::AngularVelocity);
        }
        Ok(())
    }
}
