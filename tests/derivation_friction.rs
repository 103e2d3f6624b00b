//! Steps (12) to (16) of `docs/derivation.md`, one test each: friction by hand in f64, and the kernel beside it.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed"))]

#[path = "support/exact.rs"]
mod exact;

use std::cell::Cell;

use carom::RestitutionLaw;
use carom::impulse::{Impact, Outcome, relative_velocity};
use exact::hand::{Hand, Pair, V, add, close, cross, direction, dot, each, length, read};
use exact::laws::{Result, rub};
use exact::{Case, Format, in_formats};
use proptest::prelude::*;

fn impulse<S: Format>(pair: &Pair, impact: &Impact<S>) -> V {
    add(read(impact.friction_impulse), impact.normal_impulse.value().to_f64(), pair.n)
}

fn after<S: Format>(case: &Case<S>, result: &Result<S>) -> Pair {
    Pair { a: Hand::read(&result.a, case.contact.r_a), b: Hand::read(&result.b, case.contact.r_b), ..Pair::read(case) }
}

/// The impulse that sticks, by Cramer's rule: W J = -(v_r + e v_n n).
fn sticking(pair: &Pair) -> V {
    let w = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|d| pair.yields_to(d));
    let v = pair.relative_velocity();
    let y = add(v, pair.e * dot(v, pair.n), pair.n).map(|x| -x);
    let determinant = dot(w[0], cross(w[1], w[2]));
    let columns = [cross(w[1], w[2]), cross(w[2], w[0]), cross(w[0], w[1])];
    [0, 1, 2].map(|i| (0..3).map(|k| columns[k][i] * y[k]).sum::<f64>() / determinant)
}

/// The tangential problem: S, q and K_nt in the tangents, K_nn, and b = (1 + e) v_n.
struct Tangential {
    s: [[f64; 2]; 2],
    q: [f64; 2],
    k_nt: [f64; 2],
    k_nn: f64,
    b: f64,
    tangents: [V; 2],
}

fn tangential<S: Format>(case: &Case<S>, pair: &Pair) -> Tangential {
    let (t1, t2) = case.contact.normal.tangents();
    let tangents = [direction(t1), direction(t2)];
    let along_n = pair.yields_to(pair.n);
    let k_nn = dot(along_n, pair.n);
    let k_nt = tangents.map(|t| dot(along_n, t));
    let v = pair.relative_velocity();
    let b = (1.0 + pair.e) * dot(v, pair.n);
    let s = [0, 1].map(|i| {
        let along = pair.yields_to(tangents[i]);
        [0, 1].map(|k| dot(along, tangents[k]) - k_nt[i] * k_nt[k] / k_nn)
    });
    let q = [0, 1].map(|i| dot(v, tangents[i]) - k_nt[i] * b / k_nn);
    Tangential { s, q, k_nt, k_nn, b, tangents }
}

impl Tangential {
    /// j_t of (S + s 1) j_t = -q
    fn held_back(&self, s: f64) -> [f64; 2] {
        let (a, b, d) = (self.s[0][0] + s, self.s[0][1], self.s[1][1] + s);
        let determinant = a * d - b * b;
        [(b * self.q[1] - d * self.q[0]) / determinant, (b * self.q[0] - a * self.q[1]) / determinant]
    }

    /// j_n of the normal row K_nn j_n + K_nt . j_t = -b
    fn normal(&self, j_t: [f64; 2]) -> f64 {
        -(self.b + self.k_nt[0] * j_t[0] + self.k_nt[1] * j_t[1]) / self.k_nn
    }

    /// How far |j_t| is above mu j_n.
    fn excess(&self, mu: f64, s: f64) -> f64 {
        let j_t = self.held_back(s);
        j_t[0].hypot(j_t[1]) - mu * self.normal(j_t)
    }

    fn impulse(&self, n: V, s: f64) -> V {
        let j_t = self.held_back(s);
        add(add(n.map(|x| x * self.normal(j_t)), j_t[0], self.tangents[0]), j_t[1], self.tangents[1])
    }
}

/// (12): v_r' = v_r + W J for an impulse in any direction; W is symmetric and at least 1/m_a + 1/m_b.
fn step_12_three_components<S: Format>() {
    each::<S>(|case, pair| {
        let Result { a, b, impact } = rub(&case, RestitutionLaw::Newton);
        let j = impulse(&pair, &impact);
        let expected = add(pair.relative_velocity(), 1.0, pair.yields_to(j));
        prop_assert!(close(read(relative_velocity(&a, &b, &case.contact)), expected, 16.0 * pair.tolerance));
        let (x, y) = ([0.3, -0.8, 0.5], [-0.1, 0.4, 0.9]);
        prop_assert!((dot(pair.yields_to(x), y) - dot(pair.yields_to(y), x)).abs() < 1e-8);
        prop_assert!(dot(pair.yields_to(x), x) >= (pair.a.inv_mass + pair.b.inv_mass) * dot(x, x) * (1.0 - 1e-6));
        Ok(())
    });
}

