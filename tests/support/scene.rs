//! Bodies and contacts over time, by the solver alone: a few pairs of shapes by hand.
#![allow(dead_code)]

use carom::solver::{Buffers, ManifoldConstraint, Motion, PointConstraint, Settings, Step, WarmStart};
use carom::{
    Body, Collide, Cuboid, HalfSpace, Manifold, MassProperties, Material, Pose, Quat, Scalar, Sphere, UnitVec3, Vec3,
};

use crate::host::HostScalar;
pub use crate::host::{floats, number, vector};

/// What a body looks like.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Sphere(f64),
    /// Half edges.
    Cuboid([f64; 3]),
    /// Everything below the plane through the origin of the body, with the normal in its frame.
    HalfSpace([f64; 3]),
}

/// What a contact did in a step.
#[derive(Clone, Copy, Debug)]
pub struct Touched {
    pub pushed: bool,
    pub impulse: f64,
    pub approach: f64,
}

/// A scene.
pub struct Scene<S: Scalar> {
    pub bodies: Vec<Body<S>>,
    pub shapes: Vec<Shape>,
    pub settings: Settings<S>,
    pub material: Material<S>,
    /// The length of a step.
    pub dt: f64,
    /// The part of a shape's size within which points count.
    pub margin: f64,
    pub contacts: usize,
    pub saturated: bool,
    /// What the contacts of the last step did.
    pub touches: Vec<Touched>,
    /// Bodies that are held.
    pub held: Vec<usize>,
    /// Bodies that were not finite, over all steps.
    pub not_finite: usize,
    kept: Vec<([u16; 2], Vec<WarmStart<S>>)>,
    motions: Vec<Motion<S>>,
    manifolds: Vec<ManifoldConstraint<S>>,
    points: Vec<PointConstraint<S>>,
}

pub fn quat<S: HostScalar>(q: [f64; 4]) -> Quat<S> {
    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|x| S::unit(x / length));
    Quat::normalize(w, x, y, z).expect("a rotation")
}

pub fn mass<S: HostScalar>(mass: f64, moments: [f64; 3]) -> MassProperties<S> {
    MassProperties::from_inverses(S::scaled(1.0 / mass), moments.map(|i| S::scaled(1.0 / i))).expect("a mass")
}

/// A solid sphere's or box's mass and moments.
pub fn solid<S: HostScalar>(m: f64, shape: Shape) -> MassProperties<S> {
    match shape {
        Shape::Sphere(r) => mass(m, [0.4 * m * r * r; 3]),
        Shape::Cuboid([x, y, z]) => {
            mass(m, [y * y + z * z, x * x + z * z, x * x + y * y].map(|square| m / 3.0 * square))
        }
        Shape::HalfSpace(_) => panic!("a half-space has no mass"),
    }
}

impl<S: HostScalar> Scene<S> {
    pub fn new(gravity: [f64; 3], seconds: [u16; 2], sub_steps: u8, friction: f64, restitution: f64) -> Self {
        let material = Material::new(number(restitution), number(friction)).expect("a material");
        Self {
            bodies: vec![],
            shapes: vec![],
            settings: Settings::new(vector(gravity), seconds, sub_steps).expect("settings"),
            material,
            dt: f64::from(seconds[0]) / f64::from(seconds[1]),
            margin: 0.005,
            contacts: 0,
            saturated: false,
            touches: vec![],
            held: vec![],
            not_finite: 0,
            kept: vec![],
            motions: vec![],
            manifolds: vec![],
            points: vec![],
        }
    }

    pub fn ground(&mut self, normal: [f64; 3]) {
        self.push(Body::immovable(), Shape::HalfSpace(normal));
    }

    pub fn push(&mut self, body: Body<S>, shape: Shape) -> usize {
        self.bodies.push(body);
        self.shapes.push(shape);
        self.motions.push(Motion::NEW);
        let n = self.bodies.len();
        self.manifolds.resize(4 * n, ManifoldConstraint::NEW);
        self.points.resize(16 * n, PointConstraint::NEW);
        n - 1
    }

    /// A solid of that mass there.
    pub fn solid(&mut self, m: f64, shape: Shape, position: [f64; 3]) -> usize {
        let mut body = Body::dynamic(solid(m, shape));
        body.position = vector(position);
        self.push(body, shape)
    }

