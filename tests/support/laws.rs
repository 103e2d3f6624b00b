//! What the laws of impact demand of a result, each as a number that says by how much they are missed.
//!
//! Errors are measured against one speed, `L |J| + (1 + e) s` with the load L = 1/m_a + 1/m_b + |I_a^-1||r_a|^2 +
//! |I_b^-1||r_b|^2 and s = |v_a| + |v_b| + |w_a||r_a| + |w_b||r_b|: the size of what is added up on the way. Arithmetic of
//! precision u cannot be better than a few u of it.

use carom::impulse::{Impact, Outcome, resolve_collision, resolve_collision_with_friction};
use carom::{Body, Material, RestitutionLaw};

use super::cases::Case;
use super::format::Format;
use super::number::{Exact, Vector};
use super::oracle::{Impulse, Problem, Scales, error, read_vector, velocities};

/// What an impact made of a case.
#[derive(Clone, Copy, Debug)]
pub struct Result<S: carom::Scalar> {
    pub a: Body<S>,
    pub b: Body<S>,
    pub impact: Impact<S>,
}

/// The impact without friction.
pub fn bounce<S: Format>(case: &Case<S>) -> Result<S> {
    let (mut a, mut b) = (case.a, case.b);
    let impact = resolve_collision(&mut a, &mut b, &case.contact, case.restitution);
    Result { a, b, impact }
}

/// The impact with friction.
pub fn rub<S: Format>(case: &Case<S>, law: RestitutionLaw) -> Result<S> {
    let material = Material::new(case.restitution, case.friction).expect("a material").with_law(law);
    let (mut a, mut b) = (case.a, case.b);
    let impact = resolve_collision_with_friction(&mut a, &mut b, &case.contact, &material);
    Result { a, b, impact }
}

/// Errors in units of the scale, beyond half a unit of the last place of what is stored.
#[derive(Clone, Copy, Debug, Default)]
pub struct Misses {
    /// K |dJ|
    pub impulse: f64,
    /// K m |dv|, the largest component
    pub linear: f64,
    /// K |dw| / (|I^-1||r|), the largest component
    pub angular: f64,
}

impl Misses {
    pub fn largest(&self) -> f64 {
        self.impulse.max(self.linear).max(self.angular)
    }
}

/// A stored component is rounded once, to the nearest: half a unit of its last place, and a little for what goes before.
pub const STORED: f64 = 0.51;

/// The speed that errors are measured against.
pub fn scale(problem: &Problem, scales: &Scales, impulse: f64) -> f64 {
    scales.load * impulse + (1.0 + problem.restitution.to_f64().abs()) * scales.speed
}

/// What is left of an error beyond its allowance, in units of `scale`: infinite where there is nothing to err on.
pub fn beyond(error: f64, allowed: f64, scale: f64) -> f64 {
    let rest = error - allowed;
    if rest <= 0.0 { 0.0 } else { rest / scale }
}

/// Velocities and normal impulse against an exact impulse along n, of which `normal` is the amount.
pub fn misses<S: Format>(problem: &Problem, result: &Result<S>, exact: &Impulse, normal: &Exact) -> Misses {
    let scales = problem.scales();
    let k = exact.over.to_f64();
    let j = normal.ratio(&exact.over);
    let scale = scale(problem, &scales, j.abs()) / k;
    let report = error(result.impact.normal_impulse, normal, &exact.over);
    let mut misses = Misses { impulse: beyond(report, STORED * S::ulp(j), scale), ..Misses::default() };
    let after = problem.after(exact);
    for (q, stored) in velocities(&result.a, &result.b).into_iter().enumerate() {
        let yields = problem.yields(&scales, q);
        for (stored, exact_component) in stored.into_iter().zip(&after[q].0) {
            let difference = error(stored, exact_component, &exact.over);
            let allowed = STORED * S::ulp(exact_component.ratio(&exact.over));
            let miss = beyond(difference, allowed, yields * scale);
            let worst = if q % 2 == 0 { &mut misses.linear } else { &mut misses.angular };
            *worst = worst.max(miss);
        }
    }
    misses
}

/// Whether results leave the range of the format, for an error bound `c` in units of the scale: `None` where they lie so
/// near its end that both answers are right.
pub fn leaves_range<S: Format>(problem: &Problem, exact: &Impulse, normal: &Exact, c: f64) -> Option<bool> {
    if !S::saturates() {
        return Some(false);
    }
    let scales = problem.scales();
    let k = exact.over.to_f64();
    let bound = c * scale(problem, &scales, normal.ratio(&exact.over).abs()) / k;
    let near = |x: f64, error: f64| {
        let margin = 1.5 * S::ulp(0.0) + error;
        match x.abs() - S::largest() {
            d if d > margin => Some(true),
            d if d < -margin => Some(false),
            _ => None,
        }
    };
    let mut answers = vec![near(normal.ratio(&exact.over), bound)];
    for (q, v) in problem.after(exact).iter().enumerate() {
        let yields = problem.yields(&scales, q);
        answers.extend(v.0.iter().map(|x| near(x.ratio(&exact.over), yields * bound)));
    }
    if answers.contains(&Some(true)) {
        return Some(true);
    }
    if answers.contains(&None) { None } else { Some(false) }
}

