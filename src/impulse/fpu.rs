//! The kernel in f32 for a Cortex-M with an FPU: what its own instructions do at once, an island of `unsafe`.
//!
//! The compiler loads and stores one number at a time here, and spills what 32 registers do hold. Every bit is that of the
//! portable form: `examples/strikes.rs` prints the same hashes of 32,000 contacts on all cores.
//!
//! Assembly of functions is that of the crate's module, which knows no FPU: each names the least that it needs. Assemblers keep to
//! that up to the next `.fpu`, so assembly of one's own in the same firmware, for a larger FPU, has to name its own.
#![allow(unsafe_code)]

/// `$to = $a $d - $b $c`, all of them registers; `$to` may be `$a` or `$d`.
macro_rules! minor {
    ($to:literal, $a:literal, $d:literal, $b:literal, $c:literal) => {
        concat!("vmul.f32 ", $to, ", ", $a, ", ", $d, "\n vmls.f32 ", $to, ", ", $b, ", ", $c, "\n ")
    };
}

/// `$to = a . b`, three registers each; `$to` may be the first of them. With a sign, the last product is taken away.
macro_rules! dot {
    ($to:literal, [$a0:literal, $a1:literal, - $a2:literal], [$b0:literal, $b1:literal, $b2:literal]) => {
        dot!($to, $a0 $b0 $a1 $b1 "vmls.f32 " $a2 $b2)
    };
    ($to:literal, [$a0:literal, $a1:literal, $a2:literal], [$b0:literal, $b1:literal, $b2:literal]) => {
        dot!($to, $a0 $b0 $a1 $b1 "vmla.f32 " $a2 $b2)
    };
    ($to:literal, $a0:literal $b0:literal $a1:literal $b1:literal $last:literal $a2:literal $b2:literal) => {
        concat!(
            "vmul.f32 ", $to, ", ", $a0, ", ", $b0, "\n vmla.f32 ", $to, ", ", $a1, ", ", $b1, "\n ", $last, $to, ", ", $a2,
            ", ", $b2, "\n ",
        )
    };
}

/// `$x = $least` where it is less.
macro_rules! at_least {
    ($x:literal, $least:literal) => {
        concat!(
            "vcmp.f32 ",
            $x,
            ", ",
            $least,
            "\n vmrs APSR_nzcv, fpscr\n it mi\n vmovmi.f32 ",
            $x,
            ", ",
            $least,
            "\n "
        )
    };
}

mod kick;
mod slide;
mod stick;
mod strike;

use core::any::{Any, TypeId};
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

/// Whether these functions are for that number type.
#[inline(always)]
pub(super) fn computes<S: Scalar>() -> bool {
    TypeId::of::<S>() == TypeId::of::<f32>()
}

/// A rebound without friction, in f32.
#[inline(always)]
pub(super) fn resolve<S: Scalar>(a: &mut Body<S>, b: &mut Body<S>, contact: &Contact<S>, restitution: S) -> Impact<S> {
    struck(a, b, contact, restitution).unwrap_or(Impact::nothing(Outcome::NotFinite))
}

/// The same; nothing in other number types.
#[inline(always)]
fn struck<S: Scalar>(a: &mut Body<S>, b: &mut Body<S>, contact: &Contact<S>, restitution: S) -> Option<Impact<S>> {
    let restitution = same(restitution)?;
    let (a, b) = ((a as &mut dyn Any).downcast_mut()?, (b as &mut dyn Any).downcast_mut()?);
    let contact = (contact as &dyn Any).downcast_ref()?;
    // SAFETY: the function reads and writes the velocities of two bodies, which are distinct, reads their inverse masses and
    // tensors and the contact, where the constants above say, and keeps to the calling convention.
    let code = unsafe { strike::strike(a, b, contact, restitution) };
    let (outcome, bits) = if code > 0 { (Outcome::Slid, code as u32) } else { (outcome(code), 0) };
    Some(Impact { normal_impulse: same(f32::from_bits(bits))?, ..Impact::nothing(outcome) })
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
    /// Where there is one, the impulse along the normal and across it.
    normal: f32,
    across: Vec3<f32>,
}

/// The points do not approach each other.
const SEPARATING: u32 = 0;
/// They stick; the impulse is applied.
const STUCK: u32 = 1;
/// They slide; the impulse is applied.
const SLID: u32 = 2;
/// They approach, and more is not known.
const UNKNOWN: u32 = 3;

/// A rebound with friction, in f32.
#[inline(always)]
pub(super) fn rub<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    material: &Material<S>,
) -> Impact<S> {
    let mut attempt = MaybeUninit::<Attempt>::uninit();
    match found(a, b, contact, material, &mut attempt) {
        Some(Ok(impact)) => impact,
        Some(Err(code)) => without(a, b, contact, material, &attempt, code),
        None => Impact::nothing(Outcome::NotFinite),
    }
}

/// The impact where it is found at once, else which code; nothing in other number types.
#[inline(always)]
fn found<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    material: &Material<S>,
    attempt: &mut MaybeUninit<Attempt>,
) -> Option<Result<Impact<S>, u32>> {
    // Under the other law the impulse found here is not yet the one to apply: with a NaN none is found.
    let restitution = same(material.restitution())?;
    let restitution = if material.law == RestitutionLaw::Newton { restitution } else { f32::NAN };
    let friction = same(material.friction())?;
    let (a, b) = ((a as &mut dyn Any).downcast_mut()?, (b as &mut dyn Any).downcast_mut()?);
    let contact = (contact as &dyn Any).downcast_ref()?;
    // SAFETY: as in `struck`; `attempt` is written in the order of its fields, which are numbers side by side.
    let code = unsafe { stick::stick(a, b, contact, attempt.as_mut_ptr(), restitution, friction) };
    let outcome = match code {
        STUCK => Outcome::Stuck,
        SLID => Outcome::Slid,
        _ => return Some(Err(code)),
    };
    // SAFETY: written with these codes.
    let (normal, across) = unsafe { ((*attempt.as_ptr()).normal, (*attempt.as_ptr()).across) };
    let (normal_impulse, friction_impulse) = (same(normal)?, same(across)?);
    Some(Ok(Impact { normal_impulse, friction_impulse, ..Impact::nothing(outcome) }))
}

/// The rest of it where no impulse was found. (Outside the caller, which then saves fewer registers.)
#[inline(never)]
fn without<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    material: &Material<S>,
    attempt: &MaybeUninit<Attempt>,
    code: u32,
) -> Impact<S> {
    let (normal, r) = (contact.normal.get(), [&contact.r_a, &contact.r_b]);
    let attempt = attempt.as_ptr();
    // SAFETY: always written.
    let velocity = Block::<f32> { mantissas: unsafe { (*attempt).velocity }, exponent: () };
    // In other number types nobody comes here.
    let Some(velocity) = same(velocity) else { return Impact::nothing(Outcome::NotFinite) };
    if code == SEPARATING {
        return Impact::nothing(unmoved(a, b, velocity, normal, r));
    }
    // SAFETY: written where the points approach each other.
    let inverse_mass = SymBlock::<f32> { mantissas: unsafe { (*attempt).inverse_mass }, exponent: () };
    let Some(inverse_mass) = same(inverse_mass) else { return Impact::nothing(Outcome::NotFinite) };
    answer(a, b, normal, r, material, (velocity, inverse_mass))
}

/// The same value, if the types are the same.
#[inline(always)]
fn same<T: Copy + 'static, U: Copy + 'static>(x: T) -> Option<U> {
    (&x as &dyn Any).downcast_ref().copied()
}
