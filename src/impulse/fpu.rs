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

use core::any::TypeId;
use core::mem::{offset_of, transmute};

use super::rub::rub as portable_rub;
use super::{Impact, Outcome};
use crate::body::Body;
use crate::contact::{Contact, Material, RestitutionLaw};
use crate::scalar::Scalar;

/// Where a body's velocities begin, and where its inverse mass and inertia do.
const MOTION: usize = offset_of!(Body<f32>, linear_velocity);
const INVERSE: usize = offset_of!(Body<f32>, inv_mass);

/// How long an impact's impulses are, and where it says what happened, from their end on.
const IMPULSES: usize = 16;
const OUTCOME: usize = offset_of!(Impact<f32>, outcome) - IMPULSES;

/// What is loaded or stored at once lies side by side.
const _: () = {
    assert!(offset_of!(Impact<f32>, normal_impulse) == 0);
    assert!(offset_of!(Impact<f32>, friction_impulse) + 12 == IMPULSES);
    assert!(offset_of!(Impact<f32>, saturated) == IMPULSES + OUTCOME + 1);
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

/// A rebound without friction, in f32: elsewhere nothing is done.
#[inline(always)]
pub(super) fn resolve<S: Scalar>(a: &mut Body<S>, b: &mut Body<S>, contact: &Contact<S>, restitution: S) -> Impact<S> {
    type Strike<S> = unsafe extern "C" fn(&mut Body<S>, &mut Body<S>, &Contact<S>, S) -> Impact<S>;
    if !computes::<S>() {
        return Impact::nothing(Outcome::NotFinite);
    }
    // SAFETY: S is f32, so both types of function are the same. It reads and writes the velocities of two bodies, which are
    // distinct, reads their inverse masses and tensors and the contact, where the constants above say, writes the impact, and
    // keeps to the calling convention.
    unsafe { transmute::<Strike<f32>, Strike<S>>(strike::strike)(a, b, contact, restitution) }
}

/// A rebound with friction, in f32: elsewhere nothing is done.
#[inline(always)]
pub(super) fn rub<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    material: &Material<S>,
) -> Impact<S> {
    type Stick<S> = unsafe extern "C" fn(&mut Body<S>, &mut Body<S>, &Contact<S>, S, S) -> Impact<S>;
    if !computes::<S>() {
        return Impact::nothing(Outcome::NotFinite);
    }
    // The impulse found at once is not yet the one to apply under the other law.
    if material.law != RestitutionLaw::Newton {
        return portably(a, b, contact, material);
    }
    // SAFETY: as in `resolve`.
    unsafe {
        let stick = transmute::<Stick<f32>, Stick<S>>(stick::stick);
        stick(a, b, contact, material.restitution(), material.friction())
    }
}

/// What the functions in assembly leave to the portable form.
#[cold]
extern "C" fn portable(
    a: &mut Body<f32>,
    b: &mut Body<f32>,
    contact: &Contact<f32>,
    restitution: f32,
    friction: f32,
) -> Impact<f32> {
    portably(a, b, contact, &Material::from_valid(restitution, friction))
}

/// The portable form.
#[cold]
#[inline(never)]
fn portably<S: Scalar>(a: &mut Body<S>, b: &mut Body<S>, contact: &Contact<S>, material: &Material<S>) -> Impact<S> {
    portable_rub(a, b, contact.normal.get(), [&contact.r_a, &contact.r_b], material, true)
}
