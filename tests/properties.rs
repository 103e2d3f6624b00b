//! Laws that hold whatever the numbers are, tried on impacts of everyday size and of any size the format holds.
//!
//! A unit is one of the last place of the largest term of a component. `support/balance.rs` computes what is missing from
//! a sum in exact arithmetic, `support/laws.rs` what is missing from a law.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/exact.rs"]
mod exact;

use carom::impulse::{Impact, Outcome};
use carom::{Body, RestitutionLaw, Vec3};
use exact::balance::{self, angular_momentum, momentum};
use exact::cases::{bits, turn_towards};
use exact::laws::{REPORTED, Result, bounce, friction_misses, rub};
use exact::oracle::read_vector;
use exact::strategy::{any_size, everyday, forall, rotations, sketch};
use exact::{Case, Exact, Format, Problem, in_formats};
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;

const LAWS: [RestitutionLaw; 2] = [RestitutionLaw::Newton, RestitutionLaw::EnergySafe];

/// Without friction, and with friction under both laws.
fn all_ways<S: Format>(case: &Case<S>) -> [Result<S>; 3] {
    [bounce(case), rub(case, LAWS[0]), rub(case, LAWS[1])]
}

fn balance_holds<S: Format>(case: &Case<S>, result: &Result<S>) -> TestCaseResult {
    let (before, after) = balance::after(case, result);
    let u = S::precision();
    // Each body's velocity is rounded by half a unit; what passes between them, in floats four times, in fixed point once.
    let passed = if S::saturates() { 1.0 } else { 4.0 };
    let change = |i: usize, k: usize| {
        (&after.sides[i].v.0[k] - &before.sides[i].v.0[k]).to_f64().abs() / before.sides[i].inv_mass.to_f64()
    };
    for (k, balance) in momentum(&before, result).iter().enumerate() {
        let allowed = balance.unit + passed * u * change(0, k);
        prop_assert!(
            balance.missing.abs() <= allowed,
            "momentum, component {k}: {balance:?}, {} units",
            balance.units()
        );
    }
    // The same for each body's angular momentum about the contact point, where the rounding of the tensor adds its share.
    let passed = if S::saturates() { 32.0 } else { 1.0 };
    for (before, after) in before.sides.iter().zip(&after.sides) {
        let (balance, condition) = angular_momentum::<S>(before, after);
        let push = (&after.v - &before.v).length() / before.inv_mass.to_f64() * before.arm.length();
        for (k, balance) in balance.iter().enumerate() {
            let allowed = 1.5 * balance.unit + passed * u * condition * push;
            prop_assert!(balance.missing.abs() <= allowed, "angular momentum, component {k}: {balance:?} of {allowed}");
        }
    }
    Ok(())
}

/// In fixed point one unit and 2^-30 of what the bodies exchange; in floats one unit and four roundings of that, which
/// never was more than 3.1 units. Angular momentum: one and a half units, and the tensor's rounding.
fn momentum_is_kept<S: Format>() {
    forall(1_000, everyday::<S>(), |mut case| {
        turn_towards(&mut case);
        all_ways(&case).iter().try_for_each(|result| balance_holds(&case, result))
    });
}

fn rebound_holds<S: Format>(case: &Case<S>, result: &Result<S>) -> TestCaseResult {
    if result.impact.outcome == Outcome::Separating || result.impact.saturated {
        return Ok(());
    }
    let miss = friction_misses(&Problem::read(case), result);
    let bound = S::precision() * if S::saturates() { 32.0 } else { 4.0 };
    prop_assert!(miss.rebound <= bound, "v_n' + e v_n is {} of the scale", miss.rebound);
    Ok(())
}

fn restitution_holds<S: Format>() {
    forall(2_000, any_size::<S>(), |case| rebound_holds(&case, &bounce(&case)));
    forall(1_000, everyday::<S>(), |case| rebound_holds(&case, &rub(&case, RestitutionLaw::Newton)));
}

fn cone_holds<S: Format>(case: &Case<S>, impact: &Impact<S>) -> TestCaseResult {
    if impact.saturated {
        return Ok(());
    }
    let (normal, friction) = (impact.normal_impulse.value().to_f64(), read_vector(impact.friction_impulse).length());
    let mu = case.friction.value().to_f64();
    let n = Problem::read(case).normal;
    let off_unit = (n.dot(&n) - Exact::one()).to_f64().abs();
    let size = normal.hypot(friction);
    let root = if S::name() == "micromath" { 1e-5 * friction } else { 0.0 };
    let allowed = (REPORTED + mu) * S::ulp(size) + (8.0 * S::precision() + off_unit) * size + root;
    prop_assert!(normal >= 0.0);
    prop_assert!(friction <= mu * normal + allowed, "|J_t| = {friction}, mu J_n = {}", mu * normal);
    Ok(())
}

