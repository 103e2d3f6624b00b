//! Impulses, forces and torques on bodies against the formulas in exact numbers, over the bits that the body was given.
//!
//! A component of a velocity is within half a unit of its last place and a 2^-17th of one, and its share of the precision u:
//!
//! ```text
//! |dv| <= C u |J|/m            |dw| <= C u |I^-1| (|L| + |r||J|)        (the trace for the norm)
//! ```
//!
//! in floating point with |v| and |w| beside these.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/exact.rs"]
mod exact;

use carom::impulse;
use carom::{Body, Contact, Scalar, Scaled, UnitVec3, Vec3};
use exact::oracle::{Side, error, read_vector};
use exact::{Exact, Format, Random, Vector, Worst, assert_share, cases_to_run, in_formats, random_case, sweep};

/// C of the bound.
fn constant<S: Format>() -> f64 {
    if S::saturates() { 8.0 } else { 3.0 }
}

/// The units of the last place within which a velocity is.
fn stored<S: Format>() -> f64 {
    if S::saturates() { 0.5 + 2f64.powi(-17) } else { 0.5 }
}

#[derive(Clone, Copy, Debug)]
enum Push {
    Impulse,
    ImpulseAt,
    AngularImpulse,
    Force,
    ForceAt,
    Torque,
}

const PUSHES: [Push; 6] =
    [Push::Impulse, Push::ImpulseAt, Push::AngularImpulse, Push::Force, Push::ForceAt, Push::Torque];

/// A push on a body: a vector, the arm at which it acts, and for how long.
#[derive(Clone, Copy, Debug)]
struct Case<S: Scalar> {
    body: Body<S>,
    push: Push,
    amount: Vec3<S>,
    r: Vec3<S>,
    seconds: S::Scaled,
}

impl<S: Format> Case<S> {
    /// Bodies and arms as the kernel is tried on, and amounts that in most cases leave velocities within the range.
    fn random(random: &mut Random, push: Push) -> Self {
        let impact = random_case::<S>(random);
        let (body, r) = (impact.a, impact.contact.r_a);
        let seconds = S::nearest_scaled(random.spread(1e-4, 2.0));
        let (low, high) = S::magnitudes();
        let side = Side::read(&body, r);
        let (yields, t) = (side.inv_mass.to_f64().max(2f64.powi(-20)), S::scaled_value(seconds).to_f64());
        let turns = side.inv_inertia.trace().to_f64().max(2f64.powi(-20));
        let reach = match push {
            Push::Impulse => yields,
            Push::Force => yields * t,
            Push::AngularImpulse => turns,
            Push::Torque => turns * t,
            Push::ImpulseAt => yields.max(turns * side.arm.length()),
            Push::ForceAt => yields.max(turns * side.arm.length()) * t,
        };
        let most = if random.one_in(8) { high } else { (high / reach).clamp(low, high) };
        let (direction, amount) = (random.direction(), random.spread(low, most * 1.0001));
        Self { body, push, amount: Vec3::from_array(direction.map(|x| S::nearest(x * amount * 0.99))), r, seconds }
    }

    fn apply_to(&self, body: &mut Body<S>) -> bool {
        let Self { amount, r, seconds, .. } = *self;
        match self.push {
            Push::Impulse => body.apply_impulse(amount),
            Push::ImpulseAt => body.apply_impulse_at(amount, r),
            Push::AngularImpulse => body.apply_angular_impulse(amount),
            Push::Force => body.apply_force(amount, seconds),
            Push::ForceAt => body.apply_force_at(amount, r, seconds),
            Push::Torque => body.apply_torque(amount, seconds),
        }
    }

    fn after(&self) -> (Body<S>, bool) {
        let mut body = self.body;
        let met = self.apply_to(&mut body);
        (body, met)
    }

