//! Units in which a scene fits a number format.
//!
//! Fixed point has a range and a spacing, and units decide where in it a scene lies: a marble of 5 mm that rolls at 2 m/s turns
//! at 400 rad/s, beyond the 128 of `I8F24`, and in units of 1/4 s it does not. [`Scene`] takes the extremes of a scene in SI
//! units and integers; [`Scene::check`] tells whether a format holds them, [`Scene::propose`] in which units it does, and
//! [`Units`] brings quantities there and back. Both are `const`: what does not fit does not compile, and nothing of it is in the
//! firmware.
//!
//! ```
//! # #[cfg(feature = "fixed")] {
//! use carom::units::{Dimension, Quantity, Scene, Units};
//! use fixed::types::I8F24;
//!
//! const SCENE: Scene = Scene {
//!     smallest_size: Quantity::milli(5),         // a marble's radius
//!     largest_distance: Quantity::milli(80),     // across the badge
//!     lightest: Quantity::new(13, -4),           // 1.3 g
//!     heaviest: Quantity::new(13, -4),
//!     fastest: Quantity::whole(2),
//!     gravity: Quantity::centi(981),
//!     step: Quantity::ratio(1, 60),
//!     sub_steps: 4,
//!     duration: Quantity::kilo(86),              // a day
//! };
//! const UNITS: Units = match SCENE.propose::<I8F24>() {
//!     Ok(units) => units,
//!     Err(_) => panic!("no units do"),
//! };
//! const _: () = assert!(SCENE.check::<I8F24>().is_err() && SCENE.check_in::<I8F24>(&UNITS).is_ok());
//!
//! let radius: I8F24 = UNITS.length(Quantity::milli(5)).unwrap();
//! assert_eq!(UNITS.count(radius, Dimension::LENGTH, Quantity::micro(1)), 5000);
//! # }
//! ```
//!
//! **What is checked** is what can go wrong. Bodies keep their mass and inertia with powers of two of their own, and impulses
//! within a step are speeds: neither has a range. In fixed point there remain
//!
//! - positions, speeds, spins, masses, gravity and reported impulses, which have to be within the range;
//! - sizes, masses and gravity, of at least 512 units of the last place, so that they are a thousandth off at most (piles of
//!   boxes of half that size fall);
//! - what gravity adds in a sub-step, 512 units too, of those that the solver has to spare: the more, the slower the fastest
//!   body is;
//! - and what that moves a body by in a sub-step, a 512th of a unit, so that friction feels its weight;
//! - the sub-step, below one unit of time, and so precise that the clock is no step off at the end of the duration.
//!
//! In floating point it is the distance, of 16,384 times the smallest size at most in `f32`, and gravity beside the highest speed.
//!
//! **Not checked** is what units do not change: how far bodies move in a step beside their size, and how much they turn.

mod check;
mod error;
mod format;
mod magnitude;
mod propose;
mod quantity;
mod scene;
mod system;

pub use self::check::{Misfit, Property};
pub use self::error::UnitsError;
pub use self::format::{Format, NumberFormat};
pub use self::quantity::{Dimension, Quantity};
pub use self::scene::{Fit, Scene};
pub use self::system::Units;
