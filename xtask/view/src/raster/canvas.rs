//! A picture with a depth at each point, and triangles on it.

use super::vector::{Vector, mix};

/// Several points to a pixel; [`Canvas::pixels`] brings them together.
pub struct Canvas {
    pub width: usize,
    pub height: usize,
    /// Red, green, blue, 0 to 1.
    pub colours: Vec<Vector>,
    /// One over the distance; nothing is at zero.
    pub depths: Vec<f32>,
}

/// A corner as the canvas has it: across, down, and one over the distance; with what is to be mixed between corners.
#[derive(Clone, Copy)]
pub struct Corner {
    pub x: f32,
    pub y: f32,
    pub near: f32,
    pub world: Vector,
    pub normal: Vector,
}

impl Canvas {
    pub fn new(width: usize, height: usize, colour: Vector) -> Self {
        Self { width, height, colours: vec![colour; width * height], depths: vec![0.0; width * height] }
    }

    /// Calls `put` with the place in the buffers, the depth and the parts of the corners, for each point in the triangle.
    pub fn cover(&self, corners: [&Corner; 3], mut put: impl FnMut(usize, f32, [f32; 3])) {
        let [a, b, c] = corners;
        let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if area == 0.0 {
            return;
        }
        let bound = |low: f32, high: f32, end: usize| {
            (low.floor().max(0.0) as usize, high.ceil().clamp(0.0, end as f32) as usize)
        };
        let (left, right) = bound(a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x), self.width);
        let (top, bottom) = bound(a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y), self.height);
        for row in top..bottom {
            let y = row as f32 + 0.5;
            for column in left..right {
                let x = column as f32 + 0.5;
                let part_b = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
                let part_c = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
                let part_a = 1.0 - part_b - part_c;
                if part_a < 0.0 || part_b < 0.0 || part_c < 0.0 {
                    continue;
                }
                let near = part_a * a.near + part_b * b.near + part_c * c.near;
                // What lies between corners in space is mixed by distance.
                let parts = [part_a * a.near / near, part_b * b.near / near, part_c * c.near / near];
                put(row * self.width + column, near, parts);
            }
        }
    }

    /// One pixel for each square of `fine` by `fine` points.
    pub fn pixels(&self, fine: usize) -> Vec<[u8; 3]> {
        let (width, height) = (self.width / fine, self.height / fine);
        let mut pixels = Vec::with_capacity(width * height);
        for row in 0..height {
            for column in 0..width {
                let mut sum = [0.0; 3];
                for point in 0..fine * fine {
                    let at = (row * fine + point / fine) * self.width + column * fine + point % fine;
                    sum = std::array::from_fn(|part| sum[part] + self.colours[at][part]);
                }
                pixels.push(sum.map(|part| (part / (fine * fine) as f32 * 255.0 + 0.5).clamp(0.0, 255.0) as u8));
            }
        }
        pixels
    }

    /// Mixes a colour in.
    pub fn blend(&mut self, at: usize, colour: Vector, alpha: f32) {
        self.colours[at] = mix(self.colours[at], colour, alpha);
    }
}
