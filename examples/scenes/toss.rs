//! A measured cube on a measured table, on the solver's own slices: metres, kilograms and seconds.

use carom::solver::{Buffers, ManifoldConstraint, Motion, PointConstraint, Settings, Step, WarmStart};
use carom::{
    Body, Collide, Cuboid, HalfSpace, Manifold, MassProperties, Material, Pose, Quat, Scalar, Scaled, UnitVec3, Vec3,
};

/// The frames were recorded at 148 Hz; a step is a quarter of a frame.
const STEPS: u16 = 4;
const RATE: u16 = 148 * STEPS;
const SUB_STEPS: u8 = 8;

/// Half a side, m/10,000; restitution and friction in thousandths, as those who tossed it state them.
const HALF_SIDE: i32 = 524;
const RESTITUTION: i32 = 125;
const FRICTION: i32 = 180;

/// The cube over the table.
pub struct Cube<S: Scalar> {
    /// The table, then the cube.
    bodies: [Body<S>; 2],
    shape: Cuboid<S>,
    material: Material<S>,
    settings: Settings<S>,
    /// How near a point counts: a two hundredth of half a side.
    margin: S,
    motions: [Motion<S>; 2],
    manifolds: [ManifoldConstraint<S>; 1],
    points: [PointConstraint<S>; 4],
    warm: [WarmStart<S>; 4],
    warm_points: usize,
}

impl<S: Scalar> Cube<S> {
    /// At that place, turned like that, with that velocity, and the angular one in the cube's frame.
    pub fn new(position: Vec3<S>, orientation: Quat<S>, velocity: Vec3<S>, spin: Vec3<S>) -> Option<Self> {
        let ratio = |numerator, denominator| S::from_ratio(numerator, denominator).ok();
        // 0.37 kg and 0.00081 kg m^2 about any axis.
        let inverse = [S::Scaled::ratio(100_000, 81); 3];
        let mut body = Body::dynamic(MassProperties::from_inverses(S::Scaled::ratio(100, 37), inverse).ok()?);
        body.position = position;
        body.set_orientation(orientation);
        body.linear_velocity = velocity;
        body.angular_velocity = orientation.rotate(spin);
        let half = ratio(HALF_SIDE, 10_000)?;
        let gravity = Vec3::new(S::ZERO, S::ZERO, ratio(-981, 100)?);
        Some(Self {
            bodies: [Body::immovable(), body],
            shape: Cuboid::new(Vec3::new(half, half, half)).ok()?,
            material: Material::new(ratio(RESTITUTION, 1000)?, ratio(FRICTION, 1000)?).ok()?,
            settings: Settings::new(gravity, [1, RATE], SUB_STEPS).ok()?,
            margin: ratio(HALF_SIDE, 2_000_000)?,
            motions: [Motion::NEW; 2],
            manifolds: [ManifoldConstraint::NEW],
            points: [PointConstraint::NEW; 4],
            warm: [WarmStart::NONE; 4],
            warm_points: 0,
        })
    }

    pub fn body(&self) -> &Body<S> {
        let [_, body] = &self.bodies;
        body
    }

    /// To the next frame.
    pub fn frame(&mut self) {
        (0..STEPS).for_each(|_| self.step());
    }

    fn step(&mut self) {
        let pose = Pose::new(self.body().position, self.body().orientation());
        let mut manifold = Manifold::empty(UnitVec3::Z);
        HalfSpace::new(UnitVec3::Z).collide(&Pose::IDENTITY, &self.shape, &pose, self.margin, &mut manifold);
        let buffers = Buffers { motions: &mut self.motions, manifolds: &mut self.manifolds, points: &mut self.points };
        let mut step = Step::begin(&mut self.bodies, buffers, &self.settings);
        step.add([0, 1], &manifold, &self.material, self.warm.get(..self.warm_points).unwrap_or(&[]));
        let (mut constraints, _) = step.finish();
        let (warm, warm_points) = (&mut self.warm, &mut self.warm_points);
        *warm_points = 0;
        constraints.impulses(|_, impulses| {
            for (place, impulse) in warm.iter_mut().zip(impulses) {
                *place = *impulse;
                *warm_points = warm_points.wrapping_add(1);
            }
        });
    }
}
