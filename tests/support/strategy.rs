//! Impacts of everyday size for `proptest`: a few kilograms, metres and metres per second, that every format can hold.

use std::fmt::Debug;

use carom::{Body, Contact, MassProperties, Quat, UnitVec3, Vec3};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestCaseResult, TestRunner};

use super::cases::{Case, random_case};
use super::format::Format;
use super::random::Random;

/// Runs a property over so many cases, the same ones every time.
pub fn forall<T: Debug>(cases: u32, strategy: impl Strategy<Value = T>, property: impl Fn(T) -> TestCaseResult) {
    let config = Config { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(2), ..Config::default() };
    if let Err(error) = TestRunner::new(config).run(&strategy, property) {
        panic!("{error}");
    }
}

fn triple(range: std::ops::RangeInclusive<f64>) -> impl Strategy<Value = [f64; 3]> {
    [range.clone(), range.clone(), range]
}

fn vector<S: Format>(v: [f64; 3]) -> Vec3<S> {
    Vec3::from_array(v.map(S::nearest))
}

/// What a body is made of, before it is put into a format.
#[derive(Clone, Copy, Debug)]
pub struct BodySketch {
    pub mass: f64,
    /// Radii of gyration of a box with these half edges
    pub half: [f64; 3],
    pub orientation: [f64; 4],
    pub velocity: [f64; 3],
    pub spin: [f64; 3],
}

/// What an impact is made of, before it is put into a format.
#[derive(Clone, Copy, Debug)]
pub struct Sketch {
    pub bodies: [BodySketch; 2],
    pub normal: [f64; 3],
    pub arms: [[f64; 3]; 2],
    pub restitution: f64,
    pub friction: f64,
}

fn body_sketch() -> impl Strategy<Value = BodySketch> {
    let orientation = [-1.0..=1.0, -1.0..=1.0, -1.0..=1.0, 0.1..=1.0];
    (0.25..=4.0, triple(0.3..=1.0), orientation, triple(-4.0..=4.0), triple(-4.0..=4.0))
        .prop_map(|(mass, half, orientation, velocity, spin)| BodySketch { mass, half, orientation, velocity, spin })
}

pub fn sketch() -> impl Strategy<Value = Sketch> {
    let normal = triple(-1.0..=1.0).prop_filter("a direction", |n| n.iter().map(|x| x * x).sum::<f64>() > 0.01);
    ([body_sketch(), body_sketch()], normal, [triple(-1.0..=1.0), triple(-1.0..=1.0)], 0.0..=1.0, 0.0..=1.5).prop_map(
        |(bodies, normal, arms, restitution, friction)| Sketch { bodies, normal, arms, restitution, friction },
    )
}

impl BodySketch {
    pub fn build<S: Format>(&self) -> Body<S> {
        self.place(Body::dynamic(self.mass()))
    }

    /// The same body with its rotation locked.
    pub fn build_locked<S: Format>(&self) -> Body<S> {
        self.place(Body::dynamic(self.mass().with_locked_rotation()))
    }

    fn mass<S: Format>(&self) -> MassProperties<S> {
        let square = self.half.map(|h| h * h / 3.0);
        let moments = [square[1] + square[2], square[0] + square[2], square[0] + square[1]];
        let scaled = S::nearest_scaled;
        let inverse = moments.map(|k| scaled(1.0 / (self.mass * k)));
        MassProperties::from_inverses(scaled(1.0 / self.mass), inverse).expect("a body")
    }

    fn place<S: Format>(&self, mut body: Body<S>) -> Body<S> {
        body.linear_velocity = vector(self.velocity);
        body.angular_velocity = vector(self.spin);
        body.set_orientation(quaternion::<S>(self.orientation));
        body
    }
}

pub fn quaternion<S: Format>(q: [f64; 4]) -> Quat<S> {
    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|x| S::nearest_unit(x / length));
    Quat::normalize(w, x, y, z).expect("a rotation")
}

impl Sketch {
    pub fn build<S: Format>(&self) -> Case<S> {
        let length = self.normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        let normal = UnitVec3::new(Vec3::from_array(self.normal.map(|x| S::nearest_unit(x / length))));
        let [r_a, r_b] = self.arms.map(vector);
        Case {
            a: self.bodies[0].build(),
            b: self.bodies[1].build(),
            contact: Contact { normal: normal.expect("a direction"), r_a, r_b },
            restitution: S::nearest(self.restitution),
            friction: S::nearest(self.friction),
        }
    }
}

/// Everyday impacts in a format.
pub fn everyday<S: Format>() -> impl Strategy<Value = Case<S>> {
    sketch().prop_map(|sketch| sketch.build())
}

/// Impacts of any size, from a seed.
pub fn any_size<S: Format>() -> impl Strategy<Value = Case<S>> {
    any::<u64>().prop_map(|seed| random_case(&mut Random::new(seed)))
}

pub type Turn<const N: usize> = Box<dyn Fn([f64; N]) -> [f64; N]>;

/// A rotation of vectors, and of orientations, in f64.
pub fn rotations(q: [f64; 4]) -> (Turn<3>, Turn<4>) {
    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|c| c / length);
    let cross =
        |a: [f64; 3], b: [f64; 3]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let turn = move |v: [f64; 3]| {
        let t = cross([x, y, z], v).map(|c| 2.0 * c);
        let s = cross([x, y, z], t);
        [v[0] + w * t[0] + s[0], v[1] + w * t[1] + s[1], v[2] + w * t[2] + s[2]]
    };
    let compose = move |[a, b, c, d]: [f64; 4]| {
        [
            w * a - x * b - y * c - z * d,
            w * b + x * a + y * d - z * c,
            w * c - x * d + y * a + z * b,
            w * d + x * c - y * b + z * a,
        ]
    };
    (Box::new(turn), Box::new(compose))
}
