//! The kernel in f32 for a Cortex-M with an FPU: what its own instructions do at once, an island of `unsafe`.
//!
//! The compiler loads and stores one number at a time here, and spills what 32 registers do hold. Every bit is that of the
//! portable form: `examples/strikes.rs` prints the same hashes of 32,000 contacts on all cores.
#![allow(unsafe_code)]

mod stick;
mod strike;

use core::any::Any;
use core::mem::{MaybeUninit, offset_of};

use super::lever::reason;
use super::rub::{answer, unmoved};
use super::{Impact, Outcome};
use crate::body::Body;
use crate::contact::{Contact, Material, RestitutionLaw};
use crate::math::{Block, SymBlock, SymMat3, Vec3};
use crate::scalar::Scalar;

/// Where a body's velocities begin, and where its inverse mass and inertia do.
const MOTION: usize = offset_of!(Body<f32>, linear_velocity);
const INVERSE: usize = offset_of!(Body<f32>, inv_mass);

/// What is loaded at once lies side by side.
const _: () = {
    assert!(offset_of!(Body<f32>, angular_velocity) == MOTION + 12);
    assert!(offset_of!(Body<f32>, inv_inertia_world) == INVERSE + 4);
    assert!(offset_of!(Contact<f32>, normal) == 0);
    assert!(offset_of!(Contact<f32>, r_a) == 12);
    assert!(offset_of!(Contact<f32>, r_b) == 24);
};

/// A rebound without friction, in f32; nothing in other number types.
#[inline(always)]
pub(super) fn resolve<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    restitution: S,
) -> Option<Impact<S>> {
    let restitution = same(restitution)?;
    let (a, b) = ((a as &mut dyn Any).downcast_mut()?, (b as &mut dyn Any).downcast_mut()?);
    let contact = (contact as &dyn Any).downcast_ref()?;
    // SAFETY: the function reads and writes the velocities of two bodies, which are distinct, reads their inverse masses and
    // tensors and the contact, where the constants above say, and keeps to the calling convention.
    let code = unsafe { strike::strike(a, b, contact, restitution) };
    if code <= 0 {
        return Some(Impact::nothing(outcome(code)));
    }
    let normal_impulse = same(f32::from_bits(code as u32))?;
    Some(Impact { normal_impulse, ..Impact::nothing(Outcome::Slid) })
}

/// What a function in assembly returns where there is no impulse: zero or less, as bits of an impulse are not.
#[cold]
extern "C" fn refused(speed: f32, k: f32) -> i32 {
    (reason(speed, k) as i32).wrapping_neg()
}

/// The outcome that [`refused`] gave. (All of them in order: the compiler then looks nothing up.)
#[inline(always)]
fn outcome(code: i32) -> Outcome {
    match code.wrapping_neg() {
        0 => Outcome::Separating,
        1 => Outcome::Stuck,
        2 => Outcome::Slid,
        3 => Outcome::Immovable,
        _ => Outcome::NotFinite,
    }
}

/// What [`stick::stick`] finds out.
#[repr(C)]
struct Attempt {
    velocity: Vec3<f32>,
    /// K
    inverse_mass: SymMat3<f32>,
    /// Where the points stick, the impulse along the normal and across it.
    normal: f32,
    across: Vec3<f32>,
}

/// The points do not approach each other.
const SEPARATING: u32 = 0;
/// They stick; the impulse is applied.
const STUCK: u32 = 1;
/// They slide.
const SLIDES: u32 = 2;
/// They approach, and more is not known.
const UNKNOWN: u32 = 3;

/// A rebound with friction, in f32; nothing in other number types.
#[inline(always)]
pub(super) fn rub<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    material: &Material<S>,
) -> Option<Impact<S>> {
    // Under the other law an impulse that makes the points stick is not yet the one to apply. Without friction none is found.
    let newton = material.law == RestitutionLaw::Newton;
    let friction = if newton { material.friction() } else { S::ZERO };
    let (restitution, friction) = (same(material.restitution())?, same(friction)?);
    let mut attempt = MaybeUninit::<Attempt>::uninit();
    let code = {
        let (a, b) = ((a as &mut dyn Any).downcast_mut()?, (b as &mut dyn Any).downcast_mut()?);
        let contact = (contact as &dyn Any).downcast_ref()?;
        // SAFETY: as in `resolve`; `attempt` is written in the order of its fields, which are numbers side by side.
        unsafe { stick::stick(a, b, contact, attempt.as_mut_ptr(), restitution, friction) }
    };
    let attempt = attempt.as_ptr();
    if code == STUCK {
        // SAFETY: written where the points stick.
        let (normal, across) = unsafe { ((*attempt).normal, (*attempt).across) };
        let (normal_impulse, friction_impulse) = (same(normal)?, same(across)?);
        return Some(Impact { normal_impulse, friction_impulse, ..Impact::nothing(Outcome::Stuck) });
    }
    let (normal, r) = (contact.normal.get(), [&contact.r_a, &contact.r_b]);
    // SAFETY: always written.
    let velocity = same(Block::<f32> { mantissas: unsafe { (*attempt).velocity }, exponent: () })?;
    if code == SEPARATING {
        return Some(Impact::nothing(unmoved(a, b, velocity, normal, r)));
    }
    // SAFETY: written where the points approach each other.
    let inverse_mass = same(SymBlock::<f32> { mantissas: unsafe { (*attempt).inverse_mass }, exponent: () })?;
    Some(answer(a, b, normal, r, material, (velocity, inverse_mass), newton && code == SLIDES))
}

/// The same value, if the types are the same.
#[inline(always)]
fn same<T: Copy + 'static, U: Copy + 'static>(x: T) -> Option<U> {
    (&x as &dyn Any).downcast_ref().copied()
}
