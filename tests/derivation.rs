//! The steps of `docs/derivation.md`, one test each: by hand in f64 with cross products, and the kernel beside it wherever
//! it shows the quantity.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed"))]

#[path = "support/exact.rs"]
mod exact;

use carom::impulse::{
    Outcome, apply_impulse, collision_impulse, effective_mass, relative_velocity, resolve_collision,
    resolve_collision_with_friction,
};
use carom::{Body, Material, RestitutionLaw, UnitVec3, Vec3};
use exact::strategy::{everyday, forall};
use exact::{Case, Format};
use proptest::prelude::*;

type V = [f64; 3];
type M = [V; 3];

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a + k b
fn add(a: V, k: f64, b: V) -> V {
    [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]]
}

fn length(a: V) -> f64 {
    dot(a, a).sqrt()
}

fn apply(m: M, v: V) -> V {
    m.map(|row| dot(row, v))
}

fn product(a: M, b: M) -> M {
    let b = transposed(b);
    a.map(|row| b.map(|column| dot(row, column)))
}

fn transposed(m: M) -> M {
    [0, 1, 2].map(|i| [m[0][i], m[1][i], m[2][i]])
}

fn read<S: Format>(v: Vec3<S>) -> V {
    v.to_array().map(|x| x.value().to_f64())
}

/// One body and its arm, by hand.
#[derive(Clone, Copy, Debug)]
struct Hand {
    inv_mass: f64,
    rotation: M,
    /// In the body's frame
    inv_inertia_body: M,
    v: V,
    w: V,
    r: V,
}

impl Hand {
    fn read<S: Format>(body: &Body<S>, arm: Vec3<S>) -> Self {
        let [w, x, y, z] = body.orientation().to_array().map(|c| S::unit_value(c).to_f64());
        let rotation = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ];
        let [xx, xy, xz, yy, yz, zz] = body.inv_inertia_local().map(|x| S::scaled_value(x).to_f64());
        Self {
            inv_mass: S::scaled_value(body.inv_mass()).to_f64(),
            rotation,
            inv_inertia_body: [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]],
            v: read(body.linear_velocity),
            w: read(body.angular_velocity),
            r: read(arm),
        }
    }

    /// I^-1 = R I_body^-1 R^T
    fn inv_inertia(&self) -> M {
        product(self.rotation, product(self.inv_inertia_body, transposed(self.rotation)))
    }

    /// (4)
    fn point_velocity(&self) -> V {
        add(self.v, 1.0, cross(self.w, self.r))
    }

    /// (2) and (3), for the impulse `sign j n` on this body.
    fn struck(&self, sign: f64, j: f64, n: V) -> Self {
        let turn = apply(self.inv_inertia(), cross(self.r, n));
        Self { v: add(self.v, sign * j * self.inv_mass, n), w: add(self.w, sign * j, turn), ..*self }
    }

    /// n/m + (I^-1 (r x n)) x r
    fn yields_to(&self, n: V) -> V {
        add(cross(apply(self.inv_inertia(), cross(self.r, n)), self.r), self.inv_mass, n)
    }
}

/// Both bodies, the normal from A to B, e, mu, and what rounding may do to a velocity of the kernel.
struct Pair {
    a: Hand,
    b: Hand,
    n: V,
    e: f64,
    mu: f64,
    tolerance: f64,
}

