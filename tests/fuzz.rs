//! Arbitrary bits in every input: no panic, no wrap, and a report that tells the truth.
//!
//! More than a million cases in an ordinary run, shared by the formats; `CAROM_LONG=1` runs a hundred and twenty million,
//! twenty a format, in 40 minutes of two cores. Integer overflow and debug assertions panic in this profile, and a panic
//! fails the test.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/exact.rs"]
mod exact;

use std::cell::RefCell;

use carom::impulse::{
    Impact, Outcome, apply_impulse, collision_impulse, effective_mass, relative_velocity, resolve_collision,
    resolve_collision_with_friction,
};
use carom::{Body, Contact, MassProperties, Material, RestitutionLaw, Scaled, Solid, SymMat3, UnitVec3, Vec3};
use exact::cases::bits;
use exact::laws::{Result, leaves_range, misses};
use exact::strategy::forall;
use exact::words::{WORDS, Words};
use exact::{Case, Exact, Format, Problem, assert_share, cases_to_run, in_formats};
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;

#[derive(Default)]
struct Counts {
    applied: u64,
    refused: u64,
    exact: u64,
    saturated: u64,
    frictional: u64,
    /// Applied with a finite impulse, and still a velocity that was finite is no more
    overflowed: u64,
}

/// What must hold of any report, whatever went in.
///
/// `wild`: masses that no format leads to, such as 2^(2^20). Only they make fixed point give up.
fn report_is_true<S: Format>(
    case: &Case<S>,
    (a, b): (&Body<S>, &Body<S>),
    impact: &Impact<S>,
    wild: bool,
) -> TestCaseResult {
    match impact.outcome {
        Outcome::Stuck | Outcome::Slid => {
            let impulse = impact.normal_impulse;
            prop_assert!(impulse.is_finite() && impulse >= S::ZERO, "{impact:?} of {case:?}");
        }
        _ => {
            prop_assert_eq!([bits(a), bits(b)], [bits(&case.a), bits(&case.b)]);
            prop_assert_eq!(impact.normal_impulse, S::ZERO);
            prop_assert_eq!(impact.friction_impulse, Vec3::ZERO);
            prop_assert!(!impact.saturated);
        }
    }
    let always_finite = S::saturates() && !wild;
    prop_assert!(!always_finite || impact.outcome != Outcome::NotFinite, "fixed point is always finite");
    prop_assert!(S::saturates() || !impact.saturated);
    Ok(())
}

/// In fixed point every velocity is the exact one, clamped to the range, within the bound of `tests/exact.rs`. So is the
/// restitution, to 0 to 1.
fn nothing_wrapped<S: Format>(case: &Case<S>, result: &Result<S>, counts: &mut Counts) -> TestCaseResult {
    let restitution = if case.restitution > S::ONE { S::ONE } else { case.restitution };
    let restitution = if restitution < S::ZERO { S::ZERO } else { restitution };
    let problem = Problem::read(&Case { restitution, ..*case });
    let numerator = problem.numerator();
    let k = problem.denominator();
    if !k.is_positive() {
        return Ok(());
    }
    let numerator = if numerator.is_positive() { numerator } else { Exact::zero() };
    let exact = problem.along_normal(&numerator);
    let bound = 16.0 * S::precision();
    // An arm so nearly along the normal that no digit of K is left: its sign holds, its size does not.
    if bound * problem.scales().load > 0.25 * k.to_f64() {
        return Ok(());
    }
    let miss = misses(&problem, result, &exact, &numerator).largest();
    prop_assert!(miss <= bound, "off by {miss:e} of the scale: {case:?} {result:?}");
    if let Some(leaves) = leaves_range::<S>(&problem, &exact, &numerator, bound) {
        prop_assert_eq!(result.impact.saturated, leaves);
    }
    counts.exact += 1;
    counts.saturated += u64::from(result.impact.saturated);
    Ok(())
}