    /// The exact impulse and angular impulse, and |L| + |r||J|.
    fn exact(&self) -> (Vector, Vector, f64) {
        let time = match self.push {
            Push::Impulse | Push::ImpulseAt | Push::AngularImpulse => Exact::one(),
            Push::Force | Push::ForceAt | Push::Torque => S::scaled_value(self.seconds),
        };
        let (amount, arm) = (read_vector(self.amount).times(&time), read_vector(self.r));
        match self.push {
            Push::Impulse | Push::Force => (amount, Vector::zero(), 0.0),
            Push::ImpulseAt | Push::ForceAt => {
                let (angular, size) = (arm.cross(&amount), arm.length() * amount.length());
                (amount, angular, size)
            }
            Push::AngularImpulse | Push::Torque => {
                let size = amount.length();
                (Vector::zero(), amount, size)
            }
        }
    }

    /// The exact velocities, and the sizes that go with u.
    fn velocities(&self) -> ([Vector; 2], [f64; 2]) {
        let side = Side::read(&self.body, self.r);
        let (linear, angular, size) = self.exact();
        let (v, w) = (&side.v + &linear.times(&side.inv_mass), &side.w + &side.inv_inertia.times(&angular));
        let own = if S::saturates() { 0.0 } else { 1.0 };
        let sizes = [
            linear.length() * side.inv_mass.to_f64() + own * side.v.length(),
            side.inv_inertia.trace().to_f64() * size + own * side.w.length(),
        ];
        ([v, w], sizes)
    }

    /// The largest miss of a body's velocities, in units of u.
    fn misses(&self, body: &Body<S>) -> f64 {
        let (exact, sizes) = self.velocities();
        let found = [body.linear_velocity, body.angular_velocity];
        let mut worst = 0f64;
        for ((exact, size), found) in exact.iter().zip(sizes).zip(found) {
            for (exact, found) in exact.0.iter().zip(found.to_array()) {
                let off = error(found, exact, &Exact::one()) - stored::<S>() * S::ulp(exact.to_f64());
                if off > 0.0 {
                    worst = worst.max(off / (size * S::precision()));
                }
            }
        }
        worst
    }

    /// Whether a velocity leaves the range; `None` where it comes too near to its end to tell.
    fn leaves_range(&self) -> Option<bool> {
        let (exact, sizes) = self.velocities();
        let mut leaves = Some(false);
        for (exact, size) in exact.iter().zip(sizes) {
            let allowed = S::ulp(0.0) + constant::<S>() * S::precision() * size;
            for x in exact.to_f64() {
                let beyond = x.abs() - S::largest();
                if beyond.abs() <= 2.0 * allowed {
                    leaves = leaves.filter(|leaves| *leaves);
                } else if beyond > 0.0 {
                    leaves = Some(true);
                }
            }
        }
        leaves
    }
}

/// Every push on random bodies, in every orientation, against the exact velocities.
fn velocities<S: Format>() {
    let count = cases_to_run(3_000, 200_000);
    let mut random = Random::new(60);
    for push in PUSHES {
        let mut worst = Worst::default();
        let [mut moved, mut saturated, mut immovable] = [0u64; 3];
        sweep(&S::name(), count, |i| {
            let case = Case::<S>::random(&mut random, push);
            let (body, met) = case.after();
            worst.see(case.misses(&body), i);
            if let (true, Some(leaves)) = (S::saturates(), case.leaves_range()) {
                assert_eq!(met, leaves, "{push:?}, case {i}: {case:?}");
            }
            let same = (body.position, body.orientation(), body.inv_inertia_world(), body.gravity_scale)
                == (
                    case.body.position,
                    case.body.orientation(),
                    case.body.inv_inertia_world(),
                    case.body.gravity_scale,
                );
            assert!(same, "{push:?}, case {i}: more than velocities has changed");
            if case.body.is_immovable() {
                assert!(body == case.body && !met, "{push:?}, case {i}: an immovable body");
            }
            let before = (case.body.linear_velocity, case.body.angular_velocity);
            moved += u64::from(before != (body.linear_velocity, body.angular_velocity));
            saturated += u64::from(met);
            immovable += u64::from(case.body.is_immovable());
        });
        println!("{} {push:?}: {count} cases, {moved} moved, {saturated} at the end of the range: {worst}", S::name());
        assert_share("a change", moved, count, 0.4);
        assert_share("an immovable body", immovable, count, 0.03);
        if S::saturates() {
            assert_share("the end of the range", saturated, count, 0.005);
            assert_share("results inside the range", count - saturated, count, 0.5);
        }
        assert!(worst.value <= constant::<S>(), "{push:?}: {worst}");
    }
}