impl Pair {
    fn read<S: Format>(case: &Case<S>) -> Self {
        let (a, b) = (Hand::read(&case.a, case.contact.r_a), Hand::read(&case.b, case.contact.r_b));
        let n = direction(case.contact.normal);
        let turn = |h: &Hand| h.inv_inertia_body.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs())) * length(h.r);
        let turns = turn(&a).max(turn(&b));
        let load = a.inv_mass + b.inv_mass + turn(&a) * length(a.r) + turn(&b) * length(b.r);
        let least = a.inv_mass + b.inv_mass;
        let tolerance = (4.0 * S::ulp(4.0) + 64.0 * S::precision()) * (1.0 + turns) * (1.0 + load / least);
        Self { a, b, n, e: case.restitution.value().to_f64(), mu: case.friction.value().to_f64(), tolerance }
    }

    /// (5)
    fn relative_velocity(&self) -> V {
        add(self.b.point_velocity(), -1.0, self.a.point_velocity())
    }

    /// The bracket of (8)
    fn yields_to(&self, d: V) -> V {
        add(self.a.yields_to(d), 1.0, self.b.yields_to(d))
    }

    /// (10)
    fn impulse(&self) -> f64 {
        -(1.0 + self.e) * dot(self.relative_velocity(), self.n) / dot(self.yields_to(self.n), self.n)
    }

    fn struck(&self, j: f64) -> Self {
        Self { a: self.a.struck(-1.0, j, self.n), b: self.b.struck(1.0, j, self.n), ..*self }
    }

    fn energy(&self) -> f64 {
        [&self.a, &self.b]
            .map(|h| {
                let spin = apply(transposed(h.rotation), h.w);
                let moments = [0, 1, 2].map(|i| 1.0 / h.inv_inertia_body[i][i]);
                0.5 * (dot(h.v, h.v) / h.inv_mass + (0..3).map(|i| moments[i] * spin[i] * spin[i]).sum::<f64>())
            })
            .iter()
            .sum()
    }
}

fn direction<S: Format>(n: UnitVec3<S>) -> V {
    n.get().to_array().map(|x| S::unit_value(x).to_f64())
}

fn close(left: V, right: V, tolerance: f64) -> bool {
    length(add(left, -1.0, right)) <= tolerance
}

/// Everyday impacts, the pair by hand, and the kernel's case.
fn each<S: Format>(step: impl Fn(Case<S>, Pair) -> proptest::test_runner::TestCaseResult) {
    forall(300, everyday::<S>(), |mut case| {
        exact::cases::turn_towards(&mut case);
        let pair = Pair::read(&case);
        step(case, pair)
    });
}

/// (1): what B gets, A gives.
fn step_1_action_and_reaction<S: Format>() {
    each::<S>(|case, pair| {
        let (mut a, mut b) = (case.a, case.b);
        let _ = apply_impulse(&mut a, &mut b, &case.contact, S::nearest(1.5));
        let given = add(read(a.linear_velocity), -1.0, pair.a.v).map(|x| x / pair.a.inv_mass);
        let got = add(read(b.linear_velocity), -1.0, pair.b.v).map(|x| x / pair.b.inv_mass);
        prop_assert!(close(got, given.map(|x| -x), 4.0 * pair.tolerance));
        prop_assert!(close(got, pair.n.map(|x| 1.5 * x), 4.0 * pair.tolerance));
        Ok(())
    });
}

/// (2): v_a' = v_a - j/m_a n, v_b' = v_b + j/m_b n.
fn step_2_linear_velocity<S: Format>() {
    each::<S>(|case, pair| {
        let (mut a, mut b) = (case.a, case.b);
        let _ = apply_impulse(&mut a, &mut b, &case.contact, S::nearest(1.5));
        let hand = pair.struck(1.5);
        prop_assert!(close(read(a.linear_velocity), hand.a.v, pair.tolerance));
        prop_assert!(close(read(b.linear_velocity), hand.b.v, pair.tolerance));
        // The fault: the normal taken from B to A.
        prop_assert!(!close(read(a.linear_velocity), pair.struck(-1.5).a.v, pair.tolerance));
        Ok(())
    });
}

/// (3): w_a' = w_a - j I_a^-1 (r_a x n), w_b' = w_b + j I_b^-1 (r_b x n).
fn step_3_angular_velocity<S: Format>() {
    let wrong = std::cell::Cell::new(0);
    each::<S>(|case, pair| {
        let (mut a, mut b) = (case.a, case.b);
        let _ = apply_impulse(&mut a, &mut b, &case.contact, S::nearest(1.5));
        let hand = pair.struck(1.5);
        prop_assert!(close(read(a.angular_velocity), hand.a.w, pair.tolerance));
        prop_assert!(close(read(b.angular_velocity), hand.b.w, pair.tolerance));
        // The fault: n x r for r x n, and the tensor of the body's frame for that of the world's.
        let flipped = add(pair.b.w, -1.5, apply(pair.b.inv_inertia(), cross(pair.b.r, pair.n)));
        let local = add(pair.b.w, 1.5, apply(pair.b.inv_inertia_body, cross(pair.b.r, pair.n)));
        for fault in [flipped, local] {
            wrong.set(wrong.get() + u32::from(!close(read(b.angular_velocity), fault, pair.tolerance)));
        }
        Ok(())
    });
    assert!(wrong.get() > 450, "{wrong:?} of 600 faults seen");
}

