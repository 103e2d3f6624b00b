//! Units in which the values of an impact fill a fixed-point format without leaving it.

use std::fmt;

use super::number::Number;
use super::problem::{Body, Problem, State};
use super::vector::{Vector, scale};

/// What one is, in metres, seconds and kilograms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    pub length: f64,
    pub time: f64,
    pub mass: f64,
}

impl Units {
    pub const SI: Self = Self { length: 1.0, time: 1.0, mass: 1.0 };

    /// For 36 g, arms of 35 mm, 3 m/s and 90 rad/s.
    pub fn of_the_ellipse(number: Number) -> Self {
        match number {
            Number::I16F16 => Self { length: 1e-3, time: 1.0, mass: 0.1 },
            Number::I12F20 => Self { length: 1e-2, time: 1.0, mass: 0.1 },
            Number::I8F24 => Self { length: 1e-2, time: 0.1, mass: 0.1 },
            Number::F32 | Number::F64 | Number::Micromath => Self::SI,
        }
    }

    /// For 1 to 2 kg, arms of 0.7 m, 5 m/s and 60 rad/s.
    pub fn of_the_laws(number: Number) -> Self {
        match number {
            Number::I16F16 => Self { length: 1e-2, ..Self::SI },
            Number::I12F20 => Self { length: 0.1, ..Self::SI },
            Number::I8F24 => Self { length: 0.1, time: 0.1, mass: 1.0 },
            Number::F32 | Number::F64 | Number::Micromath => Self::SI,
        }
    }

    /// For shapes of a millimetre, a few millimetres apart.
    pub fn of_millimetres(number: Number) -> Self {
        match number {
            Number::I16F16 => Self { length: 1e-5, ..Self::SI },
            Number::I12F20 => Self { length: 1e-4, ..Self::SI },
            Number::I8F24 => Self { length: 1e-3, ..Self::SI },
            Number::F32 | Number::F64 | Number::Micromath => Self::SI,
        }
    }

    pub fn velocity(&self) -> f64 {
        self.length / self.time
    }

    pub fn spin(&self) -> f64 {
        1.0 / self.time
    }

    pub fn impulse(&self) -> f64 {
        self.mass * self.velocity()
    }

    /// An impact in SI, in these units.
    pub fn problem(&self, si: &Problem) -> Problem {
        let moment = self.mass * self.length * self.length;
        let bodies = si.bodies.map(|body| Body {
            inv_mass: body.inv_mass * self.mass,
            inv_moments: scale(moment, body.inv_moments),
            inv_inertia: body.inv_inertia.map(|row| scale(moment, row)),
            arm: scale(1.0 / self.length, body.arm),
            velocity: scale(1.0 / self.velocity(), body.velocity),
            spin: scale(1.0 / self.spin(), body.spin),
            ..body
        });
        Problem { bodies, ..*si }
    }

    /// A result in SI, in these units.
    pub fn state(&self, si: &State) -> State {
        let all = |vectors: [Vector; 2], unit: f64| vectors.map(|v| scale(1.0 / unit, v));
        State {
            impulse: scale(1.0 / self.impulse(), si.impulse),
            velocity: all(si.velocity, self.velocity()),
            spin: all(si.spin, self.spin()),
        }
    }
}

impl fmt::Display for Units {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { length, time, mass } = self;
        write!(f, "{length} m, {time} s, {mass} kg")
    }
}