fn one_case<S: Format>(words: &[u64], counts: &mut Counts) -> TestCaseResult {
    let mut words = Words(words.iter());
    let kind = words.next();
    let wild = kind & 15 == 0;
    let normal = match UnitVec3::new(Vec3::new(words.unit::<S>(), words.unit::<S>(), words.unit::<S>())) {
        Ok(normal) => normal,
        Err(_) => UnitVec3::normalize(words.vector::<S>()).unwrap_or(UnitVec3::X),
    };
    let n = normal.get().to_array().map(|x| S::unit_value(x).to_f64());
    let square = n.iter().map(|x| x * x).sum::<f64>();
    prop_assert!((square - 1.0).abs() < 1.6e-5, "not of unit length: {normal:?}");
    let (a, b) = (words.body::<S>(wild), words.body::<S>(wild));
    let contact = Contact { normal, r_a: words.vector(), r_b: words.vector() };
    let (restitution, friction) = (words.number::<S>(), words.number::<S>());
    let case = Case { a, b, contact, restitution, friction };
    let finite = |body: &Body<S>| body.linear_velocity.is_finite() && body.angular_velocity.is_finite();

    let _ = relative_velocity(&a, &b, &contact);
    let _ = effective_mass(&a, &b, &contact, normal);
    prop_assert!(collision_impulse(&a, &b, &contact, restitution).is_finite());
    let (mut x, mut y) = (a, b);
    let _ = apply_impulse(&mut x, &mut y, &contact, words.number::<S>());

    let (mut x, mut y) = (a, b);
    let impact = resolve_collision(&mut x, &mut y, &contact, restitution);
    report_is_true(&case, (&x, &y), &impact, wild)?;
    let applied = matches!(impact.outcome, Outcome::Slid);
    counts.applied += u64::from(applied);
    counts.refused += u64::from(!applied);
    counts.overflowed += u64::from(applied && finite(&a) && finite(&b) && !(finite(&x) && finite(&y)));
    if S::saturates() && !wild && kind >> 4 & 15 == 0 {
        nothing_wrapped(&case, &Result { a: x, b: y, impact }, counts)?;
    }

    // Any restitution and friction are either refused or right.
    let material = Material::new(restitution, friction);
    let in_range =
        restitution >= S::ZERO && restitution.value_or_nan() <= 1.0 && friction >= S::ZERO && friction.is_finite();
    prop_assert_eq!(material.is_ok(), in_range);
    let ordinary = Material::new(S::ZERO, S::nearest(0.5)).expect("a material");
    for law in [RestitutionLaw::Newton, RestitutionLaw::EnergySafe] {
        let (mut x, mut y) = (a, b);
        let material = material.unwrap_or(ordinary).with_law(law);
        let impact = resolve_collision_with_friction(&mut x, &mut y, &contact, &material);
        report_is_true(&case, (&x, &y), &impact, wild)?;
        counts.frictional += u64::from(matches!(impact.outcome, Outcome::Stuck | Outcome::Slid));
    }
    constructors::<S>(&mut words)
}

/// Any bits into the constructors: a value, or a named error, and a value only where the input is one.
fn constructors<S: Format>(words: &mut Words<'_>) -> TestCaseResult {
    let (mass, size) = (words.number::<S>(), words.vector::<S>());
    let positive = |x: S| x.is_finite() && x > S::ZERO;
    for (solid, valid) in [
        (Solid::sphere(size.x), positive(size.x)),
        (Solid::cuboid(size), positive(size.x) && positive(size.y) && positive(size.z)),
        (Solid::capsule(size.x, size.y), positive(size.x) && (positive(size.y) || size.y == S::ZERO)),
        (Solid::cone(size.x, size.y), positive(size.x) && positive(size.y)),
    ] {
        // A float may refuse what is valid: where the volume or a moment leaves its range.
        let refusable = !S::saturates() && !size.to_array().iter().all(|&x| is_moderate(x));
        let expected = solid.is_ok() == valid || (refusable && solid.is_err());
        prop_assert!(expected, "valid: {valid}");
        if let Ok(properties) = solid.map_err(|_| ()).and_then(|solid| solid.with_mass(mass).map_err(|_| ())) {
            prop_assert!(positive(mass));
            let body = Body::dynamic(properties);
            prop_assert!(body.inv_mass() > S::Scaled::ZERO && body.inv_mass().is_finite());
            prop_assert!(body.inv_inertia_world().iter().all(|x| x.is_finite()));
            let [x, _, _, y, _, z] = body.inv_inertia_local();
            let turns = [x, y, z].into_iter().all(|x| x > S::Scaled::ZERO);
            prop_assert!(S::saturates() || turns, "the rotation is locked");
        }
    }
    let tensor = SymMat3 {
        xx: words.number(),
        xy: words.number(),
        xz: words.number(),
        yy: words.number(),
        yz: words.number(),
        zz: words.number(),
    };
    if MassProperties::new(mass, tensor).is_ok() {
        prop_assert!(positive(mass) && positive(tensor.xx) && positive(tensor.yy) && positive(tensor.zz));
    }
    let (word, other) = (words.next(), words.next());
    let (numerator, denominator) = (word as u32 as i32, (word >> 32) as i32);
    if let Ok(ratio) = S::from_ratio(numerator, denominator) {
        prop_assert!(denominator != 0 && ratio.is_finite());
    }
    if let Ok(h) = S::sub_step(numerator, denominator) {
        let mut remainder = S::Remainder::default();
        let _ = S::from_raw(other).advance(size.x, h, &mut remainder);
    }
    Ok(())
}

