//! The kernel: the impulse of one contact between two bodies.
//!
//! With the unit normal n from body A to body B, the arms r_a and r_b from the centres of mass to the point, and the
//! relative velocity at the point v_r = (v_b + w_b x r_b) - (v_a + w_a x r_a):
//!
//! ```text
//! j    = -(1 + e) (v_r . n) / (1/m_a + 1/m_b + [(I_a^-1 (r_a x n)) x r_a + (I_b^-1 (r_b x n)) x r_b] . n)   (10)
//! v_a' = v_a - j/m_a n               v_b' = v_b + j/m_b n                                                    (2)
//! w_a' = w_a - j I_a^-1 (r_a x n)    w_b' = w_b + j I_b^-1 (r_b x n)                                         (3)
//! ```
//!
//! The denominator is computed as 1/m_a + 1/m_b + c_a . I_a^-1 c_a + c_b . I_b^-1 c_b with c = r x n, which equals it
//! by the cyclic symmetry of the triple product. `docs/derivation.md` walks the derivation.
//!
//! **Accuracy.** In fixed point nothing between reading the bodies and storing the velocities is rounded to the format.
//! Against the exact result for the given bits, the impulse of (10) is off by at most 16 u (L |J| + (1 + e) s)/K with
//! u = 2^-30, K the denominator of (10), s = |v_a| + |v_b| + |w_a||r_a| + |w_b||r_b| and
//! L = 1/m_a + 1/m_b + |I_a^-1||r_a|^2 + |I_b^-1||r_b|^2; 8.5 u is the worst of a million random cases a format. A stored
//! velocity component is off by 0.51 units of its last place and its share (1/m, or |I^-1||r|) of that. In f32 the bound is
//! 4 u with u = 2^-24. With friction the same form holds with larger factors: `docs/derivation.md` has the table, and
//! `tests/exact.rs` and `tests/exact_friction.rs` hold it.
//!
//! **Range.** Only the stored velocities and the reported impulses can meet the end of the format; they then stay there
//! and [`Impact::saturated`] says so. No function here panics, allocates, loops without a bound or writes to a body
//! that it reports untouched.

mod apply;
mod energy;
#[cfg(all(feature = "f32", target_abi = "eabihf", multiply = "long"))]
mod fpu;
mod friction;
mod lever;
mod rub;
mod slip;

use self::apply::apply_normal;
use self::lever::{Column, lever};
use self::rub::rub;
use crate::body::Body;
#[cfg(doc)]
use crate::contact::RestitutionLaw;
use crate::contact::{Contact, Material};
use crate::math::{UnitVec3, Vec3};
use crate::scalar::{Scalar, Scaled};

/// The column of a direction, and what it refers to.
macro_rules! column {
    (let $column:ident = $a:ident, $b:ident, $contact:ident, $direction:expr) => {
        let direction = $direction.as_vec3();
        let opposite = S::opposite(direction);
        let lever_a = lever($a, &$contact.r_a, &opposite);
        let lever_b = lever($b, &$contact.r_b, direction);
        let $column = Column { directions: [&opposite, direction], levers: [&lever_a, &lever_b] };
    };
}

/// What a contact did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(u8)]
pub enum Outcome {
    /// The bodies do not approach each other at the point: nothing was changed.
    Separating,
    /// The points move apart along the normal, or rest, and do not slide on each other: friction held.
    Stuck,
    /// The points slide on each other, with friction at its limit (or without friction). Where
    /// [`RestitutionLaw::EnergySafe`] has drawn the impulse back, this and [`Stuck`](Self::Stuck) tell of the impulse before
    /// that; the one applied lies in the friction cone.
    Slid,
    /// Neither body can move: nothing was changed.
    Immovable,
    /// A velocity, arm or tensor was not finite, or the impulse would not be, or would be less than the smallest number:
    /// nothing was changed. Never in fixed point.
    NotFinite,
}

/// What a contact did, and with which impulse: on B as given here, on A the opposite.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct Impact<S> {
    /// The impulse along the normal, never negative.
    pub normal_impulse: S,
    /// The impulse of friction, across the normal, in the world's frame.
    pub friction_impulse: Vec3<S>,
    /// The kind of event.
    pub outcome: Outcome,
    /// A velocity or a reported impulse met the end of the format and stayed there.
    pub saturated: bool,
}

impl<S: Scalar> Impact<S> {
    const fn nothing(outcome: Outcome) -> Self {
        Self { outcome, normal_impulse: S::ZERO, friction_impulse: Vec3::ZERO, saturated: false }
    }
}

/// The velocity of B's point relative to A's, v_r = (v_b + w_b x r_b) - (v_a + w_a x r_a). In fixed point a component
/// beyond the format takes its end.
#[must_use]
pub fn relative_velocity<S: Scalar>(a: &Body<S>, b: &Body<S>, contact: &Contact<S>) -> Vec3<S> {
    let scaled = |v: Vec3<S>| v.to_array().map(S::to_scaled);
    let (v_a, v_b) = (scaled(a.linear_velocity), scaled(b.linear_velocity));
    let (w_a, w_b) = (scaled(a.angular_velocity), scaled(b.angular_velocity));
    let (r_a, r_b) = (scaled(contact.r_a), scaled(contact.r_b));
    Vec3::from_array([(0, 1, 2), (1, 2, 0), (2, 0, 1)].map(|(x, y, z)| {
        let turn_a = w_a[y] * r_a[z] - w_a[z] * r_a[y];
        let turn_b = w_b[y] * r_b[z] - w_b[z] * r_b[y];
        S::from_scaled((v_b[x] - v_a[x]) + (turn_b - turn_a)).0
    }))
}

