//! The kinetic energy before and after an impact, in exact arithmetic.
//!
//! Without friction an impact changes it by -(1 - e^2) v_n^2 / 2K. With friction, Newton's law of restitution raises it in
//! some eccentric impacts; under [`RestitutionLaw::EnergySafe`] none does, beyond the rounding of what is stored.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/exact.rs"]
mod exact;

use std::cell::RefCell;

use carom::RestitutionLaw;
use carom::impulse::Outcome;
use exact::balance::kinetic_energy;
use exact::cases::turn_towards;
use exact::laws::{REPORTED, Result, beyond, bounce, rub, scale, stored_problem};
use exact::oracle::read_vector;
use exact::strategy::{Sketch, any_size, everyday, forall, sketch};
use exact::{Case, Exact, Format, Problem, Vector, Worst, in_formats};
use proptest::prelude::*;

/// Energies before and after, and what rounding can do to the difference: each stored velocity is off by half a unit of
/// its last place and by a few roundings of the intermediate numbers.
struct Energies {
    before: f64,
    after: f64,
    rounding: f64,
}

fn energies<S: Format>(problem: &Problem, result: &Result<S>) -> Energies {
    let after = stored_problem(problem, result);
    let scales = problem.scales();
    let size = result
        .impact
        .normal_impulse
        .value()
        .to_f64()
        .hypot(Vector(result.impact.friction_impulse.to_array().map(S::value)).length());
    let roundings = if S::saturates() { 16.0 } else { 1.0 };
    let impulse_error = roundings * S::precision() * scale(problem, &scales, size) / scales.inv_mass;
    let mut rounding = 0.0;
    for (i, side) in after.sides.iter().enumerate() {
        if side.inv_mass.is_zero() {
            continue;
        }
        let half = 0.5 * 3f64.sqrt();
        let v_error = half * side.ulps[0] + side.inv_mass.to_f64() * impulse_error;
        let w_error = half * side.ulps[1] + scales.turn[i] * impulse_error;
        rounding += (side.v.length() + v_error) * v_error / side.inv_mass.to_f64();
        if !side.inv_inertia.is_zero() {
            let spin = angular_momentum(side.inv_inertia.rows(), &side.w);
            rounding += (spin + trace_of_inverse(&side.inv_inertia) * w_error) * w_error;
        }
    }
    Energies { before: kinetic_energy(problem), after: kinetic_energy(&after), rounding }
}

/// |I w|
fn angular_momentum(rows: [Vector; 3], w: &Vector) -> f64 {
    let (turned, determinant) = exact::number::cramer(&rows, w);
    turned.length() / determinant.to_f64()
}

/// tr I
fn trace_of_inverse(inverse: &exact::number::Tensor) -> f64 {
    let axis = |i: usize| Vector(std::array::from_fn(|k| if k == i { Exact::one() } else { Exact::zero() }));
    (0..3)
        .map(|i| {
            let (column, determinant) = exact::number::cramer(&inverse.rows(), &axis(i));
            column.0[i].ratio(&determinant)
        })
        .sum()
}

/// Everyday bodies with an arm that may be far longer than they are: impacts as eccentric as they come. One in five is
/// against the resting ground, and half of them are hard, with most of the sliding taken out: there it is the impact that
/// makes the points slide, against the way they slid before, and friction may push the way they did.
fn eccentric() -> impl Strategy<Value = (Sketch, u8)> {
    (sketch(), 0u8..10)
}

