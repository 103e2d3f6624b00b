//! The solver: bodies and contacts over one step of time, by sub-steps with soft contacts and warm starting.
//!
//! It knows bodies and manifolds, and no shapes. A step over the caller's own slices:
//!
//! 1. [`Step::begin`] reads the velocities,
//! 2. [`Step::add`] takes each pair that touches or is about to, with the impulses of the step before,
//! 3. [`Step::finish`] solves and moves the bodies.
//!
//! Then [`Constraints::impulses`] has what to keep for the next step.
//!
//! **Cost.** With n sub-steps, b bodies that move, m manifolds and p points in them, a step takes n (b A + p B) + b C + m D + p E
//! instructions, with constants of the core and the number type: no loop depends on anything else.

mod constraint;
mod drive;
mod energy;
mod friction;
mod gyroscope;
mod impact;
mod integrate;
mod motion;
mod prepare;
mod settings;
mod softness;
mod step;
mod touch;
mod warm_start;

pub use self::constraint::{ManifoldConstraint, PointConstraint};
pub use self::drive::drive;
pub use self::motion::Motion;
pub use self::settings::{Settings, SettingsError};
pub use self::softness::Softness;
pub use self::step::{Buffers, Constraints, Step, StepReport};
pub use self::touch::Touch;
pub use self::warm_start::WarmStart;
