//! `he3d-physics`: allocates. Up is y; the ground is a large box.

use crate::harness::Call;
use crate::harness::scene::Play;
use crate::heap;
use crate::measure::{FRICTION, GRAVITY, Peer, RADIUS, STEP, Scene, to_the_end};
use he3d_math::Vec3;
use he3d_physics::{BodyDesc, BodyId, Shape, World};

pub struct WithHe3d {
    world: World,
    balls: [Option<BodyId>; 8],
    /// Bytes of the heap that others use.
    before: usize,
    /// The most that were in use.
    most: usize,
}

#[unsafe(export_name = "kernel_spheres_he3d-physics")]
extern "C" fn step(world: &mut World) {
    world.step(STEP);
}

#[unsafe(export_name = "kernel_play_he3d-physics")]
extern "C" fn play(out: &mut f32, scene: &Scene) {
    to_the_end::<WithHe3d>(out, scene, |peer| peer.world.step(STEP));
}

impl Play for WithHe3d {
    fn step(&mut self) -> Call {
        Call::new(step as *const (), [(&raw mut self.world).cast()])
    }

    /// Nobody sleeps.
    fn prepare(&mut self) {
        self.most = self.most.max(heap::used() - self.before);
        for ball in self.balls.iter().flatten() {
            self.world.wake(*ball);
        }
    }
}

impl Peer for WithHe3d {
    const NAME: &'static str = "he3d-physics";

    fn new(scene: &Scene) -> Self {
        let before = heap::used();
        let mut world = World::new();
        world.set_gravity(Vec3::new(0.0, GRAVITY, 0.0));
        let ground = BodyDesc::stationary(Shape::cuboid(Vec3::new(50.0, 0.5, 50.0)));
        world.add_body(ground.at(Vec3::new(0.0, -0.5, 0.0)).with_friction(FRICTION).with_restitution(0.0));
        let mut balls = [None; 8];
        for (place, height) in balls.iter_mut().take(scene.balls.into()).zip(0_u8..) {
            let ball = BodyDesc::dynamic(Shape::sphere(RADIUS), 1.0).with_friction(FRICTION).with_restitution(0.0);
            let ball = ball.at(Vec3::new(0.0, RADIUS + f32::from(height), 0.0));
            *place = Some(world.add_body(ball.with_velocity(Vec3::new(scene.speed, 0.0, 0.0)).with_damping(0.0, 0.0)));
        }
        Self { world, balls, before, most: 0 }
    }

    fn height(&self) -> f32 {
        let top = self.balls.iter().flatten().last();
        top.and_then(|ball| self.world.position(*ball)).map_or(f32::NAN, |position| position.y)
    }

    fn speed(&self) -> f32 {
        self.balls[0].and_then(|ball| self.world.velocity(ball)).map_or(f32::NAN, |velocity| velocity.x)
    }

    fn ram(&self) -> usize {
        size_of::<World>() + self.most
    }
}
