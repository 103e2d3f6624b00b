//! What operations are given, in a number type: made from an impact of the input by the library's public functions.

use crate::harness::input::{self, Number};
use carom::impulse::{Impact, Outcome};
use carom::{Body, Contact, DirectionError, MassProperties, Material, Quat, Scalar, Scaled, UnitVec3, Vec3};

/// A contact and what meets there.
#[derive(Clone, Copy)]
pub struct Given<S: Scalar> {
    pub contact: Contact<S>,
    pub material: Material<S>,
}

/// Everything that an operation reads or writes.
#[derive(Clone, Copy)]
pub struct Operands<S: Scalar> {
    pub a: Body<S>,
    pub b: Body<S>,
    pub given: Given<S>,
    pub x: S,
    pub y: S,
    pub orientation: Quat<S>,
    pub turned: Body<S>,
    pub number: S,
    pub vector: Vec3<S>,
    pub direction: Result<UnitVec3<S>, DirectionError>,
    pub impact: Impact<S>,
}

impl<S: Scalar> Operands<S> {
    /// `None` where the number type cannot hold the impact.
    pub fn new(impact: &input::Impact) -> Option<Self> {
        let [a, b] = &impact.bodies;
        let normal = UnitVec3::new(vector::<S::Unit>(&impact.normal)?).ok()?;
        let contact = Contact::new(normal, vector(&a.arm)?, vector(&b.arm)?).ok()?;
        let material = Material::new(number(impact.restitution)?, number(impact.friction)?).ok()?;
        let bodies = (body(a)?, body(b)?);
        Some(Self {
            a: bodies.0,
            b: bodies.1,
            given: Given { contact, material },
            // e and pi: as irregular as numbers are.
            x: S::from_ratio(271_828, 100_000).ok()?,
            y: S::from_ratio(314_159, 100_000).ok()?,
            orientation: bodies.1.orientation(),
            turned: bodies.0,
            number: S::ZERO,
            vector: Vec3::ZERO,
            direction: Ok(UnitVec3::X),
            impact: Impact {
                outcome: Outcome::Separating,
                normal_impulse: S::ZERO,
                friction_impulse: Vec3::ZERO,
                saturated: false,
            },
        })
    }
}

fn body<S: Scalar>(given: &input::Body) -> Option<Body<S>> {
    let mut body = if given.inv_mass.mantissa == 0 {
        Body::immovable()
    } else {
        let moments = given.inv_moments.map(scaled::<S>);
        let mut body = Body::dynamic(MassProperties::from_inverses(scaled::<S>(given.inv_mass), moments).ok()?);
        let [w, x, y, z] = given.orientation.map(|n| S::Unit::from_scaled(scaled::<S>(n)).0);
        body.set_orientation(Quat::new(w, x, y, z).ok()?);
        body
    };
    body.linear_velocity = vector(&given.velocity)?;
    body.angular_velocity = vector(&given.spin)?;
    Some(body)
}

fn vector<S: Scalar>(v: &[Number; 3]) -> Option<Vec3<S>> {
    Some(Vec3::new(number(v[0])?, number(v[1])?, number(v[2])?))
}

fn number<S: Scalar>(n: Number) -> Option<S> {
    let (number, clipped) = S::from_scaled(scaled::<S>(n));
    (!clipped).then_some(number)
}

fn scaled<S: Scalar>(n: Number) -> S::Scaled {
    S::Scaled::from_parts(n.mantissa, n.exponent)
}
