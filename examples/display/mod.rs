//! A display of 240 x 240 pixels in RGB565, drawn band by band: a frame takes 115,200 bytes, which small parts do not have.

pub mod dice;
pub mod way;

use core::convert::Infallible;

use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics_core::primitives::Rectangle;

/// Pixels of the display, across and down.
pub const SIDE: usize = 240;
/// Pixels that are drawn for one that is shown, across and down: edges are smooth.
const FINE: usize = 2;
/// What is drawn, across and down.
pub const FINE_SIDE: usize = SIDE * FINE;
/// Rows of the display in a band.
const ROWS: usize = 1;

/// Some rows of the display.
pub struct Band {
    top: usize,
    pixels: [[Rgb565; FINE_SIDE]; ROWS * FINE],
}

impl Band {
    pub const fn new() -> Self {
        Self { top: 0, pixels: [[Rgb565::BLACK; FINE_SIDE]; ROWS * FINE] }
    }

    /// Draws the display band by band, and hands on its rows as bytes: of each pixel the upper one first, as displays take them.
    pub fn draw_all(&mut self, mut draw: impl FnMut(&mut Self), mut show: impl FnMut(&[u8])) {
        for band in 0..SIDE / ROWS {
            self.top = band.wrapping_mul(ROWS * FINE);
            draw(self);
            for rows in self.pixels.chunks_exact(FINE) {
                for column in 0..SIDE {
                    show(&mean(rows, column.wrapping_mul(FINE)).to_be_bytes());
                }
            }
        }
    }
}

/// A pixel of the display, from those drawn for it.
fn mean(rows: &[[Rgb565; FINE_SIDE]], from: usize) -> u16 {
    const COUNT: u16 = (FINE * FINE) as u16;
    let fine = || rows.iter().flat_map(|row| row.iter().skip(from).take(FINE));
    let mean = |part: fn(&Rgb565) -> u8| {
        let sum = fine().fold(COUNT / 2, |sum, pixel| sum.wrapping_add(u16::from(part(pixel))));
        sum / COUNT
    };
    mean(Rgb565::r) << 11 | mean(Rgb565::g) << 5 | mean(Rgb565::b)
}

impl Dimensions for Band {
    fn bounding_box(&self) -> Rectangle {
        let size = Size::new(FINE_SIDE as u32, (ROWS * FINE) as u32);
        Rectangle::new(Point::new(0, self.top as i32), size)
    }
}

impl DrawTarget for Band {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(Point { x, y }, color) in pixels {
            let row = self.pixels.get_mut((y as usize).wrapping_sub(self.top));
            if let Some(pixel) = row.and_then(|row| row.get_mut(x as usize)) {
                *pixel = color;
            }
        }
        Ok(())
    }
}
