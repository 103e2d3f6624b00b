//! One contact with friction in fixed point: the equations of `impulse/friction.rs` and `impulse/slip.rs` in integers.
//!
//! Every quantity is brought to 30 bits once and keeps a fixed place from there on; sums of products are exact in 64 bits and
//! cut off. That takes well-conditioned contacts: where one of the guards below fails, the caller solves the same
//! equations in [`Scaled32`](super::scaled32::Scaled32), whose numbers keep an exponent each. Products and sums of numbers
//! in Q2.30 are written `times30` and `dot30`; where it is not plain, the bound that keeps a result within 32 bits stands
//! beside it.

use super::integer::long_quotient;
use super::product::{dot, dot2, leading_zeros, product};
use super::slip32::Slip32;
use super::wide::{dot30, high, inverse, leading_zeros64, leading32, magnitude, max, narrow, shift_left, times30};

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
    /// The rows of K.
    #[inline(always)]
    fn rows(&self) -> [[i32; 3]; 3] {
        let [xx, xy, xz, yy, yz, zz] = self.inverse_mass;
        [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
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
        let minus = [xy.wrapping_neg(), xz.wrapping_neg(), yz.wrapping_neg()];
        let minor = |a: i32, b: i32, c: i32, d: i32| dot2([a, c], [b, d]);
        let (a_xx, a_yy, a_zz) =
            (minor(yy, zz, yz, minus[2]), minor(xx, zz, xz, minus[1]), minor(xx, yy, xy, minus[0]));
        let (a_xy, a_xz, a_yz) =
            (minor(xz, yz, minus[0], zz), minor(xy, yz, minus[1], yy), minor(xy, xz, xx, minus[2]));
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
        let zeros = leading_zeros64(determinant);
        let over = inverse(leading32(determinant, zeros));
        let v = self.velocity;
        let v = [
            v[0].wrapping_add(times30(bounce, n[0])),
            v[1].wrapping_add(times30(bounce, n[1])),
            v[2].wrapping_add(times30(bounce, n[2])),
        ];
        // |v| < 2^30.8, and a row of the adjugate is below 2^31.8.
        let [x, y, z] = [dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)];
        let up = leading_zeros(magnitude([high(x), high(y), high(z)])).wrapping_sub(1);
        let component = |x: i64| times30(shift_left(x, up) >> 1, over).wrapping_neg();
        let whole = [component(x), component(y), component(z)];
        let normal = dot30(whole, n);
        let across = [
            whole[0].wrapping_sub(times30(normal, n[0])),
            whole[1].wrapping_sub(times30(normal, n[1])),
            whole[2].wrapping_sub(times30(normal, n[2])),
        ];
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
        let [x, y, z] = self.rows();
        let half = |d: [i32; 3]| [narrow::<31>(dot(x, d)), narrow::<31>(dot(y, d)), narrow::<31>(dot(z, d))];
        // All of K in units twice its own.
        let (k_n, k_1) = (half(n), half(t1));
        let (nn, n1, n2) = (dot30(k_n, n), dot30(k_n, t1), dot30(k_n, t2));
        if nn < 1 << 27 {
            return None;
        }
        let (k11, k12) = (dot30(k_1, t1), dot30(k_1, t2));
        let k22 = dot30(half(t2), t2);

        // K_nt / K_nn in Q5.27.
        let nn_zeros = leading_zeros(nn as u32);
        let over_nn = inverse((nn as u32).wrapping_shl(nn_zeros));
        let quotient = |x: i32| times30(x, over_nn).wrapping_shr(4u32.wrapping_sub(nn_zeros));
        let g = [quotient(n1), quotient(n2)];
        let less = |k: i32, a: i32, g: i32| k.wrapping_sub(narrow::<27>(product(a, g)));
        let (s11, s12, s22) = (less(k11, n1, g[0]), less(k12, n1, g[1]), less(k22, n2, g[1]));
        let m = max(s11, s22);
        if m < 1 << 24 {
            return None;
        }

        // S over its larger diagonal element in Q2.30.
        let m_zeros = leading_zeros(m as u32);
        let over_m = inverse((m as u32).wrapping_shl(m_zeros));
        let part = |s: i32| {
            let s = if s > m { m } else { s };
            times30(s.wrapping_shl(m_zeros.wrapping_sub(1)), over_m)
        };
        let (s11, s22) = (part(max(s11, 0)), part(max(s22, 0)));
        let s12 = part(max(s12, m.wrapping_neg()));
        let determinant = narrow::<30>(dot2([s11, s12], [s22, s12.wrapping_neg()]));
        if determinant < 1 << 14 {
            return None;
        }

        // q in units of 2^(7 - up) of the velocity, within 2^29.
        let q = |t: [i32; 3], g: i32| (dot(self.velocity, t) >> 3).wrapping_sub(product(g, b));
        let q = [q(t1, g[0]), q(t2, g[1])];
        let up = magnitude([high(q[0]), high(q[1]), 0]).leading_zeros().wrapping_sub(1);
        let q = [shift_left(q[0], up) >> 2, shift_left(q[1], up) >> 2];

        // mu m / K_nn in Q(nn_zeros + 2).30, and times -b in the units of q.
        let load = narrow::<31>(product(self.friction, times30(m, over_nn)));
        let load = product(load, b.wrapping_neg()).wrapping_shr(37u32.wrapping_sub(nn_zeros).wrapping_sub(up));
        let minus = self.friction.wrapping_neg();
        let coupling = [product(minus, g[0]), product(minus, g[1])];
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
        let zeros = leading_zeros64(yields);
        let b_zeros = leading_zeros(b.unsigned_abs());
        let quotient = long_quotient(b.unsigned_abs().wrapping_shl(b_zeros), leading32(yields, zeros));
        // The whole within 2^30.5.
        let places = if self.friction > ONE { 2 } else { 1 };
        let normal = quotient.wrapping_shr(places as u32) as i32;
        let friction = times30(self.friction, normal).wrapping_neg();
        let across = |i: usize| times30(friction, narrow::<30>(dot2([t1[i], t2[i]], d)));
        let across = [across(0), across(1), across(2)];
        let whole = [
            across[0].wrapping_add(times30(normal, n[0])),
            across[1].wrapping_add(times30(normal, n[1])),
            across[2].wrapping_add(times30(normal, n[2])),
        ];
        let exponent = (zeros as i32)
            .wrapping_sub(b_zeros as i32)
            .wrapping_sub(33)
            .wrapping_add(places)
            .wrapping_add(self.velocity_exponent)
            .wrapping_sub(self.inverse_mass_exponent);
        Some(Impulse32 { normal, across, whole, exponent, stuck: false })
    }
}

/// The exponent of the least determinant for which the adjugate is precise enough.
const LEAST_DETERMINANT: u32 = 58;

/// Two unit vectors across a unit vector whose last component is not below zero, and each other; as `UnitVec3::tangents`.
#[inline(always)]
fn tangents([x, y, z]: [i32; 3]) -> [[i32; 3]; 2] {
    let divisor = (ONE as u32).wrapping_add(z as u32);
    let zeros = leading_zeros(divisor);
    let a = inverse(divisor.wrapping_shl(zeros)).wrapping_shr(1u32.wrapping_sub(zeros));
    let (xa, ya) = (times30(x, a), times30(y, a));
    let b = times30(xa, y).wrapping_neg();
    [[ONE.wrapping_sub(times30(x, xa)), b, x.wrapping_neg()], [b, ONE.wrapping_sub(times30(y, ya)), y.wrapping_neg()]]
}
