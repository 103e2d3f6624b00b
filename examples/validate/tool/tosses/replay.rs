//! The scene's cube, with the parameters of a run.

use carom::{Body, MassProperties, Material, Quat, Vec3};

use super::recording::{Frame, Toss};
use super::scene;
use crate::host::HostScalar;

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
    let [w, x, y, z] = first.orientation.map(S::unit);
    let orientation: Quat<S> = Quat::normalize(w, x, y, z).ok()?;
    let setup = setup(cube)?;
    let [position, velocity, spin] = [vector(first.position)?, vector(toss.velocity)?, vector(toss.spin)?];
    let mut cube = scene::Cube::new(&setup, position, orientation, velocity, spin)?;
    let mut frames = vec![frame(cube.body())];
    for _ in 1..toss.frames.len() {
        cube.frame();
        frames.push(frame(cube.body()));
    }
    Some(frames)
}

fn setup<S: HostScalar>(cube: &Cube) -> Option<scene::Setup<S>> {
    Some(scene::Setup {
        half_side: S::from_f64(cube.half_side)?,
        mass: MassProperties::from_inverses(S::scaled(1.0 / cube.mass), [S::scaled(1.0 / cube.inertia); 3]).ok()?,
        material: Material::new(S::from_f64(cube.restitution)?, S::from_f64(cube.friction)?).ok()?,
        gravity: S::from_f64(cube.gravity)?,
    })
}

fn frame<S: HostScalar>(body: &Body<S>) -> Frame {
    Frame {
        position: body.position.to_array().map(S::to_f64),
        orientation: body.orientation().to_array().map(S::unit_to_f64),
    }
}
