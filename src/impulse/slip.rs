//! Which way a sliding contact slides: a root of one equation in one unknown.
//!
//! Sliding means j_t = -u/s for the sliding velocity u after the impact and some s > 0, so that the tangential rows read
//! (S + s 1) j_t = -q, and s has to bring |j_t| = mu j_n. Sticking is s = 0. With s = m (1 - t)/t for m = max(S_11, S_22),
//! the unknown t runs from 0 (no friction) to 1 (sticking), and everything in the equation stays of order one:
//!
//! ```text
//! t |N(t)| = mu/K_nn (-b m D(t) + t K_nt . N(t))      N(t) = q + t p,  D(t) = det of t S/m + (1 - t) 1
//! ```
//!
//! At t = 0 the left side is the smaller one, and at t = 1 the larger one whenever sticking is not possible: a root lies
//! between, whatever the coupling of normal and tangent. It is also the well-conditioned form: for slow friction the
//! direction N(t) hardly depends on t.

use crate::scalar::{MAX_SLIP_ITERATIONS, Scaled};

/// The equation of sliding, in the form above.
pub(super) struct Slip<T> {
    /// N(0).
    q: [T; 2],
    /// dN/dt.
    p: [T; 2],
    /// The larger of S_11 and S_22.
    m: T,
    /// Trace and determinant of S/m.
    trace: T,
    determinant: T,
    /// mu m times the frictionless impulse.
    load: T,
    /// mu K_nt / K_nn.
    coupling: [T; 2],
}

/// How a sliding contact slides: the unit direction of sliding after the impact in the two tangents, and the amount of
/// friction by the tangential rows.
pub(super) struct Sliding<T> {
    pub direction: [T; 2],
    pub friction: T,
}

impl<T: Scaled> Slip<T> {
    /// From S (11, 12, 22), its larger diagonal element and the determinant over that, q, the frictionless impulse
    /// -b/K_nn, mu, and K_nt/K_nn.
    #[inline(always)]
    pub fn new(s: [T; 3], (m, pivot): (T, T), q: [T; 2], frictionless: T, friction: T, g: [T; 2]) -> Self {
        let over = T::ONE / m;
        let [s11, s12, s22] = [s[0] * over, s[1] * over, s[2] * over];
        Self {
            q,
            p: [(s22 - T::ONE) * q[0] - s12 * q[1], (s11 - T::ONE) * q[1] - s12 * q[0]],
            m,
            trace: s11 + s22,
            determinant: pivot * over,
            load: friction * m * frictionless,
            coupling: [friction * g[0], friction * g[1]],
        }
    }

    /// N(t) and its length.
    #[inline(always)]
    fn numerator(&self, t: T) -> ([T; 2], T) {
        let n = [self.q[0] + t * self.p[0], self.q[1] + t * self.p[1]];
        (n, (n[0] * n[0] + n[1] * n[1]).sqrt())
    }

    /// D(t), a sum of what is not negative.
    #[inline(always)]
    fn denominator(&self, t: T) -> T {
        let rest = T::ONE - t;
        rest * (rest + t * self.trace) + t * t * self.determinant
    }

    /// Newton's first step from t = 0, where the equation's value is -load.
    #[inline(always)]
    fn guess(&self) -> T {
        let [x, y] = self.q;
        let along = self.coupling[0] * x + self.coupling[1] * y;
        let rise = self.load * (T::ONE + T::ONE - self.trace);
        self.load / ((x * x + y * y).sqrt() - along + rise)
    }

    /// Left side minus right side, and its derivative.
    #[inline(always)]
    fn excess(&self, t: T) -> (T, T) {
        let (n, length) = self.numerator(t);
        let dot = |a: [T; 2], b: [T; 2]| a[0] * b[0] + a[1] * b[1];
        let along = dot(self.coupling, n);
        let value = t * (length - along) - self.load * self.denominator(t);
        // D(t) = 1 + t (d1 + t d2)
        let two = T::ONE + T::ONE;
        let (d1, d2) = (self.trace - two, self.determinant - self.trace + T::ONE);
        let slope = length - along + t * (dot(n, self.p) / length - dot(self.coupling, self.p))
            - self.load * (d1 + t * (d2 + d2));
        (value, slope)
    }
}

/// The root, and what it says of the sliding.
#[inline]
pub(super) fn sliding<T: Scaled>(slip: &Slip<T>) -> Sliding<T> {
    let half = T::from_parts(1, -1);
    let (mut low, mut high) = (T::ZERO, T::ONE);
    let mut t = slip.guess();
    if !(t > low && t < high) {
        t = half;
    }
    // After a small step of Newton's its square, or some of that, is left.
    let tolerance = T::from_parts(1, -5) * T::EPSILON;
    for _ in 0..MAX_SLIP_ITERATIONS {
        let (value, slope) = slip.excess(t);
        if value < T::ZERO {
            low = t;
        } else {
            high = t;
        }
        let step = value / slope;
        let next = t - step;
        if step * step <= tolerance * (t * t) {
            t = if next < T::ONE { next } else { T::ONE };
            break;
        }
        t = if next > low && next < high { next } else { half * (low + high) };
    }
    let ([x, y], length) = slip.numerator(t);
    Sliding { direction: [x / length, y / length], friction: t * length / (slip.m * slip.denominator(t)) }
}