/// I^-1 = R I_body^-1 R^T is a tensor: it turns with the body, and neither commutes with R nor is a number.
fn the_tensor_turns<S: Format>() {
    let [plain, number] = [0, 0].map(std::cell::Cell::new);
    each::<S>(|case, pair| {
        let hand = pair.a.inv_inertia();
        let [xx, xy, xz, yy, yz, zz] = case.a.inv_inertia_world().map(|x| S::scaled_value(x).to_f64());
        let kernel = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let trace = xx + yy + zz;
        let far = |m: M| (0..9).any(|k| (m[k / 3][k % 3] - kernel[k / 3][k % 3]).abs() > 1e-6 * trace);
        prop_assert!(!far(hand));
        plain.set(plain.get() + u32::from(far(pair.a.inv_inertia_body)));
        let isotropic = [[trace / 3.0, 0.0, 0.0], [0.0, trace / 3.0, 0.0], [0.0, 0.0, trace / 3.0]];
        number.set(number.get() + u32::from(far(isotropic)));
        // Tumbled twice about different axes: the order matters.
        let swapped = product(transposed(pair.a.rotation), product(pair.a.inv_inertia_body, pair.a.rotation));
        plain.set(plain.get() + u32::from(far(swapped)));
        Ok(())
    });
    assert!(plain.get() > 500 && number.get() > 250, "{plain:?} {number:?}");
}

/// (4) and (5): v_r = (v_b + w_b x r_b) - (v_a + w_a x r_a).
fn step_5_relative_velocity<S: Format>() {
    each::<S>(|case, pair| {
        let kernel = read(relative_velocity(&case.a, &case.b, &case.contact));
        prop_assert!(close(kernel, pair.relative_velocity(), pair.tolerance));
        // The fault of the order: r x w.
        let wrong = add(add(pair.b.v, -1.0, cross(pair.b.w, pair.b.r)), -1.0, pair.a.point_velocity());
        let spin = length(cross(pair.b.w, pair.b.r));
        prop_assert!(spin < 0.1 || !close(kernel, wrong, pair.tolerance));
        Ok(())
    });
}

/// (6): v_r' . n = -e v_r . n, by hand and by the kernel; the other components are not ruled by e.
fn step_6_restitution<S: Format>() {
    let changed = std::cell::Cell::new(0);
    each::<S>(|case, pair| {
        let (before, hand) = (pair.relative_velocity(), pair.struck(pair.impulse()));
        let after = hand.relative_velocity();
        prop_assert!((dot(after, pair.n) + pair.e * dot(before, pair.n)).abs() < 1e-9 + pair.tolerance);
        let (mut a, mut b) = (case.a, case.b);
        let impact = resolve_collision(&mut a, &mut b, &case.contact, case.restitution);
        prop_assert_eq!(impact.outcome, Outcome::Slid);
        let kernel = read(relative_velocity(&a, &b, &case.contact));
        prop_assert!((dot(kernel, pair.n) + pair.e * dot(before, pair.n)).abs() <= pair.tolerance);
        // Instantaneous: the positions are as before. The tangential velocity is changed by the rotations all the same.
        prop_assert_eq!([a.position, b.position], [case.a.position, case.b.position]);
        let across = |v: V| add(v, -dot(v, pair.n), pair.n);
        changed.set(changed.get() + u32::from(!close(across(before), across(kernel), pair.tolerance)));
        Ok(())
    });
    assert!(changed.get() > 200, "{changed:?}");
}

/// (7): v_p' = v_p -+ j (n/m + (I^-1 (r x n)) x r): (2) and (3) put into (4).
fn step_7_points_after<S: Format>() {
    each::<S>(|_, pair| {
        let j = 1.5;
        let hand = pair.struck(j);
        prop_assert!(close(hand.a.point_velocity(), add(pair.a.point_velocity(), -j, pair.a.yields_to(pair.n)), 1e-9));
        prop_assert!(close(hand.b.point_velocity(), add(pair.b.point_velocity(), j, pair.b.yields_to(pair.n)), 1e-9));
        Ok(())
    });
}

