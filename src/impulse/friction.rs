//! One contact with Coulomb friction, solved as a block of three.

use super::Outcome;
use super::slip::{Sliding, Slip, sliding};
use crate::math::{Block, BlockImpulse, SymBlock, Vec3};
use crate::scalar::{Scalar, Scaled};

/// An impulse: along the normal, across it, and the whole of it.
#[derive(Clone, Copy)]
pub(super) struct Impulse<T> {
    pub normal: T,
    pub across: [T; 3],
    pub whole: [T; 3],
}

impl<T: Scaled> Impulse<T> {
    #[inline(always)]
    pub fn from_block<S: Scalar<Scaled = T>>(j: &BlockImpulse<S>) -> Self {
        let (normal, across, whole) = j.to_scaled();
        Self { normal, across, whole }
    }

    /// No component is an infinity or NaN.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        (self.whole[0] + self.whole[1] + self.whole[2]).is_finite()
    }

    /// The same under one power of two.
    #[inline(always)]
    pub fn to_block<S: Scalar<Scaled = T>>(self) -> BlockImpulse<S> {
        BlockImpulse::align(self.normal, self.across, self.whole)
    }
}

/// What the contact problem is made of, in the world's frame.
#[derive(Clone, Copy)]
pub(super) struct ContactBlock<T> {
    /// K = (1/m_a + 1/m_b) 1 + sum of (r x .)^T I^-1 (r x .): xx, xy, xz, yy, yz, zz.
    pub inverse_mass: [T; 6],
    /// The relative velocity.
    pub velocity: [T; 3],
    /// The unit normal.
    pub normal: [T; 3],
    /// The relative velocity along it, below zero.
    pub speed: T,
    /// 1/m_a + 1/m_b, below which no direction's inverse mass can be.
    pub least: T,
}

