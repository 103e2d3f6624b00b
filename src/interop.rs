//! carom beside other crates: what the features `mint`, `serde`, `bytemuck`, `defmt`, `arbitrary` and `embedded-graphics` add.
//!
//! Each is an optional dependency without its default features, and adds implementations of that crate's traits to the public
//! types; no type or function of carom changes. None of them costs a firmware anything that it does not use.
//!
//! | feature | adds | for |
//! |---|---|---|
//! | `mint` | `From` and `TryFrom` between [`Vec3`](crate::Vec3), [`UnitVec3`](crate::UnitVec3), [`Quat`](crate::Quat), [`Mat3`](crate::Mat3) and mint's types | glam, nalgebra, cgmath and others |
//! | `serde` | `Serialize`, `Deserialize` | files, links between machines |
//! | `bytemuck` | `Pod`, or `NoUninit` and `CheckedBitPattern` | bytes in flash, over a radio, in memory that is shared |
//! | `defmt` | `Format` | logs of firmware |
//! | `arbitrary` | `Arbitrary` | fuzzers, on the host: that crate needs `std` |
//! | `embedded-graphics` | views of worlds and shapes, as `Drawable` | displays |
//!
//! # mint
//!
//! In any number type. What carom keeps normalised comes in through `TryFrom`, with the error of its constructor: a quaternion or
//! direction whose square is off by more than 2^-16 is refused. Normalise it first (`Quat::normalize`, `UnitVec3::normalize`).
//! Fixed point has components of directions in Q2.30 ([`Scalar::Unit`](crate::Scalar::Unit)), so has the mint type then.
//!
//! # serde
//!
//! Values: vectors, directions, orientations, tensors, poses, boxes, materials, contacts, solids, mass properties, bodies, spheres,
//! cuboids, capsules, half-spaces, handles, filters, and what a step and an impulse report. Numbers go as the number type's own
//! implementation writes them: f32 and f64 as floats, fixed point as `{"bits": n}`. `micromath::F32` has none.
//!
//! What goes out comes back bit for bit, a body with all that it carries beyond its format. What comes in passes the checks of the
//! constructors, so that no file makes a direction that is not of unit length or a body of negative mass; a body that is not finite
//! is refused, too. JSON has no infinities, and keeps every bit of a float where the reader rounds right (`float_roundtrip` of
//! `serde_json`).
//!
//! Shapes that borrow (hulls by reference, height fields, compounds) are not values. A set made by [`shapes!`](crate::shapes) takes
//! the derives like any enum, with a bound that names the numbers in it. A [`World`](crate::World) is kept by
//! [`copy_from`](crate::World::copy_from).
//!
//! # bytemuck
//!
//! Values in place, without a format: vectors and matrices are plain data, directions, orientations and bodies go out as bytes and come
//! back through `bytemuck::checked`, which refuses what no constructor makes. A slice of bodies is a snapshot: in f32 140 bytes each, in
//! fixed point 156, in the byte order of the machine and the layout of this version of carom. What comes back goes on with the same bits. `micromath::F32` has none.
//!
//! ```
//! # #[cfg(all(feature = "bytemuck", feature = "f32"))]
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! use bytemuck::checked::try_pod_read_unaligned;
//! use carom::{Body, Solid, Vec3};
//!
//! const SIZE: usize = size_of::<Body<f32>>();
//! let mass = Solid::sphere(0.02_f32)?.with_mass(0.03)?;
//! let bodies = [Body::dynamic(mass).at(Vec3::new(0.0, 0.0, 1.0)), Body::immovable()];
//! let mut flash = [0; 2 * SIZE];
//! flash.copy_from_slice(bytemuck::cast_slice(&bodies));
//!
//! let kept = |at: usize| try_pod_read_unaligned::<Body<f32>>(&flash[at * SIZE..][..SIZE]);
//! assert_eq!([kept(0), kept(1)], bodies.map(Ok));
//! flash[..4].fill(0xff); // a position that is no number
//! assert!(try_pod_read_unaligned::<Body<f32>>(&flash[..SIZE]).is_err());
//! # Ok(())
//! # }
//! # #[cfg(not(all(feature = "bytemuck", feature = "f32")))]
//! # fn main() {}
//! ```
//!
//! # defmt
//!
//! Public values and errors. Fixed-point numbers are sent as the bits of an `f64`, put together from integers: exact to 30 bits,
//! without one float routine on the device. Errors print their text, which stays in the ELF file.
//!
//! # arbitrary
//!
//! Any value that safe code could make: vectors with any bits in them, NaN included; directions, orientations, materials, shapes and
//! bodies as their constructors would give them.
//!
//! # embedded-graphics
//!
//! Worlds, shapes, lines and faces as a camera sees them, on any `DrawTarget`, whole or band by band:
#![cfg_attr(feature = "embedded-graphics", doc = "[`embedded_graphics`].")]
#![cfg_attr(not(feature = "embedded-graphics"), doc = "the module `embedded_graphics`.")]

#[cfg(feature = "arbitrary")]
#[cfg_attr(docsrs, doc(cfg(feature = "arbitrary")))]
mod arbitrary;
#[cfg(feature = "bytemuck")]
#[cfg_attr(docsrs, doc(cfg(feature = "bytemuck")))]
mod bytemuck;
#[cfg(feature = "defmt")]
#[cfg_attr(docsrs, doc(cfg(feature = "defmt")))]
mod defmt;
#[cfg(feature = "embedded-graphics")]
#[cfg_attr(docsrs, doc(cfg(feature = "embedded-graphics")))]
pub mod embedded_graphics;
#[cfg(feature = "mint")]
#[cfg_attr(docsrs, doc(cfg(feature = "mint")))]
mod mint;
#[cfg(feature = "serde")]
#[cfg_attr(docsrs, doc(cfg(feature = "serde")))]
mod serde;
#[cfg(any(feature = "serde", all(feature = "bytemuck", any(feature = "f32", feature = "f64", feature = "fixed"))))]
mod sound;
