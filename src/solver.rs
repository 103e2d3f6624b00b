//! The solver: bodies and contacts over one step of time, by sub-steps with soft contacts and warm starting.
//!
//! It knows bodies and manifolds, and no shapes. A step over the caller's own slices:
//!
//! 1. [`Step::begin`] reads the velocities,
//! 2. [`Step::add`] takes each pair that touches or is about to, with the impulses of the step before,
//! 3. [`Step::finish`] solves and moves the bodies; [`Step::advance`] before it does so in parts.
//!
//! Then [`Constraints::impulses`] has what to keep for the next step.
//!
//! **Cost.** With n sub-steps, b bodies that move, m manifolds and p points in them, a step takes at most n (b A + m B + p C) +
//! b D + m E + p F instructions, with constants of the core and the number type: the loops within them have fixed ends (eight
//! parts of a turn, eight rounds of the gyroscopic rule, four old points for each new one). It takes less where points are
//! apart, do not slide or do not rebound, and where bodies do not spin. Each body of the slice, whether it moves or not, is
//! also looked at once per loop over bodies.

mod constraint;
mod drive;
mod energy;
mod friction;
mod gyroscope;
mod impact;
mod integrate;
mod motion;
mod prepare;
mod prepare_round;
mod settings;
mod softness;
mod stages;
mod step;
mod touch;
mod warm_start;

pub use self::constraint::{ManifoldConstraint, PointConstraint};
pub use self::drive::drive;
pub use self::motion::Motion;
pub use self::settings::{Settings, SettingsError};
pub use self::softness::Softness;
pub use self::stages::{Buffers, Constraints};
pub(crate) use self::step::Paused;
pub use self::step::{Step, StepReport};
pub use self::touch::Touch;
pub use self::warm_start::WarmStart;
