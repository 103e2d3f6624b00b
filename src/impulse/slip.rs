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
    /// N(0) = q and N(1).
    ends: [[T; 2]; 2],
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

/// The unknown t, and what it lacks of one: near sticking that is what counts, and 1 - t has no digits of it.
#[derive(Clone, Copy)]
struct Place<T> {
    t: T,
    rest: T,
}

/// How a sliding contact slides: the unit direction of sliding after the impact in the two tangents, and the amount of
/// friction by the tangential rows.
pub(super) struct Sliding<T> {
    pub direction: [T; 2],
    pub friction: T,
}

#[inline(always)]
fn dot2<T: Scaled>(a: [T; 2], b: [T; 2]) -> T {
    a[0] * b[0] + a[1] * b[1]
}

impl<T: Scaled> Place<T> {
    const FREE: Self = Self { t: T::ZERO, rest: T::ONE };
    const STUCK: Self = Self { t: T::ONE, rest: T::ZERO };

    #[inline(always)]
    fn moved_back(self, step: T) -> Self {
        Self { t: self.t - step, rest: self.rest + step }
    }

    #[inline(always)]
    fn middle(self, other: Self) -> Self {
        let half = T::from_parts(1, -1);
        Self { t: half * (self.t + other.t), rest: half * (self.rest + other.rest) }
    }

    /// Strictly between two others.
    #[inline(always)]
    fn is_between(self, low: Self, high: Self) -> bool {
        self.t > low.t && self.rest > high.rest
    }
}

impl<T: Scaled> Slip<T> {
    /// From S (11, 12, 22), its larger diagonal element and the determinant over that, q, the frictionless impulse
    /// -b/K_nn, mu, and K_nt/K_nn.
    #[inline(always)]
    pub fn new(s: [T; 3], (m, pivot): (T, T), q: [T; 2], frictionless: T, friction: T, g: [T; 2]) -> Self {
        let over = T::ONE / m;
        let [s11, s12, s22] = [s[0] * over, s[1] * over, s[2] * over];
        Self {
            ends: [q, [s22 * q[0] - s12 * q[1], s11 * q[1] - s12 * q[0]]],
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
    fn numerator(&self, Place { t, rest }: Place<T>) -> ([T; 2], T) {
        let [free, stuck] = self.ends;
        let n = [rest * free[0] + t * stuck[0], rest * free[1] + t * stuck[1]];
        (n, dot2(n, n).sqrt())
    }

    /// D(t), a sum of what is not negative.
    #[inline(always)]
    fn denominator(&self, Place { t, rest }: Place<T>) -> T {
        rest * (rest + t * self.trace) + t * t * self.determinant
    }

    /// Newton's first step from t = 0, where the equation's value is -load.
    #[inline(always)]
    fn guess(&self) -> T {
        let [q, _] = self.ends;
        let rise = self.load * (T::ONE + T::ONE - self.trace);
        self.load / (dot2(q, q).sqrt() - dot2(self.coupling, q) + rise)
    }

    /// What the tangential rows say of the friction there.
    #[inline(always)]
    fn at(&self, place: Place<T>) -> Sliding<T> {
        let ([x, y], length) = self.numerator(place);
        // Nothing slides, nothing rubs.
        let length_or_one = if length > T::ZERO { length } else { T::ONE };
        let direction = [x / length_or_one, y / length_or_one];
        Sliding { direction, friction: place.t * length / (self.m * self.denominator(place)) }
    }

    /// The friction at which the points stick, if friction at its limit is no less.
    #[inline(always)]
    pub fn sticking(&self) -> Option<Sliding<T>> {
        let (value, _, _) = self.excess(Place::STUCK);
        if value <= T::ZERO { Some(self.at(Place::STUCK)) } else { None }
    }

    /// Left side minus right side, its derivative, and the frictionless part of the right side.
    #[inline(always)]
    fn excess(&self, place: Place<T>) -> (T, T, T) {
        let Place { t, rest } = place;
        let (n, length) = self.numerator(place);
        let along = dot2(self.coupling, n);
        let free = self.load * self.denominator(place);
        let value = t * (length - along) - free;
        // Half of dD/dt
        let half = t * self.determinant - rest + T::from_parts(1, -1) * self.trace * (rest - t);
        let slope =
            length - along + t * (dot2(n, self.p) / length - dot2(self.coupling, self.p)) - self.load * (half + half);
        (value, slope, free)
    }
}

/// The root, and what it says of the sliding.
#[inline]
pub(super) fn sliding<T: Scaled>(slip: &Slip<T>) -> Sliding<T> {
    let (mut low, mut high) = (Place::FREE, Place::STUCK);
    let t = slip.guess();
    let mut place = Place { t, rest: T::ONE - t };
    if !place.is_between(low, high) {
        place = low.middle(high);
    }
    // After a small step of Newton's its square, or some of that, is left.
    let tolerance = T::from_parts(1, -5) * T::EPSILON;
    let noise = T::EPSILON * T::EPSILON;
    for _ in 0..MAX_SLIP_ITERATIONS {
        let (value, slope, free) = slip.excess(place);
        if value < T::ZERO {
            low = place;
        } else {
            high = place;
        }
        let step = value / slope;
        let next = place.moved_back(step);
        let size = place.t * place.rest;
        let inside = next.is_between(low, high);
        // Or the two sides are equal, as far as can be told.
        let equal = value * value <= noise * (free * free);
        if step * step <= tolerance * (size * size) || (equal && inside) {
            place = next;
            break;
        }
        place = if inside { next } else { low.middle(high) };
    }
    slip.at(place)
}
