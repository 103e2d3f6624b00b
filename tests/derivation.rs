//! Steps (1) to (11) of `docs/derivation.md`, one test each: by hand in f64 with cross products, and the kernel beside it wherever
//! it shows the quantity.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed"))]

#[path = "support/exact.rs"]
mod exact;

use carom::Body;
use carom::impulse::{Outcome, apply_impulse, collision_impulse, effective_mass, relative_velocity, resolve_collision};
use exact::hand::{M, V, add, apply, close, cross, dot, each, length, product, read, transposed};
use exact::{Format, in_formats};
use proptest::prelude::*;

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

/// (4): v_p = v + w x r, which is what a resting, immovable A makes of (5).
fn step_4_point_velocity<S: Format>() {
    each::<S>(|case, pair| {
        let kernel = read(relative_velocity(&Body::immovable(), &case.b, &case.contact));
        prop_assert!(close(kernel, pair.b.point_velocity(), pair.tolerance));
        prop_assert!(close(kernel, add(pair.b.v, 1.0, cross(pair.b.w, pair.b.r)), pair.tolerance));
        Ok(())
    });
}

/// (5): v_r = (v_b + w_b x r_b) - (v_a + w_a x r_a).
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
fn step_11_triple_product<S: Format>() {
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
        heavy.a.inv_mass *= 1e-18;
        heavy.a.inv_inertia_body = heavy.a.inv_inertia_body.map(|row| row.map(|x| x * 1e-18));
        prop_assert!((kernel - heavy.impulse()).abs() <= heavy.tolerance * 16.0, "{kernel} {}", heavy.impulse());
        Ok(())
    });
}

in_formats!(derived {
    step_1_action_and_reaction step_2_linear_velocity step_3_angular_velocity the_tensor_turns step_4_point_velocity
    step_5_relative_velocity step_6_restitution step_7_points_after step_8_relative_velocity_after
    step_9_along_the_normal step_10_impulse step_11_triple_product separating_bodies_are_left_alone
    immovable_is_the_limit_of_heavy
});