    pub fn position(&self, i: usize) -> [f64; 3] {
        floats(self.bodies[i].position)
    }

    pub fn velocity(&self, i: usize) -> [f64; 3] {
        floats(self.bodies[i].linear_velocity)
    }

    pub fn spin(&self, i: usize) -> [f64; 3] {
        floats(self.bodies[i].angular_velocity)
    }

    pub fn orientation(&self, i: usize) -> [f64; 4] {
        self.bodies[i].orientation().to_array().map(S::unit_to_f64)
    }

    pub fn step(&mut self) {
        let buffers = Buffers { motions: &mut self.motions, manifolds: &mut self.manifolds, points: &mut self.points };
        let found = manifolds(&self.bodies, &self.shapes, self.margin, self.dt);
        let mut step = Step::begin(&mut self.bodies, buffers, &self.settings);
        self.held.iter().for_each(|i| step.hold(*i));
        self.contacts = found.iter().map(|(_, manifold)| manifold.points().len()).sum();
        for (pair, manifold) in &found {
            let warm = self.kept.iter().find(|(kept, _)| kept == pair).map_or(&[][..], |(_, warm)| warm);
            assert!(step.add(*pair, manifold, &self.material, warm), "no room");
        }
        let (mut constraints, report) = step.finish();
        self.saturated |= report.saturated;
        self.not_finite += usize::from(report.not_finite);
        self.touches.clear();
        let touches = &mut self.touches;
        constraints.touches(|_, touch| {
            let (impulse, approach) = (S::scaled_to_f64(touch.impulse), touch.approach.to_f64());
            touches.push(Touched { pushed: touch.pushed, impulse, approach });
        });
        self.kept.clear();
        let kept = &mut self.kept;
        constraints.impulses(|index, warm| kept.push((found[index].0, warm.to_vec())));
    }

    pub fn run(&mut self, seconds: f64) {
        for _ in 0..(seconds / self.dt).round() as usize {
            self.step();
        }
    }
}

/// Those of all pairs, in the order of the bodies: within a part of the size, and as far as a step leads where that is
/// farther than the size.
fn manifolds<S: HostScalar>(
    bodies: &[Body<S>],
    shapes: &[Shape],
    margin: f64,
    dt: f64,
) -> Vec<([u16; 2], Manifold<S>)> {
    let length = |v: Vec3<S>| floats(v).iter().map(|x| x * x).sum::<f64>().sqrt();
    let pose = |body: &Body<S>| Pose::new(body.position, body.orientation());
    let mut found = vec![];
    for (i, (a, shape_a)) in bodies.iter().zip(shapes).enumerate() {
        for (j, (b, shape_b)) in bodies.iter().zip(shapes).enumerate().skip(i + 1) {
            let size = shape_a.size().min(shape_b.size());
            let speed = length(b.linear_velocity - a.linear_velocity);
            let way = dt * (speed + (length(a.angular_velocity) + length(b.angular_velocity)) * size);
            let margin = number(margin * size + if way > size && way.is_finite() { way } else { 0.0 });
            let mut manifold = Manifold::empty(UnitVec3::Z);
            shape_a.build::<S>().collide(&pose(a), &shape_b.build(), &pose(b), margin, &mut manifold);
            if !manifold.is_empty() {
                found.push(([i as u16, j as u16], manifold));
            }
        }
    }
    found
}

carom::shapes! {
    /// The shapes of scenes.
    pub enum Piece<S> { Sphere, Cuboid, HalfSpace }
}

impl Shape {
    fn size(&self) -> f64 {
        match self {
            Self::Sphere(r) => *r,
            Self::Cuboid(h) => h.iter().map(|x| x * x).sum::<f64>().sqrt(),
            Self::HalfSpace(_) => f64::INFINITY,
        }
    }

    pub fn build<S: HostScalar>(&self) -> Piece<S> {
        match *self {
            Self::Sphere(r) => Sphere::new(number(r)).expect("a radius").into(),
            Self::Cuboid(h) => Cuboid::new(vector(h)).expect("half extents").into(),
            Self::HalfSpace(n) => {
                HalfSpace::new(UnitVec3::new(Vec3::from_array(n.map(S::unit))).expect("a direction")).into()
            }
        }
    }
}
