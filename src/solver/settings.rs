//! How steps are made.

use core::error::Error;
use core::fmt::{Display, Formatter};

use super::Softness;
#[cfg(doc)]
use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::{Scalar, Scaled};

/// Gravity, time and softness: the same for all bodies of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings<S: Scalar> {
    /// The acceleration of free fall, m/s^2.
    pub gravity: Vec3<S>,
    /// The speed at which bodies that overlap are pushed apart, at most, m/s: 4 at first, in whatever units. About the highest
    /// speed of the scene suits; see [`with_push_out_speed`](Self::with_push_out_speed). Blows that are harder let go of their
    /// friction before positions change.
    pub push_out_speed: S,
    /// Between bodies that both move.
    pub soft: Softness<S>,
    /// Against immovable ones.
    pub hard: Softness<S>,
    pub(super) sub_steps: u8,
    pub(super) h: S::SubStep,
    pub(super) inv_h: S::Scaled,
    /// A whole step, s.
    pub(crate) dt: S::Unit,
    /// The steps in half a second, 255 at most.
    pub(crate) half_second: u8,
}

/// A time that cannot be stepped over, or a gravity that is no acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SettingsError;

impl Display for SettingsError {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        f.write_str(
            "settings: take a sub-step or more, each longer than zero and below one second, the step below two, and a finite gravity",
        )
    }
}

impl Error for SettingsError {}

impl<S: Scalar> Settings<S> {
    /// Steps of `seconds[0] / seconds[1]`, each in as many sub-steps.
    ///
    /// Contacts have a frequency of a quarter of a cycle a sub-step and twice the critical damping; twice that frequency
    /// against immovable bodies. A stack sags by g/w^2 a contact times its load.
    ///
    /// # Errors
    /// [`SettingsError`]: no sub-steps, one that is not between zero and one second, or a step of two seconds or more; or a
    /// gravity that is not finite.
    ///
    /// ```
    /// # #[cfg(feature = "f32")] {
    /// use carom::{Vec3, solver::Settings};
    ///
    /// assert!(Settings::new(Vec3::new(0.0, 0.0, -9.81_f32), [1, 60], 4).is_ok());
    /// assert!(Settings::new(Vec3::new(0.0, 0.0, f32::NAN), [1, 60], 4).is_err());
    /// assert!(Settings::new(Vec3::new(0.0, 0.0, -9.81_f32), [1, 60], 0).is_err());
    /// # }
    /// ```
    pub fn new(gravity: Vec3<S>, seconds: [u16; 2], sub_steps: u8) -> Result<Self, SettingsError> {
        let [numerator, denominator] = [i32::from(seconds[0]), i32::from(seconds[1]) * i32::from(sub_steps)];
        let h = S::sub_step(numerator, denominator).map_err(|_| SettingsError)?;
        if numerator == 0 || !gravity.is_finite() {
            return Err(SettingsError);
        }
        let two = S::Scaled::ratio(2, 1);
        let (dt, too_long) = S::Unit::from_scaled(S::Scaled::ratio(numerator, i32::from(seconds[1])));
        if too_long {
            return Err(SettingsError);
        }
        let half_second = u32::from(seconds[1]).div_ceil(2 * u32::from(seconds[0]));
        Ok(Self {
            gravity,
            push_out_speed: S::from_ratio(4, 1).map_err(|_| SettingsError)?,
            soft: Softness::new(S::Scaled::ratio(1, 4), two),
            hard: Softness::new(S::Scaled::ratio(1, 2), two),
            sub_steps,
            h,
            inv_h: S::Scaled::ratio(denominator, numerator),
            dt,
            half_second: half_second.min(255) as u8,
        })
    }

    /// The same, but bodies that overlap are pushed apart at up to that speed, in units of length by units of time.
    ///
    /// [`new`](Self::new) takes 4 of these, which is far too slow where the unit of length is a millimetre, and bodies that were
    /// put into each other, or driven there, part only after seconds. [`Scene::settings`](crate::units::Scene::settings) takes the
    /// highest speed of the scene. Zero leaves them where they are.
    #[must_use]
    pub const fn with_push_out_speed(mut self, speed: S) -> Self {
        self.push_out_speed = speed;
        self
    }

    /// The sub-steps of a step.
    #[must_use]
    pub const fn sub_steps(&self) -> u8 {
        self.sub_steps
    }

    /// The length of a step in seconds, for [forces](Body::apply_force) that act over one. One division: to 2^-29 of it in
    /// fixed point.
    #[must_use]
    pub fn seconds(&self) -> S::Scaled {
        S::Scaled::from_parts(i32::from(self.sub_steps), 0) / self.inv_h
    }
}
