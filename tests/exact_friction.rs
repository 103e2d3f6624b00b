//! Impacts with friction, against the contact law in exact arithmetic.
//!
//! What a result misses of the law is measured against the speed L |J| + (1 + e) s of `support/laws.rs`: Newton's
//! v_n' = -e v_n; v_t' = 0 where the points stick; friction at its limit and against v_t' where they slide; and, where
//! they stick, the impulse itself against the exact solution of the system of three equations.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/exact.rs"]
mod exact;

use carom::impulse::{Impact, Outcome};
use carom::{RestitutionLaw, Vec3};
use exact::laws::{FrictionMisses, REPORTED, Result, beyond, friction_misses, rub, scale};
use exact::oracle::{Impulse, read_vector};
use exact::{
    Case, Exact, Format, Problem, Random, Vector, Worst, assert_share, cases_to_run, in_formats, random_case, sweep,
};

/// The bounds, in units of the precision of the kernel's intermediate numbers.
struct Bounds {
    /// v_n' + e v_n
    rebound: f64,
    /// The same where friction presses the bodies together and more than doubles the normal impulse
    jammed_rebound: f64,
    /// The velocities against the impulse
    applied: f64,
    /// v_t' where the points stick
    stick: f64,
    /// The direction where they slide
    against: f64,
    /// |J_t| - mu J_n, of |J|
    cone: f64,
    /// (1/m_a + 1/m_b) |dJ| where they stick
    impulse: f64,
}

fn bounds<S: Format>() -> Bounds {
    if S::saturates() {
        let (rebound, jammed_rebound) = (32.0, 64.0);
        Bounds { rebound, jammed_rebound, applied: 64.0, stick: 64.0, against: 1024.0, cone: 8.0, impulse: 8.0 }
    } else {
        // micromath's square root is good to 1e-5 only, and |J_t| with it.
        let cone = if S::name() == "micromath" { 64.0 } else { 2.0 };
        let (rebound, jammed_rebound) = (4.0, 8.0);
        Bounds { rebound, jammed_rebound, applied: 2.0, stick: 4.0, against: 256.0, cone, impulse: 4.0 }
    }
}

/// Each of the misses over its bound.
fn over_bounds<S: Format>(misses: &FrictionMisses) -> f64 {
    let limit = bounds::<S>();
    let rebound = if misses.gain < 2.0 { limit.rebound } else { limit.jammed_rebound };
    let ratios = [
        misses.rebound / rebound,
        misses.applied / limit.applied,
        misses.stick / limit.stick,
        misses.against / limit.against,
        misses.cone / limit.cone,
    ];
    ratios.into_iter().fold(0.0, f64::max) / S::precision()
}

fn hold<S: Format>(misses: &FrictionMisses) -> bool {
    over_bounds::<S>(misses) <= 1.0
}

fn contact_law<S: Format>() {
    let count = cases_to_run(20_000, 1_000_000);
    let mut random = Random::new(20);
    let [mut rebound, mut jammed, mut applied, mut stick, mut against, mut cone, mut impulse, mut over] =
        [Worst::default(); 8];
    let [mut stuck, mut slid, mut left_out, mut rough] = [0u64; 4];
    sweep(&S::name(), count, |i| {
        let case = random_case::<S>(&mut random);
        let problem = Problem::read(&case);
        let result = rub(&case, RestitutionLaw::Newton);
        match result.impact.outcome {
            // Where the end of the range was met, the law does not hold.
            Outcome::Stuck | Outcome::Slid if result.impact.saturated => return left_out += 1,
            Outcome::Stuck => stuck += 1,
            Outcome::Slid => slid += 1,
            Outcome::Separating => return assert!((result.a, result.b) == (case.a, case.b)),
            other => panic!("case {i} is {other:?}"),
        }
        let miss = friction_misses(&problem, &result);
        if miss.gain < 2.0 {
            rebound.see(miss.rebound, i)
        } else {
            jammed.see(miss.rebound, i)
        }
        over.see(over_bounds::<S>(&miss), i);
        applied.see(miss.applied, i);
        stick.see(miss.stick, i);
        against.see(miss.against, i);
        cone.see(miss.cone, i);
        rough += u64::from(miss.against > 16.0 * S::precision());
        if result.impact.outcome == Outcome::Stuck {
            impulse.see(impulse_miss(&problem, &result), i);
        }
    });
    println!(
        "{}, {count} cases: {stuck} stick, {slid} slide, {left_out} leave the range\n  v_n' = -e v_n      {rebound}\n  \
         the same, jammed   {jammed}\n  velocities of J    {applied}\n  v_t' = 0           {stick}\n  J_t against v_t'   {against}; above 16 u: {rough}\n  \
         |J_t| = mu J_n     {cone}\n  J where they stick {impulse}",
        S::name()
    );
    assert_share("sticking", stuck, count, 0.05);
    assert_share("sliding", slid, count, 0.2);
    assert!(over.value <= 1.0, "{over} of a bound");
    assert!(impulse.value <= bounds::<S>().impulse * S::precision(), "{impulse}");
    // None of the bounds could be tighter by far (the one of the direction depends on the seed).
    let loose = [(rebound, bounds::<S>().rebound), (stick, bounds::<S>().stick), (impulse, bounds::<S>().impulse)];
    for (worst, bound) in loose {
        assert!(worst.value > bound * S::precision() / 16.0, "the bound could be tighter: {worst}");
    }
}

