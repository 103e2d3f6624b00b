//! The generator of the sweeps: splitmix64 (Steele and others, 2014), the same sequence on every machine.

#![allow(dead_code)]

/// A sequence of numbers that look random.
pub struct Random(u64);

impl Random {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5851_f42d_4c95_7f2d)
    }

    /// 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    /// 32 bits.
    pub fn next(&mut self) -> u32 {
        (self.bits() >> 32) as u32
    }

    /// A number in `0..end`.
    pub fn below(&mut self, end: u32) -> u32 {
        ((u64::from(self.next()) * u64::from(end)) >> 32) as u32
    }

    /// In 0..1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / 2f64.powi(53)
    }

    /// A number in `low..high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Between positive ends, evenly in the logarithm.
    pub fn spread(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.log2(), high.log2()).exp2()
    }

    /// True once in `n`.
    pub fn one_in(&mut self, n: u64) -> bool {
        self.bits().is_multiple_of(n)
    }

    pub fn pick(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    /// A direction, even on the sphere.
    pub fn direction(&mut self) -> [f64; 3] {
        loop {
            let v = [self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0)];
            let square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
            if square > 1e-3 && square <= 1.0 {
                return v.map(|x| x / square.sqrt());
            }
        }
    }
}
