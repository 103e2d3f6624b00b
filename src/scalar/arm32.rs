//! Arms in fixed point: what a contact point's velocity is, and what it opposes to impulses in any direction.
//!
//! As in `lever32.rs`, blocks of 32-bit mantissas under one power of two, made of the upper parts of 64-bit sums, cut off. No
//! sum here can leave 64 bits: |W| < 2^30.8 for W = I^-1 (r x .), since the trace of a tensor's block is at most 2^29.

use fixed::FixedI32;
use fixed::types::I2F30;

use super::integer::leading_zeros;
use super::machine::at_most_31;
use super::product::{add_dot2, dot, raised_difference};
use super::scaled32::Scaled32;
use super::wide::{bits_of, high, magnitude, max, minus, narrow, shift_left, shift_right};
use super::{Scalar, Scaled};
use crate::math::Vec3;

/// An arm r in fixed point, and W = I^-1 (r x .).
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Arm32 {
    /// Within 2^30, in units of `2^exponent`.
    pub(super) r: [i32; 3],
    pub(super) exponent: i32,
    /// The rows of W, in units of `2^turn_exponent`.
    pub(super) turn: [[i32; 3]; 3],
    pub(super) turn_exponent: i32,
}

impl Arm32 {
    /// W j for a vector within 2^30.8, within 2^30.7, and its exponent.
    #[inline(always)]
    pub(super) fn turn(&self, j: [i32; 3]) -> ([i32; 3], i32) {
        let [x, y, z] = self.turn;
        // |W| < 2^30.8 a row.
        let turn = [narrow::<31>(dot(x, j)), narrow::<31>(dot(y, j)), narrow::<31>(dot(z, j))];
        (turn, self.turn_exponent.wrapping_add(31))
    }

    #[inline(always)]
    fn inverse_mass_exponent(&self) -> i32 {
        self.exponent.wrapping_add(self.turn_exponent)
    }

    /// The arm in units of `2^places` of its own.
    #[inline(always)]
    fn lowered(&self, places: i32) -> [i32; 3] {
        let places = if places > 31 { 31 } else { places as u32 };
        [self.r[0].wrapping_shr(places), self.r[1].wrapping_shr(places), self.r[2].wrapping_shr(places)]
    }
}

/// `start + a . b + c . d`
#[inline(always)]
fn sum(start: i64, a: [i32; 2], b: [i32; 2], c: [i32; 2], d: [i32; 2]) -> i64 {
    add_dot2(add_dot2(start, a, b), c, d)
}

/// (r x .)^T W of both bodies and `least` on the diagonal, as 64-bit sums: xx, xy, xz, yy, yz, zz.
#[inline(always)]
fn inverse_mass_sums(a: &Arm32, b: &Arm32, r: [[i32; 3]; 2], least: i64) -> [i64; 6] {
    let [ra, rb] = r;
    let [ax, ay, az] = a.turn;
    let [bx, by, bz] = b.turn;
    let [[ma, na, oa], [mb, nb, ob]] = [minus(ra), minus(rb)];
    [
        sum(least, [ay[0], az[0]], [ra[2], na], [by[0], bz[0]], [rb[2], nb]),
        sum(0, [ay[1], az[1]], [ra[2], na], [by[1], bz[1]], [rb[2], nb]),
        sum(0, [ay[2], az[2]], [ra[2], na], [by[2], bz[2]], [rb[2], nb]),
        sum(least, [az[1], ax[1]], [ra[0], oa], [bz[1], bx[1]], [rb[0], ob]),
        sum(0, [az[2], ax[2]], [ra[0], oa], [bz[2], bx[2]], [rb[0], ob]),
        sum(least, [ax[2], ay[2]], [ra[1], ma], [bx[2], by[2]], [rb[1], mb]),
    ]
}

/// K of a contact: a block whose largest element has 31 bits, and its exponent.
#[inline(always)]
pub(super) fn inverse_mass(inv_masses: [Scaled32; 2], arms: [&Arm32; 2]) -> ([i32; 6], i32) {
    let [ma, mb] = inv_masses;
    let [a, b] = arms;
    // The masses as one number of 31 bits, in units of 2^(top - 30).
    let top = max(ma.exponent(), mb.exponent());
    let masses = lowered(ma, top).wrapping_add(lowered(mb, top));
    // The common unit: that of the larger arm, or where the masses outweigh them by far, theirs. Sums stay below 2^62.9.
    let (of_a, of_b) = (a.inverse_mass_exponent(), b.inverse_mass_exponent());
    let unit = max(max(of_a, of_b), top.wrapping_sub(60));
    let r = [a.lowered(unit.wrapping_sub(of_a)), b.lowered(unit.wrapping_sub(of_b))];
    let down = unit.wrapping_sub(top).wrapping_add(60);
    let least = if down > 31 { far_mass(masses, down) } else { shift_right((masses as i64) << 30, down as u32) };
    let [xx, xy, xz, yy, yz, zz] = inverse_mass_sums(a, b, r, least);
    // Cut off, an element beside the diagonal can be the largest by a unit or two.
    let largest = max(max(high(xx), high(yy)), high(zz)).wrapping_add(2) | 1;
    let up = leading_zeros(largest as u32).wrapping_sub(1);
    let k = [
        shift_left(xx, up),
        shift_left(xy, up),
        shift_left(xz, up),
        shift_left(yy, up),
        shift_left(yz, up),
        shift_left(zz, up),
    ];
    (k, unit.wrapping_add(32).wrapping_sub(up as i32))
}

