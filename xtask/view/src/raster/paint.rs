//! A moment of the replay on a canvas. The page's shaders do the same.

use super::camera::Camera;
use super::canvas::{Canvas, Corner};
use super::shading::{LIGHT, Shading};
use super::vector::{Vector, add, cross, direction, dot, mix, scale, smooth, sub};
use crate::mesh::{Mesh, paint};
use crate::replay::{Actor, Mark, Replay};
use crate::stage::{Stage, walls};

/// Lights that make a soft shadow.
const LIGHTS: usize = 10;

const SKY: Vector = [0.933, 0.945, 0.965];
const FLOOR: Vector = [0.867, 0.886, 0.918];
const LINES: Vector = [0.725, 0.757, 0.808];
const WALL: Vector = [0.80, 0.82, 0.86];
const PUSH: Vector = [0.898, 0.282, 0.302];
const GHOST: Vector = [0.145, 0.388, 0.922];
const GOAL: Vector = [0.02, 0.588, 0.412];
const SHADOW: f32 = 0.3;
/// How long a blow is seen, s.
const AFTERGLOW: f32 = 0.12;

/// Where a mesh is put.
#[derive(Clone, Copy)]
struct Pose {
    position: Vector,
    turn: [f32; 4],
    size: Vector,
}

impl Pose {
    fn rotate(&self, v: Vector) -> Vector {
        let [w, x, y, z] = self.turn;
        let t = scale(cross([x, y, z], v), 2.0);
        add(add(v, scale(t, w)), cross([x, y, z], t))
    }

    fn of(poses: &[f32], frame: usize) -> Self {
        let first = 7 * frame.min(poses.len() / 7 - 1);
        let [x, y, z, w, i, j, k] = std::array::from_fn(|part| poses[first + part]);
        Self { position: [x, y, z], turn: [w, i, j, k], size: [1.0; 3] }
    }
}

/// Draws a frame in so many pixels, each from `fine` by `fine` points.
pub fn frame(replay: &Replay, index: usize, [width, height]: [usize; 2], fine: usize, closer: f32) -> Vec<[u8; 3]> {
    let mut canvas = Canvas::new(width * fine, height * fine, SKY);
    let camera = Camera::new(&replay.stage, canvas.width, canvas.height, closer);
    let mut painter = Painter { canvas: &mut canvas, camera, stage: &replay.stage };
    let solid = || replay.actors.iter().filter(|actor| !actor.sensor);
    let shadows = painter.shadows(solid().map(|actor| (&replay.meshes[actor.mesh], Pose::of(&actor.poses, index))));
    painter.floor(&shadows);
    painter.walls();
    for actor in solid() {
        painter.solid(&replay.meshes[actor.mesh], &Pose::of(&actor.poses, index), actor.colour);
    }
    for actor in replay.actors.iter().filter(|actor| actor.sensor) {
        painter.glass(&replay.meshes[actor.mesh], &Pose::of(&actor.poses, index), GOAL);
    }
    let ghosts = |actor: &&Actor| actor.free && !actor.ghost.is_empty();
    for actor in replay.actors.iter().filter(ghosts) {
        painter.glass(&replay.meshes[actor.mesh], &Pose::of(&actor.ghost, index), GHOST);
    }
    painter.pushes(replay, index);
    canvas.pixels(fine)
}

struct Painter<'a> {
    canvas: &'a mut Canvas,
    camera: Camera,
    stage: &'a Stage,
}