#[inline(always)]
pub(super) fn dot<T: Scaled>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a + k b`
#[inline(always)]
pub(super) fn add<T: Scaled>(a: [T; 3], b: [T; 3], k: T) -> [T; 3] {
    [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]]
}

impl<T: Scaled> ContactBlock<T> {
    #[inline(always)]
    pub fn new<S: Scalar<Scaled = T>>(
        inverse_mass: &SymBlock<S>,
        velocity: &Block<S>,
        normal: &Vec3<S::Unit>,
        inv_masses: [T; 2],
    ) -> Self {
        let speed = velocity.along(normal);
        let normal = [normal.x.to_scaled(), normal.y.to_scaled(), normal.z.to_scaled()];
        let least = inv_masses[0] + inv_masses[1];
        let block =
            Self { inverse_mass: inverse_mass.to_scaled(), velocity: velocity.to_scaled(), normal, speed, least };
        // Bodies held in place that can only turn have directions in which nothing gives way.
        Self { least: least.max(T::EPSILON * block.trace()), ..block }
    }

    /// The trace of K.
    #[inline(always)]
    pub fn trace(&self) -> T {
        let [xx, _, _, yy, _, zz] = self.inverse_mass;
        xx + yy + zz
    }

    /// K j: what an impulse changes the relative velocity by.
    #[inline(always)]
    pub fn change(&self, j: [T; 3]) -> [T; 3] {
        let [xx, xy, xz, yy, yz, zz] = self.inverse_mass;
        [dot([xx, xy, xz], j), dot([xy, yy, yz], j), dot([xz, yz, zz], j)]
    }

    /// The impulse that gives v_n' = -e v_n under friction mu.
    #[inline(always)]
    pub fn solve(&self, restitution: T, friction: T) -> (Impulse<T>, Outcome) {
        let (n, speed) = (self.normal, self.speed);
        let j = self.answer_to(add(self.velocity, n, restitution * speed));
        let normal = dot(j, n);
        let across = add(j, n, -normal);
        let limit = friction * normal;
        if normal > T::ZERO && dot(across, across) <= limit * limit {
            return (Impulse { normal, across, whole: j }, Outcome::Stuck);
        }
        self.slide((T::ONE + restitution) * speed, friction)
    }

    /// The same outside the caller: for what is rarely needed.
    #[inline(never)]
    pub fn solve_apart(&self, restitution: T, friction: T) -> (Impulse<T>, Outcome) {
        self.solve(restitution, friction)
    }

    /// -K^-1 v: once more for what is left, where K is ill-conditioned.
    #[inline(always)]
    fn answer_to(&self, v: [T; 3]) -> [T; 3] {
        let factors = Factors::new(&self.inverse_mass, self.least);
        let j = factors.answer_to(v);
        if factors.over_pivots() * self.trace() < T::from_parts(64, 0) {
            return j;
        }
        self.refined(factors, v, j)
    }

    #[inline(always)]
    fn refined(self, factors: Factors<T>, v: [T; 3], j: [T; 3]) -> [T; 3] {
        add(j, factors.answer_to(add(v, self.change(j), T::ONE)), T::ONE)
    }

    /// The impulse where the points slide, for b = (1 + e) v_n.
    ///
    /// In the frame of the normal n and its tangents 1 and 2, the normal row K_nn j_n + K_nt . j_t = -b is taken out of the
    /// tangential ones, which leaves S j_t = -q with the Schur complement S = K_tt - K_tn K_nt / K_nn and
    /// q = v_t - K_tn b / K_nn.
    #[inline(always)]
    fn slide(&self, b: T, friction: T) -> (Impulse<T>, Outcome) {
        let n = self.normal;
        let k_n = self.change(n);
        // Rounding must not take any of these below 1/m_a + 1/m_b.
        let least = self.least;
        let nn = dot(k_n, n).max(least);
        // Normals are of unit length to 2^-17 only, and the frame has to be one to the last digit.
        let square = dot(n, n);
        let over = T::ONE / square.sqrt();
        let (t1, t2) = tangents([n[0] * over, n[1] * over, n[2] * over]);
        let k_1 = self.change(t1);
        let (k_n1, k_n2) = (dot(k_n, t1), dot(k_n, t2));
        let over = T::ONE / nn;
        let (g1, g2) = (k_n1 * over, k_n2 * over);
        let s12 = dot(k_1, t2) - k_n1 * g2;
        let k11 = dot(k_1, t1);
        let k22 = self.trace() - nn / square - k11;
        let (s11, s22) = ((k11 - k_n1 * g1).max(least), (k22 - k_n2 * g2).max(least));
        let (q1, q2) = (dot(self.velocity, t1) - g1 * b, dot(self.velocity, t2) - g2 * b);
        let (large, small) = if s11 < s22 { (s22, s11) } else { (s11, s22) };
        let pivot = (small - s12 / large * s12).max(least);

        let slip = Slip::new([s11, s12, s22], (large, pivot), [q1, q2], -b / nn, friction, [g1, g2]);
        let Sliding { direction: [d1, d2], friction: j_t } = sliding(&slip);
        // On the cone, j_t = -mu j_n d, and the normal row gives j_n. Where friction presses the bodies together, that is
        // a quotient of small differences, and the tangential rows know better. The rows of an ill-conditioned contact may
        // then see it stick, when in the world's frame it just did not: they have to be believed, or no root is left.
        let yields = nn - friction * (k_n1 * d1 + k_n2 * d2);
        if T::from_parts(8, 0) * yields > nn {
            let j_n = -b / yields;
            return (assembled((n, j_n), (t1, t2), [d1, d2], friction * j_n), Outcome::Slid);
        }
        match slip.sticking() {
            Some(Sliding { direction: [d1, d2], friction: j_t }) => {
                let j_n = j_t * (g1 * d1 + g2 * d2) - b * over;
                (assembled((n, j_n), (t1, t2), [d1, d2], j_t), Outcome::Stuck)
            }
            None => (assembled((n, j_t / friction), (t1, t2), [d1, d2], j_t), Outcome::Slid),
        }
    }
}

/// The impulse `j_n` along the normal and `j_t` against the direction `d` of the tangents.
#[inline(always)]
fn assembled<T: Scaled>((n, j_n): ([T; 3], T), (t1, t2): ([T; 3], [T; 3]), d: [T; 2], j_t: T) -> Impulse<T> {
    let across = weighted(t1, t2, [-(j_t * d[0]), -(j_t * d[1])]);
    Impulse { normal: j_n, across, whole: add(across, n, j_n) }
}

/// `k1 a + k2 b`
#[inline(always)]
fn weighted<T: Scaled>(a: [T; 3], b: [T; 3], k: [T; 2]) -> [T; 3] {
    add([k[0] * a[0], k[0] * a[1], k[0] * a[2]], b, k[1])
}

/// K = L D L^T, with pivots of at least 1/m_a + 1/m_b: rounding must not take them below.
#[derive(Clone, Copy)]
struct Factors<T> {
    /// Below the diagonal of L: 10, 20, 21.
    low: [T; 3],
    /// 1/D
    over: [T; 3],
}

impl<T: Scaled> Factors<T> {
    #[inline(always)]
    fn new([xx, xy, xz, yy, yz, zz]: &[T; 6], least: T) -> Self {
        let over_0 = T::ONE / xx.max(least);
        let (l10, l20) = (*xy * over_0, *xz * over_0);
        let over_1 = T::ONE / (*yy - l10 * *xy).max(least);
        let rest = *yz - l10 * *xz;
        let l21 = rest * over_1;
        let over_2 = T::ONE / (*zz - l20 * *xz - l21 * rest).max(least);
        Self { low: [l10, l20, l21], over: [over_0, over_1, over_2] }
    }

    /// The trace of 1/D: with that of K, a bound on the condition.
    #[inline(always)]
    fn over_pivots(&self) -> T {
        self.over[0] + self.over[1] + self.over[2]
    }

    /// -K^-1 v
    #[inline(always)]
    fn answer_to(&self, v: [T; 3]) -> [T; 3] {
        let [l10, l20, l21] = self.low;
        let [over_0, over_1, over_2] = self.over;
        let y1 = v[1] - l10 * v[0];
        let y2 = v[2] - l20 * v[0] - l21 * y1;
        let z = -(y2 * over_2);
        let y = -(y1 * over_1 + l21 * z);
        [-(v[0] * over_0 + l10 * y + l20 * z), y, z]
    }
}

/// Two unit vectors across the unit vector `n` and each other. The opposite vector has the opposite ones.
///
/// Duff and others, "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017, with the first one times the sign.
#[inline(always)]
fn tangents<T: Scaled>([x, y, z]: [T; 3]) -> ([T; 3], [T; 3]) {
    let mirrored = z < T::ZERO || (z == T::ZERO && (y < T::ZERO || (y == T::ZERO && x < T::ZERO)));
    let sign = if mirrored { -T::ONE } else { T::ONE };
    let a = -(T::ONE / (sign + z));
    let b = x * y * a;
    ([sign + x * x * a, b, -x], [b, sign + y * y * a, -y])
}
