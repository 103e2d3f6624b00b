//! Values for fuzzers: whatever safe code could make, and nothing else.

use ::arbitrary::{Arbitrary, Error, Result, Unstructured};

use crate::body::Body;
use crate::contact::{Contact, Material, RestitutionLaw};
use crate::mass::{MassProperties, Solid};
use crate::math::{Pose, Quat, UnitVec3, Vec3};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Cuboid, HalfSpace, Sphere};

/// Any bits.
impl<'a, S: Arbitrary<'a>> Arbitrary<'a> for Vec3<S> {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        Ok(Self::new(u.arbitrary()?, u.arbitrary()?, u.arbitrary()?))
    }

    fn size_hint(depth: usize) -> (usize, Option<usize>) {
        <[S; 3]>::size_hint(depth)
    }
}

/// Newton's or the safe one.
impl<'a> Arbitrary<'a> for RestitutionLaw {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        Ok(if u.arbitrary()? { Self::EnergySafe } else { Self::Newton })
    }
}

macro_rules! arbitrary {
    ($($(#[$doc:meta])* $type:ident: $($number:ty),+ => |$u:ident| $value:expr;)+) => {$(
        $(#[$doc])*
        impl<'a, S: Scalar> Arbitrary<'a> for $type<S>
        where
            $($number: Arbitrary<'a>),+
        {
            fn arbitrary($u: &mut Unstructured<'a>) -> Result<Self> {
                $value
            }
        }
    )+};
}

/// What a constructor refuses is no value: the fuzzer tries other bytes.
fn made<T, E>(result: core::result::Result<T, E>) -> Result<T> {
    result.map_err(|_| Error::IncorrectFormat)
}

arbitrary! {
    /// The direction of any vector.
    UnitVec3: S => |u| made(Self::normalize(u.arbitrary()?));
    /// Any rotation.
    Quat: S::Unit => |u| made(Self::normalize(u.arbitrary()?, u.arbitrary()?, u.arbitrary()?, u.arbitrary()?));
    Pose: S, S::Unit => |u| Ok(Self::new(u.arbitrary()?, u.arbitrary()?));
    Contact: S => |u| Ok(Self { normal: u.arbitrary()?, r_a: u.arbitrary()?, r_b: u.arbitrary()? });
    /// Any friction, and a restitution from 0 to 1 in 65,535 steps.
    Material: S => |u| {
        let restitution = made(S::from_ratio(u.arbitrary::<u16>()?.into(), u16::MAX.into()))?;
        let material = made(Self::new(restitution, size(u)?))?;
        Ok(material.with_law(u.arbitrary()?))
    };
    Sphere: S => |u| made(Self::new(size(u)?));
    Cuboid: S => |u| made(Self::new(Vec3::new(size(u)?, size(u)?, size(u)?)));
    Capsule: S => |u| made(Self::new(size(u)?, size(u)?));
    HalfSpace: S => |u| Ok(Self::new(u.arbitrary()?));
    /// A ball, a box or a rod.
    Solid: S => |u| match u.int_in_range(0..=2)? {
        0 => made(Self::sphere(size(u)?)),
        1 => made(Self::cuboid(Vec3::new(size(u)?, size(u)?, size(u)?))),
        _ => made(Self::capsule(size(u)?, size(u)?)),
    };
    /// Of a solid, sometimes with its rotation locked.
    MassProperties: S => |u| {
        let solid: Solid<S> = u.arbitrary()?;
        let mass = made(solid.with_mass(size(u)?))?;
        Ok(if u.ratio(1, 8)? { mass.with_locked_rotation() } else { mass })
    };
    /// Immovable or not, anywhere, with any velocity: numbers that are not finite among them.
    Body: S, S::Unit => |u| {
        let mut body = if u.ratio(1, 4)? { Self::immovable() } else { Self::dynamic(u.arbitrary()?) };
        body.set_orientation(u.arbitrary()?);
        body.position = u.arbitrary()?;
        body.linear_velocity = u.arbitrary()?;
        body.angular_velocity = u.arbitrary()?;
        body.gravity_scale = u.arbitrary()?;
        body.linear_damping = u.arbitrary()?;
        body.angular_damping = u.arbitrary()?;
        Ok(body)
    };
}

/// Not negative, so that half of the fuzzer's work is not for nothing.
fn size<'a, S: Scalar + Arbitrary<'a>>(u: &mut Unstructured<'a>) -> Result<S> {
    let x: S = u.arbitrary()?;
    Ok(if x < S::ZERO { x.negated() } else { x })
}
