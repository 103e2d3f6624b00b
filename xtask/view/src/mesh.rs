//! Solids as triangles, for the page and for pictures alike.

use crate::algebra::{add, direction, scale};
use crate::trace::{Look, Shape};
use serde::Serialize;

/// What a corner is painted with.
pub mod paint {
    /// The colour of the body.
    pub const OWN: u8 = 0;
    /// The pips of a die.
    pub const DARK: u8 = 1;
    /// The band of a ball, which shows how it rolls.
    pub const LIGHT: u8 = 2;
}

/// Triangles, anticlockwise seen from outside. In metres; three numbers to a point.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Mesh {
    pub points: Vec<f32>,
    pub normals: Vec<f32>,
    pub paints: Vec<u8>,
    pub triangles: Vec<u16>,
}

/// Rounded so that it is short in the page: to micrometres, or a millionth.
pub fn tidy(x: f64) -> f32 {
    ((x * 1e6).round() / 1e6) as f32
}

impl Mesh {
    fn corner(&mut self, point: [f64; 3], normal: [f64; 3], paint: u8) -> u16 {
        self.points.extend(point.map(tidy));
        self.normals.extend(normal.map(tidy));
        self.paints.push(paint);
        (self.paints.len() - 1) as u16
    }

    /// A sheet of corners, rows by columns, that looks to where rows cross columns.
    fn sheet(&mut self, rows: usize, columns: usize, corner: impl Fn(usize, usize) -> ([f64; 3], [f64; 3], u8)) {
        let first = self.paints.len() as u16;
        for row in 0..rows {
            for column in 0..columns {
                let (point, normal, paint) = corner(row, column);
                self.corner(point, normal, paint);
            }
        }
        for row in 0..rows - 1 {
            for column in 0..columns - 1 {
                let at = first + (row * columns + column) as u16;
                let below = at + columns as u16;
                self.triangles.extend([at, below, below + 1, at, below + 1, at + 1]);
            }
        }
    }

    /// The mesh of a body; `None` of one without an end.
    pub fn of(shape: &Shape, look: Look, unit: f64) -> Option<Self> {
        let mut mesh = Self::default();
        match *shape {
            Shape::HalfSpace { .. } => return None,
            Shape::Sphere { radius } => mesh.rod(radius * unit, 0.0, look != Look::Sensor),
            Shape::Capsule { radius, half_length } => mesh.rod(radius * unit, half_length * unit, false),
            Shape::Cuboid { half } => {
                let half = half.map(|part| part * unit);
                mesh.cuboid(half);
                if look == Look::Die {
                    mesh.pips(half);
                }
            }
        }
        Some(mesh)
    }

    /// A ball, or two half balls with a cylinder between them along z.
    fn rod(&mut self, radius: f64, half_length: f64, banded: bool) {
        const BANDS: usize = 18;
        const COLUMNS: usize = 29;
        for band in 0..BANDS {
            let paint = if banded && (7..11).contains(&band) { paint::LIGHT } else { paint::OWN };
            self.sheet(2, COLUMNS, |row, column| {
                let polar = std::f64::consts::PI * (band + row) as f64 / BANDS as f64;
                let around = std::f64::consts::TAU * column as f64 / (COLUMNS - 1) as f64;
                let normal = [polar.sin() * around.cos(), polar.sin() * around.sin(), polar.cos()];
                // The ring in the middle belongs to both halves.
                let upper = 2 * band + 1 < BANDS;
                let shift = if upper { half_length } else { -half_length };
                (add(scale(normal, radius), [0.0, 0.0, shift]), normal, paint)
            });
        }
        if half_length > 0.0 {
            self.sheet(2, COLUMNS, |row, column| {
                let around = std::f64::consts::TAU * column as f64 / (COLUMNS - 1) as f64;
                let normal = [around.cos(), around.sin(), 0.0];
                let shift = if row == 0 { half_length } else { -half_length };
                (add(scale(normal, radius), [0.0, 0.0, shift]), normal, paint::OWN)
            });
        }
    }

    /// A box whose edges are a little round, so that they catch the light.
    fn cuboid(&mut self, half: [f64; 3]) {
        const ANGLES: [(f64, f64); 6] =
            [(-1.0, -1.0), (-1.0, -0.414), (-1.0, 0.0), (1.0, 0.0), (1.0, 0.414), (1.0, 1.0)];
        let round = 0.07 * half[0].min(half[1]).min(half[2]);
        for (axis, sign) in faces() {
            self.sheet(6, 6, |row, column| {
                // Rows cross columns outwards on both sides of the box.
                let (row, column) = if sign > 0.0 { (row, column) } else { (column, row) };
                let ((side_u, u), (side_v, v)) = (ANGLES[row], ANGLES[column]);
                let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
                let (mut inner, mut normal) = ([0.0; 3], [0.0; 3]);
                (inner[axis], inner[first], inner[second]) =
                    (sign * (half[axis] - round), side_u * (half[first] - round), side_v * (half[second] - round));
                (normal[axis], normal[first], normal[second]) = (sign, u, v);
                let normal = direction(normal);
                (add(inner, scale(normal, round)), normal, paint::OWN)
            });
        }
    }

