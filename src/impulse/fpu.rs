//! The kernel in f32 for a Cortex-M with an FPU: what its own instructions do at once, an island of `unsafe`.
//!
//! The compiler loads and stores one number at a time here, and spills what 32 registers do hold. Every bit is that of the
//! portable form: `examples/strikes.rs` prints the same hashes of 32,000 contacts on all cores.
#![allow(unsafe_code)]

mod strike;

use core::any::Any;
use core::mem::offset_of;

use super::lever::reason;
use super::{Impact, Outcome};
use crate::body::Body;
use crate::contact::Contact;
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
    let (a, b) = ((a as &mut dyn Any).downcast_mut()?, (b as &mut dyn Any).downcast_mut()?);
    let contact = (contact as &dyn Any).downcast_ref()?;
    let restitution = *(&restitution as &dyn Any).downcast_ref::<f32>()?;
    // SAFETY: the function reads and writes the velocities of two bodies, which are distinct, reads their inverse masses and
    // tensors and the contact, where the constants above say, and keeps to the calling convention.
    let code = unsafe { strike::strike(a, b, contact, restitution) };
    if code <= 0 {
        return Some(Impact::nothing(outcome(code)));
    }
    let normal_impulse = *(&f32::from_bits(code as u32) as &dyn Any).downcast_ref()?;
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
