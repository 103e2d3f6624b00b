//! The law of restitution under which no impact raises the kinetic energy.

use super::friction::{ContactBlock, Impulse, add, dot};
use crate::scalar::Scaled;

/// Where the impulse would raise the kinetic energy, the point nearest to it that does not, on the line to the impulse
/// without rebound.
///
/// An impulse j changes the energy by T(j) = j . v + 1/2 j . K j. The impulse j_0 without rebound never raises it
/// (v_n' = 0 and friction opposes v_t', so that T(j_0) = j_0 . v' - 1/2 j_0 . K j_0 <= 0), and on the line j_0 + s d T is
/// a parabola that opens upwards: it crosses zero once between s = 0 and s = 1. Both ends lie in the friction cone, which
/// is convex, and v_n' is linear in s.
#[inline(never)]
pub(super) fn limit_energy<T: Scaled>(block: &ContactBlock<T>, friction: T, impulse: Impulse<T>) -> Option<Impulse<T>> {
    let j = impulse.whole;
    let half = T::from_parts(1, -1);
    let energy = |j: [T; 3]| dot(j, block.velocity) + half * dot(j, block.change(j));
    if energy(j) <= T::ZERO {
        return None;
    }
    let (safe, _) = block.solve_apart(T::ZERO, friction);
    let base = safe.whole;
    let d = [j[0] - base[0], j[1] - base[1], j[2] - base[2]];
    let after = add(block.change(base), block.velocity, T::ONE);
    let (a, b, c) = (half * dot(d, block.change(d)), dot(d, after), energy(base));
    // False where d is zero (e = 0) or something is not finite, and where no energy is there to keep.
    let crosses = a > T::ZERO && c < T::ZERO;
    if !crosses {
        return Some(safe);
    }
    let two = T::ONE + T::ONE;
    let root = (b * b - (two + two) * a * c).sqrt();
    // The positive root, in the form that subtracts nothing.
    let s = if b > T::ZERO { -(two * c) / (b + root) } else { (root - b) / (two * a) };
    // Where the line is too short to be told from rounding, its end is as good as any point.
    let s = if s < T::ONE { s } else { T::ONE };
    // Rounding must not tip it over.
    let s = s * (T::ONE - (two + two) * T::EPSILON);
    let between = |from: [T; 3], to: [T; 3]| {
        [from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1]), from[2] + s * (to[2] - from[2])]
    };
    Some(Impulse {
        normal: safe.normal + s * (impulse.normal - safe.normal),
        across: between(safe.across, impulse.across),
        whole: between(base, j),
    })
}
