//! The physics of `embedded-3dgfx`. Its shapes hold no plane: the ground is a large box.

use crate::harness::Call;
use crate::harness::scene::Play;
use crate::measure::{FRICTION, GRAVITY, Peer, RADIUS, STEP, Scene, to_the_end};
use embedded_3dgfx::physics::{BodyId, Collider, PhysicsWorld, RigidBody};
use nalgebra::Vector3;

/// Contacts of a step, at most.
const CONTACTS: usize = 16;

type World = PhysicsWorld<9>;

pub struct With3dgfx {
    world: World,
    balls: [Option<BodyId>; 8],
}

#[unsafe(export_name = "kernel_spheres_embedded-3dgfx")]
extern "C" fn step(world: &mut World) {
    world.step::<CONTACTS>(STEP);
}

#[unsafe(export_name = "kernel_play_embedded-3dgfx")]
extern "C" fn play(out: &mut f32, scene: &Scene) {
    to_the_end::<With3dgfx>(out, scene, |peer| peer.world.step::<CONTACTS>(STEP));
}

impl Play for With3dgfx {
    fn step(&mut self) -> Call {
        Call::new(step as *const (), [(&raw mut self.world).cast()])
    }
}

impl Peer for With3dgfx {
    const NAME: &'static str = "embedded-3dgfx";

    fn new(scene: &Scene) -> Self {
        let mut world = World::new();
        world.set_gravity(Vector3::new(0.0, GRAVITY, 0.0));
        let ground = RigidBody::new_static().with_position(Vector3::new(0.0, -0.5, 0.0));
        let ground = ground.with_collider(Collider::Aabb { half_extents: Vector3::new(50.0, 0.5, 50.0) });
        world.add_body(ground.with_friction(FRICTION).with_restitution(0.0));
        let mut balls = [None; 8];
        for (place, height) in balls.iter_mut().take(scene.balls.into()).zip(0_u8..) {
            let ball = RigidBody::new(1.0).with_collider(Collider::Sphere { radius: RADIUS });
            let ball = ball.with_inertia_sphere(RADIUS).with_friction(FRICTION).with_restitution(0.0);
            let ball = ball.with_position(Vector3::new(0.0, RADIUS + f32::from(height), 0.0));
            let ball = ball.with_velocity(Vector3::new(scene.speed, 0.0, 0.0));
            *place = world.add_body(ball.with_damping(0.0).with_angular_damping(0.0));
        }
        Self { world, balls }
    }

    fn height(&self) -> f32 {
        let top = self.balls.iter().flatten().last();
        top.and_then(|ball| self.world.body(*ball)).map_or(f32::NAN, |ball| ball.position.y)
    }

    fn speed(&self) -> f32 {
        self.balls[0].and_then(|ball| self.world.body(ball)).map_or(f32::NAN, |ball| ball.velocity.x)
    }

    fn ram(&self) -> usize {
        size_of::<World>()
    }
}
