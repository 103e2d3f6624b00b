//! A world on a display: its shapes as drawables of `embedded-graphics`, on any draw target.
//!
//! A [`View`] is what a [`Camera`] sees; it makes drawables of [lines](View::line), [faces](View::face), [shapes](View::shape) and
//! [worlds](View::world), in a [`Style`] of your own colours:
//!
//! ```
//! # #[cfg(feature = "f32")]
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! use carom::interop::embedded_graphics::{Camera, Lens, Style, View};
//! use carom::{Body, Cuboid, HalfSpace, Material, Solid, UnitVec3, Vec3, World};
//! use embedded_graphics_core::{Drawable, geometry::Size, pixelcolor::Rgb565, prelude::WebColors};
//!
//! carom::shapes! { enum Piece<S> { Cuboid, HalfSpace } }
//! let mut world = World::<f32, Piece<f32>, 2, 4, 8>::new();
//! world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), Material::DEAD)?;
//! let half = Vec3::new(0.1, 0.1, 0.1);
//! let body = Body::dynamic(Solid::cuboid(half)?.with_mass(1.0)?).at(Vec3::new(0.0, 0.0, 0.1));
//! let die = world.insert(body, Cuboid::new(half)?, Material::DEAD)?;
//!
//! let camera = Camera {
//!     eye: Vec3::new(0.3, -0.8, 0.6),
//!     target: Vec3::ZERO,
//!     up: UnitVec3::Z,
//!     lens: Lens::Perspective(0.4),
//! };
//! let view = View::new(Size::new(240, 240), &camera)?.with_grid(0.1, 5);
//! let style = |handle, _: &Body<f32>| {
//!     if handle == die {
//!         Style::solid(Rgb565::CSS_WHITE, Rgb565::CSS_DARK_RED) // edges, and faces that hide what is behind
//!     } else {
//!         Style::wireframe(Rgb565::CSS_GRAY)
//!     }
//! };
//! # let mut display = Display(0);
//! view.world(&world, style).draw(&mut display)?;
//! # assert!(display.0 > 1000);
//! # Ok(())
//! # }
//! # #[cfg(not(feature = "f32"))]
//! # fn main() {}
//! # struct Display(u32);
//! # impl embedded_graphics_core::geometry::OriginDimensions for Display {
//! #     fn size(&self) -> embedded_graphics_core::geometry::Size {
//! #         embedded_graphics_core::geometry::Size::new(240, 240)
//! #     }
//! # }
//! # impl embedded_graphics_core::draw_target::DrawTarget for Display {
//! #     type Color = embedded_graphics_core::pixelcolor::Rgb565;
//! #     type Error = std::convert::Infallible;
//! #     fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Self::Error>
//! #     where
//! #         I: IntoIterator<Item = embedded_graphics_core::Pixel<Self::Color>>,
//! #     {
//! #         self.0 += pixels.into_iter().count() as u32;
//! #         Ok(())
//! #     }
//! # }
//! ```
//!
//! Points are brought to the display in the world's number type, lines and faces drawn from there on in integers, so that every
//! machine draws the same pixels. Lines are cut to what is seen before anything is divided by a distance; nothing is drawn, or
//! counted through, that is not on the draw target.
//!
//! A display need not fit the memory: a target that is a band of it (its bounding box says which) gets the pixels of that band, the
//! same as in one piece. `examples/drawing.rs` draws so in 16 KB, of which a face takes some 3 KB of stack. Each band costs anew what
//! it costs to bring all points to the display: a division for each of them.
//!
//! Of convex shapes the faces that look away are left out. Faces that are filled hide what was drawn before, and a world is drawn
//! [back to front](View::back_to_front), by the positions of its bodies: right for bodies of about one size, and wrong now and then
//! where a small one lies beside a large one. Balls and capsules are outlines; height fields lines from sample to sample, and
//! planes a [grid](View::with_grid), through which one sees.
//!
//! With `fixed` 1.30 or later cargo takes `embedded-graphics` 0.8.1 and its core 0.4.0: the releases after them refuse the `az` that
//! `fixed` asks for.

mod clip;
mod drawables;
mod order;
mod paint;
mod raster;
mod round;
mod view;

pub use self::drawables::{Face, Line, ShapeView, WorldView};
pub use self::paint::Style;
pub use self::view::{Camera, Lens, View};
pub use crate::error::ViewError;
