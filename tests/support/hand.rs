//! Impacts by hand: f64, cross products, and the formulas as the derivation writes them.

use carom::{Body, UnitVec3, Vec3};

use super::cases::{Case, turn_towards};
use super::format::Format;
use super::rotation::matrix;
use super::strategy::{everyday, forall};

pub type V = [f64; 3];
pub type M = [V; 3];

pub fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a + k b
pub fn add(a: V, k: f64, b: V) -> V {
    [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]]
}

pub fn length(a: V) -> f64 {
    dot(a, a).sqrt()
}

pub fn apply(m: M, v: V) -> V {
    m.map(|row| dot(row, v))
}

pub fn product(a: M, b: M) -> M {
    let b = transposed(b);
    a.map(|row| b.map(|column| dot(row, column)))
}

pub fn transposed(m: M) -> M {
    [0, 1, 2].map(|i| [m[0][i], m[1][i], m[2][i]])
}

pub fn read<S: Format>(v: Vec3<S>) -> V {
    v.to_array().map(|x| x.value().to_f64())
}

/// One body and its arm, by hand.
#[derive(Clone, Copy, Debug)]
pub struct Hand {
    pub inv_mass: f64,
    pub rotation: M,
    /// In the body's frame
    pub inv_inertia_body: M,
    pub v: V,
    pub w: V,
    pub r: V,
}

impl Hand {
    pub fn read<S: Format>(body: &Body<S>, arm: Vec3<S>) -> Self {
        let rotation = matrix(body.orientation().to_array().map(|c| S::unit_value(c).to_f64()));
        let [xx, xy, xz, yy, yz, zz] = body.inv_inertia_local().map(|x| S::scaled_value(x).to_f64());
        Self {
            inv_mass: S::scaled_value(body.inv_mass()).to_f64(),
            rotation,
            inv_inertia_body: [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]],
            v: read(body.linear_velocity),
            w: read(body.angular_velocity),
            r: read(arm),
        }
    }

    /// I^-1 = R I_body^-1 R^T
    pub fn inv_inertia(&self) -> M {
        product(self.rotation, product(self.inv_inertia_body, transposed(self.rotation)))
    }

    /// (4)
    pub fn point_velocity(&self) -> V {
        add(self.v, 1.0, cross(self.w, self.r))
    }

    /// (2) and (3), for the impulse `sign j n` on this body.
    pub fn struck(&self, sign: f64, j: f64, n: V) -> Self {
        let turn = apply(self.inv_inertia(), cross(self.r, n));
        Self { v: add(self.v, sign * j * self.inv_mass, n), w: add(self.w, sign * j, turn), ..*self }
    }

    /// n/m + (I^-1 (r x n)) x r
    pub fn yields_to(&self, n: V) -> V {
        add(cross(apply(self.inv_inertia(), cross(self.r, n)), self.r), self.inv_mass, n)
    }
}

/// Both bodies, the normal from A to B, e, mu, and what rounding may do to a velocity of the kernel.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    pub a: Hand,
    pub b: Hand,
    pub n: V,
    pub e: f64,
    pub mu: f64,
    pub tolerance: f64,
}

impl Pair {
    pub fn read<S: Format>(case: &Case<S>) -> Self {
        let (a, b) = (Hand::read(&case.a, case.contact.r_a), Hand::read(&case.b, case.contact.r_b));
        let n = direction(case.contact.normal);
        let turn = |h: &Hand| h.inv_inertia_body.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs())) * length(h.r);
        let turns = turn(&a).max(turn(&b));
        let load = a.inv_mass + b.inv_mass + turn(&a) * length(a.r) + turn(&b) * length(b.r);
        let least = a.inv_mass + b.inv_mass;
        let tolerance = (4.0 * S::ulp(4.0) + 64.0 * S::precision()) * (1.0 + turns) * (1.0 + load / least);
        Self { a, b, n, e: case.restitution.value().to_f64(), mu: case.friction.value().to_f64(), tolerance }
    }

    /// (5)
    pub fn relative_velocity(&self) -> V {
        add(self.b.point_velocity(), -1.0, self.a.point_velocity())
    }

    /// The bracket of (8)
    pub fn yields_to(&self, d: V) -> V {
        add(self.a.yields_to(d), 1.0, self.b.yields_to(d))
    }

    /// (10)
    pub fn impulse(&self) -> f64 {
        -(1.0 + self.e) * dot(self.relative_velocity(), self.n) / dot(self.yields_to(self.n), self.n)
    }

    pub fn struck(&self, j: f64) -> Self {
        Self { a: self.a.struck(-1.0, j, self.n), b: self.b.struck(1.0, j, self.n), ..*self }
    }

    pub fn energy(&self) -> f64 {
        [&self.a, &self.b]
            .map(|h| {
                let spin = apply(transposed(h.rotation), h.w);
                let moments = [0, 1, 2].map(|i| 1.0 / h.inv_inertia_body[i][i]);
                0.5 * (dot(h.v, h.v) / h.inv_mass + (0..3).map(|i| moments[i] * spin[i] * spin[i]).sum::<f64>())
            })
            .iter()
            .sum()
    }
}

pub fn direction<S: Format>(n: UnitVec3<S>) -> V {
    n.get().to_array().map(|x| S::unit_value(x).to_f64())
}

pub fn close(left: V, right: V, tolerance: f64) -> bool {
    length(add(left, -1.0, right)) <= tolerance
}

/// Everyday impacts, the pair by hand, and the kernel's case.
pub fn each<S: Format>(step: impl Fn(Case<S>, Pair) -> proptest::test_runner::TestCaseResult) {
    forall(300, everyday::<S>(), |mut case| {
        turn_towards(&mut case);
        let pair = Pair::read(&case);
        step(case, pair)
    });
}
