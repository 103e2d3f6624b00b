//! One contact with friction in fixed point: the equations of `impulse/friction.rs` and `impulse/slip.rs` in integers.
//!
//! Every quantity is brought to 30 bits once and keeps a fixed place from there on; sums of products are exact in 64 bits and
//! cut off. That takes well-conditioned contacts: where one of the guards below fails, the caller solves the same
//! equations in [`Scaled32`](super::scaled32::Scaled32), whose numbers keep an exponent each. Products and sums of numbers
//! in Q2.30 are written `times30` and `dot30`; where it is not plain, the bound that keeps a result within 32 bits stands
//! beside it.

use super::integer::{leading_zeros, leading_zeros64, long_quotient};
use super::machine::times30;
use super::product::{dot, dot2, product};
use super::slip32::Slip32;
use super::wide::{dot30, high, inverse, leading32, magnitude, max, min, minus, narrow, plus30, shift_left};

/// An impulse in units of 2^exponent: along the normal, across it, and the whole. Its length is within 2^30.5 where the points
/// slide, and its components within 2^30 where they stick.
pub(super) struct Impulse32 {
    pub normal: i32,
    pub across: [i32; 3],
    pub whole: [i32; 3],
    pub exponent: i32,
    pub stuck: bool,
}

/// A contact: K, whose largest element has 31 bits; the relative velocity within 2^29; both in units of a power of two. The unit
/// normal, restitution and friction in Q2.30.
pub(super) struct Contact32 {
    pub inverse_mass: [i32; 6],
    pub inverse_mass_exponent: i32,
    pub velocity: [i32; 3],
    pub velocity_exponent: i32,
    pub normal: [i32; 3],
    pub restitution: i32,
    pub friction: i32,
}

/// One in Q2.30.
pub(super) const ONE: i32 = 1 << 30;

impl Contact32 {
    /// K d for a unit vector d, in units twice those of K.
    #[inline(always)]
    fn half_change(&self, d: [i32; 3]) -> [i32; 3] {
        let [xx, xy, xz, yy, yz, zz] = self.inverse_mass;
        [narrow::<31>(dot([xx, xy, xz], d)), narrow::<31>(dot([xy, yy, yz], d)), narrow::<31>(dot([xz, yz, zz], d))]
    }

    /// The impulse, for approaching points; nothing where the contact is not well conditioned.
    #[inline(always)]
    pub fn solve(&self) -> Option<Impulse32> {
        // |v_n| < 2^29.8, and v_n' - v_n, twice that at most.
        let speed = dot30(self.velocity, self.normal);
        let bounce = times30(self.restitution, speed);
        let stuck = self.sticking(bounce)?;
        if stuck.stuck { Some(stuck) } else { self.sliding(speed.wrapping_add(bounce)) }
    }