/// `masses 2^30 / 2^down` for masses that hardly count beside the arms.
#[cold]
#[inline(never)]
fn far_mass(masses: u32, down: i32) -> i64 {
    ((masses as i64) << 30).wrapping_shr(if down > 63 { 63 } else { down as u32 })
}

/// The mantissa of a number that is not negative, in units of 2^(top - 30).
#[inline(always)]
fn lowered(x: Scaled32, top: i32) -> u32 {
    (x.mantissa() as u32).wrapping_shr(at_most_31(top.wrapping_sub(x.exponent())))
}

/// v + w x r of the second body less that of the first, for components in units of 2^-frac: mantissas within 2^29 and their
/// exponent.
#[inline(always)]
pub(super) fn velocity<F>(
    v: [&Vec3<FixedI32<F>>; 2],
    w: [&Vec3<FixedI32<F>>; 2],
    r: [&Vec3<FixedI32<F>>; 2],
    frac: i32,
) -> Option<([i32; 3], i32)> {
    let ([va, vb], [wa, wb], [ra, rb]) =
        ([bits_of(v[0]), bits_of(v[1])], [bits_of(w[0]), bits_of(w[1])], [bits_of(r[0]), bits_of(r[1])]);
    // Products of 60 bits: four of them and the velocities stay within 63. And what can change its sign.
    let (of_wa, of_ra) = (magnitude(wa), magnitude(ra));
    let large = (of_wa | magnitude(wb) | magnitude(rb)) >> 30 != 0;
    if large || (of_ra >> 30 != 0 && of_wa >> 29 != 0) {
        return None;
    }
    let (m, n) = (minus(wa), minus(rb));
    let places = frac as u32;
    let x = sum(raised_difference(vb[0], va[0], places), [wb[1], wb[2]], [rb[2], n[1]], [m[1], wa[2]], [ra[2], ra[1]]);
    let y = sum(raised_difference(vb[1], va[1], places), [wb[2], wb[0]], [rb[0], n[2]], [m[2], wa[0]], [ra[0], ra[2]]);
    let z = sum(raised_difference(vb[2], va[2], places), [wb[0], wb[1]], [rb[1], n[0]], [m[0], wa[1]], [ra[1], ra[0]]);
    Some(leading(x, y, z, frac.wrapping_mul(-2)))
}

/// Three 64-bit numbers as a block within 2^29, rounded, and their exponent with it.
#[inline(always)]
fn leading(x: i64, y: i64, z: i64, exponent: i32) -> ([i32; 3], i32) {
    let (mut x, mut y, mut z, mut exponent) = (x, y, z, exponent);
    if magnitude([high(x), high(y), high(z)]) == 1 {
        // Within 2^33, and exact from here on.
        (x, y, z, exponent) = (x << 28, y << 28, z << 28, exponent.wrapping_sub(28));
    }
    let up = leading_zeros(magnitude([high(x), high(y), high(z)])).wrapping_sub(1);
    ([rounded(x, up), rounded(y, up), rounded(z, up)], exponent.wrapping_add(34).wrapping_sub(up as i32))
}

/// `x 2^up / 2^34`, rounded.
#[inline(always)]
const fn rounded(x: i64, up: u32) -> i32 {
    (shift_left(x, up) >> 1).wrapping_add(1) >> 1
}

/// The same by numbers with exponents of their own, for what is near the end of the range.
#[cold]
#[inline(never)]
pub(super) fn far_velocity<S: Scalar<Scaled = Scaled32>>(
    v: [&Vec3<S>; 2],
    w: [&Vec3<S>; 2],
    r: [&Vec3<S>; 2],
) -> ([I2F30; 3], i32) {
    let scaled = |v: &Vec3<S>| [v.x.to_scaled(), v.y.to_scaled(), v.z.to_scaled()];
    let ([va, vb], [wa, wb], [ra, rb]) =
        ([scaled(v[0]), scaled(v[1])], [scaled(w[0]), scaled(w[1])], [scaled(r[0]), scaled(r[1])]);
    let component = |x: usize, y: usize, z: usize| {
        let turned_b = wb[y] * rb[z] - wb[z] * rb[y];
        let turned_a = wa[y] * ra[z] - wa[z] * ra[y];
        (vb[x] - va[x]) + (turned_b - turned_a)
    };
    Scaled32::align3([component(0, 1, 2), component(1, 2, 0), component(2, 0, 1)])
}
