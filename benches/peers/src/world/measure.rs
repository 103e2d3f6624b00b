//! Every peer on every scene of balls that `benches/world` plays with carom.

use crate::board;
use crate::harness::counter;
use crate::harness::scene::{self, Play};
use crate::with_3dgfx::With3dgfx;
use crate::with_he3d::WithHe3d;

/// Balls of one metre and one kilogram at rest on each other, or one that slides, on a plane: friction of a half, no rebound, no
/// damping, and steps of 1/60 s.
pub struct Scene {
    pub name: &'static str,
    pub balls: u8,
    /// Of the balls, m/s.
    pub speed: f32,
}

const SCENES: [Scene; 4] = [
    Scene { name: "spheres_1", balls: 1, speed: 0.0 },
    Scene { name: "spheres_4", balls: 4, speed: 0.0 },
    Scene { name: "spheres_8", balls: 8, speed: 0.0 },
    Scene { name: "slide", balls: 1, speed: 7.0 },
];

pub const STEP: f32 = 1.0 / 60.0;
pub const GRAVITY: f32 = -9.81;
pub const FRICTION: f32 = 0.5;
pub const RADIUS: f32 = 0.5;

/// Somebody's world.
pub trait Peer: Play {
    const NAME: &'static str;

    fn new(scene: &Scene) -> Self;
    /// The height of the highest ball.
    fn height(&self) -> f32;
    /// The speed of the first one.
    fn speed(&self) -> f32;
    /// Bytes of the world.
    fn ram(&self) -> usize;
}

/// Prints `counter EMPTY TICKS`, and the lines of scenes as `benches/world` does.
pub fn run() -> Result<(), &'static str> {
    board::println!("counter {} {}", counter::empty(), counter::ticks_per_thousand());
    if board::option("--scalar") != Some("f32") {
        return Err("--scalar f32 is missing");
    }
    for scene in &SCENES {
        play::<With3dgfx>(scene)?;
        play::<WithHe3d>(scene)?;
    }
    Ok(())
}

fn play<P: Peer>(scene: &Scene) -> Result<(), &'static str> {
    let stack = scene::stack(&mut P::new(scene)).ok_or("a step took more stack than is painted")?;
    let mut world = P::new(scene);
    let found = scene::instructions(&mut world).ok_or("a step took longer than the counter counts")?;
    let outcome = if scene.speed > 0.0 { world.speed() } else { world.height() };
    let scene::Instructions { mean, min, max, worst } = found;
    let (by, name, ram, word) = (P::NAME, scene.name, world.ram(), outcome.to_bits());
    board::println!("scene {by} {name} {mean} {min} {max} {worst} {stack} {ram} {word}");
    Ok(())
}

/// The scene to its end with nothing measured: what is weighed.
pub fn to_the_end<P: Peer>(out: &mut f32, scene: &Scene, step: impl Fn(&mut P)) {
    let mut world = P::new(scene);
    for _ in 0..180 {
        world.prepare();
        step(&mut world);
    }
    *out = world.height();
}