    /// The impulse that brings v_n' = -e v_n and v_t' = 0, from the adjugate of K, and whether friction can hold it.
    #[inline(always)]
    fn sticking(&self, bounce: i32) -> Option<Impulse32> {
        let n = self.normal;
        let [xx, xy, xz, yy, yz, zz] = self.inverse_mass;
        let m = minus([xy, xz, yz]);
        let (a_xx, a_yy, a_zz) = (minor(yy, zz, yz, m[2]), minor(xx, zz, xz, m[1]), minor(xx, yy, xy, m[0]));
        let (a_xy, a_xz, a_yz) = (minor(xz, yz, m[0], zz), minor(xy, yz, m[1], yy), minor(xy, xz, xx, m[2]));
        let up = leading_zeros(max(max(high(a_xx), high(a_yy)), high(a_zz)) as u32 | 1).wrapping_sub(1);
        let rows = [
            [shift_left(a_xx, up), shift_left(a_xy, up), shift_left(a_xz, up)],
            [shift_left(a_xy, up), shift_left(a_yy, up), shift_left(a_yz, up)],
            [shift_left(a_xz, up), shift_left(a_yz, up), shift_left(a_zz, up)],
        ];
        // Of 2^62 at most; digits are lost by as much as it is less.
        let determinant = dot([xx, xy, xz], rows[0]);
        if determinant < 1 << LEAST_DETERMINANT {
            return None;
        }
        let zeros = leading_zeros64(determinant as u64);
        let over = inverse(leading32(determinant, zeros));
        let v = plus30(self.velocity, n, bounce);
        // |v| < 2^30.8, and a row of the adjugate is below 2^31.8.
        let [x, y, z] = [dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)];
        let up = leading_zeros(magnitude([high(x), high(y), high(z)])).wrapping_sub(1);
        let answer = [shift_left(x, up) >> 1, shift_left(y, up) >> 1, shift_left(z, up) >> 1];
        let whole = minus([times30(answer[0], over), times30(answer[1], over), times30(answer[2], over)]);
        let normal = dot30(whole, n);
        let across = plus30(whole, n, normal.wrapping_neg());
        let limit = narrow::<31>(product(self.friction, normal));
        let stuck = normal > 0 && dot(across, across) >> 2 <= product(limit, limit);
        let exponent = (zeros as i32)
            .wrapping_sub(up as i32)
            .wrapping_sub(30)
            .wrapping_add(self.velocity_exponent)
            .wrapping_sub(self.inverse_mass_exponent);
        Some(Impulse32 { normal, across, whole, exponent, stuck })
    }

    /// The impulse on the friction cone, for b = (1 + e) v_n.
    #[inline(always)]
    fn sliding(&self, b: i32) -> Option<Impulse32> {
        let n = self.normal;
        let [t1, t2] = tangents(n);
        // All of K in units twice its own.
        let (k_n, k_1) = (self.half_change(n), self.half_change(t1));
        let (nn, n1, n2) = (dot30(k_n, n), dot30(k_n, t1), dot30(k_n, t2));
        if nn < 1 << 27 {
            return None;
        }
        let (k11, k12) = (dot30(k_1, t1), dot30(k_1, t2));
        // What is left of the trace. Sums may wrap; what is left fits.
        let [xx, _, _, yy, _, zz] = self.inverse_mass;
        let k22 = (xx >> 1).wrapping_add(yy >> 1).wrapping_add(zz >> 1).wrapping_sub(nn).wrapping_sub(k11);

        // K_nt / K_nn in Q5.27.
        let nn_zeros = leading_zeros(nn as u32);
        let over_nn = inverse((nn as u32).wrapping_shl(nn_zeros));
        let down = 4u32.wrapping_sub(nn_zeros);
        let g = [times30(n1, over_nn).wrapping_shr(down), times30(n2, over_nn).wrapping_shr(down)];
        let (s11, s12, s22) = (less(k11, n1, g[0]), less(k12, n1, g[1]), less(k22, n2, g[1]));
        let m = max(s11, s22);
        if m < 1 << 24 {
            return None;
        }

        // S over its larger diagonal element in Q2.30.
        let m_zeros = leading_zeros(m as u32);
        let over_m = inverse((m as u32).wrapping_shl(m_zeros));
        let up = m_zeros.wrapping_sub(1);
        let s11 = times30(max(s11, 0).wrapping_shl(up), over_m);
        let s22 = times30(max(s22, 0).wrapping_shl(up), over_m);
        let s12 = times30(min(max(s12, m.wrapping_neg()), m).wrapping_shl(up), over_m);
        let determinant = narrow::<30>(dot2([s11, s12], [s22, s12.wrapping_neg()]));
        if determinant < 1 << 14 {
            return None;
        }

        // q in units of 2^(7 - up) of the velocity, within 2^29.
        let v = self.velocity;
        let q = [(dot(v, t1) >> 3).wrapping_sub(product(g[0], b)), (dot(v, t2) >> 3).wrapping_sub(product(g[1], b))];
        let up = leading_zeros(magnitude([high(q[0]), high(q[1]), 0])).wrapping_sub(1);
        let q = [shift_left(q[0], up) >> 2, shift_left(q[1], up) >> 2];

        // mu m / K_nn in Q(nn_zeros + 2).30, and times -b in the units of q.
        let load = narrow::<31>(product(self.friction, times30(m, over_nn)));
        let load = product(load, b.wrapping_neg()).wrapping_shr(37u32.wrapping_sub(nn_zeros).wrapping_sub(up));
        let minus_mu = self.friction.wrapping_neg();
        let coupling = [product(minus_mu, g[0]), product(minus_mu, g[1])];
        // -mu K_nt / K_nn within 1, and at least a few bits of sliding left.
        if load >= 1 << 30 || up > 24 || magnitude([high(coupling[0]), high(coupling[1]), 0]) >= 1 << 25 {
            return None;
        }
        let slip = Slip32 {
            q,
            p: [
                narrow::<30>(dot2([s22.wrapping_sub(ONE), s12.wrapping_neg()], q)),
                narrow::<30>(dot2([s12.wrapping_neg(), s11.wrapping_sub(ONE)], q)),
            ],
            half_trace: (s11 >> 1).wrapping_add(s22 >> 1),
            determinant,
            load: load as i32,
            coupling: [narrow::<27>(coupling[0]), narrow::<27>(coupling[1])],
        };
        let d = slip.direction();

        // The normal row: K_nn j_n - mu j_n K_nt . d = -b.
        let along = narrow::<30>(dot2([n1, n2], d));
        let yields = ((nn as i64) << 30).wrapping_sub(product(self.friction, along));
        // Where friction presses the bodies together, this is a quotient of small differences.
        if yields < (nn as i64) << 27 {
            return None;
        }
        let zeros = leading_zeros64(yields as u64);
        let b_zeros = leading_zeros(b.unsigned_abs());
        let quotient = long_quotient(b.unsigned_abs().wrapping_shl(b_zeros), leading32(yields, zeros));
        // The whole within 2^30.5.
        let places = if self.friction > ONE { 2 } else { 1 };
        let normal = quotient.wrapping_shr(places as u32) as i32;
        let friction = times30(self.friction, normal).wrapping_neg();
        let across = [
            times30(friction, narrow::<30>(dot2([t1[0], t2[0]], d))),
            times30(friction, narrow::<30>(dot2([t1[1], t2[1]], d))),
            times30(friction, narrow::<30>(dot2([t1[2], t2[2]], d))),
        ];
        let whole = plus30(across, n, normal);
        let exponent = (zeros as i32)
            .wrapping_sub(b_zeros as i32)
            .wrapping_sub(33)
            .wrapping_add(places)
            .wrapping_add(self.velocity_exponent)
            .wrapping_sub(self.inverse_mass_exponent);
        Some(Impulse32 { normal, across, whole, exponent, stuck: false })
    }
}

