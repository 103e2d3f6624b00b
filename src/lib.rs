//! Rigid bodies on microcontrollers: the impulse of one contact, a solver over many, and a world of bodies with shapes, in `f32`
//! or in fixed point, without an allocator, with the same bits on a Cortex-M0 as on a laptop.
//!
//! A die that falls onto a table, in a [`World`] of fixed size:
//!
//! ```
//! use carom::solver::Settings;
//! use carom::{Body, Cuboid, HalfSpace, Material, Scalar, Solid, UnitVec3, Vec3, World};
//! # #[cfg(feature = "f32")] type Real = f32;
//! # #[cfg(all(not(feature = "f32"), feature = "fixed"))] type Real = fixed::types::I12F20;
//! # #[cfg(all(not(feature = "f32"), not(feature = "fixed"), feature = "f64"))] type Real = f64;
//! # #[cfg(all(not(any(feature = "f32", feature = "fixed", feature = "f64")), feature = "micromath"))]
//! # type Real = micromath::F32;
//! # #[cfg(any(feature = "f32", feature = "fixed", feature = "f64", feature = "micromath"))]
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // `type Real = f32;`, or `fixed::types::I12F20` on a part without an FPU: nothing else changes.
//! carom::shapes! { enum Piece<S> { Cuboid, HalfSpace } }         // only the pairs of these are linked
//! let milli = |n| Real::from_ratio(n, 1000);
//! let zero = Real::ZERO;
//!
//! let mut world = World::<Real, Piece<Real>, 2, 4, 8>::new();    // bodies, pairs that touch, points
//! let wood = Material::new(milli(300)?, milli(500)?)?;           // restitution, friction
//! world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), wood)?;
//! let half = Vec3::new(milli(10)?, milli(10)?, milli(10)?);      // 2 cm
//! let die = Body::dynamic(Solid::cuboid(half)?.with_mass(milli(8)?)?);
//! let die = world.insert(die.at(Vec3::new(zero, zero, milli(100)?)), Cuboid::new(half)?, wood)?;
//!
//! let fall = Vec3::new(zero, zero, milli(-9810)?);
//! let settings = Settings::new(fall, [1, 60], 4)?;               // 1/60 s in four sub-steps
//! let mut hits = 0;
//! for _ in 0..120 {
//!     world.step(&settings);                                     // never fails
//!     hits += world.impacts().count();                           // who hit whom, how fast, how hard
//! }
//! assert!(hits > 1 && world.is_asleep(die)?);
//! # Ok(())
//! # }
//! # #[cfg(not(any(feature = "f32", feature = "fixed", feature = "f64", feature = "micromath")))]
//! # fn main() {}
//! ```
//!
//! One contact between two bodies of your own:
//!
//! ```
//! use carom::impulse::{Outcome, resolve_collision_with_friction};
//! use carom::{Body, Contact, Material, Scalar, Solid, UnitVec3, Vec3};
//! # #[cfg(feature = "f32")] type Real = f32;
//! # #[cfg(all(not(feature = "f32"), feature = "fixed"))] type Real = fixed::types::I16F16;
//! # #[cfg(all(not(feature = "f32"), not(feature = "fixed"), feature = "f64"))] type Real = f64;
//! # #[cfg(all(not(any(feature = "f32", feature = "fixed", feature = "f64")), feature = "micromath"))]
//! # type Real = micromath::F32;
//! # #[cfg(any(feature = "f32", feature = "fixed", feature = "f64", feature = "micromath"))]
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // `type Real = f32;`, or `fixed::types::I16F16` on a part without an FPU: nothing else changes.
//! let milli = |n| Real::from_ratio(n, 1000);
//! let zero = Real::ZERO;
//!
//! let solid = Solid::sphere(milli(28)?)?;                        // 28 mm
//! let mut cue = Body::dynamic(solid.with_mass(milli(170)?)?);    // 170 g
//! let mut ball = cue;
//! cue.linear_velocity = Vec3::new(milli(2000)?, zero, zero);     // 2 m/s along x
//!
//! let contact = Contact {
//!     normal: UnitVec3::X,                                       // from the cue ball to the other
//!     r_a: Vec3::new(milli(28)?, zero, zero),                    // centre of the cue ball to the point
//!     r_b: Vec3::new(milli(-28)?, zero, zero),
//! };
//! let material = Material::new(milli(950)?, milli(60)?)?;        // restitution, friction
//!
//! let hit = resolve_collision_with_friction(&mut cue, &mut ball, &contact, &material);
//! assert_eq!(hit.outcome, Outcome::Stuck);                       // a straight shot does not slide
//! assert!(ball.linear_velocity.x > milli(1949)? && ball.linear_velocity.x < milli(1951)?);
//! # Ok(())
//! # }
//! # #[cfg(not(any(feature = "f32", feature = "fixed", feature = "f64", feature = "micromath")))]
//! # fn main() {}
//! ```
//!
//! # A tour
//!
//! - [`Scalar`]: the number types. A feature each (`f32`, `fixed`, `f64`, `micromath`) adds one; none excludes another.
//! - [`Vec3`], [`UnitVec3`], [`Quat`], [`Mat3`], [`SymMat3`]: just the algebra that is used.
//! - [`Solid`] and [`MassProperties`]: mass and inertia of the usual solids, or as given.
//! - [`Assembly`]: several solids as one body.
//! - [`Body`], [`Contact`], [`Material`]: what it all works on.
//! - [`impulse`]: **one contact**. From [`impulse::effective_mass`] over [`impulse::collision_impulse`] and
//!   [`impulse::apply_impulse`] to [`impulse::resolve_collision_with_friction`].
//! - [`Sphere`], [`HalfSpace`], [`Cuboid`], [`Capsule`], [`ConvexHull`], [`HeightField`], and a [`Compound`] of several: shapes.
//!   [`Collide`] finds where two touch, [`Shape`] answers rays and points, [`shapes!`] makes one type of those that a world
//!   holds, and [`SweepAndPrune`] finds the pairs worth a look. Geometry knows neither velocities nor masses.
//! - [`solver`]: **many contacts** over a step of time, on the caller's own slices of bodies and manifolds;
//!   [`solver::Settings`] says how.
//! - [`World`]: **bodies with shapes** in memory of fixed size, from the broad phase to sleep.
//! - [`units`]: whether a scene fits a number format, and units in which it does.
//! - [`StateHash`]: one number to compare two machines by.
//! - `check_float_environment`, with `f32`: whether the FPU is set as it has to be.
//!
//! # Conventions
//!
//! Any consistent units: metres, kilograms and seconds, or centimetres, grams and seconds. Where these pages name units,
//! they name the SI's as an example; angles are in radians. Vectors are in the world's frame unless said otherwise. The
//! normal points from body A to body B, and impulses are given as they act on B. A quaternion turns the body's frame into
//! the world's. An inverse mass of zero means immovable.
//!
//! # Errors
//!
//! Constructors refuse bad input with an error that names the parameter. An impulse or a step never fails: fixed point stays at
//! the end of its range, a float that is not finite leaves the bodies as they were, contacts beyond the room there is are left
//! out, and the report says so. Nothing panics, allocates, wraps, or loops without a bound.
//!
//! # Beside other crates
//!
//! Features add implementations of others' traits: `mint` (vectors, quaternions and matrices, from and to any library of
//! mathematics), `serde` (public values, validated on the way in), `bytemuck` (values and bodies as bytes, likewise), `defmt` (logs),
//! `arbitrary` (fuzzers), `embedded-graphics` (a world on a display). [`interop`] says what each holds.
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![deny(missing_docs)]
#![deny(unsafe_code)]

