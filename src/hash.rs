//! One number for the state of many bodies, to compare runs on different machines.

use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::Scalar;

/// FNV-1a over 64 bits, fed with the stored bits of numbers, eight bytes each, the lowest first.
///
/// Two runs with the same hash have the same positions, orientations and velocities, bit for bit (up to a chance of
/// 2^-64). Not a cryptographic hash.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StateHash(u64);

impl StateHash {
    /// The hash of nothing.
    pub const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Adds one number.
    pub fn add<S: Scalar>(&mut self, x: S) {
        for byte in x.bits().to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// Adds the three components of a vector.
    pub fn add_vec3<S: Scalar>(&mut self, v: Vec3<S>) {
        for x in v.to_array() {
            self.add(x);
        }
    }

    /// Adds the state of a body: position, orientation, linear and angular velocity.
    pub fn add_body<S: Scalar>(&mut self, body: &Body<S>) {
        self.add_vec3(body.position);
        for x in body.orientation().to_array() {
            self.add(x);
        }
        self.add_vec3(body.linear_velocity);
        self.add_vec3(body.angular_velocity);
    }

    /// The hash so far.
    pub const fn get(self) -> u64 {
        self.0
    }
}

impl Default for StateHash {
    fn default() -> Self {
        Self::new()
    }
}
