//! One impact in exact numbers: formula (10) and its company as the derivation writes them, with cross products.
//!
//! Results are fractions: a numerator and the denominator they share, so that no division rounds.

use carom::{Body, Scalar, Vec3};

use super::cases::Case;
use super::format::Format;
use super::number::{Exact, Tensor, Vector, cramer};

/// What the formulas need of one body.
#[derive(Clone, Debug)]
pub struct Side {
    pub inv_mass: Exact,
    pub inv_inertia: Tensor,
    pub arm: Vector,
    pub v: Vector,
    pub w: Vector,
    /// Units of the last place of v and w, where they are results.
    pub ulps: [f64; 2],
}

/// One impact: body A, body B, and what lies between them.
#[derive(Clone, Debug)]
pub struct Problem {
    pub sides: [Side; 2],
    pub normal: Vector,
    pub restitution: Exact,
    pub friction: Exact,
}

/// An impulse on B, times `over`.
#[derive(Clone, Debug)]
pub struct Impulse {
    pub vector: Vector,
    pub over: Exact,
}

/// The sizes that bounds are made of.
#[derive(Clone, Copy, Debug)]
pub struct Scales {
    /// |v_a| + |v_b| + |w_a||r_a| + |w_b||r_b|
    pub speed: f64,
    /// 1/m_a + 1/m_b
    pub inv_mass: f64,
    /// 1/m_a + 1/m_b + |I_a^-1||r_a|^2 + |I_b^-1||r_b|^2, with the trace for the norm: no denominator is larger.
    pub load: f64,
    /// |I^-1||r| of A and of B
    pub turn: [f64; 2],
}

pub fn read_vector<S: Format>(v: Vec3<S>) -> Vector {
    Vector(v.to_array().map(S::value))
}

impl Side {
    pub fn read<S: Format>(body: &Body<S>, arm: Vec3<S>) -> Self {
        Self {
            inv_mass: S::scaled_value(body.inv_mass()),
            inv_inertia: Tensor(body.inv_inertia_world().map(S::scaled_value)),
            arm: read_vector(arm),
            v: read_vector(body.linear_velocity),
            w: read_vector(body.angular_velocity),
            ulps: [0.0; 2],
        }
    }

    /// v + w x r: the velocity of the body's point.
    pub fn point_velocity(&self) -> Vector {
        &self.v + &self.w.cross(&self.arm)
    }

    /// The change of the point's velocity by an impulse on the body: J/m + (I^-1 (r x J)) x r.
    pub fn yields_to(&self, impulse: &Vector) -> Vector {
        let turn = self.inv_inertia.times(&self.arm.cross(impulse));
        &impulse.times(&self.inv_mass) + &turn.cross(&self.arm)
    }
}

impl Problem {
    pub fn read<S: Format>(case: &Case<S>) -> Self {
        let contact = &case.contact;
        Self {
            sides: [Side::read(&case.a, contact.r_a), Side::read(&case.b, contact.r_b)],
            normal: Vector(contact.normal.get().to_array().map(S::unit_value)),
            restitution: case.restitution.value(),
            friction: case.friction.value(),
        }
    }

    /// v_r = (v_b + w_b x r_b) - (v_a + w_a x r_a)
    pub fn relative_velocity(&self) -> Vector {
        &self.sides[1].point_velocity() - &self.sides[0].point_velocity()
    }

    /// v_r . n
    pub fn approach(&self) -> Exact {
        self.relative_velocity().dot(&self.normal)
    }

    /// W d: the relative velocity that a unit impulse along d gives the points.
    pub fn yields_to(&self, d: &Vector) -> Vector {
        &self.sides[0].yields_to(d) + &self.sides[1].yields_to(d)
    }