fn build<S: Format>(sketch: &Sketch, kind: u8) -> Case<S> {
    let mut case = sketch.build::<S>();
    match kind {
        0 | 5 => case.a = carom::Body::immovable(),
        1 | 6 => case.b = carom::Body::immovable(),
        _ => {}
    }
    turn_towards(&mut case);
    if kind >= 5 {
        let problem = Problem::read(&case);
        let (v, n, v_n) = (problem.relative_velocity().to_f64(), problem.normal.to_f64(), problem.approach().to_f64());
        let (body, sign) = if case.b.is_immovable() { (&mut case.a, 0.8) } else { (&mut case.b, -0.8) };
        let u = body.linear_velocity.to_array().map(|x| x.value().to_f64());
        body.linear_velocity =
            carom::Vec3::from_array([0, 1, 2].map(|i| S::nearest(u[i] + sign * (v[i] - v_n * n[i]))));
        case.restitution = S::nearest(1.0 - 0.2 * (1.0 - sketch.restitution));
    }
    case
}

fn frictionless_loss<S: Format>() {
    let worst = RefCell::new(Worst::default());
    forall(2_000, eccentric(), |(sketch, kind)| {
        let case = build::<S>(&sketch, kind);
        let problem = Problem::read(&case);
        let result = bounce(&case);
        let energies = energies(&problem, &result);
        let loss = if result.impact.outcome == Outcome::Slid {
            let e = &problem.restitution;
            let square = problem.approach().square();
            (&square - &(&(e * e) * &square)).ratio(&problem.denominator()) / 2.0
        } else {
            0.0
        };
        let miss = (energies.before - loss - energies.after).abs();
        prop_assert!(miss <= energies.rounding, "{miss} of {}", energies.rounding);
        worst.borrow_mut().see(miss / energies.rounding, 0);
        Ok(())
    });
    println!(
        "{}: T' = T - (1 - e^2) v_n^2 / 2K, missed by at most {:.2} of the bound",
        S::name(),
        worst.borrow().value
    );
}

/// How often Newton's law gains, and by how much of the energy at most.
#[derive(Default)]
struct Gains {
    newton: u32,
    largest: f64,
    /// What is lost where the safe law took over, of the energy: next to nothing.
    lost: f64,
    kept_newton: u32,
    worst: f64,
}

fn safe_law_gains_nothing<S: Format>() {
    let gains = RefCell::new(Gains::default());
    forall(4_000, eccentric(), |(sketch, kind)| {
        let case = build::<S>(&sketch, kind);
        let problem = Problem::read(&case);
        let newton = rub(&case, RestitutionLaw::Newton);
        let safe = rub(&case, RestitutionLaw::EnergySafe);
        prop_assume!(!newton.impact.saturated && !safe.impact.saturated);
        let (by_newton, by_safe) = (energies(&problem, &newton), energies(&problem, &safe));
        let gain = by_safe.after - by_safe.before;
        prop_assert!(gain <= by_safe.rounding, "gains {gain} of {}, rounding {}", by_safe.before, by_safe.rounding);
        let mut gains = gains.borrow_mut();
        gains.worst = gains.worst.max(gain / by_safe.rounding);

        if by_newton.after > by_newton.before + by_newton.rounding {
            gains.newton += 1;
            gains.largest = gains.largest.max(by_newton.after / by_newton.before - 1.0);
            // There the energy is just kept, and v_n' = -s e v_n with s in 0 to 1.
            gains.lost = gains.lost.max((-gain - by_safe.rounding).max(0.0) / by_safe.before);
            let after = stored_problem(&problem, &safe);
            let rebound = after.approach().ratio(&problem.approach());
            let scales = problem.scales();
            let slack = (scales.load + 1.0) * 4.0 * (S::ulp(8.0) + 16.0 * S::precision() * scales.speed)
                / problem.approach().to_f64().abs();
            prop_assert!(-rebound >= -slack && -rebound <= problem.restitution.to_f64() + slack, "{rebound} {slack}");
        } else if by_newton.after < by_newton.before - by_newton.rounding {
            // Where Newton's law loses energy, the safe law is Newton's.
            gains.kept_newton += 1;
            prop_assert_eq!(newton.a, safe.a);
            prop_assert_eq!(newton.b, safe.b);
            prop_assert_eq!(newton.impact, safe.impact);
        }
        Ok(())
    });
    let gains = gains.into_inner();
    println!(
        "{}: Newton's law gains energy in {} of 4000, {:.2} of it at most; the safe law gains {:.2} of the rounding \
         at most, and where it acts loses {:.1e} of the energy",
        S::name(),
        gains.newton,
        gains.largest,
        gains.worst,
        gains.lost
    );
    // The deliberate fault of this test is Newton's law itself.
    assert!(gains.newton > 80, "too few impacts in which Newton's law gains energy: {}", gains.newton);
    assert!(gains.kept_newton > 2_000);
    assert!(gains.lost < 1e-4, "{}", gains.lost);
}

