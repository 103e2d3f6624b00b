//! Formula (10) and what follows from it, in exact arithmetic on the very bits the kernel was given.
//!
//! The bound that every format is held to, with K the denominator, L = 1/m_a + 1/m_b + |I_a^-1||r_a|^2 + |I_b^-1||r_b|^2
//! (the trace for the norm) and s = |v_a| + |v_b| + |w_a||r_a| + |w_b||r_b|:
//!
//! ```text
//! K |dJ| <= C (L |J| + (1 + e) s)
//! ```
//!
//! A velocity is within 0.51 units of the last place of the exact one, plus its image of that: times 1/m, or |I^-1||r|.
//! `cargo test --all-features --test exact -- --nocapture` prints the worst cases; `CAROM_LONG=1` runs a million cases a
//! format.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/exact.rs"]
mod exact;

use carom::Vec3;
use carom::impulse::{Outcome, collision_impulse};
use exact::laws::{Result, STORED, beyond, bounce, leaves_range, misses, scale};
use exact::oracle::{Impulse, error};
use exact::rotation::matrix;
use exact::{Case, Exact, Format, Problem, Random, Worst, assert_share, cases_to_run, in_formats, random_case, sweep};
use num_rational::BigRational;

/// C of the bound, for a precision u of the kernel's intermediate numbers.
fn constant<S: Format>() -> f64 {
    S::precision() * if S::saturates() { 16.0 } else { 4.0 }
}

/// The exact impulse where the bodies approach.
fn rebound(problem: &Problem) -> (Impulse, Exact) {
    let numerator = problem.numerator();
    let numerator = if numerator.is_positive() { numerator } else { Exact::zero() };
    (problem.along_normal(&numerator), numerator)
}

fn formula_10<S: Format>() {
    let count = cases_to_run(20_000, 1_000_000);
    let mut random = Random::new(10);
    let [mut pure, mut impulse, mut linear, mut angular, mut plain] = [Worst::default(); 5];
    let [mut hits, mut saturated, mut tilted, mut immovable] = [0u64; 4];
    sweep(&S::name(), count, |i| {
        let case = random_case::<S>(&mut random);
        let problem = Problem::read(&case);
        let (k, scales) = (problem.denominator(), problem.scales());
        let tilt = scales.load / k.to_f64();

        // The impulse of (10) itself, for either sign.
        let numerator = problem.numerator();
        let j = numerator.ratio(&k).abs();
        let scale = scale(&problem, &scales, j) / k.to_f64();
        let pure_impulse = collision_impulse(&case.a, &case.b, &case.contact, case.restitution);
        let difference = error(pure_impulse, &numerator, &k);
        pure.see(beyond(difference, STORED * S::ulp(j), scale), i);
        if tilt < 32.0 {
            plain.see(beyond(difference, STORED * S::ulp(j), j.max(scale - tilt * j)), i);
        }

        // The collision, with the velocities.
        let (exact, normal) = rebound(&problem);
        let result = bounce(&case);
        let miss = misses(&problem, &result, &exact, &normal);
        impulse.see(miss.impulse, i);
        linear.see(miss.linear, i);
        angular.see(miss.angular, i);
        match result.impact.outcome {
            Outcome::Slid => hits += 1,
            Outcome::Separating => assert!((result.a, result.b) == (case.a, case.b), "case {i} was not left alone"),
            other => panic!("case {i} is {other:?}"),
        }
        if let Some(leaves) = leaves_range::<S>(&problem, &exact, &normal, constant::<S>()) {
            assert_eq!(result.impact.saturated, leaves, "case {i}: {case:?}");
        }
        saturated += u64::from(result.impact.saturated);
        tilted += u64::from(tilt > 100.0);
        immovable += u64::from(case.a.is_immovable() || case.b.is_immovable());
    });
    println!(
        "{}, {count} cases, {hits} approach, {saturated} leave the range\n  (10) {pure}\n  J    {impulse}\n  v    \
         {linear}\n  w    {angular}\n  (10) where L < 32 K, against max(|J|, (1 + e) s / K): {plain}",
        S::name()
    );
    assert_share("an approach", hits, count, 0.85);
    assert_share("results inside the range", hits - saturated, count, 0.3);
    assert_share("an arm along the normal", tilted, count, 0.05);
    assert_share("an immovable body", immovable, count, 0.1);
    let worst = pure.value.max(impulse.value).max(linear.value).max(angular.value);
    assert!(worst <= constant::<S>(), "{worst:e}");
    assert!(worst > constant::<S>() / 8.0, "the bound could be tighter: {worst:e}");
}

