//! Light on surfaces.

use super::canvas::Corner;
use super::vector::{Vector, add, direction, dot, mix, scale, smooth, sub};
use crate::stage::Stage;

/// Where it comes from; not of length one.
pub const LIGHT: Vector = [-0.45, -0.5, 0.95];

/// Light on a point of a surface.
pub struct Shading {
    normal: Vector,
    view: Vector,
    /// How much the surface turns away from the eye.
    pub rim: f32,
    open: f32,
}

impl Shading {
    pub fn new(corners: [&Corner; 3], parts: [f32; 3], eye: Vector, stage: &Stage) -> Self {
        let mixed = |of: fn(&Corner) -> Vector| {
            let sum = corners.iter().zip(parts);
            sum.fold([0.0; 3], |sum, (corner, part)| add(sum, scale(of(corner), part)))
        };
        let world = mixed(|corner| corner.world);
        let (normal, view) = (direction(mixed(|corner| corner.normal)), direction(sub(eye, world)));
        let rim = (1.0 - dot(normal, view).max(0.0)).powi(2);
        let open = 0.72 + 0.28 * smooth(0.0, 1.0, (world[2] - stage.floor) / (0.25 * stage.reach));
        Self { normal, view, rim, open }
    }

    pub fn solid(&self, colour: Vector) -> Vector {
        let light = direction(LIGHT);
        let sky = 0.5 + 0.5 * self.normal[2];
        let ambient = scale(mix([0.20, 0.19, 0.19], [0.46, 0.49, 0.55], sky), self.open);
        let lit = dot(self.normal, light).max(0.0);
        let gleam = dot(self.normal, direction(add(light, self.view))).max(0.0).powi(70) * 0.30;
        let sun: Vector = [0.92, 0.89, 0.83];
        std::array::from_fn(|part| {
            let base = colour[part].powf(2.2);
            (base * (ambient[part] + sun[part] * lit) + gleam + self.rim * 0.05).clamp(0.0, 1.0).powf(1.0 / 2.2)
        })
    }
}
