//! Masses of several solids: against the same tensor from point masses, in f64.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/host.rs"]
mod host;
#[path = "support/random.rs"]
mod random;
#[path = "support/scalars.rs"]
mod scalars;
#[allow(dead_code)]
#[path = "../examples/validate/tool/mod.rs"]
mod tool;

use carom::{Assembly, Body, Cuboid, MassError, Part, Pose, Quat, Scaled, Solid, SolidPart, Sphere, Vec3};
use host::{HostScalar, floats, number, vector};
use random::Random;
use scalars::NUMBERS;
use tool::number::Job;
use tool::vector::{Vector, add, dot, rotation, scale, sub};

type Tensor = [Vector; 3];

/// A solid as point masses that have its first and second moments: a box by the corners of one smaller by the root of 3, a ball by
/// six points.
#[derive(Clone, Copy, Debug)]
enum Kind {
    Box(Vector),
    Ball(f64),
}

impl Kind {
    fn points(self) -> Vec<Vector> {
        match self {
            Self::Box(half) => {
                let sign = |k: usize, axis: usize| if k >> axis & 1 == 1 { -1.0 } else { 1.0 };
                (0..8).map(|k| [0, 1, 2].map(|axis| sign(k, axis) * half[axis] / 3.0_f64.sqrt())).collect()
            }
            Self::Ball(radius) => (0..6)
                .map(|k| {
                    let mut point = [0.0; 3];
                    point[k / 2] = if k % 2 == 0 { 1.0 } else { -1.0 } * radius * 0.6_f64.sqrt();
                    point
                })
                .collect(),
        }
    }

    fn solid<S: HostScalar>(self) -> Solid<S> {
        match self {
            Self::Box(half) => Solid::cuboid(vector(half)).expect("a box"),
            Self::Ball(radius) => Solid::sphere(number(radius)).expect("a ball"),
        }
    }
}

/// Mass, place and orientation of a solid.
type Item = (Kind, f64, Vector, [f64; 4]);

fn points(items: &[Item]) -> Vec<(f64, Vector)> {
    let mut all = vec![];
    for (kind, mass, position, orientation) in items {
        let (r, own) = (rotation(*orientation), kind.points());
        let share = mass / own.len() as f64;
        all.extend(own.iter().map(|p| (share, add(*position, r.map(|row| dot(row, *p))))));
    }
    all
}

fn centre(points: &[(f64, Vector)]) -> (f64, Vector) {
    let mass: f64 = points.iter().map(|(m, _)| m).sum();
    (mass, scale(1.0 / mass, points.iter().fold([0.0; 3], |sum, (m, p)| add(sum, scale(*m, *p)))))
}

fn tensor(points: &[(f64, Vector)], about: Vector) -> Tensor {
    let mut sum = [[0.0; 3]; 3];
    for (m, p) in points {
        let d = sub(*p, about);
        for (i, row) in sum.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry += m * (f64::from(u8::from(i == j)) * dot(d, d) - d[i] * d[j]);
            }
        }
    }
    sum
}

/// Sizes, masses and poses that every format holds exactly.
fn rounded(x: f64) -> f64 {
    (x * 4096.0).round() / 4096.0
}

struct Sums;

