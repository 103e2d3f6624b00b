//! Energy and momentum of the bodies that move, from the trace alone. Masses are in the scene's unit, the rest is SI.

use crate::algebra::{dot, inverse, rotate_back};
use crate::trace::{Frame, Trace};
use serde::Serialize;

/// Sums over all bodies with a mass.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Balance {
    /// Of the motion of the centres, J.
    pub motion: f64,
    /// Of the spins, J.
    pub spin: f64,
    /// In the gravity of the frame, from the origin up, J.
    pub height: f64,
    /// kg m/s.
    pub momentum: [f64; 3],
}

impl Balance {
    pub fn total(&self) -> f64 {
        self.motion + self.spin + self.height
    }

    pub fn of(trace: &Trace, frame: &Frame) -> Self {
        let mut sum = Self::default();
        let unit = trace.unit;
        for (subject, motion) in trace.bodies.iter().zip(&frame.motions) {
            if subject.is_fixed() {
                continue;
            }
            let mass = 1.0 / subject.inv_mass;
            let spin = rotate_back(motion.orientation, motion.spin);
            sum.motion += 0.5 * mass * dot(motion.velocity, motion.velocity) * unit * unit;
            sum.spin += 0.5 * inverse(subject.inv_inertia).map_or(0.0, |i| form(i, spin)) * unit * unit;
            sum.height -= mass * dot(frame.gravity, motion.position) * unit * unit;
            for (sum, speed) in sum.momentum.iter_mut().zip(motion.velocity) {
                *sum += mass * speed * unit;
            }
        }
        sum
    }
}

/// `w . I w` of a symmetric tensor.
fn form([xx, xy, xz, yy, yz, zz]: [f64; 6], [x, y, z]: [f64; 3]) -> f64 {
    xx * x * x + yy * y * y + zz * z * z + 2.0 * (xy * x * y + xz * x * z + yz * y * z)
}
