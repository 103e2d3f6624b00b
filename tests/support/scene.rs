//! Bodies and contacts over time, by the solver alone: a few pairs of shapes by hand.
#![allow(dead_code)]

use carom::solver::{Buffers, ManifoldConstraint, Motion, PointConstraint, Settings, Step, WarmStart};
use carom::{Body, FeatureId, Manifold, ManifoldPoint, MassProperties, Material, Quat, Scalar, UnitVec3, Vec3};

use crate::host::HostScalar;

/// What a body looks like.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Sphere(f64),
    /// Half edges.
    Cuboid([f64; 3]),
    /// Everything below the plane through the origin of the body, with the normal in its frame.
    HalfSpace([f64; 3]),
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
    kept: Vec<([u16; 2], Vec<WarmStart<S>>)>,
    motions: Vec<Motion<S>>,
    manifolds: Vec<ManifoldConstraint<S>>,
    points: Vec<PointConstraint<S>>,
}

pub fn number<S: HostScalar>(x: f64) -> S {
    S::from_f64(x).expect("a number within the format")
}

pub fn vector<S: HostScalar>(v: [f64; 3]) -> Vec3<S> {
    Vec3::from_array(v.map(number))
}

pub fn floats<S: HostScalar>(v: Vec3<S>) -> [f64; 3] {
    v.to_array().map(S::to_f64)
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
        let buffers =
            Buffers { motions: &mut self.motions, manifolds: &mut self.manifolds, points: &mut self.points };
        let found = manifolds(&self.bodies, &self.shapes, self.margin, self.dt);
        let mut step = Step::begin(&mut self.bodies, buffers, &self.settings);
        self.contacts = found.iter().map(|(_, manifold)| manifold.points().len()).sum();
        for (pair, manifold) in &found {
            let warm = self.kept.iter().find(|(kept, _)| kept == pair).map_or(&[][..], |(_, warm)| warm);
            assert!(step.add(*pair, manifold, &self.material, warm), "no room");
        }
        let (mut constraints, report) = step.finish();
        self.saturated |= report.saturated;
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

/// Those of all pairs, in the order of the bodies.
fn manifolds<S: HostScalar>(
    bodies: &[Body<S>],
    shapes: &[Shape],
    margin: f64,
    dt: f64,
) -> Vec<([u16; 2], Manifold<S>)> {
    let mut found = vec![];
    for (i, (a, shape_a)) in bodies.iter().zip(shapes).enumerate() {
        for (j, (b, shape_b)) in bodies.iter().zip(shapes).enumerate().skip(i + 1) {
            let manifold = match (*shape_a, *shape_b) {
                (Shape::HalfSpace(n), Shape::Sphere(r)) => Some(half_space_sphere(a, n, b, r, margin, dt)),
                (Shape::HalfSpace(n), Shape::Cuboid(h)) => Some(half_space_cuboid(a, n, b, h, margin, dt)),
                (Shape::Sphere(r), Shape::Sphere(s)) => sphere_sphere(a, r, b, s, margin, dt),
                _ => None,
            };
            if let Some(manifold) = manifold.filter(|manifold| !manifold.points().is_empty()) {
                found.push(([i as u16, j as u16], manifold));
            }
        }
    }
    found
}

/// Within a part of the size; and as far as a step leads where that is farther than the size.
fn reach<S: HostScalar>(a: &Body<S>, b: &Body<S>, size: f64, margin: f64, dt: f64) -> S {
    let length = |v: Vec3<S>| floats(v).iter().map(|x| x * x).sum::<f64>().sqrt();
    let way = dt * (length(b.linear_velocity - a.linear_velocity) + length(b.angular_velocity) * size);
    number(margin * size + if way > size { way } else { 0.0 })
}

fn half<S: HostScalar>() -> S {
    number(0.5)
}

fn half_space_sphere<S: HostScalar>(
    a: &Body<S>,
    n: [f64; 3],
    b: &Body<S>,
    r: f64,
    margin: f64,
    dt: f64,
) -> Manifold<S> {
    let normal = UnitVec3::<S>::new(Vec3::from_array(n.map(S::unit))).expect("a normal");
    let mut manifold = Manifold::empty(normal);
    let between = b.position - a.position;
    let radius = number::<S>(r);
    let separation = S::dot3_unit(between.to_array(), normal.get().to_array()).minus(radius);
    if separation < reach(a, b, r, margin, dt) {
        let r_b = normal.times(radius.plus(separation.times(half()))) * number(-1.0);
        manifold.push(ManifoldPoint { r_a: between + r_b, r_b, separation, feature: FeatureId(0) });
    }
    manifold
}

fn half_space_cuboid<S: HostScalar>(
    a: &Body<S>,
    n: [f64; 3],
    b: &Body<S>,
    h: [f64; 3],
    margin: f64,
    dt: f64,
) -> Manifold<S> {
    let normal = UnitVec3::<S>::new(Vec3::from_array(n.map(S::unit))).expect("a normal");
    let between = b.position - a.position;
    let size = h.iter().map(|x| x * x).sum::<f64>().sqrt();
    let reach = reach(a, b, size, margin, dt);
    let mut points = vec![];
    for corner in 0..8u16 {
        let sign = |bit: u16| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
        let arm = b.orientation().rotate(vector([h[0] * sign(0), h[1] * sign(1), h[2] * sign(2)]));
        let separation = S::dot3_unit((between + arm).to_array(), normal.get().to_array());
        if separation < reach {
            let r_b = arm - normal.times(separation.times(half()));
            points.push(ManifoldPoint { r_a: between + r_b, r_b, separation, feature: FeatureId(corner) });
        }
    }
    // The four lowest.
    points.sort_by(|p, q| p.separation.partial_cmp(&q.separation).expect("numbers"));
    points.truncate(4);
    points.sort_by_key(|p| p.feature.0);
    let mut manifold = Manifold::empty(normal);
    for point in points {
        manifold.push(point);
    }
    manifold
}

fn sphere_sphere<S: HostScalar>(a: &Body<S>, r: f64, b: &Body<S>, s: f64, margin: f64, dt: f64) -> Option<Manifold<S>> {
    let between = b.position - a.position;
    let normal = UnitVec3::normalize(between).ok()?;
    let (radius_a, radius_b) = (number::<S>(r), number::<S>(s));
    let separation = between.length().minus(radius_a).minus(radius_b);
    let mut manifold = Manifold::empty(normal);
    if separation < reach(a, b, r.min(s), margin, dt) {
        let r_a = normal.times(radius_a.plus(separation.times(half())));
        manifold.push(ManifoldPoint { r_a, r_b: r_a - between, separation, feature: FeatureId(0) });
    }
    Some(manifold)
}
