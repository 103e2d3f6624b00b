//! What Newton's restitution and Coulomb's friction say of one contact, in f64 and by other means than the kernel's: the
//! literal cross products of (10), Cramer's rule in the world's frame, and a scan over all directions of sliding.

use std::f64::consts::TAU;

use super::problem::{Mode, Problem, State};
use super::vector::{Vector, ZERO, add, cross, dot, norm, scale, solve, sub, unit};

/// Directions of sliding tried; roots closer together than one step are not told apart.
const DIRECTIONS: usize = 720;

#[derive(Clone, Copy, Debug)]
pub struct Solution {
    pub state: State,
    pub mode: Mode,
    /// How far from being another mode: a share of the approach speed, of the sliding speed or of the cone.
    pub margin: f64,
}

impl Solution {
    /// How far its impulse moves by unit relative rounding errors of what it is computed from: (L |J| + (1 + e) s) / k,
    /// where k is what divides: the denominator of (10); where the points stick, the least eigenvalue of the 3x3 inverse
    /// mass; and where they slide the lesser of that and of K_nn - mu K_nd for the direction d of sliding.
    pub fn condition(&self, problem: &Problem) -> f64 {
        let n = unit(problem.normal);
        let k = match self.mode {
            Mode::Separating | Mode::Frictionless => problem.inverse_mass(),
            Mode::Stick => problem.least_inverse_mass(),
            Mode::Slip => {
                let change = -(1.0 + problem.restitution) * dot(problem.relative_velocity(), n);
                problem.least_inverse_mass().min(change / dot(self.state.impulse, n))
            }
        };
        (problem.load() * norm(self.state.impulse) + (1.0 + problem.restitution) * problem.speed()) / k
    }
}

/// `None` where the law has no solution or more than one, or where nothing can move.
pub fn resolve(problem: &Problem) -> Option<Solution> {
    let n = unit(problem.normal);
    let approach = dot(problem.relative_velocity(), n);
    let closeness = approach.abs() / problem.speed();
    let solution = |impulse, mode, margin| Solution { state: problem.after(impulse), mode, margin };
    if approach >= 0.0 {
        return Some(solution(ZERO, Mode::Separating, closeness));
    }
    let k = problem.inverse_mass();
    if k == 0.0 {
        return None;
    }
    if problem.friction == 0.0 {
        let j = -(1.0 + problem.restitution) * approach / k;
        return Some(solution(scale(j, n), Mode::Frictionless, closeness));
    }
    let (impulse, load) = sticking(problem);
    if load <= 1.0 {
        return Some(solution(impulse, Mode::Stick, closeness.min(1.0 - load)));
    }
    let (impulse, sliding) = slipping(problem)?;
    Some(solution(impulse, Mode::Slip, closeness.min(sliding / problem.speed())))
}

/// The impulse that brings v_r' = -e v_n n, and its share of the friction that there is: above 1, or infinite, where it
/// is not possible.
fn sticking(problem: &Problem) -> (Vector, f64) {
    let n = unit(problem.normal);
    let v = problem.relative_velocity();
    let target = scale(-problem.restitution * dot(v, n), n);
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let impulse = solve(axes.map(|axis| problem.response(axis)), sub(target, v));
    let normal = dot(impulse, n);
    let tangential = norm(sub(impulse, scale(normal, n)));
    (impulse, if normal > 0.0 { tangential / (problem.friction * normal) } else { f64::INFINITY })
}

/// The impulse on the cone whose friction opposes the sliding after it, and the speed of that sliding.
fn slipping(problem: &Problem) -> Option<(Vector, f64)> {
    let n = unit(problem.normal);
    let v = problem.relative_velocity();
    let target = -(1.0 + problem.restitution) * dot(v, n);
    let least = (0..3).min_by(|&i, &j| n[i].abs().total_cmp(&n[j].abs()))?;
    let mut axis = ZERO;
    axis[least] = 1.0;
    let t1 = unit(cross(axis, n));
    let t2 = cross(n, t1);

    // For a direction d of sliding: the impulse, and the velocity after it along d and across.
    let at = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let d = add(scale(cos, t1), scale(sin, t2));
        let direction = sub(n, scale(problem.friction, d));
        let response = problem.response(direction);
        let normal = target / dot(response, n);
        let after = add(v, scale(normal, response));
        (normal, scale(normal, direction), dot(after, d), dot(after, cross(n, d)))
    };
    // Off the axes, where a symmetric problem has its roots.
    let angle = |step: usize| TAU * (step as f64 + 0.37) / DIRECTIONS as f64;
    let mut roots = (0..DIRECTIONS).filter_map(|step| {
        let (mut low, mut high) = (angle(step), angle(step + 1));
        let (at_low, at_high) = (at(low), at(high));
        let crosses = at_low.3 * at_high.3 < 0.0 && at_low.0 * at_high.0 > 0.0;
        if !crosses {
            return None;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if at(middle).3 * at_low.3 > 0.0 { low = middle } else { high = middle }
        }
        let (normal, impulse, along, _) = at(0.5 * (low + high));
        (normal > 0.0 && along >= 0.0).then_some((impulse, along))
    });
    let root = roots.next();
    if roots.next().is_some() { None } else { root }
}
