//! Pixels of lines and of convex rings, in integers. What is drawn in a window is what would be drawn there without one, so that
//! bands put together make the same picture.

use core::ops::Range;

use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_graphics_core::primitives::Rectangle;
use heapless::Vec;

use super::clip::CORNERS;

/// Places are counted in sixteenths of a pixel.
pub(super) const SIXTEENTHS: u32 = 4;
/// From the border of a pixel to its middle.
pub(super) const MIDDLE: i32 = 1 << (SIXTEENTHS - 1);

/// A place on the display, across and down.
pub(super) type Spot = [i32; 2];

/// The pixels that may be drawn: those of the target, without what lies beside the display.
#[derive(Clone, Debug)]
pub(super) struct Window {
    columns: Range<i32>,
    rows: Range<i32>,
}

impl Window {
    pub fn new(target: &Rectangle, display: Size) -> Self {
        let both = |start: i32, length: u32, side: u32| {
            let end = start.saturating_add_unsigned(length);
            start.max(0)..end.min(i32::try_from(side).unwrap_or(i32::MAX))
        };
        let (Point { x, y }, Size { width, height }) = (target.top_left, target.size);
        Self { columns: both(x, width, display.width), rows: both(y, height, display.height) }
    }
}

/// Draws a line: in each column the pixel that it meets in the middle, or in each row, if it is steep. Both directions give the
/// same pixels.
pub(super) fn line<D: DrawTarget>(
    target: &mut D,
    window: &Window,
    [a, b]: [Spot; 2],
    color: D::Color,
) -> Result<(), D::Error> {
    let steep = a[1].abs_diff(b[1]) > a[0].abs_diff(b[0]);
    let [a, b] = if steep { [[a[1], a[0]], [b[1], b[0]]] } else { [a, b] };
    let [from, to] = if a <= b { [a, b] } else { [b, a] };
    let (long, short) = if steep { (&window.rows, &window.columns) } else { (&window.columns, &window.rows) };
    let first = (from[0] >> SIXTEENTHS).max(long.start);
    let end = (to[0] >> SIXTEENTHS).wrapping_add(1).min(long.end);
    // The middle of the last pixel may lie beyond the end of the line, at most one pixel farther aside.
    let lowest = (from[1].min(to[1]) >> SIXTEENTHS).wrapping_sub(1);
    let highest = (from[1].max(to[1]) >> SIXTEENTHS).wrapping_add(1);
    if first >= end || highest < short.start || lowest >= short.end {
        return Ok(());
    }
    let slope = Slope::new(to[1].wrapping_sub(from[1]), to[0].wrapping_sub(from[0]));
    let middle = (first << SIXTEENTHS).wrapping_add(MIDDLE);
    let at = (from[1] << Slope::PLACES).wrapping_add(slope.over(middle.wrapping_sub(from[0])));
    target.draw_iter(Line { steep, next: first, end, at, slope, short: short.clone(), color })
}

/// How far a line goes aside on its way, in 2^-14.
#[derive(Clone, Copy)]
struct Slope(i32);

impl Slope {
    const PLACES: u32 = 14;

    /// For no more aside than ahead, and both below 2^16; zero of a point.
    fn new(aside: i32, ahead: i32) -> Self {
        Self((aside << Self::PLACES).checked_div(ahead).unwrap_or(0))
    }

    fn over(self, way: i32) -> i32 {
        self.0.wrapping_mul(way)
    }
}

/// The pixels of a line.
struct Line<C> {
    steep: bool,
    /// The next one along the line, and where it ends.
    next: i32,
    end: i32,
    /// The place across, in 2^-14.
    at: i32,
    slope: Slope,
    short: Range<i32>,
    color: C,
}

impl<C: PixelColor> Iterator for Line<C> {
    type Item = Pixel<C>;