impl Job for Sums {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(1);
        // Some roundings of intermediate numbers, and of directions; micromath's root has fewer digits.
        let epsilon = S::scaled_to_f64(S::Scaled::EPSILON);
        let root = S::scaled_to_f64(S::Scaled::from_parts(2, 0).sqrt());
        let bound = f64::max(32.0 * epsilon, if (root - 2.0_f64.sqrt()).abs() > 2.0 * epsilon { 1e-5 } else { 0.0 });
        let mut worst = 0.0_f64;
        for case in 0..400 {
            let items: Vec<Item> = (0..1 + case % 5)
                .map(|k| {
                    let mut size = || rounded(random.between(0.05, 0.5));
                    let kind = if k % 2 == 0 { Kind::Box([size(), size(), size()]) } else { Kind::Ball(size()) };
                    let place = [0, 1, 2].map(|_| rounded(random.between(-1.0, 1.0)));
                    let q: [f64; 4] = std::array::from_fn(|_| random.between(-1.0, 1.0));
                    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
                    (kind, rounded(random.between(0.1, 3.0)), place, q.map(|x| x / length))
                })
                .collect();
            let parts: Vec<_> = items
                .iter()
                .map(|(kind, mass, position, q)| {
                    let q = Quat::new(S::unit(q[0]), S::unit(q[1]), S::unit(q[2]), S::unit(q[3])).expect("a rotation");
                    SolidPart::with_mass(&kind.solid::<S>(), number(*mass), Pose::new(vector(*position), q))
                        .expect("a part")
                })
                .collect();
            let Assembly { mass_properties, frame } = Assembly::new(&parts).expect("a body");
            let all = points(&items);
            let (mass, middle) = centre(&all);
            let body = Body::dynamic(mass_properties);
            assert!((S::scaled_to_f64(body.inv_mass()) * mass - 1.0).abs() < 1e-6);
            for (found, right) in floats(frame.position).into_iter().zip(middle) {
                assert!((found - right).abs() <= S::spacing(1.0) + 1e-7, "{found} of {right}");
            }
            // R diag(I) R^T is the tensor of the points about that place.
            let right = tensor(&all, floats(frame.position));
            let size = right[0][0] + right[1][1] + right[2][2];
            let [xx, xy, xz, yy, yz, zz] = body.inv_inertia_local().map(S::scaled_to_f64);
            assert_eq!([xy, xz, yz], [0.0; 3], "principal axes");
            let moments = [xx, yy, zz].map(|x| 1.0 / x);
            let r = frame.rotation.rows.map(|row| row.to_array().map(S::unit_to_f64));
            for i in 0..3 {
                for j in 0..3 {
                    let found: f64 = (0..3).map(|k| r[i][k] * moments[k] * r[j][k]).sum();
                    worst = worst.max((found - right[i][j]).abs() / size);
                }
            }
            let determinant = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1])
                - r[0][1] * (r[1][0] * r[2][2] - r[1][2] * r[2][0])
                + r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
            assert!((determinant - 1.0).abs() < 1e-5, "a rotation: {determinant}");
        }
        println!("{}: {worst:.1e} of {bound:.1e}", std::any::type_name::<S>());
        assert!(worst < bound, "{worst:e}, more than {bound:e}");
    }
}

#[test]
fn solids_add_up_as_their_points_do() {
    for &number in NUMBERS {
        scalars::run(number, Sums);
    }
}

struct Known;

