//! Shapes drawn at random, and how far outside one a point is: by the closed forms, in f64. For a crate root with `mod tool`
//! and `mod random`.
#![allow(dead_code)]

use crate::random::Random;
use crate::tool::geometry::{Placed, Shape};
use crate::tool::vector::{Vector, add, cross, dot, norm, rotation, scale, sub};

/// Kinds of shapes, by number: sphere, capsule, box, plane.
pub const KINDS: usize = 4;

/// Every pair of kinds that can meet.
pub const PAIRS: [(usize, usize); 9] = [(0, 0), (0, 1), (0, 2), (0, 3), (1, 1), (1, 2), (1, 3), (2, 2), (2, 3)];

/// In numbers that every format holds exactly.
pub fn shape(kind: usize, random: &mut Random) -> Shape {
    let mut size = || (random.between(0.05, 1.0) * 65536.0).round() / 65536.0;
    match kind {
        0 => Shape::Sphere { radius: size() },
        1 => Shape::Capsule { radius: size(), half: size() },
        2 => Shape::Box { half: [size(), size(), size()] },
        _ => Shape::Plane,
    }
}

/// Rounded so that every format holds it exactly.
pub fn round(v: Vector) -> Vector {
    v.map(|x| (x * 65536.0).round() / 65536.0)
}

pub fn orientation(random: &mut Random) -> [f64; 4] {
    if random.one_in(5) {
        return [1.0, 0.0, 0.0, 0.0];
    }
    let q: [f64; 4] = std::array::from_fn(|_| random.between(-1.0, 1.0));
    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    q.map(|x| x / length)
}

/// The product of quaternions.
pub fn times([a, b, c, d]: [f64; 4], [e, f, g, h]: [f64; 4]) -> [f64; 4] {
    let (v, w) = ([b, c, d], [f, g, h]);
    let [x, y, z] = add(add(scale(a, w), scale(e, v)), cross(v, w));
    [a * e - dot(v, w), x, y, z]
}

/// How far outside the shape a point is, negative inside.
pub fn height(placed: &Placed, point: Vector) -> f64 {
    let r = rotation(placed.orientation);
    let way = sub(point, placed.position);
    let p = [0, 1, 2].map(|k| r[0][k] * way[0] + r[1][k] * way[1] + r[2][k] * way[2]);
    match placed.shape {
        Shape::Sphere { radius } => norm(p) - radius,
        Shape::Box { half } => {
            let beyond = [0, 1, 2].map(|k| p[k].abs() - half[k]);
            let inside = beyond[0].max(beyond[1]).max(beyond[2]).min(0.0);
            norm(beyond.map(|x| x.max(0.0))) + inside
        }
        Shape::Capsule { radius, half } => norm([p[0], p[1], p[2] - p[2].clamp(-half, half)]) - radius,
        Shape::Plane => p[2],
    }
}
