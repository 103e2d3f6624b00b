//! Drawing what shapes tell of themselves.

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::pixelcolor::PixelColor;
use heapless::Vec;

use super::clip::{CORNERS, Ring};
use super::raster::{self, Spot, Window};
use super::view::View;
use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;
use crate::shape::OutlineSink;

/// The colours of edges and faces; what has none is not drawn. Faces in the colour of the background hide what is behind them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style<C> {
    /// Of edges, and of the outline of what is round.
    pub stroke_color: Option<C>,
    /// Of faces.
    pub fill_color: Option<C>,
}

impl<C> Style<C> {
    /// Edges alone: of convex shapes those of the faces that look this way.
    pub const fn wireframe(color: C) -> Self {
        Self { stroke_color: Some(color), fill_color: None }
    }

    /// Faces alone.
    pub const fn filled(color: C) -> Self {
        Self { stroke_color: None, fill_color: Some(color) }
    }

    /// Faces with edges.
    pub const fn solid(stroke: C, fill: C) -> Self {
        Self { stroke_color: Some(stroke), fill_color: Some(fill) }
    }
}

/// Draws outlines in a style, until the target fails.
pub(super) struct Painter<'a, S: Scalar, D: DrawTarget> {
    view: &'a View<S>,
    target: &'a mut D,
    window: Window,
    style: Style<D::Color>,
    pub outcome: Result<(), D::Error>,
}

impl<'a, S: Scalar, C: PixelColor, D: DrawTarget<Color = C>> Painter<'a, S, D> {
    pub fn new(view: &'a View<S>, target: &'a mut D, style: Style<C>) -> Self {
        let window = Window::new(&target.bounding_box(), view.size());
        Self { view, target, window, style, outcome: Ok(()) }
    }

    /// A ring, unless it has to go round counter-clockwise and does not.
    fn ring(&mut self, ring: &mut Ring<S>, one_sided: bool) {
        self.view.cut_ring(ring);
        let mut spots = Vec::<Spot, CORNERS>::new();
        for seen in ring.iter() {
            // As many as there is room for in a ring.
            let _ = spots.push(self.view.spot(seen));
        }
        if self.outcome.is_ok() && (!one_sided || raster::is_counter_clockwise(&spots)) {
            self.outcome = self.draw(&spots);
        }
    }

    fn draw(&mut self, spots: &[Spot]) -> Result<(), D::Error> {
        if let Some(color) = self.style.fill_color {
            raster::fill(self.target, &self.window, spots, color)?;
        }
        if let Some(color) = self.style.stroke_color {
            for ends in raster::neighbours(spots) {
                raster::line(self.target, &self.window, ends, color)?;
            }
        }
        Ok(())
    }
}

impl<S: Scalar, C: PixelColor, D: DrawTarget<Color = C>> OutlineSink<S> for Painter<'_, S, D> {
    fn face(&mut self, corners: &[Vec3<S>]) {
        let mut ring = Ring::<S>::new();
        for &corner in corners.iter().take(crate::MAX_FACE_CORNERS) {
            // There is room for more than that.
            let _ = ring.push(self.view.seen(corner));
        }
        self.ring(&mut ring, true);
    }

    fn segment(&mut self, ends: [Vec3<S>; 2]) {
        let Some(color) = self.style.stroke_color else { return };
        let Some(ends) = self.view.cut_line(ends.map(|end| self.view.seen(end))) else { return };
        if self.outcome.is_ok() {
            self.outcome = raster::line(self.target, &self.window, ends.map(|end| self.view.spot(&end)), color);
        }
    }

    fn rod(&mut self, ends: [Vec3<S>; 2], radius: S) {
        self.ring(&mut self.view.edge(ends, radius), false);
    }

    fn plane(&mut self, point: Vec3<S>, normal: UnitVec3<S>) {
        let Some((spacing, lines)) = self.view.grid else { return };
        let (first, second) = normal.tangents();
        let lines = i32::from(lines);
        for [along, across] in [[first, second], [second, first]] {
            let at = |direction: UnitVec3<S>, number| Vec3::of_length(spacing.times_integer(number), direction.get());
            let end = at(along, lines);
            for number in lines.wrapping_neg()..=lines {
                let middle = point + at(across, number);
                self.segment([middle - end, middle + end]);
            }
        }
    }
}