/// Faults that were put in on purpose, and that the sweep above sees.
fn deliberate_faults_are_seen<S: Format>() {
    let share = |push: Push, fault: &dyn Fn(&Case<S>) -> Body<S>| {
        let mut random = Random::new(61);
        let [mut tried, mut seen] = [0u32; 2];
        for _ in 0..1_000 {
            let case = Case::<S>::random(&mut random, push);
            let (body, met) = case.after();
            if met || case.body.is_immovable() {
                continue;
            }
            assert!(case.misses(&body) <= constant::<S>());
            tried += 1;
            seen += u32::from(case.misses(&fault(&case)) > constant::<S>());
        }
        assert!(tried > 300, "{push:?}: {tried}");
        f64::from(seen) / f64::from(tried)
    };
    for push in PUSHES {
        let opposite = share(push, &|case| Case { amount: -case.amount, ..*case }.after().0);
        assert!(opposite > 0.35, "{push:?}, opposite: {opposite}");
    }
    for push in [Push::ImpulseAt, Push::ForceAt] {
        let arm = share(push, &|case| Case { r: -case.r, ..*case }.after().0);
        assert!(arm > 0.2, "{push:?}, arm: {arm}");
    }
    for push in [Push::AngularImpulse, Push::Torque] {
        let tensor = share(push, &|case| {
            let mut turned = *case;
            turned.body.set_orientation(case.body.orientation().conjugate());
            turned.after().0
        });
        assert!(tensor > 0.15, "{push:?}, R^T I^-1 R: {tensor}");
    }
    for push in [Push::Force, Push::ForceAt, Push::Torque] {
        let time = share(push, &|case| {
            let seconds = case.seconds * S::nearest_scaled(1.001);
            Case { seconds, ..*case }.after().0
        });
        assert!(time > 0.15, "{push:?}, a thousandth longer: {time}");
    }
}

/// An impulse on one body and its opposite on the other are what the kernel applies along a normal.
fn pairs_are_the_kernels<S: Format>() {
    let mut random = Random::new(62);
    let [mut components, mut equal, mut cases, mut moved] = [0u64; 4];
    while cases < 2_000 {
        let mut case = random_case::<S>(&mut random);
        // Along an axis, so that the impulse along the normal has no rounding of its own.
        case.contact.normal = [UnitVec3::X, -UnitVec3::Y, UnitVec3::Z][cases as usize % 3];
        let n = case.contact.normal.get().to_array();
        let j = S::nearest(random.spread(S::magnitudes().0, S::magnitudes().1 / 64.0));
        let Contact { r_a, r_b, .. } = case.contact;
        let (mut a, mut b) = (case.a, case.b);
        let impulse = Vec3::from_array(n.map(|x| {
            let x = S::unit_value(x).to_f64();
            S::nearest(x * j.value().to_f64())
        }));
        let met = a.apply_impulse_at(-impulse, r_a) | b.apply_impulse_at(impulse, r_b);
        let (mut kernel_a, mut kernel_b) = (case.a, case.b);
        let kernel_met = impulse::apply_impulse(&mut kernel_a, &mut kernel_b, &case.contact, j);
        assert_eq!(met, kernel_met, "case {cases}");
        cases += 1;
        for (body, kernel, before, r) in [(a, kernel_a, case.a, r_a), (b, kernel_b, case.b, r_b)] {
            let side = Side::read(&before, r);
            let j = j.value().to_f64();
            let shares = [side.inv_mass.to_f64() * j, side.inv_inertia.trace().to_f64() * side.arm.length() * j];
            let pairs = [
                (body.linear_velocity, kernel.linear_velocity, shares[0]),
                (body.angular_velocity, kernel.angular_velocity, shares[1]),
            ];
            for (found, kernel, share) in pairs {
                for (found, kernel) in found.to_array().into_iter().zip(kernel.to_array()) {
                    let off = (found.value() - kernel.value()).to_f64().abs();
                    let ulp = S::ulp(kernel.value().to_f64());
                    assert!(off <= ulp + 16.0 * S::precision() * share, "case {cases}: {off:e}, {found:?}, {kernel:?}");
                    (components, equal) = (components + 1, equal + u64::from(found == kernel));
                }
            }
            moved += u64::from(body.linear_velocity != before.linear_velocity);
        }
    }
    println!("{}: {equal} of {components} components are the same bits", S::name());
    assert_share("bodies that move", moved, 2 * cases, 0.5);
    assert_share("the same bits", equal, components, 0.9);
}