fn cone_is_respected<S: Format>() {
    forall(3_000, any_size::<S>(), |case| LAWS.iter().try_for_each(|&law| cone_holds(&case, &rub(&case, law).impact)));
    forall(1_000, everyday::<S>(), |case| LAWS.iter().try_for_each(|&law| cone_holds(&case, &rub(&case, law).impact)));
}

fn mirrors<S: Format>(result: &Result<S>, mirrored: &Result<S>) -> TestCaseResult {
    // Numeric equality: a zero may change its sign.
    prop_assert_eq!(result.a, mirrored.b);
    prop_assert_eq!(result.b, mirrored.a);
    prop_assert_eq!(result.impact.outcome, mirrored.impact.outcome);
    prop_assert_eq!(result.impact.normal_impulse, mirrored.impact.normal_impulse);
    prop_assert_eq!(result.impact.saturated, mirrored.impact.saturated);
    // (The two ends of a fixed-point range differ by one unit.)
    if !result.impact.saturated {
        prop_assert_eq!(result.impact.friction_impulse, -mirrored.impact.friction_impulse);
    }
    Ok(())
}

fn swap_mirrors<S: Format>() {
    let check = |case: Case<S>| {
        all_ways(&case).iter().zip(&all_ways(&case.swapped())).try_for_each(|(left, right)| mirrors(left, right))
    };
    forall(3_000, any_size::<S>(), check);
    forall(1_000, everyday::<S>(), check);
}

fn separating_changes_nothing<S: Format>() {
    forall(3_000, any_size::<S>(), |mut case| {
        turn_towards(&mut case);
        for body in [&mut case.a, &mut case.b] {
            body.linear_velocity = -body.linear_velocity;
            body.angular_velocity = -body.angular_velocity;
        }
        let problem = Problem::read(&case);
        let surely = problem.approach().to_f64() > 16.0 * S::precision() * problem.scales().speed;
        for result in all_ways(&case) {
            prop_assert!(!surely || result.impact.outcome == Outcome::Separating);
            if result.impact.outcome == Outcome::Separating {
                prop_assert_eq!([bits(&result.a), bits(&result.b)], [bits(&case.a), bits(&case.b)]);
                prop_assert_eq!(result.impact.normal_impulse, S::ZERO);
                prop_assert_eq!(result.impact.friction_impulse, Vec3::ZERO);
                prop_assert!(!result.impact.saturated);
            }
        }
        Ok(())
    });
}

/// (A velocity of -0.0 may come back as 0.0.)
fn immovable_stays<S: Format>() {
    forall(1_000, any_size::<S>(), |case| {
        // Kinematic: with the velocities of the body it takes the place of.
        let ground = |like: &Body<S>| {
            let mut ground = Body::immovable();
            ground.position = like.position;
            ground.linear_velocity = like.linear_velocity;
            ground.angular_velocity = like.angular_velocity;
            ground
        };
        let (a, b) = (ground(&case.a), ground(&case.b));
        for result in all_ways(&Case { a, ..case }) {
            prop_assert_eq!(result.a, a);
        }
        for result in all_ways(&Case { b, ..case }) {
            prop_assert_eq!(result.b, b);
        }
        for result in all_ways(&Case { a, b, ..case }) {
            prop_assert_eq!([result.a, result.b], [a, b]);
            prop_assert!(matches!(result.impact.outcome, Outcome::Immovable | Outcome::Separating));
        }
        Ok(())
    });
}

fn locked_rotation_stays<S: Format>() {
    forall(1_000, (sketch(), any::<[bool; 2]>()), |(sketch, locked)| {
        let mut case = sketch.build::<S>();
        for (body, (sketch, locked)) in [&mut case.a, &mut case.b].into_iter().zip(sketch.bodies.iter().zip(locked)) {
            if locked {
                *body = sketch.build_locked();
            }
        }
        turn_towards(&mut case);
        for result in all_ways(&case) {
            for (after, (before, locked)) in [result.a, result.b].iter().zip([case.a, case.b].iter().zip(locked)) {
                prop_assert!(!locked || bits(after)[6..] == bits(before)[6..]);
                prop_assert_eq!(&bits(after)[..3], &bits(before)[..3]);
            }
        }
        Ok(())
    });
}

/// The largest difference of a velocity component between an impact and the same one turned.
fn differs<S: Format>(results: [&Result<S>; 2], turn: impl Fn([f64; 3]) -> [f64; 3]) -> f64 {
    let velocities = |r: &Result<S>| {
        [r.a.linear_velocity, r.a.angular_velocity, r.b.linear_velocity, r.b.angular_velocity]
            .map(|v| v.to_array().map(|x| x.value().to_f64()))
    };
    let (left, right) = (velocities(results[0]), velocities(results[1]));
    let mut worst = 0f64;
    for (left, right) in left.into_iter().zip(right) {
        for (x, y) in turn(left).into_iter().zip(right) {
            worst = worst.max((x - y).abs());
        }
    }
    worst
}

