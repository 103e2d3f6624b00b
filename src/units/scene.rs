//! A scene's extremes, and whether a number format holds them.

use super::check::{Demand, Measures, Property};
use super::error::UnitsError;
use super::format::{Format, NumberFormat};
use super::propose::propose;
use super::quantity::Quantity;
use super::system::Units;
use crate::error::RangeError;
use crate::math::{UnitVec3, Vec3, abs};
use crate::scalar::Scalar;
use crate::solver::Settings;

/// The extremes of a scene, in SI units; signs do not count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scene {
    /// The smallest radius, half edge or half thickness of a body, m.
    pub smallest_size: Quantity,
    /// The largest distance of two points on bodies, or of such a point from the origin, m.
    pub largest_distance: Quantity,
    /// The mass of the lightest body that moves, kg.
    pub lightest: Quantity,
    /// The mass of the heaviest body that moves, kg.
    pub heaviest: Quantity,
    /// The highest speed that a body comes to, m/s.
    pub fastest: Quantity,
    /// The acceleration of free fall, m/s^2; zero where nothing falls.
    pub gravity: Quantity,
    /// The length of a step, s.
    pub step: Quantity,
    /// Sub-steps of a step.
    pub sub_steps: u8,
    /// How long it goes on, s.
    pub duration: Quantity,
}

/// A scene that fits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fit {
    /// The property that is next to its limit.
    pub tightest: Property,
    /// By how many powers of two it is within it.
    pub room: i32,
    /// The speed, m/s, up to which a single body at rest shakes, for positions are rounded: thresholds of sleep go above it.
    pub resting_noise: Quantity,
}

impl Scene {
    /// Whether the format holds the scene in metres, kilograms and seconds.
    ///
    /// # Errors
    /// [`UnitsError`] names the property that is farthest from fitting, and units in which all fit.
    pub const fn check<S: NumberFormat>(&self) -> Result<Fit, UnitsError> {
        self.check_in::<S>(&Units::SI)
    }

    /// Whether the format holds the scene in those units.
    ///
    /// # Errors
    /// [`UnitsError`] names the property that is farthest from fitting, and units in which all fit.
    pub const fn check_in<S: NumberFormat>(&self, units: &Units) -> Result<Fit, UnitsError> {
        let measures = Measures::of(self);
        let tightest = tightest(&measures, S::FORMAT, units);
        if tightest.room < 0 {
            let remedy = match propose(&measures, S::FORMAT) {
                Ok(units) => Some(units),
                Err(_) => None,
            };
            return Err(UnitsError::new(tightest, units, remedy));
        }
        let (digits, exponent) = measures.resting_noise(S::FORMAT, units).decimal();
        let resting_noise = Quantity::new(digits as i32, exponent as i8);
        Ok(Fit { tightest: tightest.property, room: tightest.room, resting_noise })
    }

    /// The scene's gravity, along `down`, its steps and its highest speed, as the one at which bodies that overlap are pushed apart,
    /// in those units.
    ///
    /// # Errors
    /// [`RangeError`] where one is beyond the format, as in a scene that [fits](Self::check_in) none is, or where the step has no
    /// [form](Units::step) in which it can be told.
    pub fn settings<S: Scalar>(&self, units: &Units, down: UnitVec3<S>) -> Result<Settings<S>, RangeError> {
        let gravity = Vec3::of_length(abs(units.acceleration(self.gravity)?), down.get());
        let steps = Settings::new(gravity, units.step(self.step)?, self.sub_steps).map_err(|_| RangeError)?;
        Ok(steps.with_push_out_speed(abs(units.speed(self.fastest)?)))
    }

    /// Units in which the format holds the scene: metres, kilograms and seconds if it does in these; else with the most room,
    /// powers of ten of the metre and the kilogram, or powers of two if no power of ten fits, and seconds if they fit, else a
    /// power of two of the second. Units that would fit are found wherever they leave a factor of four.
    ///
    /// # Errors
    /// [`UnitsError`] where no units do: the property that is in the way in the units that come closest.
    pub const fn propose<S: NumberFormat>(&self) -> Result<Units, UnitsError> {
        match propose(&Measures::of(self), S::FORMAT) {
            Ok(units) => Ok(units),
            Err((demand, units)) => Err(UnitsError::new(demand, &units, None)),
        }
    }
}

/// The demand with the least room.
pub(super) const fn tightest(measures: &Measures, format: Format, units: &Units) -> Demand {
    let of_motion = measures.time(format, units).tighter(measures.motion(format, units));
    of_motion.tighter(measures.mass(format, units))
}
