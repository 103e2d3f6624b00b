//! One contact with Coulomb friction, solved as a block of three.

use super::Outcome;
use super::lever::Column;
use super::slip::{Sliding, Slip, sliding};
use crate::body::Body;
use crate::scalar::{Scalar, Scaled};

/// The symmetric 3x3 inverse mass of a contact in the frame of its normal n and its tangents 1 and 2:
/// K = (1/m_a + 1/m_b) 1 + sum of (r x .)^T I^-1 (r x .).
#[derive(Clone, Copy)]
pub(super) struct InverseMass<T> {
    pub nn: T,
    pub n1: T,
    pub n2: T,
    pub t11: T,
    pub t12: T,
    pub t22: T,
}

/// What the contact problem is made of: the inverse mass, and the relative velocity along n, 1 and 2.
#[derive(Clone, Copy)]
pub(super) struct ContactBlock<T> {
    pub inverse_mass: InverseMass<T>,
    pub speed: [T; 3],
    /// 1/m_a + 1/m_b, below which no direction's inverse mass can be.
    pub least: T,
}

impl<T: Scaled> ContactBlock<T> {
    /// From the columns along n, 1 and 2. The speed and the inverse mass along n have been computed already.
    #[inline(always)]
    pub fn new<S: Scalar<Scaled = T>>(a: &Body<S>, b: &Body<S>, columns: &[Column<S>; 3], approach: T, nn: T) -> Self {
        let [n, t1, t2] = columns;
        let inverse_mass = InverseMass {
            nn,
            n1: n.coupling(t1),
            n2: n.coupling(t2),
            t11: t1.inverse_mass(a, b),
            t12: t1.coupling(t2),
            t22: t2.inverse_mass(a, b),
        };
        Self { inverse_mass, speed: [approach, t1.speed(a, b), t2.speed(a, b)], least: a.inv_mass + b.inv_mass }
    }

    /// The impulse that gives v_n' = -e v_n under friction mu.
    ///
    /// With b = (1 + e) v_n, the normal row K_nn j_n + K_nt . j_t = -b is taken out of the tangential ones, which leaves
    /// S j_t = -q with the Schur complement S = K_tt - K_tn K_nt / K_nn and q = v_t - K_tn b / K_nn.
    #[inline]
    pub fn solve(&self, restitution: T, friction: T) -> ([T; 3], Outcome) {
        let k = &self.inverse_mass;
        let [v_n, v_1, v_2] = self.speed;
        let b = (T::ONE + restitution) * v_n;
        let frictionless = ([-b / k.nn, T::ZERO, T::ZERO], Outcome::Slid);
        if friction == T::ZERO {
            return frictionless;
        }
        let (g1, g2) = (k.n1 / k.nn, k.n2 / k.nn);
        // S is at least 1/m_a + 1/m_b in every direction, and so are its pivots: rounding must not take them below.
        let least = self.least;
        let s12 = k.t12 - k.n1 * g2;
        let (s11, s22) = ((k.t11 - k.n1 * g1).max(least), (k.t22 - k.n2 * g2).max(least));
        let (q1, q2) = (v_1 - g1 * b, v_2 - g2 * b);
        // Elimination from the larger pivot: the residual stays small however unequal the two are.
        let swap = s11 < s22;
        let (large, small, q_large, q_small) = if swap { (s22, s11, q2, q1) } else { (s11, s22, q1, q2) };
        let ratio = s12 / large;
        let pivot = (small - ratio * s12).max(least);
        let j_small = (ratio * q_large - q_small) / pivot;
        let j_large = -(q_large + s12 * j_small) / large;
        let (j_1, j_2) = if swap { (j_small, j_large) } else { (j_large, j_small) };
        let j_n = -(b / k.nn + (g1 * j_1 + g2 * j_2));
        let limit = friction * j_n;
        if j_n > T::ZERO && j_1 * j_1 + j_2 * j_2 <= limit * limit {
            return ([j_n, j_1, j_2], Outcome::Stuck);
        }

        let slip = Slip::new([s11, s12, s22], (large, pivot), [q1, q2], -b / k.nn, friction, [g1, g2]);
        let Sliding { direction: [d1, d2], friction: j_t } = sliding(&slip);
        // On the cone, j_t = -mu j_n d, and the normal row gives j_n. Where friction presses the bodies together, that is
        // a quotient of small differences, and the tangential rows know better.
        let yields = k.nn - friction * (k.n1 * d1 + k.n2 * d2);
        let (j_n, j_t) = if T::from_parts(8, 0) * yields > k.nn {
            let j_n = -b / yields;
            (j_n, friction * j_n)
        } else {
            (j_t / friction, j_t)
        };
        ([j_n, -(j_t * d1), -(j_t * d2)], Outcome::Slid)
    }
}