    /// Those of a die, a hair above its faces.
    fn pips(&mut self, half: [f64; 3]) {
        for (axis, sign) in faces() {
            let face = if sign > 0.0 { axis + 1 } else { 6 - axis };
            let mut normal = [0.0; 3];
            normal[axis] = sign;
            let (mut u, mut v) = ([0.0; 3], [0.0; 3]);
            (u[(axis + 1) % 3], v[(axis + 2) % 3]) = (half[(axis + 1) % 3], half[(axis + 2) % 3]);
            let v = if sign > 0.0 { v } else { scale(v, -1.0) };
            for [x, y] in spots(face) {
                let middle = add(scale(normal, half[axis] * 1.004), add(scale(u, x), scale(v, y)));
                self.disc(middle, scale(u, 0.19), scale(v, 0.19), normal);
            }
        }
    }

    fn disc(&mut self, middle: [f64; 3], u: [f64; 3], v: [f64; 3], normal: [f64; 3]) {
        const CORNERS: u16 = 18;
        let hub = self.corner(middle, normal, paint::DARK);
        for corner in 0..CORNERS {
            let angle = std::f64::consts::TAU * f64::from(corner) / f64::from(CORNERS);
            self.corner(add(middle, add(scale(u, angle.cos()), scale(v, angle.sin()))), normal, paint::DARK);
            self.triangles.extend([hub, hub + 1 + corner, hub + 1 + (corner + 1) % CORNERS]);
        }
    }

    /// An arrow of length one along z, as thick as that.
    pub fn arrow(thickness: f64) -> Self {
        let mut mesh = Self::default();
        let ring = |radius: f64, height: f64, column: usize| {
            let around = std::f64::consts::TAU * column as f64 / 12.0;
            [radius * around.cos(), radius * around.sin(), height]
        };
        let profile = [(0.5, 0.0), (0.5, 0.72), (1.3, 0.72), (0.0, 1.0)].map(|(r, z)| (r * thickness, z));
        for pair in profile.windows(2) {
            let [(r0, z0), (r1, z1)] = [pair[0], pair[1]];
            mesh.sheet(2, 13, |row, column| {
                let (radius, height) = if row == 0 { (r1, z1) } else { (r0, z0) };
                let slope = direction([z1 - z0, 0.0, r0 - r1]);
                let [x, y, _] = ring(1.0, 0.0, column);
                (ring(radius, height, column), direction([x * slope[0], y * slope[0], slope[2]]), paint::OWN)
            });
        }
        mesh
    }
}

fn faces() -> impl Iterator<Item = (usize, f64)> {
    (0..3).flat_map(|axis| [(axis, 1.0), (axis, -1.0)])
}

/// Where the pips of a face are, in halves of an edge.
fn spots(face: usize) -> Vec<[f64; 2]> {
    const FAR: f64 = 0.52;
    let mut spots = Vec::new();
    if face % 2 == 1 {
        spots.push([0.0, 0.0]);
    }
    if face > 1 {
        spots.extend([[FAR, FAR], [-FAR, -FAR]]);
    }
    if face > 3 {
        spots.extend([[FAR, -FAR], [-FAR, FAR]]);
    }
    if face == 6 {
        spots.extend([[FAR, 0.0], [-FAR, 0.0]]);
    }
    spots
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{cross, dot, sub};

    /// Every triangle of a solid looks away from its middle, and all of them together close: their volume is the solid's.
    #[test]
    fn meshes_are_closed_and_look_outwards() {
        let solids = [
            (Shape::Sphere { radius: 1.0 }, 4.18879, 0.02),
            (Shape::Capsule { radius: 1.0, half_length: 2.0 }, 4.18879 + 4.0 * std::f64::consts::PI, 0.02),
            (Shape::Cuboid { half: [1.0, 2.0, 3.0] }, 48.0, 0.01),
        ];
        for (shape, volume, tolerance) in solids {
            let mesh = Mesh::of(&shape, Look::Plain, 1.0).expect("a solid");
            let point = |index: u16| std::array::from_fn(|part| f64::from(mesh.points[3 * usize::from(index) + part]));
            let (mut sixfold, mut seen) = (0.0, 0);
            for triangle in mesh.triangles.chunks(3) {
                let [a, b, c]: [[f64; 3]; 3] = std::array::from_fn(|corner| point(triangle[corner]));
                let out = dot(cross(sub(b, a), sub(c, a)), a);
                assert!(out > -1e-9, "{shape:?}: a triangle looks inwards");
                sixfold += dot(a, cross(b, c));
                seen += 1;
            }
            assert!(seen > 100, "{shape:?} has {seen} triangles");
            assert!((sixfold / 6.0 / volume - 1.0).abs() < tolerance, "{shape:?}: a volume of {}", sixfold / 6.0);
        }
    }

    #[test]
    fn a_die_has_twenty_one_pips() {
        assert_eq!((1..=6).map(|face| spots(face).len()).collect::<Vec<_>>(), [1, 2, 3, 4, 5, 6]);
    }
}