/// The oracle's arithmetic is right: formula (10) once more, letter by letter, in that of `num-rational`.
fn oracle_agrees_with_num_rational<S: Format>() {
    let mut random = Random::new(1);
    let cross = |a: &[BigRational; 3], b: &[BigRational; 3]| {
        [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
    };
    let dot = |a: &[BigRational; 3], b: &[BigRational; 3]| &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2];
    let number = |x: S| x.value().to_rational();
    for i in 0..60 {
        let case = random_case::<S>(&mut random);
        let contact = &case.contact;
        let n = contact.normal.get().to_array().map(|x| S::unit_value(x).to_rational());
        let (mut speed, mut denominator) = (number(S::ZERO), number(S::ZERO));
        for (body, arm, sign) in [(&case.a, contact.r_a, -1), (&case.b, contact.r_b, 1)] {
            let [v, w, r] = [body.linear_velocity, body.angular_velocity, arm].map(|v| v.to_array().map(number));
            let [xx, xy, xz, yy, yz, zz] = body.inv_inertia_world().map(|x| S::scaled_value(x).to_rational());
            let rows = [[xx, xy.clone(), xz.clone()], [xy, yy, yz.clone()], [xz, yz, zz]];
            let turn = cross(&r, &n);
            let turn = [dot(&rows[0], &turn), dot(&rows[1], &turn), dot(&rows[2], &turn)];
            denominator += S::scaled_value(body.inv_mass()).to_rational() + dot(&cross(&turn, &r), &n);
            let spin = cross(&w, &r);
            let point: [BigRational; 3] = std::array::from_fn(|i| &v[i] + &spin[i]);
            speed += dot(&point, &n) * BigRational::from_integer(sign.into());
        }
        let problem = Problem::read(&case);
        let j = -(number(S::from_ratio(1, 1).unwrap_or(S::ZERO)) + number(case.restitution)) * speed / &denominator;
        assert_eq!(problem.denominator().to_rational(), denominator, "case {i}");
        assert_eq!(problem.numerator().to_rational() / problem.denominator().to_rational(), j, "case {i}");
    }
}

/// The share of the approaching cases in which the bound shows a fault that was put into the result.
fn shown<S: Format>(fault: impl Fn(&Case<S>, &Problem, &mut Result<S>)) -> f64 {
    let mut random = Random::new(11);
    let [mut tried, mut caught] = [0u32; 2];
    for _ in 0..2_000 {
        let case = random_case::<S>(&mut random);
        let problem = Problem::read(&case);
        let mut result = bounce(&case);
        if result.impact.outcome != Outcome::Slid || result.impact.saturated {
            continue;
        }
        let (exact, normal) = rebound(&problem);
        assert!(misses(&problem, &result, &exact, &normal).largest() <= constant::<S>());
        fault(&case, &problem, &mut result);
        tried += 1;
        caught += u32::from(misses(&problem, &result, &exact, &normal).largest() > constant::<S>());
    }
    assert!(tried > 500);
    f64::from(caught) / f64::from(tried)
}