/// How far a result with friction is from the contact law, in units of the scale.
#[derive(Clone, Copy, Debug, Default)]
pub struct FrictionMisses {
    /// v_n' + e v_n
    pub rebound: f64,
    /// |v_t'|, where the points are said to stick
    pub stick: f64,
    /// |v_t' + |v_t'| J_t/|J_t||, where they are said to slide
    pub against: f64,
    /// |J_t| - mu J_n over |J|: of either sign where they slide, above zero where they stick
    pub cone: f64,
    /// The velocities against the reported impulse, by (2) and (3)
    pub applied: f64,
    /// By how much friction raises the normal impulse above that of (10)
    pub gain: f64,
}

/// What reporting an impulse as three rounded components and a rounded normal part puts it off by, in units of the last
/// place: half of one, and half of the root of three.
pub const REPORTED: f64 = 1.37;

/// The law of Coulomb and Newton, from the velocities that were stored and the impulse that was reported.
pub fn friction_misses<S: Format>(problem: &Problem, result: &Result<S>) -> FrictionMisses {
    let scales = problem.scales();
    let after = stored_problem(problem, result);
    let normal = &problem.normal;
    let j_n = result.impact.normal_impulse.value();
    let j_t = read_vector(result.impact.friction_impulse);
    let (normal_impulse, friction_impulse) = (j_n.to_f64(), j_t.length());
    let size = normal_impulse.hypot(friction_impulse);
    let ulp = S::ulp(size);
    let scale = scale(problem, &scales, size + REPORTED * ulp);
    // A normal of length 1 + d puts results off by its share.
    let off_unit = 2.0 * (normal.dot(normal) - Exact::one()).to_f64().abs();
    let stored = storage(&after) + off_unit * scale;

    let v = after.relative_velocity();
    let v_n = v.dot(normal);
    let v_t = &v - &normal.times(&v_n);
    let sliding = v_t.length();
    let mu = problem.friction.to_f64();
    let limit = mu * normal_impulse;
    let report = (REPORTED + 0.5 * mu) * ulp + off_unit * (limit + friction_impulse);
    let mut misses = FrictionMisses {
        rebound: beyond((&v_n + &(&problem.restitution * &problem.approach())).to_f64().abs(), stored, scale),
        gain: (&j_n * &problem.denominator()).ratio(&problem.numerator()),
        applied: applied(problem, &after, &(&normal.times(&j_n) + &j_t), scale / scales.load, ulp),
        ..FrictionMisses::default()
    };
    match result.impact.outcome {
        Outcome::Stuck => {
            misses.stick = beyond(sliding, stored, scale);
            misses.cone = beyond(friction_impulse - limit, report, size);
        }
        _ => {
            misses.cone = beyond((friction_impulse - limit).abs(), report, size);
            if friction_impulse > 0.0 {
                let along = v_t.0.iter().zip(&j_t.0).map(|(v, j)| v.to_f64() + j.to_f64() / friction_impulse * sliding);
                let across = along.map(|x| x * x).sum::<f64>().sqrt();
                // In fixed point the three parts of an impulse share one power of two: a small friction is less sharp.
                let shared = if S::saturates() { 4.0 * S::precision() * size } else { 0.0 };
                let turned = (REPORTED * ulp + shared) / friction_impulse;
                misses.against = beyond(across, 2.0 * stored + turned * sliding, scale);
            }
        }
    }
    misses
}

/// The problem with the velocities that a result has stored.
pub fn stored_problem<S: Format>(problem: &Problem, result: &Result<S>) -> Problem {
    let mut after = problem.clone();
    for (side, body) in after.sides.iter_mut().zip([&result.a, &result.b]) {
        side.v = read_vector(body.linear_velocity);
        side.w = read_vector(body.angular_velocity);
        side.ulps = [&side.v, &side.w].map(|v| v.to_f64().iter().fold(0f64, |m, &x| m.max(S::ulp(x))));
    }
    after
}

/// What rounding the stored velocities does to the relative velocity of the points.
pub fn storage(after: &Problem) -> f64 {
    let half = STORED * 3f64.sqrt();
    after.sides.iter().map(|side| half * (side.ulps[0] + side.arm.length() * side.ulps[1])).sum()
}

/// The changes of velocity against the reported impulse, in units of `scale`, an impulse.
fn applied(problem: &Problem, after: &Problem, impulse: &Vector, scale: f64, ulp: f64) -> f64 {
    let expected = problem.after(&Impulse { vector: impulse.clone(), over: Exact::one() });
    let scales = problem.scales();
    let mut worst = 0f64;
    for (q, expected) in expected.iter().enumerate() {
        let side = &after.sides[q / 2];
        let (stored, yields) = (if q % 2 == 0 { &side.v } else { &side.w }, problem.yields(&scales, q));
        let allowed = STORED * 3f64.sqrt() * side.ulps[q % 2] + REPORTED * ulp * yields;
        worst = worst.max(beyond((stored - expected).length(), allowed, yields * scale));
    }
    worst
}
