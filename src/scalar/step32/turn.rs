//! The orientation after a rotation.

use fixed::types::I2F30;

use super::round::round;
use crate::math::Vec3;
use crate::scalar::integer::round_sqrt;
use crate::scalar::product::{dot, dot2, product};
use crate::scalar::wide::{bits, inverse, narrow};

/// By twice the arc tangent of the length of `u`, of which the first two terms of the series are taken.
#[inline(never)]
pub fn turned(orientation: [I2F30; 4], u: Vec3<I2F30>) -> [I2F30; 4] {
    let [w, x, y, z] =
        [orientation[0].to_bits(), orientation[1].to_bits(), orientation[2].to_bits(), orientation[3].to_bits()];
    // tan a = a + a^3/3 + ...; 357913941 is a third.
    let u = bits(&u);
    let third = round::<30>(product(round::<30>(dot(u, u)), 357_913_941));
    let more = |x: i32| x.wrapping_add(round::<30>(product(x, third)));
    let u = [more(u[0]), more(u[1]), more(u[2])];
    let part = |d| round::<30>(dot(u, d));
    let neg = i32::wrapping_neg;
    normalized([
        w.wrapping_sub(part([x, y, z])),
        x.wrapping_add(part([w, z, neg(y)])),
        y.wrapping_add(part([neg(z), w, x])),
        z.wrapping_add(part([y, neg(x), w])),
    ])
}

/// A quaternion that is nearly of unit length, brought to it.
#[inline(always)]
fn normalized(q: [i32; 4]) -> [I2F30; 4] {
    let square = dot2([q[0], q[1]], [q[0], q[1]]).wrapping_add(dot2([q[2], q[3]], [q[2], q[3]]));
    let excess = narrow::<30>(square.wrapping_sub(1 << 60));
    let factor = if excess.wrapping_add(1 << 20) as u32 <= 1 << 21 {
        // 1 - e/2 + 3/8 e^2, for |e| below 2^-10.
        let second = narrow::<30>(product(excess, excess));
        (1i32 << 30).wrapping_sub(excess >> 1).wrapping_add((second >> 1).wrapping_sub(second >> 3))
    } else {
        inverse_length(square)
    };
    let part = |x| I2F30::from_bits(round::<30>(product(x, factor)));
    [part(q[0]), part(q[1]), part(q[2]), part(q[3])]
}

/// 1/length in Q2.30, for a square between 1 and 4 in units of 2^-60.
#[cold]
#[inline(never)]
fn inverse_length(square: i64) -> i32 {
    let length = round_sqrt(square as u64) | 1 << 30;
    inverse(length << 1)
}