/// So far from the ends of a float's range that a fourth power stays within it.
fn is_moderate<S: Format>(x: S) -> bool {
    let (size, end) = (x.value_or_nan().abs(), S::largest().sqrt().sqrt() / 8.0);
    size < end && size > 1.0 / end
}

trait ValueOrNan {
    fn value_or_nan(self) -> f64;
}

impl<S: Format> ValueOrNan for S {
    fn value_or_nan(self) -> f64 {
        if self.is_finite() { self.value().to_f64() } else { f64::NAN }
    }
}

fn arbitrary_bits<S: Format>() {
    let count = cases_to_run(200_000, 20_000_000);
    let counts = RefCell::new(Counts::default());
    let done = RefCell::new(0u64);
    forall(count as u32, proptest::collection::vec(any::<u64>(), WORDS), |words| {
        let mut done = done.borrow_mut();
        *done += 1;
        if (*done).is_multiple_of(1_000_000) {
            eprintln!("{}: {} of {} million", S::name(), *done / 1_000_000, count / 1_000_000);
        }
        one_case::<S>(&words, &mut counts.borrow_mut())
    });
    let counts = counts.into_inner();
    println!(
        "{}: {count} cases, {} applied, {} refused, {} against exact arithmetic ({} of them saturated), {} with friction; \
         a velocity left the range of the float in {}",
        S::name(),
        counts.applied,
        counts.refused,
        counts.exact,
        counts.saturated,
        counts.frictional,
        counts.overflowed
    );
    assert_share("an impulse", counts.applied, count, 0.05);
    assert_share("no impulse", counts.refused, count, 0.05);
    assert_share("friction", counts.frictional, 2 * count, 0.05);
    if S::saturates() {
        assert_share("an exact comparison", counts.exact, count, 1.0 / 32.0);
        assert_share("saturation", counts.saturated, counts.exact, 0.1);
    }
}

/// The checks refuse what they are there to refuse: a wrapped velocity, a changed body that is called untouched.
fn faults_are_seen<S: Format>() {
    let seen = RefCell::new([0u32; 2]);
    forall(2_000, proptest::collection::vec(any::<u64>(), WORDS), |words| {
        let mut words = Words(words.iter());
        let (a, b) = (words.body::<S>(false), words.body::<S>(false));
        let contact = Contact { normal: UnitVec3::X, r_a: words.vector(), r_b: words.vector() };
        let case = Case { a, b, contact, restitution: S::ZERO, friction: S::ZERO };
        let (mut x, mut y) = (a, b);
        let impact = resolve_collision(&mut x, &mut y, &contact, S::ZERO);
        let mut seen = seen.borrow_mut();
        if impact.outcome == Outcome::Separating {
            x.linear_velocity.y = S::from_raw(x.linear_velocity.y.raw() ^ 1);
            seen[0] += u32::from(report_is_true(&case, (&x, &y), &impact, false).is_err());
        } else if impact.saturated {
            // As a sum that wraps has it: the other end of the range.
            let flip = |v: Vec3<S>| Vec3 { x: S::from_raw(v.x.raw() ^ 1 << 31), ..v };
            let mut counts = Counts::default();
            x.linear_velocity = flip(x.linear_velocity);
            let wrapped = Result { a: x, b: y, impact };
            seen[1] += u32::from(nothing_wrapped(&case, &wrapped, &mut counts).is_err());
        }
        Ok(())
    });
    let seen = seen.into_inner();
    println!("{}: {} touched bodies and {} wraps seen", S::name(), seen[0], seen[1]);
    assert!(seen[0] > 200);
    assert!(!S::saturates() || seen[1] > 100);
}

in_formats!(usual { arbitrary_bits faults_are_seen });

