//! Formula (10) word for word, and (2) and (3), with nalgebra in f32 and full tensors.

use crate::harness::{Call, call};
use crate::measure::{self, Impact, Peer};
use nalgebra::{Matrix3, Vector3};

struct Body {
    velocity: Vector3<f32>,
    spin: Vector3<f32>,
    inv_mass: f32,
    inv_inertia: Matrix3<f32>,
}

struct Contact {
    normal: Vector3<f32>,
    r_a: Vector3<f32>,
    r_b: Vector3<f32>,
    restitution: f32,
}

pub struct WithNalgebra {
    impulse: f32,
    a: Body,
    b: Body,
    contact: Contact,
}

#[unsafe(export_name = "kernel_resolve_nalgebra")]
extern "C" fn resolve(impulse: &mut f32, a: &mut Body, b: &mut Body, contact: &Contact) {
    let Contact { normal: n, r_a, r_b, restitution: e } = *contact;
    let v_r = (b.velocity + b.spin.cross(&r_b)) - (a.velocity + a.spin.cross(&r_a));
    let approach = v_r.dot(&n);
    *impulse = 0.0;
    if approach >= 0.0 {
        return;
    }
    let turn_a = (a.inv_inertia * r_a.cross(&n)).cross(&r_a);
    let turn_b = (b.inv_inertia * r_b.cross(&n)).cross(&r_b);
    let j = -(1.0 + e) * approach / (a.inv_mass + b.inv_mass + (turn_a + turn_b).dot(&n));
    a.velocity -= j * a.inv_mass * n;
    b.velocity += j * b.inv_mass * n;
    a.spin -= j * (a.inv_inertia * r_a.cross(&n));
    b.spin += j * (b.inv_inertia * r_b.cross(&n));
    *impulse = j;
}

impl Peer for WithNalgebra {
    fn new(impact: &Impact) -> Self {
        let body = |body: &measure::Body| Body {
            velocity: body.velocity.into(),
            spin: body.spin.into(),
            inv_mass: body.inv_mass,
            inv_inertia: body.inv_inertia().into(),
        };
        let [a, b] = &impact.bodies;
        let contact = Contact {
            normal: impact.normal.into(),
            r_a: a.arm.into(),
            r_b: b.arm.into(),
            restitution: impact.restitution,
        };
        Self { impulse: 0.0, a: body(a), b: body(b), contact }
    }

    fn call(&mut self) -> Call {
        call!(resolve, self.impulse, self.a, self.b, self.contact)
    }

    fn velocities(&self) -> [u32; 12] {
        let vectors = [self.a.velocity, self.a.spin, self.b.velocity, self.b.spin];
        core::array::from_fn(|i| vectors[i / 3][i % 3].to_bits())
    }
}