/// (13): the points stick where the impulse of the 3x3 system lies in the cone, and nowhere else.
fn step_13_sticking<S: Format>() {
    let [stuck, box_only] = [0, 0].map(Cell::new);
    each::<S>(|case, pair| {
        let j = sticking(&pair);
        let j_n = dot(j, pair.n);
        let across = add(j, -j_n, pair.n);
        let (friction, limit) = (length(across), pair.mu * j_n);
        let impact = rub(&case, RestitutionLaw::Newton).impact;
        if (friction - limit).abs() > 16.0 * pair.tolerance {
            prop_assert_eq!(impact.outcome == Outcome::Stuck, friction < limit, "{} {}", friction, limit);
        }
        if impact.outcome == Outcome::Stuck {
            stuck.set(stuck.get() + 1);
            prop_assert!(close(impulse(&pair, &impact), j, 16.0 * pair.tolerance));
        } else {
            // The fault: a box in the two tangents for the disc, which would let these stick.
            let (t1, t2) = case.contact.normal.tangents();
            let inside = [t1, t2].iter().all(|t| dot(across, direction(*t)).abs() < limit);
            box_only.set(box_only.get() + u32::from(inside));
        }
        Ok(())
    });
    println!("{}: {stuck:?} of 300 stick, a box would hold {box_only:?} more", S::name());
    assert!(stuck.get() > 50 && box_only.get() > 0);
}

/// (14): where they slide, j_t = -u/s for the sliding u that is left, and one unknown s > 0 brings |j_t| = mu j_n.
fn step_14_sliding<S: Format>() {
    let [slid, before] = [0, 0].map(Cell::new);
    each::<S>(|case, pair| {
        let Result { a, b, impact } = rub(&case, RestitutionLaw::Newton);
        if impact.outcome != Outcome::Slid || pair.mu == 0.0 {
            return Ok(());
        }
        slid.set(slid.get() + 1);
        let problem = tangential(&case, &pair);
        // At s = 0 (sticking) there is too much friction or none to stick by, at s without end there is too little.
        let (mut low, mut high) = (0.0, 1e12);
        prop_assert!(problem.excess(pair.mu, high) < 0.0);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if problem.excess(pair.mu, middle) > 0.0 { low = middle } else { high = middle }
        }
        let j = problem.impulse(pair.n, high);
        let size = 1.0 + length(j);
        prop_assert!(close(impulse(&pair, &impact), j, 64.0 * pair.tolerance * size), "{:?} {:?}", impact, j);
        // Against the sliding that is left, not against the sliding before: the two differ.
        let v = read(relative_velocity(&a, &b, &case.contact));
        let u = add(v, -dot(v, pair.n), pair.n);
        let j_t = read(impact.friction_impulse);
        prop_assert!(length(cross(u, j_t)) <= 64.0 * pair.tolerance * size * (1.0 + length(u)));
        let first = pair.relative_velocity();
        let first = add(first, -dot(first, pair.n), pair.n);
        let turned = length(cross(first, j_t)) / (length(first) * length(j_t));
        before.set(before.get() + u32::from(turned > 0.01));
        Ok(())
    });
    println!("{}: {slid:?} of 300 slide, {before:?} of them another way than before", S::name());
    assert!(slid.get() > 150 && before.get() > 50);
}

/// (15): T' - T = J . (v_r + v_r') / 2, which Newton's e makes positive where friction pushes along the sliding before.
fn step_15_energy<S: Format>() {
    each::<S>(|case, pair| {
        let result = rub(&case, RestitutionLaw::Newton);
        let j = impulse(&pair, &result.impact);
        let end = after(&case, &result);
        let work = 0.5 * dot(j, add(pair.relative_velocity(), 1.0, end.relative_velocity()));
        let slack = 64.0 * pair.tolerance * (1.0 + length(j));
        prop_assert!((end.energy() - pair.energy() - work).abs() <= slack, "{} {work}", end.energy() - pair.energy());
        Ok(())
    });
}

/// (16): the safe law takes v_n' = -s e v_n with the largest s in 0 to 1 that does not raise the energy.
fn step_16_safe_law<S: Format>() {
    let gained = Cell::new(0);
    each::<S>(|case, pair| {
        // Hard, and with little sliding: where Newton's law gains.
        let mut case = case;
        case.restitution = S::nearest(1.0 - S::ulp(0.5));
        let v = pair.relative_velocity();
        let across = add(v, -dot(v, pair.n), pair.n);
        case.b.linear_velocity = carom::Vec3::from_array(add(pair.b.v, -0.8, across).map(S::nearest));
        let pair = Pair::read(&case);
        let slack = 64.0 * pair.tolerance * (1.0 + length(sticking(&pair)));
        let energy = |result: &Result<S>| after(&case, result).energy() - pair.energy();
        let (newton, safe) = (rub(&case, RestitutionLaw::Newton), rub(&case, RestitutionLaw::EnergySafe));
        let (by_newton, by_safe) = (energy(&newton), energy(&safe));
        prop_assert!(by_safe <= slack, "{by_safe}");
        if by_newton > slack {
            gained.set(gained.get() + 1);
            prop_assert!(by_safe >= -slack, "the largest s: {by_safe}");
            let rebound = dot(after(&case, &safe).relative_velocity(), pair.n);
            let full = -pair.e * dot(pair.relative_velocity(), pair.n);
            prop_assert!(rebound >= -slack && rebound <= full + slack);
        } else if by_newton < -slack {
            prop_assert_eq!(newton.a, safe.a);
        }
        Ok(())
    });
    println!("{}: {gained:?} of 300 gain energy under Newton's law", S::name());
    assert!(gained.get() > 5);
}

in_formats!(derived {
    step_12_three_components step_13_sticking step_14_sliding step_15_energy step_16_safe_law
});