/// (1/m_a + 1/m_b) |dJ| against the exact solution where the points stick, in units of the scale.
fn impulse_miss<S: Format>(problem: &Problem, result: &Result<S>) -> f64 {
    let exact = problem.sticking_impulse();
    let reported =
        &problem.normal.times(&result.impact.normal_impulse.value()) + &read_vector(result.impact.friction_impulse);
    let over = exact.over.to_f64();
    let difference = (&reported.times(&exact.over) - &exact.vector).length() / over;
    let size = exact.vector.length() / over;
    let scales = problem.scales();
    let off_unit = 2.0 * (problem.normal.dot(&problem.normal) - Exact::one()).to_f64().abs();
    let scale = scale(problem, &scales, size) / scales.inv_mass;
    beyond(difference, REPORTED * S::ulp(size) + off_unit * scale, scale)
}

/// A result made of a given impulse, stored as well as the format can.
fn stored<S: Format>(case: &Case<S>, problem: &Problem, impulse: &Impulse, outcome: Outcome) -> Result<S> {
    let vector =
        |v: &Vector, over: &Exact| Vec3::from_array(std::array::from_fn(|i| S::nearest(v.0[i].quotient(over))));
    let [v_a, w_a, v_b, w_b] = problem.after(impulse).map(|v| vector(&v, &impulse.over));
    let (mut a, mut b) = (case.a, case.b);
    (a.linear_velocity, a.angular_velocity, b.linear_velocity, b.angular_velocity) = (v_a, w_a, v_b, w_b);
    let n = &problem.normal;
    let normal = impulse.vector.dot(n);
    // Divided by n . n, so that a normal off unit length splits the impulse into the same two parts.
    let square = n.dot(n);
    let across = &impulse.vector.times(&square) - &n.times(&normal);
    let impact = Impact {
        outcome,
        normal_impulse: S::nearest(normal.quotient(&(&impulse.over * &square))),
        friction_impulse: vector(&across, &(&impulse.over * &square)),
        saturated: false,
    };
    Result { a, b, impact }
}

/// A float as an exact vector.
fn exact_vector(v: [f64; 3]) -> Vector {
    Vector(v.map(Exact::from_f64))
}

/// The share of the sliding cases in which the law shows that the impulse is wrong: `fault` makes one from the tangential
/// velocity before the impact and the frictionless impulse.
fn shown<S: Format>(fault: impl Fn(&Case<S>, &Problem, &Result<S>) -> Option<[f64; 3]>) -> f64 {
    let mut random = Random::new(21);
    let [mut tried, mut caught] = [0u32; 2];
    for _ in 0..3_000 {
        let case = random_case::<S>(&mut random);
        let problem = Problem::read(&case);
        let result = rub(&case, RestitutionLaw::Newton);
        if result.impact.outcome != Outcome::Slid || result.impact.saturated || problem.friction.is_zero() {
            continue;
        }
        let Some(impulse) = fault(&case, &problem, &result) else { continue };
        let impulse = Impulse { vector: exact_vector(impulse), over: Exact::one() };
        tried += 1;
        caught += u32::from(!hold::<S>(&friction_misses(&problem, &stored(&case, &problem, &impulse, Outcome::Slid))));
    }
    assert!(tried > 300, "{tried}");
    f64::from(caught) / f64::from(tried)
}