/// The mass that the contact opposes to an impulse along `direction`: the inverse of the denominator of (10). Zero where
/// neither body can move; beyond the format, its end. One division.
#[must_use]
pub fn effective_mass<S: Scalar>(a: &Body<S>, b: &Body<S>, contact: &Contact<S>, direction: UnitVec3<S>) -> S {
    column!(let column = a, b, contact, direction);
    let k = column.inverse_mass(a, b);
    if k == S::Scaled::ZERO { S::ZERO } else { S::from_scaled(S::Scaled::ONE / k).0 }
}

/// The impulse of formula (10), for approaching bodies and for separating ones alike (where it is negative). Beyond the
/// format it is the end of it, which [`resolve_collision`] would report and this cannot. Zero where
/// neither body can move, or something is not finite. `restitution` is that of [`Material`]: 0 to 1; beyond, fixed point takes
/// the nearer end, and a float the formula as it stands.
#[must_use]
pub fn collision_impulse<S: Scalar>(a: &Body<S>, b: &Body<S>, contact: &Contact<S>, restitution: S) -> S {
    column!(let column = a, b, contact, contact.normal);
    let (speed, k) = (column.speed(a, b), column.inverse_mass(a, b));
    let j = S::rebound(restitution, speed, k);
    if k.is_positive() && j.is_finite() { S::from_scaled(j).0 } else { S::ZERO }
}

/// Applies an impulse along the normal to both bodies, by (2) and (3). True where a velocity met the end of the format.
/// Where the impulse, an arm or a tensor is not finite, nothing is changed.
pub fn apply_impulse<S: Scalar>(a: &mut Body<S>, b: &mut Body<S>, contact: &Contact<S>, normal_impulse: S) -> bool {
    column!(let column = a, b, contact, contact.normal);
    if !(normal_impulse.is_finite() && column.inverse_mass(a, b).is_finite()) {
        return false;
    }
    apply_normal(a, b, &column, normal_impulse.to_scaled())
}

/// Rebound without friction: where the bodies approach, the impulse of (10) applied by (2) and (3).
///
/// The impulse goes from the quotient to the velocities unrounded; only the report is rounded to the format.
/// `restitution` is as for [`collision_impulse`].
#[inline(always)]
pub fn resolve_collision<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    restitution: S,
) -> Impact<S> {
    #[cfg(all(feature = "f32", target_abi = "eabihf", multiply = "long"))]
    if fpu::computes::<S>() {
        return fpu::resolve(a, b, contact, restitution);
    }
    S::strike(a, b, contact, restitution)
}

/// [`resolve_collision`] in any number type.
pub(crate) fn strike<S: Scalar>(a: &mut Body<S>, b: &mut Body<S>, contact: &Contact<S>, restitution: S) -> Impact<S> {
    column!(let column = a, b, contact, contact.normal);
    let j = match column.impulse(a, b, restitution) {
        Ok(j) => j,
        Err(outcome) => return Impact::nothing(outcome),
    };
    let clipped = apply_normal(a, b, &column, j);
    let (normal_impulse, large) = S::from_scaled(j);
    Impact { normal_impulse, saturated: clipped | large, ..Impact::nothing(Outcome::Slid) }
}

/// Rebound with Coulomb friction: |J_t| <= mu J_n, a disc in the tangent plane.
///
/// The three components of the impulse are found together. Where the one that brings v_n' = -e v_n and v_t' = 0 lies in
/// the cone, the points stick; else they slide, and the impulse is the one on the cone whose friction opposes the sliding
/// that is left *after* the impact. At most [`MAX_SLIP_ITERATIONS`] turns of one root search, of two under
/// [`RestitutionLaw::EnergySafe`]; no other loop.
///
/// In floating point impulses and speeds are squared on the way: in f32 magnitudes between 1e-17 and 1e18 have the accuracy
/// stated above, and beyond it sliding can be taken for sticking. A velocity that overflows to an infinity is stored as such.
///
/// With friction, Newton's v_n' = -e v_n raises the energy in rare eccentric impacts; see [`RestitutionLaw`].
pub fn resolve_collision_with_friction<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    material: &Material<S>,
) -> Impact<S> {
    let friction = material.friction();
    if friction == S::ZERO {
        return resolve_collision(a, b, contact, material.restitution());
    }
    #[cfg(all(feature = "f32", target_abi = "eabihf", multiply = "long"))]
    if fpu::computes::<S>() {
        return fpu::rub(a, b, contact, material);
    }
    // Where a change of sign is not a mirror of all roundings, one of the two orders of the bodies is computed for both.
    if !S::SYMMETRIC && contact.normal.is_mirrored() {
        let impact = rub(b, a, (-contact.normal).get(), [&contact.r_b, &contact.r_a], material, true);
        return Impact { friction_impulse: -impact.friction_impulse, ..impact };
    }
    rub(a, b, contact.normal.get(), [&contact.r_a, &contact.r_b], material, !S::SYMMETRIC)
}

pub use crate::scalar::MAX_SLIP_ITERATIONS;