/// What is not finite, or leads there, leaves the body as it was; the largest of everything ends at the end of the range.
fn extremes<S: Format>() {
    let mut random = Random::new(63);
    let (zero, one) = (S::ZERO, <S::Scaled as Scaled>::ONE);
    let infinite = one / <S::Scaled as Scaled>::ZERO;
    let raw = [S::LARGEST, S::LARGEST.negated(), S::from_raw(1 << 31), zero, S::from_raw(1)];
    let [mut met, mut kept] = [0u64; 2];
    for i in 0..3_000u64 {
        let case = Case::<S>::random(&mut random, PUSHES[i as usize % 6]);
        let mut any =
            || Vec3::new(raw[random.pick(5) as usize], raw[random.pick(5) as usize], raw[random.pick(5) as usize]);
        let mut wild = Case { amount: any(), r: any(), ..case };
        (wild.body.linear_velocity, wild.body.angular_velocity) = (any(), any());
        wild.seconds =
            S::Scaled::from_parts([1, -1, i32::MAX][i as usize % 3], [0, 100, -100, 1 << 30][i as usize % 4]);
        let (body, hit) = wild.after();
        let finite = body.linear_velocity.is_finite() && body.angular_velocity.is_finite();
        assert!(finite || body == wild.body || wild.body.check().is_err(), "case {i}");
        met += u64::from(hit);
        // A time without an end.
        let endless = Case { seconds: infinite, ..case };
        if matches!(case.push, Push::Force | Push::ForceAt | Push::Torque) {
            let (body, hit) = endless.after();
            assert!(body == endless.body && hit != body.is_immovable(), "case {i}: {body:?}");
            kept += 1;
        }
    }
    assert!(met > 500 && kept > 1_000, "{met} {kept}");
    if S::saturates() {
        return;
    }
    for bad in [S::ONE.over(zero), S::ONE.negated().over(zero), zero.over(zero)] {
        for (i, push) in PUSHES.into_iter().cycle().take(600).enumerate() {
            let case = Case::<S>::random(&mut random, push);
            if case.body.is_immovable() {
                continue;
            }
            let mut v = case.amount.to_array();
            v[i % 3] = bad;
            let wrong = Case { amount: Vec3::from_array(v), ..case };
            let (body, hit) = wrong.after();
            assert!(hit && exact::cases::bits(&body) == exact::cases::bits(&case.body), "{push:?} {bad:?}");
            if matches!(push, Push::ImpulseAt | Push::ForceAt) {
                let mut r = case.r.to_array();
                r[i % 3] = bad;
                let (body, hit) = Case { r: Vec3::from_array(r), ..case }.after();
                assert!(hit && exact::cases::bits(&body) == exact::cases::bits(&case.body), "{push:?} {bad:?}");
            }
        }
    }
}

in_formats!(usual { velocities deliberate_faults_are_seen pairs_are_the_kernels extremes });
