//! One contact with friction by `embedded-3dgfx`.
//!
//! Its contacts have no arms: it puts the point half the penetration along the normal from the centre of A. The arm of B
//! and the part of A's arm along the normal can be given like that; the rest of A's arm cannot.

use crate::harness::{Call, call};
use crate::measure::{self, Impact, Peer};
use embedded_3dgfx::physics::{BodyId, Contact, PhysicsWorld, RigidBody};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

type World = PhysicsWorld<2>;

pub struct With3dgfx {
    world: World,
    contact: [Contact; 1],
    bodies: [BodyId; 2],
}

#[unsafe(export_name = "kernel_friction_embedded-3dgfx")]
extern "C" fn resolve(world: &mut World, contact: &[Contact; 1]) {
    world.resolve_contacts(contact);
}

fn body(given: &measure::Body, impact: &Impact, position: Vector3<f32>) -> RigidBody {
    let [w, x, y, z] = given.orientation;
    let mut body = RigidBody::new(1.0 / given.inv_mass).with_restitution(impact.restitution);
    body = body.with_friction(impact.friction).with_position(position).with_velocity(given.velocity.into());
    body = body.with_angular_velocity(given.spin.into());
    body.orientation = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
    body.inv_inertia_local = Matrix3::from_diagonal(&given.inv_moments.into());
    body
}

impl Peer for With3dgfx {
    const OPERATION: &'static str = "friction";

    fn new(impact: &Impact) -> Self {
        let [a, b] = &impact.bodies;
        let normal = Vector3::from(impact.normal);
        let along = normal.dot(&Vector3::from(a.arm));
        let mut world = World::new();
        let mut add = |given, position| world.add_body(body(given, impact, position)).expect("there is room for two");
        let (body_a, body_b) = (add(a, Vector3::zeros()), add(b, normal * along - Vector3::from(b.arm)));
        let contact = [Contact { body_a, body_b, normal, penetration: 2.0 * along }];
        Self { world, contact, bodies: [body_a, body_b] }
    }

    fn call(&mut self) -> Call {
        call!(resolve, self.world, self.contact)
    }

    fn velocities(&self) -> [u32; 12] {
        let bodies = self.bodies.map(|id| self.world.body(id));
        core::array::from_fn(|i| {
            let vector = bodies[i / 6].map(|body| if i % 6 < 3 { body.velocity } else { body.angular_velocity });
            vector.unwrap_or_default()[i % 3].to_bits()
        })
    }
}
