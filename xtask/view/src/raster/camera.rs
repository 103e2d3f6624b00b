//! From the world to the canvas, as the page begins.

use super::canvas::Corner;
use super::vector::{Vector, add, cross, direction, dot, scale, sub};
use crate::stage::Stage;

pub struct Camera {
    pub eye: Vector,
    axes: [Vector; 3],
    /// Points of the canvas to a tangent of one.
    focus: f32,
    middle: [f32; 2],
}

impl Camera {
    /// `closer` of 1 is as the page has it; more shows less.
    pub fn new(stage: &Stage, width: usize, height: usize, closer: f32) -> Self {
        let Stage { azimuth, elevation, distance, .. } = *stage;
        let out: Vector =
            [f32::cos(elevation) * f32::cos(azimuth), f32::cos(elevation) * f32::sin(azimuth), f32::sin(elevation)];
        let eye = add(stage.middle, scale(out, distance / closer));
        let across = direction(cross([0.0, 0.0, 1.0], out));
        let (width, height) = (width as f32, height as f32);
        let tangent = f32::tan(0.33) * (1.7 * height / width).max(1.0);
        Self {
            eye,
            axes: [across, cross(out, across), out],
            focus: height / 2.0 / tangent,
            middle: [width / 2.0, height / 2.0],
        }
    }

    /// `None` of what is behind the eye or too near.
    pub fn corner(&self, world: Vector, normal: Vector) -> Option<Corner> {
        let seen = sub(world, self.eye);
        let distance = -dot(seen, self.axes[2]);
        if distance < 1e-4 {
            return None;
        }
        let near = 1.0 / distance;
        let x = self.middle[0] + self.focus * dot(seen, self.axes[0]) * near;
        let y = self.middle[1] - self.focus * dot(seen, self.axes[1]) * near;
        Some(Corner { x, y, near, world, normal })
    }

    /// Where the ray through a point of the canvas meets the floor, and one over the distance.
    pub fn floor(&self, x: f32, y: f32, height: f32) -> Option<(Vector, f32)> {
        let [u, v] = [(x - self.middle[0]) / self.focus, (self.middle[1] - y) / self.focus];
        let ray = sub(add(scale(self.axes[0], u), scale(self.axes[1], v)), self.axes[2]);
        let distance = (height - self.eye[2]) / ray[2];
        (distance > 0.0).then(|| (add(self.eye, scale(ray, distance)), 1.0 / distance))
    }
}
