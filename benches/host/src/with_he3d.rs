//! `he3d-physics`.

use crate::{HIGH, Peer, Piece, STACKS, start};
use he3d_math::Vec3;
use he3d_physics::{BodyDesc, BodyId, Shape, World};

pub struct WithHe3d {
    world: World,
    pieces: Vec<BodyId>,
}

impl Peer for WithHe3d {
    const NAME: &'static str = "he3d-physics";

    fn new(piece: Piece) -> Self {
        let mut world = World::new();
        world.set_gravity(Vec3::new(0.0, -9.81, 0.0));
        let ground = BodyDesc::stationary(Shape::cuboid(Vec3::new(100.0, 0.5, 100.0)));
        world.add_body(ground.at(Vec3::new(0.0, -0.5, 0.0)).with_friction(0.5).with_restitution(0.0));
        let mut pieces = Vec::new();
        for stack in 0..STACKS {
            for place in 0..HIGH {
                let [x, y, z] = start(stack, place);
                let shape = match piece {
                    Piece::Ball => Shape::sphere(0.5),
                    Piece::Box => Shape::cuboid(Vec3::new(0.5, 0.5, 0.5)),
                };
                let body =
                    BodyDesc::dynamic(shape, 1.0).with_friction(0.5).with_restitution(0.0).with_damping(0.0, 0.0);
                pieces.push(world.add_body(body.at(Vec3::new(x, y, z))));
            }
        }
        Self { world, pieces }
    }

    /// Nobody sleeps.
    fn step(&mut self) {
        for piece in &self.pieces {
            self.world.wake(*piece);
        }
        self.world.step(1.0 / 60.0);
    }

    fn heights(&self) -> Vec<f32> {
        self.pieces.iter().map(|piece| self.world.position(*piece).map_or(f32::NAN, |position| position.y)).collect()
    }
}
