//! A measured cube on a measured table, on the solver's own slices: metres, kilograms and seconds.

use carom::solver::{Buffers, ManifoldConstraint, Motion, PointConstraint, Settings, Step, WarmStart};
use carom::{
    Body, Collide, Cuboid, HalfSpace, Manifold, MassProperties, Material, Pose, Quat, Scalar, Scaled, UnitVec3, Vec3,
};

/// The frames were recorded at 148 Hz; a step is a quarter of a frame.
const STEPS: u16 = 4;
const RATE: u16 = 148 * STEPS;
/// As many as a step has elsewhere. A gap is known to the format's last place, and closed in a sub-step: in finer ones its
/// rounding is a higher speed, 0.07 m/s in I16F16 with eight. Toss 193 ends near an edge and falls to either side with that:
/// with 4 or 5 sub-steps, and points that count within 0.001 to 0.003, as in f64 in every format.
const SUB_STEPS: u8 = 4;
/// How near a point counts, in thousandths of the half side: a tenth of a millimetre.
const MARGIN: i32 = 2;

/// What the motion depends on.
#[derive(Clone, Copy)]
pub struct Setup<S: Scalar> {
    pub half_side: S,
    pub mass: MassProperties<S>,
    pub material: Material<S>,
    pub gravity: S,
}

impl<S: Scalar> Setup<S> {
    /// As those who tossed the cube state it: 104.8 mm, 0.37 kg and 0.00081 kg m^2 about any axis, e = 0.125, mu = 0.18.
    pub fn nominal() -> Option<Self> {
        let ratio = |numerator, denominator| S::from_ratio(numerator, denominator).ok();
        let inverse = [S::Scaled::ratio(100_000, 81); 3];
        Some(Self {
            half_side: ratio(524, 10_000)?,
            mass: MassProperties::from_inverses(S::Scaled::ratio(100, 37), inverse).ok()?,
            material: Material::new(ratio(125, 1000)?, ratio(180, 1000)?).ok()?,
            gravity: ratio(981, 100)?,
        })
    }
}

/// The cube over the table.
pub struct Cube<S: Scalar> {
    /// The table, then the cube.
    bodies: [Body<S>; 2],
    shape: Cuboid<S>,
    material: Material<S>,
    settings: Settings<S>,
    margin: S,
    motions: [Motion<S>; 2],
    manifolds: [ManifoldConstraint<S>; 1],
    points: [PointConstraint<S>; 4],
    warm: [WarmStart<S>; 4],
    warm_points: usize,
}

impl<S: Scalar> Cube<S> {
    /// At that place, turned like that, with that velocity, and the angular one in the cube's frame.
    pub fn new(
        setup: &Setup<S>,
        position: Vec3<S>,
        orientation: Quat<S>,
        velocity: Vec3<S>,
        spin: Vec3<S>,
    ) -> Option<Self> {
        let mut body = Body::dynamic(setup.mass).at(position).moving(velocity);
        body.set_orientation(orientation);
        body.angular_velocity = orientation.rotate(spin);
        let half = setup.half_side;
        let gravity = Vec3::new(S::ZERO, S::ZERO, setup.gravity.negated());
        Some(Self {
            bodies: [Body::immovable(), body],
            shape: Cuboid::new(Vec3::new(half, half, half)).ok()?,
            material: setup.material,
            settings: Settings::new(gravity, [1, RATE], SUB_STEPS).ok()?,
            margin: half.times(S::from_ratio(MARGIN, 1000).ok()?),
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
