//! The kernel on one impact: what it is given in its own number format, and what it makes of it.

use carom::impulse::{Outcome, resolve_collision_with_friction};
use carom::{Body, Contact, MassProperties, Material, Quat, UnitVec3, Vec3};

use super::problem::{self, Problem, State};
use super::vector::{Matrix, Vector, add, scale};
use crate::host::HostScalar;

/// An impact in the kernel's own format.
#[derive(Clone, Copy, Debug)]
pub struct Setup<S: HostScalar> {
    pub a: Body<S>,
    pub b: Body<S>,
    pub contact: Contact<S>,
    pub material: Material<S>,
}

/// What the kernel made of an impact.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    pub state: State,
    pub normal_impulse: f64,
    pub friction_impulse: Vector,
    pub outcome: Outcome,
    pub saturated: bool,
}

impl<S: HostScalar> Setup<S> {
    /// `None` where the format cannot hold a number that is given.
    pub fn new(problem: &Problem) -> Option<Self> {
        let [a, b] = &problem.bodies;
        let unit = |v: Vector| Vec3::from_array(v.map(S::unit));
        let normal = UnitVec3::new(unit(problem.normal)).expect("the normal is of unit length");
        let contact = Contact::new(normal, vector(a.arm)?, vector(b.arm)?).expect("the arms are finite");
        let material = Material::new(S::from_f64(problem.restitution)?, S::from_f64(problem.friction)?);
        let material = material.expect("the coefficients are in range");
        Some(Self { a: body(a)?, b: body(b)?, contact, material })
    }

    /// The very numbers that the kernel is given. The tensors are those in the world's frame, with their rounding.
    pub fn stored(&self) -> Problem {
        let body = |body: &Body<S>, arm: Vec3<S>| {
            let [xx, xy, xz, yy, yz, zz] = body.inv_inertia_world().map(S::scaled_to_f64);
            let inv_inertia: Matrix = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
            let [ix, _, _, iy, _, iz] = body.inv_inertia_local().map(S::scaled_to_f64);
            problem::Body {
                inv_mass: S::scaled_to_f64(body.inv_mass()),
                inv_moments: [ix, iy, iz],
                orientation: body.orientation().to_array().map(S::unit_to_f64),
                inv_inertia,
                arm: read(arm),
                velocity: read(body.linear_velocity),
                spin: read(body.angular_velocity),
            }
        };
        Problem {
            bodies: [body(&self.a, self.contact.r_a), body(&self.b, self.contact.r_b)],
            normal: self.contact.normal.get().to_array().map(S::unit_to_f64),
            restitution: self.material.restitution().to_f64(),
            friction: self.material.friction().to_f64(),
        }
    }

    pub fn resolve(mut self) -> Found {
        let impact = resolve_collision_with_friction(&mut self.a, &mut self.b, &self.contact, &self.material);
        let normal = self.contact.normal.get().to_array().map(S::unit_to_f64);
        let normal_impulse = impact.normal_impulse.to_f64();
        let friction_impulse = read(impact.friction_impulse);
        Found {
            state: State {
                impulse: add(scale(normal_impulse, normal), friction_impulse),
                velocity: [read(self.a.linear_velocity), read(self.b.linear_velocity)],
                spin: [read(self.a.angular_velocity), read(self.b.angular_velocity)],
            },
            normal_impulse,
            friction_impulse,
            outcome: impact.outcome,
            saturated: impact.saturated,
        }
    }
}

/// Whether the format can hold what comes of an impact.
pub fn holds<S: HostScalar>(state: &State) -> bool {
    let State { impulse, velocity, spin } = state;
    [*impulse, velocity[0], velocity[1], spin[0], spin[1]].iter().flatten().all(|&x| S::from_f64(x).is_some())
}

fn body<S: HostScalar>(given: &problem::Body) -> Option<Body<S>> {
    let mut body = if given.inv_mass == 0.0 {
        Body::immovable()
    } else {
        // Refused where the inverse overflows.
        let moments = given.inv_moments.map(S::scaled);
        let mut body = Body::dynamic(MassProperties::from_inverses(S::scaled(given.inv_mass), moments).ok()?);
        let [w, x, y, z] = given.orientation.map(S::unit);
        body.set_orientation(Quat::new(w, x, y, z).expect("the quaternion is of unit length"));
        body
    };
    body.linear_velocity = vector(given.velocity)?;
    body.angular_velocity = vector(given.spin)?;
    Some(body)
}

fn vector<S: HostScalar>(v: Vector) -> Option<Vec3<S>> {
    Some(Vec3::new(S::from_f64(v[0])?, S::from_f64(v[1])?, S::from_f64(v[2])?))
}

fn read<S: HostScalar>(v: Vec3<S>) -> Vector {
    v.to_array().map(S::to_f64)
}
