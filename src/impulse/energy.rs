//! The law of restitution under which no impact raises the kinetic energy.

use super::friction::ContactBlock;
use crate::scalar::Scaled;

/// W j for the block's inverse mass W.
#[inline(always)]
fn velocity_change<T: Scaled>(block: &ContactBlock<T>, j: [T; 3]) -> [T; 3] {
    let k = &block.inverse_mass;
    [
        k.nn * j[0] + (k.n1 * j[1] + k.n2 * j[2]),
        k.n1 * j[0] + (k.t11 * j[1] + k.t12 * j[2]),
        k.n2 * j[0] + (k.t12 * j[1] + k.t22 * j[2]),
    ]
}

#[inline(always)]
fn dot<T: Scaled>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + (a[1] * b[1] + a[2] * b[2])
}

/// `j`, or where it would raise the kinetic energy, the point nearest to it that does not, on the line to the impulse
/// without rebound.
///
/// An impulse j changes the energy by T(j) = j . v + 1/2 j . W j. The impulse j_0 without rebound never raises it
/// (v_n' = 0 and friction opposes v_t', so that T(j_0) = j_0 . v' - 1/2 j_0 . W j_0 <= 0), and on the line j_0 + s d T is
/// a parabola that opens upwards: it crosses zero once between s = 0 and s = 1. Both ends lie in the friction cone, which
/// is convex, and v_n' is linear in s.
#[inline]
pub(super) fn limit_energy<T: Scaled>(block: &ContactBlock<T>, friction: T, j: [T; 3]) -> [T; 3] {
    let half = T::from_parts(1, -1);
    let energy = |j: [T; 3]| {
        let change = velocity_change(block, j);
        dot(j, block.speed) + half * dot(j, change)
    };
    if energy(j) <= T::ZERO {
        return j;
    }
    let (base, _) = block.solve(T::ZERO, friction);
    let d = [j[0] - base[0], j[1] - base[1], j[2] - base[2]];
    let after = velocity_change(block, base);
    let after = [after[0] + block.speed[0], after[1] + block.speed[1], after[2] + block.speed[2]];
    let (a, b, c) = (half * dot(d, velocity_change(block, d)), dot(d, after), energy(base));
    // False where d is zero (e = 0) or something is not finite, and where no energy is there to keep.
    let crosses = a > T::ZERO && c < T::ZERO;
    if !crosses {
        return base;
    }
    let two = T::ONE + T::ONE;
    let root = (b * b - (two + two) * a * c).sqrt();
    // The positive root, in the form that subtracts nothing.
    let s = if b > T::ZERO { -(two * c) / (b + root) } else { (root - b) / (two * a) };
    // Where the line is too short to be told from rounding, its end is as good as any point.
    let s = if s < T::ONE { s } else { T::ONE };
    // Rounding must not tip it over.
    let s = s * (T::ONE - (two + two) * T::EPSILON);
    [base[0] + s * d[0], base[1] + s * d[1], base[2] + s * d[2]]
}
