//! Which way a sliding contact slides, in fixed point.

use super::MAX_SLIP_ITERATIONS;
use super::contact32::ONE;
use super::integer::{high_product, inverse_root, leading_zeros, leading_zeros64, reciprocal};
#[cfg(multiply = "short")]
use super::machine;
use super::machine::times30;
#[cfg(not(multiply = "short"))]
use super::product::dot;
use super::product::{dot2, product};
use super::wide::{high, leading32, magnitude, narrow, upper};

/// The equation of `impulse/slip.rs`, squared so that no root has to be taken: (t |N|)^2 = B^2, B = load D - t coupling . N
/// with coupling = -mu K_nt / K_nn.
/// All in Q2.30 but q, p and the load, which have a common unit and are within 2^29, 2^29.5 and 2^30.
#[repr(C)]
pub(super) struct Slip32 {
    pub q: [i32; 2],
    pub p: [i32; 2],
    pub half_trace: i32,
    pub determinant: i32,
    pub load: i32,
    pub coupling: [i32; 2],
}

impl Slip32 {
    /// N(t)
    #[inline(always)]
    fn numerator(&self, t: i32) -> [i32; 2] {
        [self.q[0].wrapping_add(times30(t, self.p[0])), self.q[1].wrapping_add(times30(t, self.p[1]))]
    }

    /// B, the difference of the squares, and half its derivative.
    #[cfg(not(multiply = "short"))]
    #[inline(always)]
    fn excess(&self, t: i32) -> (i32, i64, i64) {
        let tp = [times30(t, self.p[0]), times30(t, self.p[1])];
        let n = [self.q[0].wrapping_add(tp[0]), self.q[1].wrapping_add(tp[1])];
        let tn = [times30(t, n[0]), times30(t, n[1])];
        // d(t N)/dt, within 1.5 2^30.
        let m = [n[0].wrapping_add(tp[0]), n[1].wrapping_add(tp[1])];
        let rest = ONE.wrapping_sub(t);
        let (th, td) = (times30(t, self.half_trace), times30(t, self.determinant));
        // Beyond 2^31 for t = 1 only, where the other factor is zero.
        let d = narrow::<30>(dot2([rest, t], [rest.wrapping_add(th).wrapping_add(th), td]));
        let half_slope = td.wrapping_sub(rest).wrapping_add(times30(self.half_trace, rest.wrapping_sub(t)));
        let b = times30(self.load, d).wrapping_sub(narrow::<30>(dot2(self.coupling, tn)));
        let half_b = times30(self.load, half_slope).wrapping_sub(narrow::<31>(dot2(self.coupling, m)));
        let excess = dot([tn[0], tn[1], b], [tn[0], tn[1], b.wrapping_neg()]);
        let slope = dot2(tn, m).wrapping_sub(product(b, half_b) << 1);
        (b, excess, slope)
    }

    #[cfg(multiply = "short")]
    #[inline(always)]
    fn excess(&self, t: i32) -> (i32, i64, i64) {
        machine::excess(self, t)
    }

    /// A first guess: t = load / (slope + bend t) for the slope and half the second derivative at t = 0, and the t on the right
    /// without the bend. Where a sum of these wraps, the guess is a bad one, and the search bisects.
    #[inline(always)]
    fn guess(&self) -> i32 {
        let [long, root] = length(self.q);
        let rise = high_product((self.load as u32) << 1, (ONE.wrapping_sub(self.half_trace) as u32) << 2);
        let along = narrow::<30>(dot2(self.coupling, self.q));
        let slope = long.wrapping_add(rise as i32).wrapping_add(along);
        let more = times30(narrow::<29>(dot2(self.q, self.p)), root);
        let along = narrow::<30>(dot2(self.coupling, self.p));
        let corner = ONE.wrapping_sub(self.half_trace).wrapping_sub(self.half_trace).wrapping_add(self.determinant);
        let bend = more.wrapping_add(along).wrapping_sub(times30(self.load, corner));
        let t = self.over(slope);
        self.over(slope.wrapping_add(times30(bend, t)))
    }