impl Job for Known {
    type Output = ();
    fn run<S: HostScalar>(self) {
        // A box of eight is the box.
        let half = [0.5, 0.25, 0.375];
        let small = Solid::cuboid(vector::<S>(scale(0.5, half))).expect("a box");
        let sign = |k: usize, axis: usize| if k >> axis & 1 == 1 { 0.5 } else { -0.5 };
        let parts = [0, 1, 2, 3, 4, 5, 6, 7].map(|k: usize| {
            let place = [0, 1, 2].map(|axis| 1.0 + sign(k, axis) * half[axis]);
            SolidPart::with_density(&small, number(2.0), Pose::at(vector(place))).expect("a part")
        });
        let whole = Solid::cuboid(vector::<S>(half)).expect("a box").with_density(number(2.0)).expect("a mass");
        let eight = Assembly::new(&parts).expect("a body");
        assert_eq!(eight.frame, Pose::at(vector([1.0; 3])), "the axes stay as they are");
        let [one, eight_] = [Body::dynamic(whole), Body::dynamic(eight.mass_properties)];
        let all = |body: &Body<S>| {
            let mut all = vec![S::scaled_to_f64(body.inv_mass())];
            all.extend(body.inv_inertia_local().map(S::scaled_to_f64));
            all
        };
        for (a, b) in all(&one).into_iter().zip(all(&eight_)) {
            assert!((a - b).abs() <= 1e-6 * a.abs(), "{a} {b}");
        }
        // Its shape follows, into the frame of the body.
        let part = Part { pose: parts[3].pose, shape: Cuboid::new(vector::<S>(scale(0.5, half))).expect("a box") };
        assert_eq!(floats(part.seen_from(&eight.frame).pose.position), [0.25, 0.125, -0.1875]);
        // An L of two boxes: by hand. Legs of 1 kg, 2 x 0.5 x 0.5 at the origin and 0.5 x 2 x 0.5 at (0.75, 1.25, 0).
        let leg = |half: Vector, at: Vector| {
            let solid = Solid::cuboid(vector::<S>(half)).expect("a box");
            SolidPart::with_mass(&solid, S::ONE, Pose::at(vector(at))).expect("a part")
        };
        let bent = Assembly::new(&[leg([1.0, 0.25, 0.25], [0.0; 3]), leg([0.25, 1.0, 0.25], [0.75, 1.25, 0.0])]);
        let bent = bent.expect("a body");
        assert_eq!(floats(bent.frame.position), [0.375, 0.625, 0.0]);
        // I_zz = 2 (1/3 (1 + 1/16)) + 2 (0.375^2 + 0.625^2).
        let zz = 2.0 * (17.0 / 48.0) + 2.0 * (0.140_625 + 0.390_625);
        let body = Body::dynamic(bent.mass_properties);
        assert!((S::scaled_to_f64(body.inv_inertia_local()[5]) * zz - 1.0).abs() < 1e-5);
        // The principal axes lie across: tan 2a = 2 I_xy / (I_xx - I_yy), with I_xy = -2 x 0.375 x 0.625.
        let xx = 0.125 / 3.0 + 1.0625 / 3.0 + 2.0 * 0.390_625;
        let yy = 1.0625 / 3.0 + 0.125 / 3.0 + 2.0 * 0.140_625;
        let angle = 0.5 * (2.0 * -0.468_75_f64).atan2(xx - yy);
        let axis = frame_axis(&bent, 0);
        let along = (axis[0] * angle.cos() + axis[1] * angle.sin()).abs();
        assert!((along - 1.0).abs() < 1e-5 || along < 1e-2, "{axis:?}, {angle}");
        assert!(axis[2].abs() < 1e-6 && axis[0].abs() > 0.1 && axis[1].abs() > 0.1, "turned: {axis:?}");
        // Nothing, and what is no number.
        assert_eq!(Assembly::<S>::new(&[]).err(), Some(MassError::Mass));
        let endless = S::ONE.over(S::ZERO);
        let ball = Sphere::new(S::ONE).expect("a ball").solid().expect("a solid");
        if !endless.is_finite() {
            let away =
                SolidPart::with_mass(&ball, S::ONE, Pose::at(Vec3::new(endless, S::ZERO, S::ZERO))).expect("a mass");
            assert_eq!(Assembly::new(&[away]).err(), Some(MassError::Inertia));
        }
        assert_eq!(SolidPart::with_mass(&ball, S::ZERO, Pose::IDENTITY).err(), Some(MassError::Mass));
        assert_eq!(SolidPart::with_density(&ball, S::ZERO, Pose::IDENTITY).err(), Some(MassError::Density));
    }
}

/// An axis of the body in the parts' frame.
fn frame_axis<S: HostScalar>(assembly: &Assembly<S>, axis: usize) -> Vector {
    assembly.frame.rotation.rows.map(|row| S::unit_to_f64(row.to_array()[axis]))
}

#[test]
fn known_bodies_come_out() {
    for &number in NUMBERS {
        scalars::run(number, Known);
    }
}
