//! What can be drawn: a line, a face, a shape, a world.

use embedded_graphics_core::Drawable;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::pixelcolor::PixelColor;

use super::paint::{Painter, Style};
use super::view::View;
use crate::body::Body;
use crate::math::{Pose, Vec3};
use crate::scalar::Scalar;
use crate::shape::{OutlineSink, Shape};
use crate::world::{BodyHandle, World};

impl<S: Scalar> View<S> {
    /// A line in the world.
    pub const fn line<C>(&self, ends: [Vec3<S>; 2], color: C) -> Line<'_, S, C> {
        Line { view: self, ends, color }
    }

    /// A flat convex face in the world, drawn where it is seen from the side from which its corners go round counter-clockwise.
    /// Corners beyond [`MAX_FACE_CORNERS`](crate::MAX_FACE_CORNERS) are left out.
    pub const fn face<'a, C>(&'a self, corners: &'a [Vec3<S>], style: Style<C>) -> Face<'a, S, C> {
        Face { view: self, corners, style }
    }

    /// A shape in that pose: of a body, `Pose::new(body.position, body.orientation())`.
    pub const fn shape<'a, Sh, C>(
        &'a self,
        shape: &'a Sh,
        pose: &'a Pose<S>,
        style: Style<C>,
    ) -> ShapeView<'a, S, Sh, C> {
        ShapeView { view: self, shape, pose, style }
    }

    /// All bodies of a world, [back to front](Self::back_to_front), each in the style that the function gives it.
    pub const fn world<'a, Sh, F, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>(
        &'a self,
        world: &'a World<S, Sh, BODIES, MANIFOLDS, POINTS>,
        style: F,
    ) -> WorldView<'a, S, Sh, F, BODIES, MANIFOLDS, POINTS> {
        WorldView { view: self, world, style }
    }
}

/// A line in the world; see [`View::line`].
#[derive(Clone, Copy, Debug)]
pub struct Line<'a, S: Scalar, C> {
    view: &'a View<S>,
    ends: [Vec3<S>; 2],
    color: C,
}

/// A face in the world; see [`View::face`].
#[derive(Clone, Copy, Debug)]
pub struct Face<'a, S: Scalar, C> {
    view: &'a View<S>,
    corners: &'a [Vec3<S>],
    style: Style<C>,
}

/// A shape in the world; see [`View::shape`].
#[derive(Clone, Copy, Debug)]
pub struct ShapeView<'a, S: Scalar, Sh, C> {
    view: &'a View<S>,
    shape: &'a Sh,
    pose: &'a Pose<S>,
    style: Style<C>,
}

/// All bodies of a world; see [`View::world`].
#[derive(Clone, Copy, Debug)]
pub struct WorldView<'a, S: Scalar, Sh, F, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize> {
    view: &'a View<S>,
    world: &'a World<S, Sh, BODIES, MANIFOLDS, POINTS>,
    style: F,
}

impl<S: Scalar, C: PixelColor> Drawable for Line<'_, S, C> {
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        let mut painter = Painter::new(self.view, target, Style::wireframe(self.color));
        painter.segment(self.ends);
        painter.outcome
    }
}

impl<S: Scalar, C: PixelColor> Drawable for Face<'_, S, C> {
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        let mut painter = Painter::new(self.view, target, self.style);
        painter.face(self.corners);
        painter.outcome
    }
}

impl<S: Scalar, Sh: Shape<S>, C: PixelColor> Drawable for ShapeView<'_, S, Sh, C> {
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        let mut painter = Painter::new(self.view, target, self.style);
        self.shape.outline(self.pose, &mut painter);
        painter.outcome
    }
}

impl<S, Sh, C, F, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize> Drawable
    for WorldView<'_, S, Sh, F, BODIES, MANIFOLDS, POINTS>
where
    S: Scalar,
    Sh: Shape<S>,
    C: PixelColor,
    F: Fn(BodyHandle, &Body<S>) -> Style<C>,
{
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        for (handle, body, shape) in self.view.back_to_front(self.world) {
            let pose = Pose::new(body.position, body.orientation());
            self.view.shape(shape, &pose, (self.style)(handle, body)).draw(target)?;
        }
        Ok(())
    }
}
