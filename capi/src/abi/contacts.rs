//! The impulse of one contact, on the caller's own bodies.

use carom::impulse;
use carom::{Body, Scalar};

use super::export;
use super::pointer::{Mirror, check, check_apart, read, write};
use crate::number::Number;
use crate::status::carom_status;
use crate::types::*;

#[cfg(feature = "fixed")]
use fixed::types::{I12F20, I16F16};

/// A coefficient of restitution.
fn restitution<N: Number>(raw: N::Raw) -> Result<N, carom_status> {
    let e = N::from_raw(raw);
    if e >= <N as Scalar>::ZERO && e <= <N as Scalar>::ONE { Ok(e) } else { Err(carom_status::CAROM_RESTITUTION) }
}

/// Two bodies of finite numbers.
///
/// # Safety
/// As for [`Mirror::pair`].
unsafe fn pair<'a, N: Number, M: Mirror<N>>(a: *mut M, b: *mut M) -> Result<[&'a mut Body<N>; 2], carom_status> {
    // SAFETY: the caller's word.
    let [a, b] = unsafe { M::pair(a, b)? };
    a.check()?;
    b.check()?;
    Ok([a, b])
}

/// Two bodies that are two, to be read.
///
/// # Safety
/// As for [`Mirror::body`].
unsafe fn seen<'a, N: Number, M: Mirror<N>>(a: *const M, b: *const M) -> Result<[&'a Body<N>; 2], carom_status> {
    check_apart(a, b)?;
    // SAFETY: the caller's word.
    unsafe { Ok([M::body(a)?, M::body(b)?]) }
}

macro_rules! contacts {
    ($p:ident, $number:ty, $raw:ty) => {
        pastey::paste! { export! {
            /// The mass that the contact opposes to an impulse along its normal, kg: zero where neither body can move.
            fn [<$p _effective_mass>](
                a: *const [<$p _body>],
                b: *const [<$p _body>],
                contact: *const [<$p _contact>],
                result: *mut $raw,
            ) {
                let contact = read(contact)?.core()?;
                let [a, b]: [&Body<$number>; 2] = seen(a, b)?;
                write(result, impulse::effective_mass(a, b, &contact, contact.normal).raw())
            }

            /// The velocity of B's point relative to A's, m/s.
            fn [<$p _relative_velocity>](
                a: *const [<$p _body>],
                b: *const [<$p _body>],
                contact: *const [<$p _contact>],
                result: *mut [<$p _vec3>],
            ) {
                let contact = read(contact)?.core()?;
                let [a, b]: [&Body<$number>; 2] = seen(a, b)?;
                write(result, impulse::relative_velocity(a, b, &contact).into())
            }

            /// The impulse along the normal (N s) that makes v_n' = -e v_n, for approaching bodies and for separating ones alike, where
            /// it is negative. Nothing is changed.
            fn [<$p _collision_impulse>](
                a: *const [<$p _body>],
                b: *const [<$p _body>],
                contact: *const [<$p _contact>],
                e: $raw,
                result: *mut $raw,
            ) {
                let contact = read(contact)?.core()?;
                let e = restitution(e)?;
                let [a, b]: [&Body<$number>; 2] = seen(a, b)?;
                write(result, impulse::collision_impulse(a, b, &contact, e).raw())
            }

            /// Rebound without friction: where the bodies approach, changes both so that v_n' = -e v_n. `impact` may be null.
            fn [<$p _resolve_collision>](
                a: *mut [<$p _body>],
                b: *mut [<$p _body>],
                contact: *const [<$p _contact>],
                e: $raw,
                impact: *mut [<$p _impact>],
            ) {
                let contact = read(contact)?.core()?;
                let e = restitution(e)?;
                check_result(impact, [a, b])?;
                let [a, b]: [&mut Body<$number>; 2] = pair(a, b)?;
                tell(impact, impulse::resolve_collision(a, b, &contact, e))
            }

            /// Rebound with Coulomb friction: the three components of the impulse are found together, in the cone |J_t| <= mu J_n.
            /// `impact` may be null.
            fn [<$p _resolve_collision_with_friction>](
                a: *mut [<$p _body>],
                b: *mut [<$p _body>],
                contact: *const [<$p _contact>],
                material: *const [<$p _material>],
                impact: *mut [<$p _impact>],
            ) {
                let contact = read(contact)?.core()?;
                let material = read(material)?.core()?;
                check_result(impact, [a, b])?;
                let [a, b]: [&mut Body<$number>; 2] = pair(a, b)?;
                tell(impact, impulse::resolve_collision_with_friction(a, b, &contact, &material))
            }
        } }
    };
}

/// What is written at the end is looked at before anything is changed.
fn check_result<T, B>(result: *mut T, bodies: [*mut B; 2]) -> Result<(), carom_status> {
    if result.is_null() {
        return Ok(());
    }
    check(result)?;
    bodies.into_iter().try_for_each(|body| check_apart(result, body))
}

/// Writes what is optional.
///
/// # Safety
/// As for [`write`].
unsafe fn tell<T, U: From<T>>(result: *mut U, value: T) -> Result<(), carom_status> {
    // SAFETY: the caller's word.
    if result.is_null() { Ok(()) } else { unsafe { write(result, value.into()) } }
}

#[cfg(feature = "f32")]
contacts!(carom_f32, f32, f32);
#[cfg(feature = "fixed")]
contacts!(carom_q16, I16F16, i32);
#[cfg(feature = "fixed")]
contacts!(carom_q20, I12F20, i32);