    /// The denominator of (10): 1/m_a + 1/m_b + [(Ia^-1 (r_a x n)) x r_a + (Ib^-1 (r_b x n)) x r_b] . n
    pub fn denominator(&self) -> Exact {
        let n = &self.normal;
        let turning = |side: &Side| side.inv_inertia.times(&side.arm.cross(n)).cross(&side.arm);
        let turning = &turning(&self.sides[0]) + &turning(&self.sides[1]);
        // The source writes 1/m_a + 1/m_b for (n/m_a + n/m_b) . n: the two differ where n is not exactly of unit length.
        let mass = &self.sides[0].inv_mass + &self.sides[1].inv_mass;
        mass + turning.dot(n)
    }

    /// The numerator of (10): -(1 + e) v_r . n
    pub fn numerator(&self) -> Exact {
        -((Exact::one() + &self.restitution) * self.approach())
    }

    /// An impulse `numerator / denominator` along n.
    pub fn along_normal(&self, numerator: &Exact) -> Impulse {
        Impulse { vector: self.normal.times(numerator), over: self.denominator() }
    }

    /// The impulse under which the points stick: v_r' = -e (v_r . n) n.
    pub fn sticking_impulse(&self) -> Impulse {
        let axis = |i: usize| Vector(std::array::from_fn(|k| if k == i { Exact::one() } else { Exact::zero() }));
        // W is symmetric: its columns are its rows.
        let w = [self.yields_to(&axis(0)), self.yields_to(&axis(1)), self.yields_to(&axis(2))];
        let rebound = self.normal.times(&(&self.restitution * &self.approach()));
        let (vector, over) = cramer(&w, &-&(&self.relative_velocity() + &rebound));
        Impulse { vector, over }
    }

    /// v_a', w_a', v_b', w_b' after the impulse, by (2) and (3), times its denominator.
    pub fn after(&self, impulse: &Impulse) -> [Vector; 4] {
        let side = |side: &Side, j: &Vector| {
            let turn = side.inv_inertia.times(&side.arm.cross(j));
            let v = &side.v.times(&impulse.over) + &j.times(&side.inv_mass);
            let w = &side.w.times(&impulse.over) + &turn;
            [v, w]
        };
        let [v_a, w_a] = side(&self.sides[0], &-&impulse.vector);
        let [v_b, w_b] = side(&self.sides[1], &impulse.vector);
        [v_a, w_a, v_b, w_b]
    }

    /// How much the q-th velocity of [`after`](Self::after) changes by a unit impulse at most: 1/m, or |I^-1||r|.
    pub fn yields(&self, scales: &Scales, q: usize) -> f64 {
        if q.is_multiple_of(2) { self.sides[q / 2].inv_mass.to_f64() } else { scales.turn[q / 2] }
    }

    pub fn scales(&self) -> Scales {
        let [a, b] = &self.sides;
        let turn = |side: &Side| side.inv_inertia.trace().to_f64() * side.arm.length();
        let inv_mass = (&a.inv_mass + &b.inv_mass).to_f64();
        let arms = [a.arm.length(), b.arm.length()];
        let turn = [turn(a), turn(b)];
        Scales {
            speed: a.v.length() + b.v.length() + a.w.length() * arms[0] + b.w.length() * arms[1],
            inv_mass,
            load: inv_mass + turn[0] * arms[0] + turn[1] * arms[1],
            turn,
        }
    }
}

/// The difference of a stored number from `exact / over`, where that lies beyond the range from the end of the range.
/// `over` is positive.
pub fn error<S: Format>(stored: S, exact: &Exact, over: &Exact) -> f64 {
    let difference = stored.value() * over - exact;
    if S::saturates() {
        let top = Exact::from_f64(S::largest()) - Exact::from_f64(S::ulp(0.0));
        let bottom = Exact::from_f64(-S::largest());
        let beyond = if difference.is_negative() { stored.value() == top } else { stored.value() == bottom };
        if beyond {
            return 0.0;
        }
    }
    difference.ratio(over).abs()
}

/// The velocities of both bodies in the order of [`Problem::after`].
pub fn velocities<S: Scalar>(a: &Body<S>, b: &Body<S>) -> [[S; 3]; 4] {
    [a.linear_velocity, a.angular_velocity, b.linear_velocity, b.angular_velocity].map(Vec3::to_array)
}
