//! What the firmware of `examples/rtic` and `examples/embassy` does: a box that is dropped, a hundred steps a second.

use carom::solver::Settings;
use carom::{Body, BodyHandle, Cuboid, HalfSpace, Material, Scalar, UnitVec3, Vec3, World};
use fixed::types::I12F20 as Real;

/// Steps in a second.
pub const RATE: u16 = 100;
/// Steps until the firmware ends.
pub const STEPS: u32 = 150;
/// Steps from one telemetry frame to the next.
pub const FRAME: u32 = 15;

carom::shapes! {
    /// What there is: a box and the ground.
    pub enum Piece<S> { Cuboid, HalfSpace }
}

/// The world: all bits of a new one are zero, so that it sits in .bss.
pub type Room = World<Real, Piece<Real>, 2, 2, 8>;

/// What is sent of a step.
#[derive(Clone, Copy)]
pub struct Frame {
    pub step: u32,
    pub height_mm: i32,
    pub hash: u64,
}

/// A run as one number: its frames, one after the other.
pub fn chained(so_far: u64, frame: &Frame) -> u64 {
    so_far.rotate_left(7) ^ frame.hash ^ u64::from(frame.step)
}

/// The world with the box in it.
pub struct Drop {
    world: &'static mut Room,
    settings: Settings<Real>,
    thrown: BodyHandle,
    step: u32,
}

fn vector(v: [i32; 3]) -> Option<Vec3<Real>> {
    let [x, y, z] = v.map(|x| Real::from_ratio(x, 1000));
    Some(Vec3::new(x.ok()?, y.ok()?, z.ok()?))
}

impl Drop {
    pub fn new(world: &'static mut Room) -> Option<Self> {
        let wood = Material::new(Real::from_ratio(3, 10).ok()?, Real::from_ratio(1, 2).ok()?).ok()?;
        world.clear();
        world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), wood).ok()?;
        let cuboid = Cuboid::new(vector([100, 150, 200])?).ok()?;
        let mut body = Body::dynamic(cuboid.solid().ok()?.with_mass(Real::ONE).ok()?).at(vector([0, 0, 700])?);
        body.angular_velocity = vector([1500, 2500, -700])?;
        let thrown = world.insert(body, cuboid, wood).ok()?;
        let settings = Settings::new(vector([0, 0, -9810])?, [1, RATE], 4).ok()?;
        Some(Self { world, settings, thrown, step: 0 })
    }

    /// Makes a step, and a frame now and then.
    pub fn step(&mut self) -> Option<Frame> {
        self.world.step(&self.settings);
        self.step = self.step.wrapping_add(1);
        if self.step % FRAME != 0 {
            return None;
        }
        let height = self.world.body(self.thrown).ok()?.position.z;
        let height_mm = (height * 1000).to_num();
        Some(Frame { step: self.step, height_mm, hash: self.world.hash() })
    }
}

/// The run without any scheduler.
pub fn straight(world: &'static mut Room) -> Option<u64> {
    let mut drop = Drop::new(world)?;
    Some((0..STEPS).filter_map(|_| drop.step()).fold(0, |run, frame| chained(run, &frame)))
}
