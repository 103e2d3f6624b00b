//! A display in memory, which looks at what it is given.

use std::convert::Infallible;

use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::pixelcolor::Gray8;
use embedded_graphics_core::primitives::Rectangle;

pub const INK: Gray8 = Gray8::new(255);
pub const OTHER: Gray8 = Gray8::new(100);
const PAPER: Gray8 = Gray8::new(0);

/// A square display, or a window of one.
pub struct Display {
    side: usize,
    pub window: Rectangle,
    /// All of the display, row by row.
    pub pixels: Vec<Gray8>,
}

impl Display {
    pub fn new(side: u32) -> Self {
        Self::window(side, Rectangle::new(Point::zero(), Size::new_equal(side)))
    }

    pub fn window(side: u32, window: Rectangle) -> Self {
        let side = side as usize;
        Self { side, window, pixels: vec![PAPER; side * side] }
    }

    pub fn is_inked(&self, column: usize, row: usize) -> bool {
        self.pixels[row * self.side + column] != PAPER
    }

    pub fn inked(&self) -> impl Iterator<Item = [usize; 2]> {
        let inked = self.pixels.iter().enumerate().filter(|(_, pixel)| **pixel != PAPER);
        inked.map(|(at, _)| [at % self.side, at / self.side])
    }
}

impl Dimensions for Display {
    fn bounding_box(&self) -> Rectangle {
        self.window
    }
}

impl DrawTarget for Display {
    type Color = Gray8;
    type Error = Infallible;

    /// # Panics
    /// Where a pixel is beside the window, or beside the display.
    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, color) in pixels {
            assert!(self.window.contains(at), "{at:?} is not in {:?}", self.window);
            let [column, row] = [at.x, at.y].map(|at| usize::try_from(at).expect("on the display"));
            assert!(column < self.side && row < self.side, "{at:?} is beside the display");
            self.pixels[row * self.side + column] = color;
        }
        Ok(())
    }
}
