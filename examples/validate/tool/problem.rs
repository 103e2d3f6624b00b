//! One impact in f64: what is given, and what comes of it.

use super::vector::{
    Matrix, Vector, ZERO, add, apply, cross, diagonal, dot, least_eigenvalue, norm, rotated, rotation, scale, sub, unit,
};

/// One of the two bodies, as it meets the other.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// Zero where it is immovable.
    pub inv_mass: f64,
    /// Inverse principal moments in the body's frame.
    pub inv_moments: Vector,
    /// Of unit length: w, x, y, z.
    pub orientation: [f64; 4],
    /// The inverse inertia tensor in the world's frame.
    pub inv_inertia: Matrix,
    /// From the centre of mass to the point of contact.
    pub arm: Vector,
    pub velocity: Vector,
    pub spin: Vector,
}

/// Two bodies in contact.
#[derive(Clone, Copy, Debug)]
pub struct Problem {
    /// A and B.
    pub bodies: [Body; 2],
    /// From A to B, of unit length.
    pub normal: Vector,
    pub restitution: f64,
    pub friction: f64,
}

/// What comes of an impact: the impulse on B, and the velocities of A and B.
#[derive(Clone, Copy, Debug)]
pub struct State {
    pub impulse: Vector,
    pub velocity: [Vector; 2],
    pub spin: [Vector; 2],
}

/// What kind of impact it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    Separating,
    Frictionless,
    Stick,
    Slip,
}

impl Body {
    /// With the tensor R I^-1 R^T of that orientation, of any length.
    pub fn new(inv_mass: f64, inv_moments: Vector, orientation: [f64; 4]) -> Self {
        let length = orientation.iter().map(|c| c * c).sum::<f64>().sqrt();
        let orientation = orientation.map(|c| c / length);
        // Equal moments are the same in every frame.
        let isotropic = inv_moments[0] == inv_moments[1] && inv_moments[1] == inv_moments[2];
        let inv_inertia = if isotropic { diagonal(inv_moments) } else { rotated(&rotation(orientation), inv_moments) };
        Self { inv_mass, inv_moments, orientation, inv_inertia, arm: ZERO, velocity: ZERO, spin: ZERO }
    }

    pub fn immovable() -> Self {
        Self::new(0.0, ZERO, [1.0, 0.0, 0.0, 0.0])
    }

    /// A bound on the velocity of the point of contact per impulse there.
    fn load(&self) -> f64 {
        let trace = self.inv_inertia[0][0] + self.inv_inertia[1][1] + self.inv_inertia[2][2];
        self.inv_mass + trace * dot(self.arm, self.arm)
    }
}

impl Problem {
    /// v_r = (v_b + w_b x r_b) - (v_a + w_a x r_a)
    pub fn relative_velocity(&self) -> Vector {
        let [a, b] = self.bodies.map(|body| add(body.velocity, cross(body.spin, body.arm)));
        sub(b, a)
    }

    /// The change of v_r by an impulse, term for term as in (10): (1/m_a + 1/m_b) J + sum of (I^-1 (r x J)) x r.
    pub fn response(&self, impulse: Vector) -> Vector {
        self.bodies.iter().fold(ZERO, |sum, body| {
            let turn = apply(&body.inv_inertia, cross(body.arm, impulse));
            add(sum, add(scale(body.inv_mass, impulse), cross(turn, body.arm)))
        })
    }

    /// The denominator of (10).
    pub fn inverse_mass(&self) -> f64 {
        let n = unit(self.normal);
        dot(self.response(n), n)
    }

    /// s = |v_a| + |v_b| + |w_a||r_a| + |w_b||r_b|: what the approach speed is computed from, and so what its rounding
    /// is proportional to.
    pub fn speed(&self) -> f64 {
        self.bodies.iter().map(|body| norm(body.velocity) + norm(body.spin) * norm(body.arm)).sum()
    }

    /// L = 1/m_a + 1/m_b + tr I_a^-1 |r_a|^2 + tr I_b^-1 |r_b|^2: a bound on every eigenvalue of the 3x3 inverse mass.
    pub fn load(&self) -> f64 {
        self.bodies.iter().map(Body::load).sum()
    }

    /// The least eigenvalue of the 3x3 inverse mass.
    pub fn least_inverse_mass(&self) -> f64 {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        least_eigenvalue(&axes.map(|axis| self.response(axis)))
    }

    /// The velocities after an impulse on B, and its opposite on A.
    pub fn after(&self, impulse: Vector) -> State {
        let signs = [-1.0, 1.0];
        let velocity = [0, 1].map(|k| {
            let body = &self.bodies[k];
            add(body.velocity, scale(signs[k] * body.inv_mass, impulse))
        });
        let spin = [0, 1].map(|k| {
            let body = &self.bodies[k];
            add(body.spin, scale(signs[k], apply(&body.inv_inertia, cross(body.arm, impulse))))
        });
        State { impulse, velocity, spin }
    }
}
