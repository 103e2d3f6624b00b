//! Exact products on this core: the leading 30 bits of sums of 64-bit products, and products and differences of two, rounded and
//! clipped, made by the library's own instructions on Cortex-M, against the compiler's 128-bit arithmetic, for extreme operands
//! and for ten thousand others.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;

use board::Exit;
#[cfg(feature = "fixed")]
use carom::{Scalar, Scaled, Scaled32};
#[cfg(feature = "fixed")]
use core::hint::black_box;
#[cfg(feature = "fixed")]
use fixed::FixedI32;
#[cfg(feature = "fixed")]
use fixed::types::extra::{U0, U1, U16, U20, U30, Unsigned};
#[cfg(feature = "fixed")]
use fixed::types::{I2F30, I32F0};

board::entry!(run);

#[cfg(not(feature = "fixed"))]
fn run() -> Exit {
    board::println!("no fixed point in this build");
    Exit::Success
}

#[cfg(feature = "fixed")]
fn run() -> Exit {
    let mut words = Words(1);
    let mut wrong = 0u32;
    for turn in 0..10_000u32 {
        // The first turns take every pair of extreme operands, in each place of the sum in turn.
        let [n, m] = [turn % EXTREMES.len() as u32, turn / EXTREMES.len() as u32];
        let (v, d) = if (m as usize) < EXTREMES.len() {
            let extreme = |i: u32| EXTREMES[(i % EXTREMES.len() as u32) as usize];
            ([extreme(n), extreme(n + 1), extreme(n + m)], [extreme(m), extreme(m + n), extreme(m + 1)])
        } else {
            ([words.next(), words.next(), words.next()], [words.next(), words.next(), words.next()])
        };
        let are_right = products_are_right::<U0>(v, d)
            && products_are_right::<U1>(v, d)
            && products_are_right::<U16>(v, d)
            && products_are_right::<U20>(v, d)
            && products_are_right::<U30>(v, d);
        // A direction is no longer than two.
        let d = [d[0] >> 1, d[1] >> 1, d[2] >> 1];
        if !(are_right && sum_is_right(v, d)) {
            board::println!("wrong: {:?} . {:?}", v, d);
            wrong = wrong.wrapping_add(1);
        }
    }
    board::println!("10000 sums of products, {} wrong", wrong);
    if wrong == 0 { Exit::Success } else { Exit::Failure }
}

#[cfg(feature = "fixed")]
const EXTREMES: [i32; 13] =
    [0, 1, -1, 2, 0xffff, 0x10000, -0x10000, 0x7fff_ffff, -0x7fff_ffff, i32::MIN, 0x4000_0000, -0x4000_0000, 0x7fff];

/// Signed words of every length: xorshift (Marsaglia, 2003), each shifted by a random number of places.
#[cfg(feature = "fixed")]
struct Words(u32);

#[cfg(feature = "fixed")]
impl Words {
    fn next(&mut self) -> i32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        let places = self.0.wrapping_mul(0x9e37_79b9) >> 27;
        self.0 as i32 >> places
    }
}

/// `v0 d0` and `v0 d0 - v1 d1` of a format, and `v0` times a factor of Q2.30, are the nearest numbers, ties away from zero, or
/// the end of the range.
#[cfg(feature = "fixed")]
fn products_are_right<Frac>(v: [i32; 3], d: [i32; 3]) -> bool
where
    Frac: Unsigned,
    FixedI32<Frac>: Scalar<Unit = I2F30>,
{
    let ([x, y, _], [z, w, _]) =
        (black_box(v).map(FixedI32::<Frac>::from_bits), black_box(d).map(FixedI32::<Frac>::from_bits));
    let exact = |i: usize| i128::from(v[i]) * i128::from(d[i]);
    let nearest = |exact: i128, frac: u32| {
        let magnitude = (exact.unsigned_abs() + ((1 << frac) >> 1)) >> frac;
        (magnitude as i128 * exact.signum()).clamp(i32::MIN.into(), i32::MAX.into()) as i32
    };
    x.times(z).to_bits() == nearest(exact(0), Frac::U32)
        && FixedI32::det2(x, y, w, z).to_bits() == nearest(exact(0) - exact(1), Frac::U32)
        && x.times_unit(I2F30::from_bits(d[0])).to_bits() == nearest(exact(0), 30)
}

/// `v . d` of the library has the exact sum's leading 30 bits, and so has its square.
#[cfg(feature = "fixed")]
fn sum_is_right(v: [i32; 3], d: [i32; 3]) -> bool {
    let [x, y, z] = black_box(v).map(I32F0::from_bits);
    let sum = I32F0::scaled_dot3([x, y, z], black_box(d).map(I2F30::from_bits));
    let exact = |i: usize| i128::from(v[i]) * i128::from(d[i]);
    let exact = exact(0) + exact(1) + exact(2);
    // In units of 2^-30; and the square of the rounded sum.
    let is_nearest = |x: Scaled32, exact: i128, unit: i32| {
        let (mantissa, exponent) = (i128::from(x.mantissa()), x.exponent() - 30 - unit);
        match exact {
            0 => mantissa == 0,
            _ if exponent <= 0 => mantissa == exact << exponent.unsigned_abs().min(90),
            _ => 2 * ((mantissa << exponent) - exact).unsigned_abs() <= 1 << exponent,
        }
    };
    let square = sum * sum;
    let mantissa = i128::from(sum.mantissa());
    let zero = sum == Scaled32::ZERO;
    is_nearest(sum, exact, -30) && (zero || is_nearest(square, mantissa * mantissa, 2 * (sum.exponent() - 30)))
}
