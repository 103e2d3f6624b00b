//! Levers in fixed point: blocks of three 32-bit mantissas under one power of two.
//!
//! An arm is moved left until it fills 31 bits, whatever its format, and everything that follows from it is the upper part
//! of 64-bit sums of products. Nothing here can leave its range: |c| < 2^29.8 for c = r x d, and |u| < 2^29.8 for
//! u = I^-1 c, since the trace of a tensor's block is at most 2^29. Sums are cut off, not rounded: at 2^-28 of |r| and
//! 2^-27 of |I^-1||r|, or less.

use fixed::FixedI32;
use fixed::types::I2F30;

use super::product::{dot, dot2};
use super::scaled32::Scaled32;
use crate::math::{SymMat3, Vec3};

/// A lever in fixed point: the columns c = r x d and u = I^-1 c of an arm r and a direction d.
#[derive(Clone, Copy, Debug)]
pub struct Lever32 {
    cross: [i32; 3],
    turn: [i32; 3],
    /// Of `cross`, as a block of Q2.30.
    cross_exponent: i32,
    /// Of `turn`.
    turn_exponent: i32,
}

/// `x / 2^K` cut off, for results within 32 bits. (From halves: the compiler then knows that a product of it is one of
/// 32-bit numbers.)
#[inline(always)]
pub(super) const fn narrow<const K: u32>(x: i64) -> i32 {
    let (low, high) = (x as u32, (x >> 32) as u32);
    if K == 32 { high as i32 } else { (high.wrapping_shl(32 - K) | low >> K) as i32 }
}

/// `x / 2^places` cut off. `places` in `0..=31`.
#[inline(always)]
pub(super) const fn shift_right(x: i64, places: u32) -> i64 {
    let (low, high) = (x as u32, (x >> 32) as i32);
    let low = low.wrapping_shr(places) | ((high as u32) << 1).wrapping_shl(31 ^ places);
    (high.wrapping_shr(places) as i64) << 32 | low as i64
}

/// `x 2^places / 2^32` cut off, for results within 32 bits. `places` in `0..=31`.
#[inline(always)]
pub(super) const fn shift_left(x: i64, places: u32) -> i32 {
    ((x >> 32) as u32).wrapping_shl(places) as i32 | (x as u32 >> 1).wrapping_shr(31 ^ places) as i32
}

/// A number with as many bits as the largest of three, at least one.
#[inline(always)]
pub(super) const fn magnitude(v: [i32; 3]) -> u32 {
    // x ^ (x >> 31) is |x| for this purpose, without its exception at the lowest number.
    ((v[0] ^ (v[0] >> 31)) | (v[1] ^ (v[1] >> 31)) | (v[2] ^ (v[2] >> 31)) | 1) as u32
}

#[inline(always)]
pub(super) fn bits_of<Frac>(v: &Vec3<FixedI32<Frac>>) -> [i32; 3] {
    [v.x.to_bits(), v.y.to_bits(), v.z.to_bits()]
}

#[inline(always)]
pub(super) fn bits(v: &Vec3<I2F30>) -> [i32; 3] {
    [v.x.to_bits(), v.y.to_bits(), v.z.to_bits()]
}

/// Keeps the loads of one step behind the stores of the last: with all of them first, they outnumber the registers.
#[inline(always)]
fn step() {
    core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
}

impl Lever32 {
    /// For an arm whose components are `r` units of 2^-frac.
    #[inline(never)]
    pub(super) fn new<F>(
        r: &Vec3<FixedI32<F>>,
        d: &Vec3<I2F30>,
        inv_inertia: &SymMat3<I2F30>,
        exponent: i32,
        frac: i32,
    ) -> Self {
        let r = bits_of(r);
        let places = magnitude(r).leading_zeros().wrapping_sub(1);
        let r = [r[0].wrapping_shl(places), r[1].wrapping_shl(places), r[2].wrapping_shl(places)];
        let d = bits(d);
        let m = [d[0].wrapping_neg(), d[1].wrapping_neg(), d[2].wrapping_neg()];
        // On three cores of five there is no multiply-and-subtract: products with -d are added instead.
        let c = [
            narrow::<32>(dot2([r[1], r[2]], [d[2], m[1]])),
            narrow::<32>(dot2([r[2], r[0]], [d[0], m[2]])),
            narrow::<32>(dot2([r[0], r[1]], [d[1], m[0]])),
        ];
        // No arm, no say in which power of two a sum takes.
        let exponent_of_arm = 32i32.wrapping_sub(frac).wrapping_sub(places as i32);
        let cross_exponent = if r[0] | r[1] | r[2] == 0 { Scaled32::LOWEST } else { exponent_of_arm };
        let turn_exponent = cross_exponent.wrapping_add(exponent).wrapping_sub(1);
        step();
        let SymMat3 { xx, xy, xz, yy, yz, zz } = inv_inertia;
        let u0 = narrow::<29>(dot([xx.to_bits(), xy.to_bits(), xz.to_bits()], c));
        step();
        let u1 = narrow::<29>(dot([xy.to_bits(), yy.to_bits(), yz.to_bits()], c));
        step();
        let u2 = narrow::<29>(dot([xz.to_bits(), yz.to_bits(), zz.to_bits()], c));
        Self { cross: c, turn: [u0, u1, u2], cross_exponent, turn_exponent }
    }

