//! Bodies and what they meet.

use core::fmt::{Display, Formatter};

use ::serde::{Deserialize, Serialize};

use super::as_data;
use crate::body::{Body, Rests};
use crate::error::BodyError;
use crate::interop::sound::rests_are_finite;
use crate::mass::MassProperties;
use crate::math::{Quat, Vec3};
use crate::scalar::{Scalar, StepArithmetic};

/// Without the tensor in the world's frame, which follows from the others.
#[derive(Serialize, Deserialize)]
#[serde(
    rename = "Body",
    bound(
        serialize = "S: Serialize, S::Unit: Serialize, S::Scaled: Serialize, S::Exponent: Serialize, \
                     S::Remainder: Serialize, Rest<S>: Serialize",
        deserialize = "S: Deserialize<'de>, S::Unit: Deserialize<'de>, S::Scaled: Deserialize<'de>, \
                       S::Exponent: Deserialize<'de>, S::Remainder: Deserialize<'de>, Rest<S>: Deserialize<'de>"
    )
)]
struct BodyData<S: Scalar> {
    position: Vec3<S>,
    orientation: Quat<S>,
    linear_velocity: Vec3<S>,
    angular_velocity: Vec3<S>,
    gravity_scale: S,
    linear_damping: S,
    angular_damping: S,
    /// None of a body that is immovable.
    mass: Option<MassProperties<S>>,
    rests: RestsData<S::Remainder, Rest<S>>,
}

type Rest<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Rest;

/// What the formats cannot hold of the body's motion.
#[derive(Serialize, Deserialize)]
struct RestsData<P, V> {
    position: [P; 3],
    linear: [V; 3],
    angular: [V; 3],
}

/// Why data make no body.
enum Refused {
    State(BodyError),
    Rest,
}

impl Display for Refused {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::State(error) => error.fmt(f),
            Self::Rest => f.write_str("body: what its position carries beyond the format is not finite"),
        }
    }
}

impl<S: Scalar> From<Body<S>> for BodyData<S> {
    fn from(body: Body<S>) -> Self {
        let Rests { position, linear, angular, .. } = body.rests;
        Self {
            position: body.position,
            orientation: body.orientation(),
            linear_velocity: body.linear_velocity,
            angular_velocity: body.angular_velocity,
            gravity_scale: body.gravity_scale,
            linear_damping: body.linear_damping,
            angular_damping: body.angular_damping,
            mass: (!body.is_immovable()).then(|| body.mass_properties()),
            rests: RestsData { position, linear, angular },
        }
    }
}

impl<S: Scalar> TryFrom<BodyData<S>> for Body<S> {
    type Error = Refused;

    fn try_from(data: BodyData<S>) -> Result<Self, Refused> {
        let mut body = data.mass.map_or_else(Self::immovable, Self::dynamic);
        body.position = data.position;
        body.linear_velocity = data.linear_velocity;
        body.angular_velocity = data.angular_velocity;
        body.gravity_scale = data.gravity_scale;
        body.linear_damping = data.linear_damping;
        body.angular_damping = data.angular_damping;
        body.check().map_err(Refused::State)?;
        let RestsData { position, linear, angular } = data.rests;
        body.rests = Rests { position, linear, angular, ..Rests::NONE };
        body.set_orientation(data.orientation);
        if rests_are_finite(&body) { Ok(body) } else { Err(Refused::Rest) }
    }
}

as_data!(Body as BodyData<S>: S, S::Unit, S::Scaled, S::Exponent, S::Remainder, Rest<S>);
