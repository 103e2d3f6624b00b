//! The solver's cube.

use carom::solver::{Buffers, ManifoldConstraint, Motion, PointConstraint, Settings, Step, WarmStart};
use carom::{Body, Collide, Cuboid, HalfSpace, Manifold, MassProperties, Material, Pose, Quat, UnitVec3, Vec3};

use super::recording::{Frame, Toss};
use crate::host::HostScalar;

/// The frames were recorded at 148 Hz; a step is a quarter of a frame.
const STEPS: u16 = 4;
const RATE: u16 = 148 * STEPS;
/// As many as a step has elsewhere. A gap is known to the format's last place, and closed in a sub-step: in finer ones its
/// rounding is a higher speed, 0.07 m/s in I16F16 with eight. Toss 193 ends near an edge and falls to either side with that:
/// with 4 or 5 sub-steps, and points that count within 0.001 to 0.003, as in f64 in every format.
const SUB_STEPS: u8 = 4;
/// How near a point counts, in parts of the half side: a tenth of a millimetre.
const MARGIN: f64 = 0.002;
/// By how much better the side and gravity are known than the rest.
pub const BETTER_KNOWN: f64 = 3.0;

/// The cube and the table, in SI units.
#[derive(Clone, Copy, Debug)]
pub struct Cube {
    pub half_side: f64,
    pub mass: f64,
    pub inertia: f64,
    pub friction: f64,
    pub restitution: f64,
    pub gravity: f64,
}

impl Cube {
    /// As those who tossed it state it.
    pub const NOMINAL: Self =
        Self { half_side: 0.0524, mass: 0.37, inertia: 0.00081, friction: 0.18, restitution: 0.125, gravity: 9.81 };

    pub fn rubbed(self, friction: f64) -> Self {
        Self { friction, ..self }
    }

    /// Each parameter on which the motion depends by that part less and more, the side and gravity by a third of it.
    pub fn jittered(self, part: f64) -> impl Iterator<Item = Self> {
        [1.0 - part, 1.0 + part].into_iter().flat_map(move |factor| {
            [
                Self { half_side: self.half_side * (1.0 + (factor - 1.0) / BETTER_KNOWN), ..self },
                Self { inertia: self.inertia * factor, ..self },
                Self { friction: self.friction * factor, ..self },
                Self { restitution: self.restitution * factor, ..self },
                Self { gravity: self.gravity * (1.0 + (factor - 1.0) / BETTER_KNOWN), ..self },
            ]
        })
    }
}

fn vector<S: HostScalar>(v: [f64; 3]) -> Option<Vec3<S>> {
    Some(Vec3::new(S::from_f64(v[0])?, S::from_f64(v[1])?, S::from_f64(v[2])?))
}

/// The frames of a toss from its first one on; `None` where something does not fit the format.
pub fn replay<S: HostScalar>(cube: &Cube, toss: &Toss) -> Option<Vec<Frame>> {
    let first = toss.frames.first()?;
    let mass = MassProperties::from_inverses(S::scaled(1.0 / cube.mass), [S::scaled(1.0 / cube.inertia); 3]).ok()?;
    let mut body = Body::dynamic(mass);
    body.position = vector(first.position)?;
    let [w, x, y, z] = first.orientation.map(S::unit);
    body.set_orientation(Quat::normalize(w, x, y, z).ok()?);
    body.linear_velocity = vector(toss.velocity)?;
    body.angular_velocity = body.orientation().rotate(vector(toss.spin)?);

    let shape = Cuboid::new(vector([cube.half_side; 3])?).ok()?;
    let table = HalfSpace::new(UnitVec3::Z);
    let material = Material::new(S::from_f64(cube.restitution)?, S::from_f64(cube.friction)?).ok()?;
    let settings = Settings::new(vector([0.0, 0.0, -cube.gravity])?, [1, RATE], SUB_STEPS).ok()?;
    let margin = S::from_f64(MARGIN * cube.half_side)?;

    let mut bodies = [Body::immovable(), body];
    let (mut motions, mut manifolds) = ([Motion::NEW; 2], [ManifoldConstraint::NEW]);
    let (mut points, mut warm) = ([PointConstraint::NEW; 4], vec![]);
    let mut frames = vec![frame(&bodies[1])];
    for _ in 1..toss.frames.len() {
        for _ in 0..STEPS {
            let pose = Pose::new(bodies[1].position, bodies[1].orientation());
            let mut manifold = Manifold::empty(UnitVec3::Z);
            table.collide(&Pose::IDENTITY, &shape, &pose, margin, &mut manifold);
            let buffers = Buffers { motions: &mut motions, manifolds: &mut manifolds, points: &mut points };
            let mut step = Step::begin(&mut bodies, buffers, &settings);
            step.add([0, 1], &manifold, &material, &warm);
            let (mut constraints, _) = step.finish();
            warm.clear();
            constraints.impulses(|_, impulses: &[WarmStart<S>]| warm.extend_from_slice(impulses));
        }
        frames.push(frame(&bodies[1]));
    }
    Some(frames)
}

fn frame<S: HostScalar>(body: &Body<S>) -> Frame {
    Frame {
        position: body.position.to_array().map(S::to_f64),
        orientation: body.orientation().to_array().map(S::unit_to_f64),
    }
}