/// The share of impacts in which Newton's law gains energy, where nothing favours it: everyday bodies, arms in any
/// direction, any restitution in 0 to 1 and friction in 0 to 1.5.
fn newton_seldom_gains<S: Format>() {
    const CASES: u32 = 10_000;
    let [gains, rubbed] = [0u32; 2].map(RefCell::new);
    forall(CASES, everyday::<S>(), |mut case| {
        turn_towards(&mut case);
        let result = rub(&case, RestitutionLaw::Newton);
        let energies = energies(&Problem::read(&case), &result);
        *gains.borrow_mut() += u32::from(energies.after > energies.before + energies.rounding);
        *rubbed.borrow_mut() += u32::from(result.impact.outcome != Outcome::Separating);
        Ok(())
    });
    let share = f64::from(gains.into_inner()) / f64::from(CASES);
    println!("{}: Newton's law gains energy in {:.2} % of everyday impacts", S::name(), 100.0 * share);
    assert!(rubbed.into_inner() > CASES * 99 / 100);
    assert!((0.003..0.006).contains(&share), "{share}");
}

/// The same for impacts of any size, from the work of the reported impulse: T' - T = J . v_r + J . W J / 2.
fn safe_law_does_no_work<S: Format>() {
    let (worst, newton, tried) = (RefCell::new(Worst::default()), RefCell::new(0u32), RefCell::new(0u32));
    forall(5_000, any_size::<S>(), |case| {
        let problem = Problem::read(&case);
        let (scales, n) = (problem.scales(), &problem.normal);
        let off_unit = 2.0 * (n.dot(n) - Exact::one()).to_f64().abs();
        let work = |law| {
            let impact = rub(&case, law).impact;
            let j = &n.times(&impact.normal_impulse.value()) + &read_vector(impact.friction_impulse);
            let yields = problem.yields_to(&j);
            let v = problem.relative_velocity();
            let work = (j.dot(&v) + j.dot(&yields).shifted(-1)).to_f64();
            let reported = REPORTED * S::ulp(j.length());
            let allowed = reported * ((&v + &yields).length() + scales.load * reported);
            let size = j.length() * scale(&problem, &scales, j.length());
            (beyond(work, allowed + off_unit * size, size), impact)
        };
        let (miss, impact) = work(RestitutionLaw::EnergySafe);
        if impact.saturated || impact.outcome == Outcome::Separating {
            return Ok(());
        }
        *tried.borrow_mut() += 1;
        worst.borrow_mut().see(miss, 0);
        *newton.borrow_mut() += u32::from(work(RestitutionLaw::Newton).0 > 1e-4);
        Ok(())
    });
    let (worst, newton) = (worst.into_inner(), newton.into_inner());
    println!(
        "{}: work of the safe law, of |J| times the scale: {worst}; Newton's gains in {newton} of 5000",
        S::name()
    );
    assert!(newton > 10 && tried.into_inner() > 1_500);
    assert!(worst.value <= 8.0 * S::precision(), "{worst}");
}

