//! A world with a ground, on the host.
#![allow(dead_code)]

use carom::solver::Settings;
use carom::world::WorldReport;
use carom::{Body, BodyHandle, Material, Scaled, World};

use crate::host::HostScalar;
use crate::random::Random;
use crate::scene::{Piece, Shape, floats, number, quat, solid, vector};

pub const G: f64 = 9.81;

/// Room for what tests put into it.
pub type Room<S> = World<S, Piece<S>, 24, 96, 256>;

/// A world, how it is stepped, and what the last step had to say.
pub struct Stage<S: HostScalar> {
    pub world: Room<S>,
    pub settings: Settings<S>,
    pub material: Material<S>,
    pub ground: BodyHandle,
    pub report: WorldReport,
}

/// 1/60 s in four sub-steps, down y.
pub fn settings<S: HostScalar>() -> Settings<S> {
    Settings::new(vector([0.0, -G, 0.0]), [1, 60], 4).expect("settings")
}

pub fn nothing<S: HostScalar>() -> S::Scaled {
    <S::Scaled as Scaled>::ZERO
}

impl<S: HostScalar> Stage<S> {
    pub fn new(friction: f64, restitution: f64) -> Self {
        let material = Material::new(number(restitution), number(friction)).expect("a material");
        let mut world = Room::new();
        let ground = Shape::HalfSpace([0.0, 1.0, 0.0]).build::<S>();
        let ground = world.insert(Body::immovable(), ground, material).expect("room");
        Self { world, settings: settings(), material, ground, report: WorldReport::default() }
    }

    /// The ground is far away, and nothing falls.
    pub fn weightless(friction: f64, restitution: f64) -> Self {
        let mut stage = Self::new(friction, restitution);
        stage.settings.gravity = vector([0.0; 3]);
        stage.world.body_mut(stage.ground).expect("the ground").position = vector([0.0, -20.0, 0.0]);
        stage
    }

    pub fn insert(&mut self, body: Body<S>, shape: Shape) -> BodyHandle {
        self.world.insert(body, shape.build::<S>(), self.material).expect("room")
    }

    pub fn solid(&mut self, mass: f64, shape: Shape, position: [f64; 3]) -> BodyHandle {
        let mut body = Body::dynamic(solid(mass, shape));
        body.position = vector(position);
        self.insert(body, shape)
    }

    pub fn position(&self, handle: BodyHandle) -> [f64; 3] {
        floats(self.world.body(handle).expect("a body").position)
    }

    pub fn step(&mut self) {
        self.report = self.world.step(&self.settings);
    }

    /// In steps of 1/60 s.
    pub fn run(&mut self, seconds: f64) {
        for _ in 0..(seconds * 60.0).round() as usize {
            self.step();
        }
    }
}

/// Boxes and balls, thrown into a heap.
pub fn heap<S: HostScalar>(count: usize) -> Stage<S> {
    let mut stage = Stage::new(0.5, 0.2);
    let mut random = Random::new(7);
    for i in 0..count {
        let mut number = || random.between(-1.0, 1.0);
        let half = [0.2 + 0.1 * number().abs(), 0.2, 0.25];
        let shape = if i % 3 == 0 { Shape::Sphere(0.25) } else { Shape::Cuboid(half) };
        let mut body = Body::dynamic(solid(1.0, shape));
        body.position = vector([number() * 0.4, 0.6 + 0.5 * i as f64, number() * 0.4]);
        body.set_orientation(quat([1.0, number(), number(), number()]));
        body.linear_velocity = vector([number(), -1.0, number()]);
        stage.insert(body, shape);
    }
    stage
}