    /// c . u as a number of 64 bits and its exponent: the value is `product * 2^(exponent - 60)`.
    #[inline(always)]
    fn inverse_mass(&self) -> (i64, i32) {
        (dot(self.cross, self.turn), self.cross_exponent.wrapping_add(self.turn_exponent))
    }

    #[inline(always)]
    pub(super) fn turn(&self) -> ([i32; 3], i32) {
        (self.turn, self.turn_exponent)
    }
}

/// `v . d + w . c` of both bodies, for components of v and w in units of 2^-frac.
#[inline(always)]
pub(super) fn parting_speed(
    v: [[i32; 3]; 2],
    w: [[i32; 3]; 2],
    d: [&Vec3<I2F30>; 2],
    levers: [&Lever32; 2],
    frac: i32,
) -> Scaled32 {
    // Speeds are added up in units of 2^-22 of the last place, or less where the format is coarse and so the arms long.
    let coarse: i32 = match frac {
        26.. => 3,
        12.. => 8,
        _ => 16,
    };
    let [va, vb] = v;
    let linear = dot(va, bits(d[0])).wrapping_add(dot(vb, bits(d[1])));
    let [wa, wb] = w;
    let (turned_a, turned_b) = (dot(wa, levers[0].cross), dot(wb, levers[1].cross));
    let (down_a, down_b) =
        (coarse.wrapping_sub(levers[0].cross_exponent), coarse.wrapping_sub(levers[1].cross_exponent));
    // Below zero: arms too long for the common power of two.
    if down_a | down_b < 0 {
        return far_parting_speed(linear, [turned_a, turned_b], levers, frac);
    }
    let turned =
        shift_right(turned_a, (down_a as u32).min(31)).wrapping_add(shift_right(turned_b, (down_b as u32).min(31)));
    let speed = (linear >> coarse).wrapping_add(turned);
    let sign = (speed >> 32) as i32 >> 31;
    if (speed >> 32) as i32 == sign {
        return far_parting_speed(linear, [turned_a, turned_b], levers, frac);
    }
    Scaled32::cut(speed, coarse.wrapping_sub(frac).wrapping_sub(30))
}

/// The same for arms of any length, and for the slowest speeds: nothing is cut off before the terms are added.
#[cold]
#[inline(never)]
fn far_parting_speed(linear: i64, turned: [i64; 2], levers: [&Lever32; 2], frac: i32) -> Scaled32 {
    let exponent = (-30i32).wrapping_sub(frac);
    let a = Scaled32::new(turned[0], exponent.wrapping_add(levers[0].cross_exponent));
    let b = Scaled32::new(turned[1], exponent.wrapping_add(levers[1].cross_exponent));
    Scaled32::new(linear, exponent) + (a + b)
}

/// `mantissa` moved to the exponent `top`, from one below it.
#[inline(always)]
const fn lowered((mantissa, exponent): (u32, i32), top: i32) -> u32 {
    let down = top.wrapping_sub(exponent) as u32;
    mantissa.wrapping_shr(if down > 31 { 31 } else { down })
}

/// Four numbers of at most 30 bits, with exponents, added up.
#[inline(always)]
fn sum(terms: [(u32, i32); 4]) -> Scaled32 {
    let [a, b, c, d] = terms;
    let mut top = a.1;
    if b.1 > top {
        top = b.1;
    }
    if c.1 > top {
        top = c.1;
    }
    if d.1 > top {
        top = d.1;
    }
    let top = top.wrapping_add(1);
    let (ab, cd) = (lowered(a, top).wrapping_add(lowered(b, top)), lowered(c, top).wrapping_add(lowered(d, top)));
    Scaled32::cut32(ab.wrapping_add(cd), top.wrapping_add(2))
}

#[inline(always)]
fn mass_term(inv_mass: Scaled32) -> (u32, i32) {
    (inv_mass.mantissa() as u32, inv_mass.exponent())
}

/// c . u with 30 bits. Never negative, and cutting off must not make it so.
#[inline(always)]
fn turn_term(lever: &Lever32) -> (u32, i32) {
    let (product, exponent) = lever.inverse_mass();
    // Below 2^59.6.
    let product = if product < 0 { 0 } else { narrow::<28>(product) as u32 };
    let zeros = (product | 1).leading_zeros();
    (product.wrapping_shl(zeros) >> 2, exponent.wrapping_sub(zeros as i32))
}

/// 1/m + c . u of both bodies.
#[inline(always)]
pub(super) fn inverse_mass(inv_masses: [Scaled32; 2], levers: [&Lever32; 2]) -> Scaled32 {
    sum([mass_term(inv_masses[0]), mass_term(inv_masses[1]), turn_term(levers[0]), turn_term(levers[1])])
}