/// Found by the fuzzer: needles struck on the tip, with inverse moments 2^38 times the inverse masses. Rounding leaves the
/// turned tensor of A with a negative eigenvalue, and K would be negative: the bodies would pull each other.
#[cfg(feature = "fixed")]
#[test]
fn struck_needles_push() {
    use carom::{Quat, Scaled32};
    use fixed::types::{I2F30, I8F24};

    let unit = |bits| I2F30::from_bits(bits);
    let vector = |x: f64, y: f64, z: f64| Vec3::new(I8F24::from_num(x), I8F24::from_num(y), I8F24::from_num(z));
    let body = |inv_mass, moments: [i32; 3], exponent, [w, x, y, z]: [i32; 4]| {
        let mass = MassProperties::from_inverses(inv_mass, moments.map(|m| Scaled32::from_parts(m, exponent - 30)));
        let mut body = Body::<I8F24>::dynamic(mass.expect("a body"));
        body.set_orientation(Quat::new(unit(w), unit(x), unit(y), unit(z)).expect("a rotation"));
        body
    };
    let turned_a = [1_073_732_814, -2_796_058, -3_395_009, -36_470];
    let turned_b = [1_063_975_504, -1_525_355, -144_459_151, -2_618_675];
    let a = body(Scaled32::from_parts(688_305_918, -25), [0, 268_420_707, 14_749], 44, turned_a);
    let mut b = body(Scaled32::from_parts(1_070_992_512, -7), [24, 347_067_640, 8], 27, turned_b);
    b.linear_velocity = vector(0.0, 0.0, -16.0);
    b.angular_velocity = vector(-64.0, 0.0, 0.0);
    let normal = Vec3::new(unit(-2_338_565), unit(-8_852_398), unit(1_073_702_785));
    let contact = Contact {
        normal: UnitVec3::new(normal).expect("a direction"),
        r_a: vector(0.0, -87.11675817, -3.0297144),
        r_b: vector(-0.0007195, -0.2499156, -0.0102186),
    };
    let problem = Problem::read(&Case { a, b, contact, restitution: I8F24::ZERO, friction: I8F24::ZERO });
    assert!(problem.approach().is_negative() && problem.denominator().is_negative(), "no longer the case it was");

    assert!(effective_mass(&a, &b, &contact, contact.normal) > I8F24::ZERO);
    let (mut x, mut y) = (a, b);
    assert_eq!(resolve_collision(&mut x, &mut y, &contact, I8F24::ZERO).outcome, Outcome::Slid);
    for friction in [I8F24::ZERO, I8F24::from_num(0.5)] {
        let (mut x, mut y) = (a, b);
        let material = Material::new(I8F24::ZERO, friction).expect("a material");
        let impact = resolve_collision_with_friction(&mut x, &mut y, &contact, &material);
        assert!(impact.normal_impulse >= I8F24::ZERO, "{impact:?}");
    }
}

/// Found by the fuzzer: under the safe law, a rebound so faint, on bodies so light, that the line from the impulse without it
/// to the one with it is made of rounding. The impulse must not leave the line.
#[cfg(feature = "micromath")]
#[test]
fn faint_rebounds_push() {
    use carom::Quat;
    use micromath::F32;

    let vector = |x, y, z| Vec3::new(F32(x), F32(y), F32(z));
    let body = |inv_mass, moments: [f32; 3], [w, x, y, z]: [f32; 4], spin| {
        let mass = MassProperties::from_inverses(F32(inv_mass), moments.map(F32)).expect("a body");
        let mut body = Body::<F32>::dynamic(mass);
        body.set_orientation(Quat::new(F32(w), F32(x), F32(y), F32(z)).expect("a rotation"));
        body.angular_velocity = vector(0.0, spin, 0.0);
        body
    };
    let turned = [0.0, -1.0, 0.0, -9.2542976e-8];
    let a = body(3.9412005e17, [7.135292e13, 1631706.0, 7.808108e25], turned, -1308039.9);
    let b = body(2.0199185e22, [0.0, 9.3075505e14, 0.0], [1.0, 0.0, 0.0, 0.0], 1.6344541e15);
    let contact = Contact {
        normal: UnitVec3::new(vector(0.0, 0.0, 0.99999994)).expect("a direction"),
        r_a: vector(-52536.23, 34215.703, 0.0),
        r_b: vector(795.3946, 0.0, -5.5097656),
    };
    let material =
        Material::new(F32(5.960465e-8), F32(0.08554439)).expect("a material").with_law(RestitutionLaw::EnergySafe);
    let (mut x, mut y) = (a, b);
    let impact = resolve_collision_with_friction(&mut x, &mut y, &contact, &material);
    println!("{impact:?}");
    assert!(impact.normal_impulse.0 >= 0.0, "{impact:?}");
}