    /// The load over that, in Q2.30; a half where it is not below one.
    #[inline(always)]
    fn over(&self, slope: i32) -> i32 {
        if slope <= self.load {
            return ONE >> 1;
        }
        let zeros = leading_zeros(slope as u32);
        high_product((self.load as u32).wrapping_shl(zeros), reciprocal((slope as u32).wrapping_shl(zeros))) as i32
    }

    /// The direction of sliding after the impact, in Q2.30.
    #[inline(always)]
    pub fn direction(&self) -> [i32; 2] {
        let (mut low, mut high_end) = (0, ONE);
        let mut t = self.guess();
        let mut turns = MAX_SLIP_ITERATIONS;
        while turns > 0 {
            turns = turns.wrapping_sub(1);
            let (b, excess, slope) = self.excess(t);
            if b < 0 || excess >= 0 {
                high_end = t;
            } else {
                low = t;
            }
            let step = step(excess, slope);
            let next = t.wrapping_sub(step);
            if b > 0 && step.unsigned_abs() < SMALL_STEP {
                t = if next < ONE { next } else { ONE };
                break;
            }
            t = if b > 0 && next > low && next < high_end { next } else { low.wrapping_add(high_end) >> 1 };
        }
        unit(self.numerator(t))
    }
}

/// A step after which Newton's method is at its end: half its square, or some of that, is what is left.
const SMALL_STEP: u32 = 1 << 15;

/// `excess / (2 slope)` in Q2.30, to 26 bits; beyond 1/2 something that is outside every bracket.
#[inline(always)]
fn step(excess: i64, slope: i64) -> i32 {
    if slope <= 0 || (excess ^ (excess >> 63)) >= slope {
        return i32::MAX;
    }
    let zeros = leading_zeros64(slope as u64);
    let over = reciprocal(upper(slope, zeros) as u32);
    high(product(upper(excess, zeros.wrapping_sub(1)), (over >> 1) as i32)) << 1
}

/// The length of a vector of which a component is 2^28 at least, and none 2^29; and 2^59 over that.
#[inline(always)]
fn length(v: [i32; 2]) -> [i32; 2] {
    let square = dot2(v, v);
    let down = if high(square) < 1 << 26 { 1u32 } else { 0 };
    // In [2^30, 2^32) now, and its root 2^-14 of the product's upper half.
    let square = leading32(square, down.wrapping_mul(2).wrapping_add(4));
    let root = inverse_root(square);
    [high_product(square, root).wrapping_shr(down) as i32, (root >> 1).wrapping_shl(down) as i32]
}

/// The vector over its length, in Q2.30.
#[inline(always)]
fn unit(v: [i32; 2]) -> [i32; 2] {
    let up = leading_zeros(magnitude([v[0], v[1], 0])).wrapping_sub(2);
    let v = [v[0].wrapping_shl(up), v[1].wrapping_shl(up)];
    // In [2^58, 2^61).
    let square = dot2(v, v) as u64;
    let places = leading_zeros64(square) & 62;
    // 2^30 sqrt(2^64 / (square 2^places)), in [2^30, 2^31].
    let root = inverse_root(leading32(square as i64, places));
    // v root / 2^30 2^(places / 2) / 2^32
    let (half, down) = ((root >> 1) as i32, 31u32.wrapping_sub(places / 2));
    let d = [product(v[0], half).wrapping_shr(down) as i32, product(v[1], half).wrapping_shr(down) as i32];
    // One step of Newton's for the length.
    let lacks = narrow::<31>((1i64 << 60).wrapping_sub(dot2(d, d)));
    [d[0].wrapping_add(times30(d[0], lacks)), d[1].wrapping_add(times30(d[1], lacks))]
}