mod aabb;
mod body;
mod broad_phase;
mod contact;
mod error;
#[cfg(feature = "f32")]
mod float_environment;
mod hash;
pub mod impulse;
pub mod interop;
mod manifold;
mod mass;
mod math;
mod narrow_phase;
mod query;
mod scalar;
mod shape;
pub mod solver;
pub mod units;
pub mod world;

pub use aabb::Aabb;
pub use body::Body;
pub use broad_phase::{PairSink, Pairs, SweepAndPrune};
pub use contact::{Contact, Material, RestitutionLaw};
pub use error::{
    BodyError, CompoundError, ContactError, DirectionError, HandleError, HeightFieldError, HullError, InsertError,
    MassError, MaterialError, OrientationError, RangeError, ShapeError, SolidError,
};
#[cfg(feature = "f32")]
pub use float_environment::{FloatEnvironmentError, check_float_environment};
pub use hash::StateHash;
pub use manifold::{FeatureId, Manifold, ManifoldPoint};
pub use mass::{Assembly, MassProperties, Solid, SolidPart};
pub use math::{Block, BlockImpulse, Mat3, Pose, Quat, SymBlock, SymMat3, UnitVec3, Vec3};
pub use query::{Ray, RayHit, SurfacePoint};
#[cfg(feature = "fixed")]
pub use scalar::Scaled32;
pub use scalar::{Column, Scalar, Scaled, StepArithmetic, Velocity, Weights};
pub use shape::{
    Capsule, Closest, Collide, Compound, ConvexHull, Cuboid, HalfSpace, HeightField, MAX_CORNERS, MAX_FACE_CORNERS,
    ManifoldSink, Member, OutlineSink, Part, Shape, Sphere,
};
pub use world::{BodyHandle, World};

// The examples of the README and of the guide compile and run.
#[cfg(all(doctest, feature = "f32"))]
mod pages {
    #[doc = include_str!("../README.md")]
    mod readme {}
    #[doc = include_str!("../docs/guide/impulse.md")]
    mod impulse {}
    #[doc = include_str!("../docs/guide/solver.md")]
    mod solver {}
    #[doc = include_str!("../docs/guide/world.md")]
    mod world {}
    #[doc = include_str!("../docs/guide/format.md")]
    mod format {}
}
