//! What an impact must leave as it was: momentum and angular momentum, in units of the last place of what they are made of.

use super::cases::Case;
use super::format::Format;
use super::laws::{Result, stored_problem};
use super::number::{Exact, Vector, cramer};
use super::oracle::{Problem, Side};

/// What is missing, and what one unit of the last place of the largest term is worth.
#[derive(Clone, Copy, Debug)]
pub struct Balance {
    pub missing: f64,
    pub unit: f64,
}

impl Balance {
    pub fn units(&self) -> f64 {
        if self.missing == 0.0 { 0.0 } else { self.missing.abs() / self.unit }
    }
}

/// The unit of the last place of the larger of two numbers.
fn unit<S: Format>(before: &Exact, after: &Exact) -> f64 {
    S::ulp(before.to_f64().abs().max(after.to_f64().abs()))
}

/// m_a v_a + m_b v_b, after less before, by components. Both bodies have mass.
pub fn momentum<S: Format>(problem: &Problem, result: &Result<S>) -> [Balance; 3] {
    let after = stored_problem(problem, result);
    let [a, b] = &problem.sides;
    let change = |i: usize, k: usize| &after.sides[i].v.0[k] - &problem.sides[i].v.0[k];
    let masses = &a.inv_mass * &b.inv_mass;
    std::array::from_fn(|k| {
        let missing = change(0, k) * &b.inv_mass + change(1, k) * &a.inv_mass;
        let largest = [0, 1].map(|i| {
            let (before, after) = (&problem.sides[i], &after.sides[i]);
            unit::<S>(&before.v.0[k], &after.v.0[k]) / before.inv_mass.to_f64()
        });
        Balance { missing: missing.ratio(&masses), unit: largest[0].max(largest[1]) }
    })
}

/// I w - r x m v of one body, after less before: its angular momentum about the point of contact, through which every
/// impulse goes. The tensor must have an inverse. Also |I||I^-1|, by which the rounding of the tensor counts.
pub fn angular_momentum<S: Format>(before: &Side, after: &Side) -> ([Balance; 3], f64) {
    let rows = before.inv_inertia.rows();
    let (turned, determinant) = cramer(&rows, &(&after.w - &before.w));
    let pushed = before.arm.cross(&(&after.v - &before.v));
    // Over the common denominator det I^-1 / m.
    let missing = &turned.times(&before.inv_mass) - &pushed.times(&determinant);
    let over = &before.inv_mass * &determinant;
    let axis = |i: usize| Vector(std::array::from_fn(|k| if k == i { Exact::one() } else { Exact::zero() }));
    let inertia = [0, 1, 2].map(|j| cramer(&rows, &axis(j)).0.0.map(|x| x.ratio(&determinant)));
    let m = 1.0 / before.inv_mass.to_f64();
    let (arm, spin_unit, speed_unit) = (
        before.arm.to_f64(),
        [0, 1, 2].map(|j| unit::<S>(&before.w.0[j], &after.w.0[j])),
        [0, 1, 2].map(|j| unit::<S>(&before.v.0[j], &after.v.0[j])),
    );
    let balance = std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let turning = (0..3).map(|j| inertia[j][i].abs() * spin_unit[j]);
        let pushing = [m * arm[j].abs() * speed_unit[k], m * arm[k].abs() * speed_unit[j]];
        Balance { missing: missing.0[i].ratio(&over), unit: turning.chain(pushing).fold(0.0, f64::max) }
    });
    let trace = inertia[0][0] + inertia[1][1] + inertia[2][2];
    (balance, trace * before.inv_inertia.trace().to_f64())
}

/// The kinetic energy: (m v^2 + w . I w)/2 of both bodies that can move, the sums exact.
pub fn kinetic_energy(problem: &Problem) -> f64 {
    let side = |side: &Side| {
        if side.inv_mass.is_zero() {
            return 0.0;
        }
        let linear = side.v.dot(&side.v).ratio(&side.inv_mass);
        let angular = if side.inv_inertia.is_zero() {
            0.0
        } else {
            let (turned, determinant) = cramer(&side.inv_inertia.rows(), &side.w);
            turned.dot(&side.w).ratio(&determinant)
        };
        0.5 * (linear + angular)
    };
    side(&problem.sides[0]) + side(&problem.sides[1])
}

/// The problem as a result leaves it, for either of the two sides.
pub fn after<S: Format>(case: &Case<S>, result: &Result<S>) -> (Problem, Problem) {
    let problem = Problem::read(case);
    let after = stored_problem(&problem, result);
    (problem, after)
}