fn deliberate_faults_are_seen<S: Format>() {
    let float = |v: &Vector| v.to_f64();
    let sticking = |problem: &Problem| {
        let exact = problem.sticking_impulse();
        let over = exact.over.to_f64();
        exact.vector.to_f64().map(|x| x / over)
    };
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let reported = |problem: &Problem, result: &Result<S>| {
        let n = problem.normal.times(&result.impact.normal_impulse.value());
        (float(&n), float(&read_vector(result.impact.friction_impulse)))
    };
    let add = |a: [f64; 3], b: [f64; 3], k: f64| [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];

    // Friction the wrong way round.
    let backwards = shown::<S>(|_, problem, result| {
        let (n, t) = reported(problem, result);
        Some(add(n, t, -1.0))
    });
    // The sticking impulse, clamped to the cone axis by axis: a box for the disc.
    let per_axis = shown::<S>(|case, problem, _| {
        let (n, j) = (float(&problem.normal), sticking(problem));
        let normal = dot(j, n);
        let limit = problem.friction.to_f64() * normal.max(0.0);
        let (t1, t2) = case.contact.normal.tangents();
        let mut impulse = n.map(|x| x * normal);
        for t in [t1, t2].map(|t| t.get().to_array().map(|x| S::unit_value(x).to_f64())) {
            impulse = add(impulse, t, dot(j, t).clamp(-limit, limit));
        }
        (normal > 0.0).then_some(impulse)
    });
    // The sticking impulse, shortened to the disc: the direction and v_n' are off.
    let radially = shown::<S>(|_, problem, _| {
        let (n, j) = (float(&problem.normal), sticking(problem));
        let normal = dot(j, n);
        let across = add(j, n, -normal);
        let length = dot(across, across).sqrt();
        let limit = problem.friction.to_f64() * normal;
        (normal > 0.0 && length > limit).then(|| add(n.map(|x| x * normal), across, limit / length))
    });
    // Against the sliding before the impact instead of after it, with v_n' = -e v_n kept.
    let before = shown::<S>(|_, problem, _| {
        let (n, v) = (float(&problem.normal), float(&problem.relative_velocity()));
        let across = add(v, n, -dot(v, n));
        let length = dot(across, across).sqrt();
        let mu = problem.friction.to_f64();
        let direction = add(n, across, -mu / length);
        let yields = dot(float(&problem.yields_to(&exact_vector(direction))), n);
        let j = problem.numerator().to_f64() / yields;
        (length > 0.0 && j > 0.0).then(|| direction.map(|x| x * j))
    });
    // One part in a thousand too much friction.
    let strong = shown::<S>(|_, problem, result| {
        let (n, t) = reported(problem, result);
        Some(add(n, t, 1.001))
    });
    let shares = [
        ("friction backwards", backwards, 0.8),
        ("clamped axis by axis", per_axis, 0.3),
        ("clamped radially", radially, 0.3),
        ("against the sliding before", before, 0.2),
        ("0.1 % too strong", strong, 0.5),
    ];
    println!("{}: share of cases that show a fault: {shares:.2?}", S::name());
    for (fault, share, least) in shares {
        assert!(share >= least, "{fault}: seen in {share} of the cases");
    }
}

/// The check itself accepts the exact sticking impulse, and refuses it with the wrong sign.
fn faults_in_sticking_are_seen<S: Format>() {
    let mut random = Random::new(22);
    let [mut tried, mut flipped, mut named] = [0u32; 3];
    for _ in 0..3_000 {
        let case = random_case::<S>(&mut random);
        let problem = Problem::read(&case);
        let result = rub(&case, RestitutionLaw::Newton);
        if result.impact.outcome != Outcome::Stuck || result.impact.saturated {
            continue;
        }
        tried += 1;
        let exact = problem.sticking_impulse();
        let right = stored(&case, &problem, &exact, Outcome::Stuck);
        let miss = friction_misses(&problem, &right);
        assert!(hold::<S>(&miss), "the exact impulse is refused: {miss:?} {case:?}");
        let wrong = Impulse { vector: -&exact.vector, over: exact.over.clone() };
        let wrong = stored(&case, &problem, &wrong, Outcome::Stuck);
        flipped += u32::from(!hold::<S>(&friction_misses(&problem, &wrong)));
        // Sticking where the law says sliding: without friction the points do not stick.
        let numerator = problem.numerator();
        let frictionless = stored(&case, &problem, &problem.along_normal(&numerator), Outcome::Stuck);
        named += u32::from(!hold::<S>(&friction_misses(&problem, &frictionless)));
    }
    println!("{}: of {tried} sticking, {flipped} show a wrong sign, {named} a wrong outcome", S::name());
    assert!(tried > 100);
    assert!(f64::from(flipped) > 0.8 * f64::from(tried));
    assert!(f64::from(named) > 0.3 * f64::from(tried));
}

in_formats!(all { contact_law deliberate_faults_are_seen faults_in_sticking_are_seen });