/// (8): v_r' = v_r + j (n/m_a + n/m_b + ...), linear in j.
fn step_8_relative_velocity_after<S: Format>() {
    each::<S>(|case, pair| {
        let expected = add(pair.relative_velocity(), 1.5, pair.yields_to(pair.n));
        prop_assert!(close(pair.struck(1.5).relative_velocity(), expected, 1e-9));
        let (mut a, mut b) = (case.a, case.b);
        let _ = apply_impulse(&mut a, &mut b, &case.contact, S::nearest(1.5));
        let kernel = read(relative_velocity(&a, &b, &case.contact));
        prop_assert!(close(kernel, expected, 4.0 * pair.tolerance));
        Ok(())
    });
}

/// (9): -e v_r . n = v_r . n + j K, with the K that the kernel's effective mass is the inverse of.
fn step_9_along_the_normal<S: Format>() {
    each::<S>(|case, pair| {
        let (v_n, k) = (dot(pair.relative_velocity(), pair.n), dot(pair.yields_to(pair.n), pair.n));
        prop_assert!((-pair.e * v_n - (v_n + pair.impulse() * k)).abs() < 1e-9);
        let mass = effective_mass(&case.a, &case.b, &case.contact, case.contact.normal).value().to_f64();
        prop_assert!((mass * k - 1.0).abs() <= pair.tolerance * k, "{mass} {k}");
        Ok(())
    });
}

/// (10): the impulse, literally.
fn step_10_impulse<S: Format>() {
    each::<S>(|case, pair| {
        let kernel = collision_impulse(&case.a, &case.b, &case.contact, case.restitution).value().to_f64();
        prop_assert!((kernel - pair.impulse()).abs() <= pair.tolerance * 4.0, "{kernel} {}", pair.impulse());
        let (mut a, mut b) = (case.a, case.b);
        let impact = resolve_collision(&mut a, &mut b, &case.contact, case.restitution);
        let hand = pair.struck(pair.impulse());
        prop_assert_eq!(impact.normal_impulse.value().to_f64(), kernel);
        for (kernel, hand) in [
            (a.linear_velocity, hand.a.v),
            (a.angular_velocity, hand.a.w),
            (b.linear_velocity, hand.b.v),
            (b.angular_velocity, hand.b.w),
        ] {
            prop_assert!(close(read(kernel), hand, pair.tolerance * (1.0 + length(hand))));
        }
        Ok(())
    });
}

/// [(I^-1 (r x n)) x r] . n = (r x n) . I^-1 (r x n), which is never negative: K >= 1/m_a + 1/m_b.
fn the_triple_product_cycles<S: Format>() {
    each::<S>(|_, pair| {
        for hand in [&pair.a, &pair.b] {
            let turn = apply(hand.inv_inertia(), cross(hand.r, pair.n));
            let (literal, cheap) = (dot(cross(turn, hand.r), pair.n), dot(cross(hand.r, pair.n), turn));
            prop_assert!((literal - cheap).abs() < 1e-9 * (1.0 + cheap));
            prop_assert!(cheap >= -1e-12);
        }
        prop_assert!(dot(pair.yields_to(pair.n), pair.n) >= (pair.a.inv_mass + pair.b.inv_mass) * (1.0 - 1e-6));
        Ok(())
    });
}

/// Only approaching contacts: (10) is negative for separating ones, and would pull.
fn separating_bodies_are_left_alone<S: Format>() {
    each::<S>(|case, pair| {
        let mut case = case;
        for body in [&mut case.a, &mut case.b] {
            body.linear_velocity = -body.linear_velocity;
            body.angular_velocity = -body.angular_velocity;
        }
        prop_assume!(dot(pair.relative_velocity(), pair.n) < -pair.tolerance);
        prop_assert!(collision_impulse(&case.a, &case.b, &case.contact, case.restitution) <= S::ZERO);
        let (mut a, mut b) = (case.a, case.b);
        let impact = resolve_collision(&mut a, &mut b, &case.contact, case.restitution);
        prop_assert_eq!(impact.outcome, Outcome::Separating);
        prop_assert_eq!([a, b], [case.a, case.b]);
        Ok(())
    });
}