/// `a b - c d` for `minus_d` = -d.
#[inline(always)]
fn minor(a: i32, b: i32, c: i32, minus_d: i32) -> i64 {
    dot2([a, c], [b, minus_d])
}

/// `k - a g` for `g` in Q5.27.
#[inline(always)]
fn less(k: i32, a: i32, g: i32) -> i32 {
    k.wrapping_sub(narrow::<27>(product(a, g)))
}

/// The exponent of the least determinant for which the adjugate is precise enough.
const LEAST_DETERMINANT: u32 = 58;

/// Two unit vectors across a unit vector whose last component is not below zero, and each other; by the formula of
/// `UnitVec3::tangents`.
#[inline(always)]
fn tangents([x, y, z]: [i32; 3]) -> [[i32; 3]; 2] {
    let divisor = (ONE as u32).wrapping_add(z as u32);
    let zeros = leading_zeros(divisor);
    let a = inverse(divisor.wrapping_shl(zeros)).wrapping_shr(1u32.wrapping_sub(zeros));
    let (xa, ya) = (times30(x, a), times30(y, a));
    let b = times30(xa, y).wrapping_neg();
    [[ONE.wrapping_sub(times30(x, xa)), b, x.wrapping_neg()], [b, ONE.wrapping_sub(times30(y, ya)), y.wrapping_neg()]]
}
