//! Levers in fixed point: blocks of three 32-bit mantissas under one power of two.
//!
//! An arm is moved left until it fills 31 bits, whatever its format, and everything that follows from it is the upper part
//! of 64-bit sums of products. Nothing here can leave its range: |c| < 2^29.8 for c = r x d, and |u| < 2^29.8 for
//! u = I^-1 c, since the trace of a tensor's block is at most 2^29. Sums are cut off, not rounded: at 2^-28 of |r| and
//! 2^-27 of |I^-1||r|, or less.

use fixed::types::I2F30;

use super::integer::{high_product, leading_zeros};
use super::machine::{at_most_31, shift_left, shift_right};
use super::product::{add_dot, dot};
use super::scaled32::Scaled32;
use super::wide::bits;
use crate::math::Vec3;

/// A lever in fixed point: of the columns c = r x d and u = I^-1 c of an arm r and a direction d, what the kernel needs.
///
/// It knows no format: exponents are those of an arm in units of 2^-32, to which each user adds those of its own.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Lever32 {
    /// w . c for the body's angular velocity w, in units of 2^(2 - 2 frac - places).
    pub(super) spin: i64,
    /// u, as a block of Q2.30.
    pub(super) turn: Vec3<I2F30>,
    /// By how much the arm was moved left: 30 at most.
    pub(super) places: i32,
    pub(super) turn_exponent: i32,
    /// c . u with 30 bits, in units of 2^(inverse_mass_exponent - 30).
    pub(super) inverse_mass: u32,
    pub(super) inverse_mass_exponent: i32,
}

impl Lever32 {
    /// I^-1 (r x d) for an arm in units of 2^-frac, as a block and its exponent.
    #[cfg(not(multiply = "short"))]
    #[inline(always)]
    pub(super) fn turn(&self, frac: i32) -> (&Vec3<I2F30>, i32) {
        (&self.turn, self.turn_exponent.wrapping_add(31i32.wrapping_sub(frac)))
    }

    /// c . u for an arm in units of 2^-frac, with its exponent.
    #[inline(always)]
    fn inverse_mass(&self, frac: i32) -> (u32, i32) {
        (self.inverse_mass, self.inverse_mass_exponent.wrapping_add(67i32.wrapping_sub(frac.wrapping_mul(2))))
    }
}

/// `v . d` of both bodies, added up.
#[inline(always)]
fn linear_speed(v: [[i32; 3]; 2], d: [&Vec3<I2F30>; 2]) -> i64 {
    let ([va, vb], [da, db]) = (v, [bits(d[0]), bits(d[1])]);
    add_dot(dot(va, da), vb, db)
}

/// Speeds are added up in units of 2^-22 of the last place, or less where the format is coarse and so the arms long.
#[inline(always)]
pub(super) const fn places_of_speed(frac: i32) -> i32 {
    match frac {
        26.. => 3,
        12.. => 8,
        _ => 16,
    }
}

/// `v . d + w . c` of both bodies for components of v in units of 2^-frac, and the units of the result; `None` where the arms
/// are too long for common ones, or the speed has less than 32 bits.
#[inline(always)]
fn near_speed(linear: i64, levers: [&Lever32; 2], frac: i32) -> Option<(i64, i32)> {
    let coarse = places_of_speed(frac);
    let [a, b] = levers;
    // 31 at most.
    let fewer = 32i32.wrapping_sub(frac).wrapping_sub(coarse);
    let (down_a, down_b) = (a.places.wrapping_sub(fewer), b.places.wrapping_sub(fewer));
    if down_a | down_b < 0 {
        return None;
    }
    let turned = shift_right(a.spin, down_a as u32).wrapping_add(shift_right(b.spin, down_b as u32));
    let speed = (linear >> coarse).wrapping_add(turned);
    if (speed >> 32) as i32 == (speed >> 32) as i32 >> 31 {
        return None;
    }
    Some((speed, coarse.wrapping_sub(frac).wrapping_sub(30)))
}