impl Painter<'_> {
    /// How many of the lights do not reach each point of the floor.
    fn shadows<'m>(&self, solids: impl Iterator<Item = (&'m Mesh, Pose)>) -> Vec<u8> {
        let mut dark = vec![0u16; self.canvas.colours.len()];
        let solids: Vec<_> = solids.collect();
        for light in 0..LIGHTS {
            let (angle, out) = (light as f32 * 2.39996, 0.11 * ((light as f32 + 0.5) / LIGHTS as f32).sqrt());
            let light_from = direction(add(direction(LIGHT), [out * angle.cos(), out * angle.sin(), 0.0]));
            for (mesh, pose) in &solids {
                let cast = |world: Vector| {
                    let height = world[2] - self.stage.floor;
                    sub(world, scale(light_from, height / light_from[2]))
                };
                self.triangles(mesh, pose, cast, |corners, _| {
                    self.canvas.cover([&corners[0], &corners[1], &corners[2]], |at, _, _| dark[at] |= 1 << light);
                });
            }
        }
        dark.into_iter().map(|bits| bits.count_ones() as u8).collect()
    }

    fn floor(&mut self, shadows: &[u8]) {
        let stage = self.stage;
        for row in 0..self.canvas.height {
            for column in 0..self.canvas.width {
                let (x, y) = (column as f32 + 0.5, row as f32 + 0.5);
                let Some((world, near)) = self.camera.floor(x, y, stage.floor) else { continue };
                if !inside(&stage.outline, world) {
                    continue;
                }
                let away = f32::hypot(world[0] - stage.middle[0], world[1] - stage.middle[1]) / stage.reach;
                let fade = 1.0 - smooth(1.2, 4.2, away);
                let mut colour = mix(SKY, FLOOR, fade * if stage.solid { 1.0 } else { 0.45 });
                // How much of the floor a point of the canvas covers.
                let wide = 1.2 / (near * self.canvas.height as f32);
                let rule = |spacing: f32, width: f32| {
                    let off = |x: f32| (((x / spacing - 0.5).rem_euclid(1.0)) - 0.5).abs() * spacing / wide;
                    1.0 - (off(world[0]).min(off(world[1])) - width).clamp(0.0, 1.0)
                };
                let lines = (0.55 * rule(stage.grid, 0.6)).max(rule(5.0 * stage.grid, 1.0));
                colour = mix(colour, LINES, fade * lines * 0.8);
                let at = row * self.canvas.width + column;
                let dark = SHADOW * f32::from(shadows[at]) / LIGHTS as f32;
                self.canvas.colours[at] = scale(colour, 1.0 - dark);
            }
        }
    }

    fn walls(&mut self) {
        for wall in walls(self.stage) {
            let [a, b, c, d] = wall.map(|corner| corner.map(|part| part as f32));
            let normal = direction(cross(sub(b, a), sub(c, a)));
            if dot(normal, sub(self.camera.eye, a)) < 0.0 {
                continue;
            }
            for corners in [[a, b, c], [a, c, d]] {
                let corners: Vec<Corner> = corners.iter().filter_map(|at| self.camera.corner(*at, normal)).collect();
                if let [a, b, c] = &corners[..] {
                    self.fill([a, b, c], |shading| shading.solid(WALL));
                }
            }
        }
    }

    fn solid(&mut self, mesh: &Mesh, pose: &Pose, colour: Vector) {
        for (corners, kind) in self.facing(mesh, pose) {
            let own = painted(colour, kind);
            self.fill([&corners[0], &corners[1], &corners[2]], |shading| shading.solid(own));
        }
    }

    /// Fills a triangle where nothing is nearer.
    fn fill(&mut self, corners: [&Corner; 3], colour: impl Fn(&Shading) -> Vector) {
        let (eye, stage) = (self.camera.eye, self.stage);
        let mut points = Vec::new();
        self.canvas.cover(corners, |at, near, parts| points.push((at, near, parts)));
        for (at, near, parts) in points {
            if near > self.canvas.depths[at] {
                self.canvas.depths[at] = near;
                self.canvas.colours[at] = colour(&Shading::new(corners, parts, eye, stage));
            }
        }
    }

    /// Something that one sees through: only its front, and nothing behind what is solid.
    fn glass(&mut self, mesh: &Mesh, pose: &Pose, colour: Vector) {
        let mut layer = vec![(0.0f32, [0.0; 3], 0.0f32); self.canvas.colours.len()];
        for (corners, kind) in self.facing(mesh, pose) {
            let own = if kind == paint::DARK { scale(colour, 0.45) } else { colour };
            let corners = [&corners[0], &corners[1], &corners[2]];
            self.canvas.cover(corners, |at, near, parts| {
                if near > 1.0005 * self.canvas.depths[at] && near > layer[at].0 {
                    let shading = Shading::new(corners, parts, self.camera.eye, self.stage);
                    let alpha = 0.55 * (0.55 + 0.8 * shading.rim);
                    layer[at] = (near, scale(own, 0.75 + 0.35 * shading.rim), alpha);
                }
            });
        }
        for (at, (near, colour, alpha)) in layer.into_iter().enumerate() {
            if near > 0.0 {
                self.canvas.blend(at, colour, alpha);
            }
        }
    }

    /// Where and how hard bodies pushed, seen through them.
    fn pushes(&mut self, replay: &Replay, index: usize) {
        let strongest = replay.pushes.iter().flatten().map(|mark| mark.impulse).fold(1e-12, f32::max);
        for frame in (0..=index).rev() {
            let age = (replay.times[index] - replay.times[frame]) / AFTERGLOW;
            if age >= 1.0 {
                break;
            }
            for mark in replay.pushes[frame].iter().filter(|mark| mark.struck || frame == index) {
                let fresh = if mark.struck { 1.0 - age } else { 1.0 };
                self.push(replay, mark, fresh, (mark.impulse / strongest).sqrt());
            }
        }
    }

    fn push(&mut self, replay: &Replay, mark: &Mark, fresh: f32, strength: f32) {
        let size = [0.09 * self.stage.size; 3];
        for point in &mark.points {
            self.overlay(&replay.dot, &Pose { position: *point, turn: [1.0, 0.0, 0.0, 0.0], size }, 0.9 * fresh);
        }
        let middle =
            scale(mark.points.iter().fold([0.0; 3], |sum, point| add(sum, *point)), 1.0 / mark.points.len() as f32);
        let long = 6.0 * self.stage.size * strength * fresh;
        let thick = long.min(3.0 * self.stage.size);
        let turn = crate::algebra::turn_from_z(mark.direction.map(f64::from)).map(|part| part as f32);
        self.overlay(&replay.arrow, &Pose { position: middle, turn, size: [thick, thick, long] }, 0.9 * fresh);
    }

    fn overlay(&mut self, mesh: &Mesh, pose: &Pose, alpha: f32) {
        for (corners, _) in self.facing(mesh, pose) {
            let corners = [&corners[0], &corners[1], &corners[2]];
            let mut points = Vec::new();
            self.canvas.cover(corners, |at, _, parts| points.push((at, parts)));
            for (at, parts) in points {
                let colour = Shading::new(corners, parts, self.camera.eye, self.stage).solid(PUSH);
                self.canvas.blend(at, colour, alpha);
            }
        }
    }

    /// The triangles that look at the camera.
    fn facing(&self, mesh: &Mesh, pose: &Pose) -> Vec<([Corner; 3], u8)> {
        let mut facing = Vec::new();
        self.triangles(
            mesh,
            pose,
            |world| world,
            |corners, kind| {
                let [a, b, c] = &corners;
                // Down counts up: what is anticlockwise in the world is clockwise here.
                if (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) < 0.0 {
                    facing.push((corners, kind));
                }
            },
        );
        facing
    }

    fn triangles(
        &self,
        mesh: &Mesh,
        pose: &Pose,
        place: impl Fn(Vector) -> Vector,
        mut take: impl FnMut([Corner; 3], u8),
    ) {
        let part = |list: &[f32], index: usize| -> Vector { std::array::from_fn(|axis| list[3 * index + axis]) };
        let corners: Vec<Option<Corner>> = (0..mesh.paints.len())
            .map(|index| {
                let [point, normal] = [part(&mesh.points, index), part(&mesh.normals, index)];
                let sized = std::array::from_fn(|axis| point[axis] * pose.size[axis]);
                let slope = std::array::from_fn(|axis| normal[axis] / pose.size[axis]);
                self.camera.corner(place(add(pose.position, pose.rotate(sized))), pose.rotate(direction(slope)))
            })
            .collect();
        for triangle in mesh.triangles.chunks(3) {
            let [a, b, c] = [0, 1, 2].map(|corner| usize::from(triangle[corner]));
            if let (Some(first), Some(second), Some(third)) = (corners[a], corners[b], corners[c]) {
                take([first, second, third], mesh.paints[a]);
            }
        }
    }
}

fn painted(colour: Vector, kind: u8) -> Vector {
    match kind {
        paint::DARK => [0.10, 0.11, 0.14],
        paint::LIGHT => mix(colour, [1.0; 3], 0.8),
        _ => colour,
    }
}

/// Whether a point is within a convex outline.
fn inside(outline: &[[f32; 2]], [x, y, _]: Vector) -> bool {
    (0..outline.len()).all(|index| {
        let ([x0, y0], [x1, y1]) = (outline[index], outline[(index + 1) % outline.len()]);
        (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) >= 0.0
    })
}