/// Where in the world an impact happens, and how the axes lie, makes no difference but rounding.
fn place_and_axes_do_not_matter<S: Format>() {
    let rotation = [-1.0..=1.0, -1.0..=1.0, -1.0..=1.0, 0.1..=1.0];
    forall(500, (sketch(), rotation, any::<[u64; 6]>()), |(sketch, rotation, place)| {
        let mut case = sketch.build::<S>();
        turn_towards(&mut case);
        // Positions are not even read.
        let mut moved = case;
        let finite = |x: u64| Some(S::from_raw(x)).filter(|x| x.is_finite()).unwrap_or(S::ZERO);
        let [x, y, z, u, v, w] = place.map(finite);
        (moved.a.position, moved.b.position) = (Vec3::new(x, y, z), Vec3::new(u, v, w));
        for (still, moved) in all_ways(&case).iter().zip(all_ways(&moved)) {
            prop_assert_eq!(&bits(&still.a)[3..], &bits(&moved.a)[3..]);
            prop_assert_eq!(still.impact, moved.impact);
        }

        // Everything turned by one rotation.
        let (turn, compose) = rotations(rotation);
        let mut turned = sketch;
        turned.normal = turn(sketch.normal);
        turned.arms = sketch.arms.map(&turn);
        for body in &mut turned.bodies {
            (body.velocity, body.spin) = (turn(body.velocity), turn(body.spin));
            body.orientation = compose(body.orientation);
        }
        let mut turned = turned.build::<S>();
        turn_towards(&mut turned);
        let problem = Problem::read(&case);
        let scales = problem.scales();
        // Each input is rounded anew: a few units of the inputs, times what the impact makes of them.
        let input = 8.0 * S::ulp(4.0) * (1.0 + scales.turn[0].max(scales.turn[1]));
        let gain = scales.load / problem.denominator().to_f64();
        let (straight, oblique) = (bounce(&case), bounce(&turned));
        let difference = differs([&straight, &oblique], &turn);
        let grazing = straight.impact.outcome != oblique.impact.outcome;
        prop_assert!(grazing || difference <= input * gain, "{difference} of {}", input * gain);
        Ok(())
    });
}

/// Each check above refuses a result with a fault in it.
fn faults_are_seen<S: Format>() {
    let counts = std::cell::RefCell::new([0u32; 6]);
    let touch = |v: Vec3<S>| Vec3 { x: S::from_raw(v.x.raw() ^ 1), ..v };
    forall(300, everyday::<S>(), |mut case| {
        turn_towards(&mut case);
        let result = rub(&case, RestitutionLaw::Newton);
        prop_assume!(result.impact.outcome == Outcome::Slid && result.impact.normal_impulse.value().to_f64() > 0.05);
        prop_assume!(case.friction.value().to_f64() > 0.1);
        let mut counts = counts.borrow_mut();
        // The impulse missing from body B.
        let only_a = Result { b: case.b, ..result };
        // B's spin changed the other way.
        let mut torque = result;
        torque.b.angular_velocity = case.b.angular_velocity - (result.b.angular_velocity - case.b.angular_velocity);
        // Another e.
        let soft = Case { restitution: S::ZERO, ..case };
        // A hundredth too much friction.
        let friction = result.impact.friction_impulse.to_array().map(|x| S::nearest(x.value().to_f64() * 1.01));
        let strong = Impact { friction_impulse: Vec3::from_array(friction), ..result.impact };
        // A zero impulse that still touches the last place of a velocity.
        let mut touched = case.a;
        touched.linear_velocity = touch(touched.linear_velocity);
        // One unit of the last place, as a rounding that is not symmetric makes it.
        let mirrored = rub(&case.swapped(), RestitutionLaw::Newton);
        let mut unequal = mirrored;
        unequal.a.linear_velocity = touch(unequal.a.linear_velocity);
        mirrors(&result, &mirrored)?;
        for (count, seen) in counts.iter_mut().zip([
            balance_holds(&case, &only_a).is_err(),
            balance_holds(&case, &torque).is_err(),
            rebound_holds(&case, &rub(&soft, RestitutionLaw::Newton)).is_err(),
            cone_holds(&case, &strong).is_err(),
            bits(&touched) != bits(&case.a),
            mirrors(&result, &unequal).is_err(),
        ]) {
            *count += u32::from(seen);
        }
        Ok(())
    });
    let counts = counts.into_inner();
    println!("{}: of 300 cases show the fault: {counts:?}", S::name());
    assert!(counts.iter().all(|&n| n >= 250), "{counts:?}");
}

in_formats!(usual {
    momentum_is_kept restitution_holds cone_is_respected swap_mirrors separating_changes_nothing immovable_stays
    locked_rotation_stays place_and_axes_do_not_matter faults_are_seen
});
