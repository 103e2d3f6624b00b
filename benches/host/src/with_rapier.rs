//! `rapier3d`.

use crate::{HIGH, Peer, Piece, STACKS, start};
use rapier3d::prelude::{ColliderBuilder, PhysicsWorld, RigidBodyBuilder, RigidBodyHandle, Vector};

pub struct WithRapier {
    world: PhysicsWorld,
    pieces: Vec<RigidBodyHandle>,
}

impl Peer for WithRapier {
    const NAME: &'static str = "rapier3d";

    fn new(piece: Piece) -> Self {
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::new(0.0, -9.81, 0.0);
        world.integration_parameters.dt = 1.0 / 60.0;
        let ground = ColliderBuilder::cuboid(100.0, 0.5, 100.0).friction(0.5).restitution(0.0);
        world.insert(RigidBodyBuilder::fixed().translation(Vector::new(0.0, -0.5, 0.0)), ground);
        let mut pieces = Vec::new();
        for stack in 0..STACKS {
            for place in 0..HIGH {
                let [x, y, z] = start(stack, place);
                let shape = match piece {
                    Piece::Ball => ColliderBuilder::ball(0.5),
                    Piece::Box => ColliderBuilder::cuboid(0.5, 0.5, 0.5),
                };
                let body = RigidBodyBuilder::dynamic().translation(Vector::new(x, y, z)).can_sleep(false);
                let shape = shape.mass(1.0).friction(0.5).restitution(0.0);
                pieces.push(world.insert(body, shape).0);
            }
        }
        Self { world, pieces }
    }

    fn step(&mut self) {
        self.world.step();
    }

    fn heights(&self) -> Vec<f32> {
        self.pieces.iter().map(|piece| self.world.bodies[*piece].translation().y).collect()
    }
}