/// The speed at which two points part.
#[inline(always)]
pub(super) fn parting_speed(v: [[i32; 3]; 2], d: [&Vec3<I2F30>; 2], levers: [&Lever32; 2], frac: i32) -> Scaled32 {
    let linear = linear_speed(v, d);
    match near_speed(linear, levers, frac) {
        Some((speed, exponent)) => Scaled32::cut(speed, exponent),
        None => far_parting_speed(linear, levers, frac),
    }
}

/// `-(1 + e) speed / k` where the points approach each other, or else the speed and k: `factor` is 1 + e in Q2.30.
#[inline(always)]
pub(super) fn approach_impulse(
    factor: u32,
    v: [[i32; 3]; 2],
    d: [&Vec3<I2F30>; 2],
    inv_masses: [Scaled32; 2],
    levers: [&Lever32; 2],
    frac: i32,
) -> Result<Scaled32, (Scaled32, Scaled32)> {
    let linear = linear_speed(v, d);
    let (speed, exponent) = match near_speed(linear, levers, frac) {
        Some(near) => near,
        None => {
            let speed = far_parting_speed(linear, levers, frac);
            ((speed.mantissa() as i64) << 32, speed.exponent().wrapping_sub(62))
        }
    };
    let (k, k_exponent) = inverse_mass_sum(inv_masses, levers, frac);
    if speed >= 0 || k == 0 {
        return Err((Scaled32::new(speed, exponent), Scaled32::new(k as i64, k_exponent.wrapping_sub(30))));
    }
    // The leading 32 bits of the speed, of which there are more.
    let speed = speed.wrapping_neg();
    let zeros = leading_zeros((speed >> 32) as u32 | 1);
    let n = high_product(shift_left(speed, zeros) as u32, factor);
    Ok(Scaled32::leading_quotient((n, exponent.wrapping_sub(zeros as i32).wrapping_add(64)), (k, k_exponent)))
}

/// What [`near_speed`] adds up, for arms of any length and the slowest speeds: nothing is cut off before the terms are added.
#[cold]
#[inline(never)]
fn far_parting_speed(linear: i64, [a, b]: [&Lever32; 2], frac: i32) -> Scaled32 {
    let exponent = (-30i32).wrapping_sub(frac);
    let of_arm = exponent.wrapping_add(32).wrapping_sub(frac);
    let turned_a = Scaled32::new(a.spin, of_arm.wrapping_sub(a.places));
    let turned_b = Scaled32::new(b.spin, of_arm.wrapping_sub(b.places));
    Scaled32::new(linear, exponent) + (turned_a + turned_b)
}

/// `mantissa` moved to the exponent `top`, from one below it.
#[inline(always)]
fn lowered((mantissa, exponent): (u32, i32), top: i32) -> u32 {
    mantissa.wrapping_shr(at_most_31(top.wrapping_sub(exponent)))
}

/// 1/m + c . u of both bodies: a number of at most 32 bits in units of 2^(exponent - 30).
#[inline(always)]
fn inverse_mass_sum([ma, mb]: [Scaled32; 2], [a, b]: [&Lever32; 2], frac: i32) -> (u32, i32) {
    let terms = [
        (ma.mantissa() as u32, ma.exponent()),
        (mb.mantissa() as u32, mb.exponent()),
        a.inverse_mass(frac),
        b.inverse_mass(frac),
    ];
    let mut top = terms[0].1;
    if terms[1].1 > top {
        top = terms[1].1;
    }
    if terms[2].1 > top {
        top = terms[2].1;
    }
    if terms[3].1 > top {
        top = terms[3].1;
    }
    let top = top.wrapping_add(1);
    // Four times 2^29.
    let masses = lowered(terms[0], top).wrapping_add(lowered(terms[1], top));
    (masses.wrapping_add(lowered(terms[2], top)).wrapping_add(lowered(terms[3], top)), top)
}

/// 1/m + c . u of both bodies.
#[inline(always)]
pub(super) fn inverse_mass(inv_masses: [Scaled32; 2], levers: [&Lever32; 2], frac: i32) -> Scaled32 {
    let (k, exponent) = inverse_mass_sum(inv_masses, levers, frac);
    Scaled32::cut32(k, exponent.wrapping_add(2))
}