    fn next(&mut self) -> Option<Pixel<C>> {
        while self.next < self.end {
            let (along, across) = (self.next, self.at >> (Slope::PLACES + SIXTEENTHS));
            self.next = along.wrapping_add(1);
            self.at = self.at.wrapping_add(self.slope.over(1 << SIXTEENTHS));
            if self.short.contains(&across) {
                let [x, y] = if self.steep { [across, along] } else { [along, across] };
                return Some(Pixel(Point::new(x, y), self.color));
            }
        }
        None
    }
}

/// A side of a ring, from its upper end to its lower one.
struct Side {
    from: Spot,
    bottom: i32,
    /// Across for one down, in 2^-15.
    slope: i32,
}

impl Side {
    const PLACES: u32 = 15;

    /// None of one that crosses no row.
    fn new([a, b]: [Spot; 2]) -> Option<Self> {
        let [from, to] = if a[1] < b[1] { [a, b] } else { [b, a] };
        let slope = (to[0].wrapping_sub(from[0]) << Self::PLACES).checked_div(to[1].wrapping_sub(from[1]))?;
        Some(Self { from, bottom: to[1], slope })
    }

    /// Where it crosses a height.
    fn at(&self, height: i32) -> Option<i32> {
        let down = height.wrapping_sub(self.from[1]);
        let across = i64::from(self.slope).wrapping_mul(i64::from(down)) >> Self::PLACES;
        (down >= 0 && height < self.bottom).then_some(self.from[0].wrapping_add(across as i32))
    }
}

/// Fills a convex ring: the pixels whose middle is in it. Rings that share a side share no pixel and leave none out.
pub(super) fn fill<D: DrawTarget>(
    target: &mut D,
    window: &Window,
    ring: &[Spot],
    color: D::Color,
) -> Result<(), D::Error> {
    let mut sides = Vec::<Side, CORNERS>::new();
    let (mut top, mut bottom) = (i32::MAX, i32::MIN);
    for side in neighbours(ring).filter_map(Side::new) {
        (top, bottom) = (top.min(side.from[1]), bottom.max(side.bottom));
        // As many as corners.
        let _ = sides.push(side);
    }
    if sides.is_empty() {
        return Ok(());
    }
    let rows = pixel_from(top).max(window.rows.start)..pixel_from(bottom).min(window.rows.end);
    for row in rows {
        let height = (row << SIXTEENTHS).wrapping_add(MIDDLE);
        let (mut left, mut right) = (i32::MAX, i32::MIN);
        for across in sides.iter().filter_map(|side| side.at(height)) {
            (left, right) = (left.min(across), right.max(across));
        }
        let start = pixel_from(left).max(window.columns.start);
        let end = pixel_from(right).min(window.columns.end);
        if start < end {
            let length = end.abs_diff(start);
            target.fill_solid(&Rectangle::new(Point::new(start, row), Size::new(length, 1)), color)?;
        }
    }
    Ok(())
}

/// The first pixel whose middle is not before a place.
const fn pixel_from(at: i32) -> i32 {
    at.saturating_add(MIDDLE - 1) >> SIXTEENTHS
}

/// The sides of a ring.
pub(super) fn neighbours(ring: &[Spot]) -> impl Iterator<Item = [Spot; 2]> {
    let before = ring.last().into_iter().chain(ring);
    before.zip(ring).map(|(a, b)| [*a, *b])
}

/// Whether a ring goes round counter-clockwise as one sees it: y points down.
pub(super) fn is_counter_clockwise(ring: &[Spot]) -> bool {
    let [x, y] = ring.first().copied().unwrap_or_default();
    // Counted from a corner, so that products stay within 34 bits.
    let area = neighbours(ring).fold(0i64, |area, sides| {
        let [[a, b], [c, d]] = sides.map(|[at, down]| [at.wrapping_sub(x), down.wrapping_sub(y)].map(i64::from));
        area.wrapping_add(a.wrapping_mul(d)).wrapping_sub(b.wrapping_mul(c))
    });
    area < 0
}
