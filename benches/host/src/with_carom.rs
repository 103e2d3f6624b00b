//! carom, in four sub-steps.

use crate::{HIGH, Peer, Piece, STACKS, start};
use carom::solver::Settings;
use carom::{Body, BodyHandle, Cuboid, HalfSpace, Material, Solid, Sphere, UnitVec3, Vec3, World};

carom::shapes! { enum Shape<S> { Sphere, Cuboid, HalfSpace } }

pub struct WithCarom {
    world: Box<World<f32, Shape<f32>, 65, 128, 512>>,
    settings: Settings<f32>,
    pieces: Vec<BodyHandle>,
}

impl Peer for WithCarom {
    const NAME: &'static str = "carom";

    fn new(piece: Piece) -> Self {
        let mut world = Box::new(World::new());
        world.set_sleeping(false);
        let material = Material::new(0.0, 0.5).expect("a material");
        world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Y), material).expect("room");
        let half = Vec3::new(0.5, 0.5, 0.5);
        let mut pieces = Vec::new();
        for stack in 0..STACKS {
            for place in 0..HIGH {
                let (solid, shape) = match piece {
                    Piece::Ball => (Solid::sphere(0.5), Shape::from(Sphere::new(0.5).expect("a ball"))),
                    Piece::Box => (Solid::cuboid(half), Shape::from(Cuboid::new(half).expect("a box"))),
                };
                let mass = solid.expect("a solid").with_mass(1.0).expect("a mass");
                let body = Body::dynamic(mass).at(Vec3::from_array(start(stack, place)));
                pieces.push(world.insert(body, shape, material).expect("room"));
            }
        }
        let settings = Settings::new(Vec3::new(0.0, -9.81, 0.0), [1, 60], 4).expect("settings");
        Self { world, settings, pieces }
    }

    fn step(&mut self) {
        let report = self.world.step(&self.settings);
        assert_eq!(report.dropped, 0, "a step left something out");
    }

    fn heights(&self) -> Vec<f32> {
        self.pieces.iter().map(|piece| self.world.body(*piece).map_or(f32::NAN, |body| body.position.y)).collect()
    }
}