/// The safe law leaves v_n' between 0 and -e v_n and the impulse in the cone, with the faintest rebound as with any: there
/// the line from the impulse without it to the one with it is too short to be told from rounding.
fn safe_law_rebounds_less<S: Format>() {
    let [over, tried] = [0u32; 2].map(RefCell::new);
    forall(20_000, (any_size::<S>(), any::<u8>()), |(mut case, faint)| {
        if faint > 64 {
            case.restitution = S::nearest(S::ulp(0.5) * f64::from(faint % 16));
        }
        let problem = Problem::read(&case);
        let impact = rub(&case, RestitutionLaw::EnergySafe).impact;
        if impact.saturated || impact.outcome == Outcome::Separating {
            return Ok(());
        }
        let (n, normal) = (&problem.normal, impact.normal_impulse.value());
        let friction = read_vector(impact.friction_impulse);
        let j = &n.times(&normal) + &friction;
        let reported = REPORTED * S::ulp(j.length());
        let scales = problem.scales();
        let scale = scale(&problem, &scales, j.length() + reported);
        let off_unit = 2.0 * (n.dot(n) - Exact::one()).to_f64().abs();
        let slack = 1024.0 * S::precision() * scale + scales.load * reported + off_unit * scale;
        let (v_n, e) = (problem.approach().to_f64(), problem.restitution.to_f64());
        let after = v_n + problem.yields_to(&j).dot(n).to_f64();
        prop_assert!(after >= -slack && after <= -e * v_n + slack, "{after} of {v_n}, e {e}: {impact:?}");
        let limit = problem.friction.to_f64() * normal.to_f64();
        let loose = 1e-5 * j.length() + (1.0 + problem.friction.to_f64()) * reported + off_unit * j.length();
        prop_assert!(normal >= Exact::zero() && friction.length() <= limit + loose, "{impact:?}");
        *tried.borrow_mut() += 1;
        *over.borrow_mut() += u32::from(faint > 64);
        Ok(())
    });
    assert!(tried.into_inner() > 4_000 && over.into_inner() > 2_000);
}

in_formats!(usual {
    frictionless_loss safe_law_gains_nothing newton_seldom_gains safe_law_rebounds_less safe_law_does_no_work
});

/// A body that hardly resists being turned, struck at the end of an arm, so heavy that its mass does not count: the impulse
/// without rebound, which the energy-safe law falls back on, has no sliding direction.
#[cfg(feature = "f32")]
#[test]
fn a_body_that_only_turns_stays_finite() {
    use carom::impulse::resolve_collision_with_friction;
    use carom::{Body, Contact, MassProperties, Material, UnitVec3, Vec3};

    let mut hits = 0;
    for power in 0..100 {
        let inv_mass: f32 = 2e-8 * 0.6f32.powi(power);
        for inverses in [[0.5, 1.0, 2.0], [1.0, 1.0, 1.0]] {
            for (arm, spin) in [([0.0, -1.0, 3.0], [1.0, 0.0, 0.0]), ([1.0, 0.0, 1.0], [0.0, 1.0, 0.0])] {
                let mass = MassProperties::from_inverses(inv_mass, inverses).expect("a mass");
                let (mut wall, mut body) = (Body::<f32>::immovable(), Body::dynamic(mass));
                body.angular_velocity = Vec3::from_array(spin);
                let contact = Contact::new(UnitVec3::Z, Vec3::ZERO, Vec3::from_array(arm)).expect("a contact");
                for restitution in [0.0, 0.25, 1.0] {
                    let material = Material::new(restitution, 1.0).expect("a material");
                    for law in [RestitutionLaw::Newton, RestitutionLaw::EnergySafe] {
                        let mut body = body;
                        let impact =
                            resolve_collision_with_friction(&mut wall, &mut body, &contact, &material.with_law(law));
                        assert_eq!(body.check(), Ok(()), "{impact:?}");
                        assert!(f32::is_finite(impact.normal_impulse), "{impact:?}");
                        hits += u32::from(matches!(impact.outcome, Outcome::Stuck | Outcome::Slid));
                    }
                }
            }
        }
    }
    assert!(hits > 600, "{hits} impacts");
}