/// Inverse mass 0: the limit of ever heavier bodies, without a case of its own.
fn immovable_is_the_limit_of_heavy<S: Format>() {
    each::<S>(|case, pair| {
        let mut ground = Body::immovable();
        ground.linear_velocity = case.a.linear_velocity;
        ground.angular_velocity = case.a.angular_velocity;
        let kernel = collision_impulse(&ground, &case.b, &case.contact, case.restitution).value().to_f64();
        let mut heavy = pair;
        heavy.a.inv_mass *= 1e-12;
        heavy.a.inv_inertia_body = heavy.a.inv_inertia_body.map(|row| row.map(|x| x * 1e-12));
        prop_assert!((kernel - heavy.impulse()).abs() <= heavy.tolerance * 16.0, "{kernel} {}", heavy.impulse());
        Ok(())
    });
}

/// Friction: sticking is the system W J = -(v_r + e v_n n), sliding has |J_t| = mu J_n against v_t', and (6) holds in both.
fn friction_sticks_or_slides<S: Format>() {
    let [stuck, slid, gained, wild] = [0, 0, 0, 0].map(std::cell::Cell::new);
    let up = |cell: &std::cell::Cell<u32>| cell.set(cell.get() + 1);
    each::<S>(|case, pair| {
        let material = Material::new(case.restitution, case.friction).expect("a material");
        let (mut a, mut b) = (case.a, case.b);
        let impact = resolve_collision_with_friction(&mut a, &mut b, &case.contact, &material);
        let v = read(relative_velocity(&a, &b, &case.contact));
        let (v_n, before) = (dot(v, pair.n), pair.relative_velocity());
        let v_t = add(v, -v_n, pair.n);
        let j_t = read(impact.friction_impulse);
        let (limit, friction) = (pair.mu * impact.normal_impulse.value().to_f64(), length(j_t));
        prop_assert!((v_n + pair.e * dot(before, pair.n)).abs() <= 4.0 * pair.tolerance);
        prop_assert!(friction <= limit + 4.0 * pair.tolerance);
        let j = add(j_t, impact.normal_impulse.value().to_f64(), pair.n);
        prop_assert!(close(v, add(before, 1.0, pair.yields_to(j)), 16.0 * pair.tolerance));
        if impact.outcome == Outcome::Stuck {
            up(&stuck);
            prop_assert!(length(v_t) <= 4.0 * pair.tolerance);
        } else {
            up(&slid);
            prop_assert!((friction - limit).abs() <= 4.0 * pair.tolerance);
            if friction > 0.01 {
                let against = add(v_t, length(v_t) / friction, j_t);
                prop_assert!(length(against) <= 16.0 * pair.tolerance * (1.0 + length(v_t) / friction));
            }
        }
        // Newton's e may raise the energy; the safe law does not.
        let after = |a: &Body<S>, b: &Body<S>| Pair {
            a: Hand::read(a, case.contact.r_a),
            b: Hand::read(b, case.contact.r_b),
            ..Pair::read(&case)
        };
        let slack = 32.0 * pair.tolerance;
        if after(&a, &b).energy() > pair.energy() + slack {
            up(&gained);
        }
        let (mut a, mut b) = (case.a, case.b);
        let safe = material.with_law(RestitutionLaw::EnergySafe);
        let _ = resolve_collision_with_friction(&mut a, &mut b, &case.contact, &safe);
        if after(&a, &b).energy() > pair.energy() + slack {
            up(&wild);
        }
        Ok(())
    });
    println!("{}: {stuck:?} stick, {slid:?} slide, {gained:?} gain energy under Newton's law", S::name());
    assert!(stuck.get() > 20 && slid.get() > 100);
    assert_eq!(wild.get(), 0);
}

macro_rules! formats {
    ($($feature:literal, $name:ident, $format:ty;)+) => {$(
        #[cfg(feature = $feature)]
        mod $name {
            type S = $format;
            formats!(@ step_1_action_and_reaction step_2_linear_velocity step_3_angular_velocity the_tensor_turns
                step_5_relative_velocity step_6_restitution step_7_points_after step_8_relative_velocity_after
                step_9_along_the_normal step_10_impulse the_triple_product_cycles separating_bodies_are_left_alone
                immovable_is_the_limit_of_heavy friction_sticks_or_slides);
        }
    )+};
    (@ $($step:ident)+) => {$(
        #[test]
        fn $step() {
            super::$step::<S>();
        }
    )+};
}

formats! {
    "fixed", i12f20, fixed::types::I12F20;
    "f32", single, f32;
    "f64", double, f64;
}
