//! Newton's restitution with Coulomb's friction in the plane: two equations, or one on the edge of the cone.

use crate::tool::closed_form::Solution;
use crate::tool::problem::{Mode, Problem};

/// The impact of a body B on an immovable plane with the normal (0, 1, 0); `None` where no solution or more than one
/// exists.
pub fn resolve(problem: &Problem) -> Option<Solution> {
    let body = &problem.bodies[1];
    let ([rx, ry, _], [vx, vy, _], [_, _, w]) = (body.arm, body.velocity, body.spin);
    let (inv_mass, inv_moment) = (body.inv_mass, body.inv_inertia[2][2]);
    let (v_n, v_t) = (vy + w * rx, vx - w * ry);
    let solution =
        |j_n: f64, j_t: f64, mode, margin| Some(Solution { state: problem.after([j_t, j_n, 0.0]), mode, margin });
    let speed = problem.speed();
    let closeness = v_n.abs() / speed;
    if v_n >= 0.0 {
        return solution(0.0, 0.0, Mode::Separating, closeness);
    }
    let (nn, tt, nt) = (inv_mass + inv_moment * rx * rx, inv_mass + inv_moment * ry * ry, -inv_moment * rx * ry);
    let change = -(1.0 + problem.restitution) * v_n;
    let mu = problem.friction;
    if mu == 0.0 {
        return solution(change / nn, 0.0, Mode::Frictionless, closeness);
    }

    let determinant = nn * tt - nt * nt;
    let j_n = (change * tt + v_t * nt) / determinant;
    let j_t = (-v_t * nn - change * nt) / determinant;
    if j_t.abs() <= mu * j_n {
        return solution(j_n, j_t, Mode::Stick, closeness.min(1.0 - j_t.abs() / (mu * j_n)));
    }
    let slips = [1.0, -1.0].map(|direction: f64| {
        let k = nn - mu * direction * nt;
        let j_n = change / k;
        let j_t = -mu * direction * j_n;
        let sliding = direction * (v_t + nt * j_n + tt * j_t);
        (k > 0.0 && sliding >= 0.0).then_some((j_n, j_t, sliding))
    });
    match slips {
        [Some((j_n, j_t, sliding)), None] | [None, Some((j_n, j_t, sliding))] => {
            solution(j_n, j_t, Mode::Slip, closeness.min(sliding / speed))
        }
        _ => None,
    }
}
