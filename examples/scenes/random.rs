//! Numbers that look random and are the same everywhere.

use carom::{Quat, Scalar, UnitVec3, Vec3};

/// xorshift32 (Marsaglia, "Xorshift RNGs", 2003): the same sequence on every machine.
#[derive(Clone, Copy)]
pub struct Random(u32);

impl Random {
    /// A generator that starts there; zero is not a start.
    pub const fn new(seed: u32) -> Self {
        Self(if seed == 0 { 0x2545_f491 } else { seed })
    }

    pub fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    pub fn below(&mut self, end: u32) -> u32 {
        (self.next() >> 16).wrapping_mul(end) >> 16
    }

    /// An integer in `low..high`.
    pub fn integer(&mut self, low: i32, high: i32) -> i32 {
        low.wrapping_add(self.below(high.wrapping_sub(low) as u32) as i32)
    }

    /// A multiple of 1/1024 in `low..high`, both in units of 1/1024.
    pub fn number<S: Scalar>(&mut self, low: i32, high: i32) -> S {
        S::from_ratio(self.integer(low, high), 1024).unwrap_or(S::ZERO)
    }

    pub fn vector<S: Scalar>(&mut self, low: i32, high: i32) -> Vec3<S> {
        Vec3::new(self.number(low, high), self.number(low, high), self.number(low, high))
    }

    pub fn direction<S: Scalar>(&mut self) -> UnitVec3<S> {
        UnitVec3::normalize(self.vector(-1024, 1024)).unwrap_or(UnitVec3::Z)
    }

    pub fn orientation<S: Scalar>(&mut self) -> Quat<S> {
        let mut unit = || {
            // Within +-1/2: the square of a quaternion of four such components fits every format.
            self.number::<S::Unit>(-512, 512)
        };
        Quat::normalize(unit(), unit(), unit(), unit()).unwrap_or(Quat::IDENTITY)
    }

    /// Every orientation as likely as every other: the directions of points in a ball of four dimensions.
    pub fn fair_orientation<S: Scalar>(&mut self) -> Quat<S> {
        for _ in 0..64 {
            let q = [(); 4].map(|()| self.integer(-512, 512));
            let square: i32 = q.iter().map(|c| c.wrapping_mul(*c)).sum();
            if (1..=512 * 512).contains(&square) {
                let [w, x, y, z] = q.map(|c| S::Unit::from_ratio(c, 1024).unwrap_or(S::Unit::ZERO));
                return Quat::normalize(w, x, y, z).unwrap_or(Quat::IDENTITY);
            }
        }
        Quat::IDENTITY
    }
}