/// Faults that were put in on purpose, and that the sweep above sees.
fn deliberate_faults_are_seen<S: Format>() {
    let back = |before: Vec3<S>, after: Vec3<S>| before - (after - before);
    let flipped = shown::<S>(|case, _, result| {
        for (body, before) in [(&mut result.a, &case.a), (&mut result.b, &case.b)] {
            body.linear_velocity = back(before.linear_velocity, body.linear_velocity);
            body.angular_velocity = back(before.angular_velocity, body.angular_velocity);
        }
    });
    let torque_of_a_flipped = shown::<S>(|case, _, result| {
        result.a.angular_velocity = back(case.a.angular_velocity, result.a.angular_velocity);
    });
    // As a shift to the right cuts.
    let cut_off_instead_of_rounded = shown::<S>(|_, problem, result| {
        let (exact, _) = rebound(problem);
        for (body, v) in [&mut result.a, &mut result.b].into_iter().zip([0, 2]) {
            let after = &problem.after(&exact)[v];
            body.linear_velocity = Vec3::from_array(std::array::from_fn(|i| {
                let x = after.0[i].quotient(&exact.over);
                let ulp = S::ulp(x);
                S::nearest((x / ulp).floor() * ulp)
            }));
        }
    });
    let one_unit_and_a_half_off = shown::<S>(|_, _, result| {
        let x = result.b.linear_velocity.x.value().to_f64();
        result.b.linear_velocity.x = S::nearest(x + 1.5 * S::ulp(x));
    });
    let tensor_turned_the_wrong_way = shown::<S>(|case, _, result| {
        let mut wrong = *case;
        wrong.a.set_orientation(case.a.orientation().conjugate());
        wrong.b.set_orientation(case.b.orientation().conjugate());
        *result = bounce(&wrong);
    });
    let restitution_subtracted = shown::<S>(|case, _, result| {
        *result = bounce(&Case { restitution: case.restitution.negated(), ..*case });
    });
    let shares = [
        ("flipped", flipped, 0.9),
        ("torque of A flipped", torque_of_a_flipped, 0.3),
        // (In f64 the fault itself is computed from a number that is already rounded.)
        ("cut off", cut_off_instead_of_rounded, if S::precision() < 1e-15 { 0.0 } else { 0.15 }),
        ("1.5 units off", one_unit_and_a_half_off, 0.15),
        ("R^T I^-1 R", tensor_turned_the_wrong_way, 0.3),
        ("1 - e", restitution_subtracted, 0.3),
    ];
    println!("{}: share of cases that show a fault: {shares:.2?}", S::name());
    for (fault, share, least) in shares {
        assert!(share >= least, "{fault}: seen in {share} of the cases");
    }
}

/// The tensor in the world's frame is R I^-1 R^T of the one in the body's frame, within a few units of its 30 bits.
fn world_tensor<S: Format>() {
    let mut random = Random::new(12);
    let [mut worst, mut wrong_order] = [Worst::default(); 2];
    for i in 0..5_000 {
        let case = random_case::<S>(&mut random);
        let r = matrix(case.a.orientation().to_array().map(|c| S::unit_value(c).to_f64()));
        let full = |[xx, xy, xz, yy, yz, zz]: [f64; 6]| [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let local = full(case.a.inv_inertia_local().map(|x| S::scaled_value(x).to_f64()));
        let world = full(case.a.inv_inertia_world().map(|x| S::scaled_value(x).to_f64()));
        let trace = local[0][0] + local[1][1] + local[2][2];
        if trace == 0.0 {
            continue;
        }
        for (p, q) in (0..9).map(|k| (k / 3, k % 3)) {
            let turned = |r: &dyn Fn(usize, usize) -> f64| -> f64 {
                (0..9).map(|k| r(p, k / 3) * local[k / 3][k % 3] * r(q, k % 3)).sum()
            };
            worst.see((turned(&|i, j| r[i][j]) - world[p][q]).abs() / trace, i);
            wrong_order.see((turned(&|i, j| r[j][i]) - world[p][q]).abs() / trace, i);
        }
    }
    println!("{}: R I^-1 R^T, in units of the trace: {worst}", S::name());
    assert!(worst.value <= 16.0 * S::precision(), "{worst}");
    // The fault: R^T I^-1 R.
    assert!(wrong_order.value > 0.1);
}

in_formats!(all { formula_10 oracle_agrees_with_num_rational deliberate_faults_are_seen world_tensor });
