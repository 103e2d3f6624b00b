//! Manifolds: points that lie on both surfaces, mirrored and turned with the shapes, with names that last.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/host.rs"]
mod host;
#[path = "support/random.rs"]
mod random;
#[path = "support/scalars.rs"]
mod scalars;
#[path = "support/solids.rs"]
mod solids;
#[allow(dead_code)]
#[path = "../examples/validate/tool/mod.rs"]
mod tool;

use std::collections::BTreeSet;

use carom::{Collide, Manifold, Pose, UnitVec3};
use host::{HostScalar, floats};
use random::Random;
use scalars::NUMBERS;
use solids::{PAIRS, height, orientation, round, shape, times};
use tool::geometry::{Placed, Shape, Solid};
use tool::number::Job;
use tool::vector::{Vector, add, cross, dot, norm, rotation, scale, sub};

/// The kernel's view of two shapes.
struct Scene<S: HostScalar>([(Solid<'static, S>, Pose<S>); 2]);

impl<S: HostScalar> Scene<S> {
    fn new(shapes: &[Placed; 2]) -> Self {
        Self(shapes.map(|placed| placed.for_kernel(None).expect("it fits")))
    }

    /// Boxes as hulls, planes as flat height fields, which stay for the rest of the test.
    fn disguised(shapes: &[Placed; 2]) -> Self {
        Self(shapes.map(|placed| {
            let disguise = Box::leak(Box::new(placed.disguise(8.0).expect("it fits")));
            placed.for_kernel(Some(disguise)).expect("it fits")
        }))
    }

    fn made(disguised: bool, shapes: &[Placed; 2]) -> Self {
        if disguised { Self::disguised(shapes) } else { Self::new(shapes) }
    }

    fn manifold(&self, margin: f64) -> Option<Manifold<S>> {
        let [(a, pose_a), (b, pose_b)] = &self.0;
        let mut manifold = Manifold::empty(UnitVec3::Z);
        a.collide(pose_a, b, pose_b, S::from_f64(margin).expect("it fits"), &mut manifold);
        (!manifold.is_empty()).then_some(manifold)
    }

    fn swapped(&self, margin: f64) -> Option<Manifold<S>> {
        let [a, b] = self.0;
        Self([b, a]).manifold(margin)
    }
}

fn normal<S: HostScalar>(manifold: &Manifold<S>) -> Vector {
    manifold.normal.get().to_array().map(S::unit_to_f64)
}

/// Two shapes nearly touching, in numbers that every format holds exactly.
fn touching<S: HostScalar>((a, b): (usize, usize), random: &mut Random) -> [Placed; 2] {
    let position = round([0, 1, 2].map(|_| random.between(-1.0, 1.0)));
    let first = Placed { shape: shape(a, random), position, orientation: orientation(random) };
    let start = add(position, scale(3.0, random.direction()));
    let mut second = Placed { shape: shape(b, random), position: round(start), orientation: orientation(random) };
    let wanted = random.between(-0.02, 0.02);
    for _ in 0..20 {
        let [(a, pose_a), (b, pose_b)] = Scene::<S>::new(&[first, second]).0;
        let closest = a.closest(&pose_a, &b, &pose_b).expect("they can meet");
        let n = closest.normal.get().to_array().map(S::unit_to_f64);
        let way = wanted - closest.separation.to_f64();
        second.position = round(add(second.position, scale(way, n)));
        if way.abs() < 1e-3 {
            break;
        }
    }
    [first, second]
}

/// Units of the last place, of numbers up to 4: a dozen roundings.
fn allowance<S: HostScalar>() -> f64 {
    // micromath's root is off by 1.6e-6 of a length.
    16.0 * S::spacing(4.0) + if S::from_f64(2.0).expect("fits").sqrt().to_f64() == 2.0_f64.sqrt() { 0.0 } else { 5e-6 }
}

/// With shapes as they are, or disguised.
struct OnBothSurfaces(bool);

impl Job for OnBothSurfaces {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut counts = [0; 5];
        let mut random = Random::new(1);
        for pair in PAIRS {
            for case in 0..300 {
                let shapes = touching::<S>(pair, &mut random);
                let scene = Scene::<S>::made(self.0, &shapes);
                let Some(manifold) = scene.manifold(0.05) else { continue };
                let points = manifold.points();
                counts[points.len()] += 1;
                let n = normal(&manifold);
                let tolerance = allowance::<S>();
                let least = points.iter().map(|point| point.separation.to_f64()).fold(f64::INFINITY, f64::min);
                let [(a, pose_a), (b, pose_b)] = &scene.0;
                let closest = a.closest(pose_a, b, pose_b).expect("they can meet").separation.to_f64();
                // A capsule lies along a face up to 3.6 degrees, and its lowest points below its ends; edges and corners of boxes
                // are as deep as faces to within a thousandth; and apart, the edges that separate them best may end before they
                // meet.
                let depth = match pair {
                    (1, 1 | 2) if points.len() > 1 => 1.0 / 256.0,
                    (2, 2) if closest > 0.0 && points.len() == 1 => {
                        1e-3 + (closest * closest - least * least).max(0.0).sqrt()
                    }
                    (2, 2) => 1e-3,
                    _ => 0.0,
                };
                let mut features = BTreeSet::new();
                for point in points {
                    assert!(features.insert(point.feature.0), "{pair:?} {case}: each point has a name of its own");
                    let middle = add(shapes[0].position, floats(point.r_a));
                    let other = add(shapes[1].position, floats(point.r_b));
                    assert!(norm(sub(middle, other)) <= tolerance, "{pair:?} {case}: {middle:?} {other:?}");
                    let separation = point.separation.to_f64();
                    assert!(separation <= 0.05);
                    // What is below the end of a leaning capsule that is higher lies in the capsule.
                    let depth = depth + if pair.0 == 1 { separation - least } else { 0.0 };
                    for (placed, sign) in shapes.iter().zip([-0.5, 0.5]) {
                        let surface = add(middle, scale(sign * separation, n));
                        let off = height(placed, surface).abs();
                        assert!(
                            off <= tolerance + depth,
                            "{pair:?} {case}: {off:e} from a surface, {manifold:?} {shapes:?}"
                        );
                    }
                }
                // Between corners of polytopes the separation along the best axis may be less than the distance.
                let slack = if pair == (2, 2) && closest > 0.0 { 0.03 } else { tolerance + depth };
                assert!((least - closest).abs() <= slack, "{pair:?} {case}: {least} of {closest}");
            }
        }
        assert!(counts.iter().skip(1).all(|&count| count > 20) && counts[0] == 0, "{counts:?}");
        assert!(counts.iter().sum::<usize>() > 2500, "{counts:?}");
    }
}

#[test]
fn points_lie_on_both_surfaces() {
    for &number in NUMBERS {
        for disguised in [false, true] {
            scalars::run(number, OnBothSurfaces(disguised));
        }
    }
}

fn mirrored<S: HostScalar>(mut manifold: Manifold<S>) -> Manifold<S> {
    manifold.swap();
    manifold
}

/// With shapes as they are, or disguised.
struct Mirrored(bool);

impl Job for Mirrored {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(2);
        let mut compared = 0;
        for pair in PAIRS {
            for _ in 0..300 {
                let scene = Scene::<S>::made(self.0, &touching::<S>(pair, &mut random));
                assert_eq!(scene.swapped(0.05), scene.manifold(0.05).map(mirrored), "{pair:?}");
                let [(a, pose_a), (b, pose_b)] = &scene.0;
                let (there, back) = (a.closest(pose_a, b, pose_b), b.closest(pose_b, a, pose_a));
                assert_eq!(there, back.map(|closest| closest.swapped()), "{pair:?}");
                compared += usize::from(scene.manifold(0.05).is_some());
            }
        }
        assert!(compared > 2500, "{compared}");
    }
}

/// To the last bit.
#[test]
fn shapes_in_the_other_order_give_the_mirrored_manifold() {
    for &number in NUMBERS {
        for disguised in [false, true] {
            scalars::run(number, Mirrored(disguised));
        }
    }
}

struct Moved;

impl Job for Moved {
    type Output = ();
    fn run<S: HostScalar>(self) {
        // Far out, in numbers that the format still holds exactly.
        let far = if S::spacing(64.0) == S::spacing(1.0) { 48.0 } else { 0.0 };
        let mut random = Random::new(3);
        for pair in PAIRS {
            for _ in 0..50 {
                let shapes = touching::<S>(pair, &mut random);
                let away = shapes.map(|mut placed| {
                    placed.position = add(placed.position, [far, -far, far]);
                    placed
                });
                assert_eq!(Scene::<S>::new(&shapes).manifold(0.05), Scene::<S>::new(&away).manifold(0.05), "{pair:?}");
            }
        }
    }
}

/// In fixed point to the last bit.
#[test]
fn far_from_the_origin_the_manifold_is_the_same() {
    for &number in NUMBERS {
        scalars::run(number, Moved);
    }
}

/// With shapes as they are, or disguised.
struct Turned(bool);

impl Job for Turned {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(4);
        let (mut compared, mut others) = (0, 0);
        for pair in PAIRS {
            for _ in 0..200 {
                let shapes = touching::<S>(pair, &mut random);
                let q = orientation(&mut random);
                let r = rotation(q);
                let turn = |v: Vector| r.map(|row| dot(row, v));
                let turned = shapes.map(|placed| Placed {
                    position: turn(placed.position),
                    orientation: times(q, placed.orientation),
                    ..placed
                });
                let (before, after) = (
                    Scene::<S>::made(self.0, &shapes).manifold(0.05),
                    Scene::<S>::made(self.0, &turned).manifold(0.05),
                );
                let (Some(before), Some(after)) = (before, after) else {
                    others += usize::from(before.is_some() != after.is_some());
                    continue;
                };
                compared += 1;
                let tolerance = 4.0 * allowance::<S>();
                let same = norm(sub(turn(normal(&before)), normal(&after))) < 0.01 + 100.0 * tolerance
                    && before.points().len() == after.points().len()
                    && before.points().iter().all(|p| {
                        let (place, separation) = (turn(floats(p.r_a)), p.separation.to_f64());
                        after.points().iter().any(|q| {
                            norm(sub(place, floats(q.r_a))) < 1e-3 + 100.0 * tolerance
                                && (q.separation.to_f64() - separation).abs() < tolerance
                        })
                    });
                others += usize::from(!same);
            }
        }
        // Where two axes separate as well as each other, or a point is just at the margin, rounding decides.
        println!("{others} of {compared} otherwise");
        assert!(compared > 1500 && others * 50 < compared, "{others} of {compared}");
    }
}

#[test]
fn the_manifold_turns_with_the_shapes() {
    for &number in NUMBERS {
        for disguised in [false, true] {
            scalars::run(number, Turned(disguised));
        }
    }
}

/// With shapes as they are, or disguised.
struct Lasting(bool);

impl Job for Lasting {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(5);
        let (mut compared, mut lost) = (0, 0);
        for pair in PAIRS {
            for _ in 0..200 {
                let shapes = touching::<S>(pair, &mut random);
                let before = Scene::<S>::made(self.0, &shapes).manifold(0.05);
                // A thousandth of a step, and a thousandth of a radian.
                let mut moved = shapes;
                moved[1].position = add(moved[1].position, scale(2e-4, random.direction()));
                let [x, y, z] = scale(2e-4, random.direction());
                moved[1].orientation = times([1.0, x, y, z], moved[1].orientation);
                let after = Scene::<S>::made(self.0, &moved).manifold(0.05);
                let (Some(before), Some(after)) = (before, after) else { continue };
                for point in before.points().iter().filter(|point| point.separation.to_f64() < 0.04) {
                    compared += 1;
                    let same = after.points().iter().find(|other| other.feature == point.feature);
                    let near = same.is_some_and(|other| norm(sub(floats(other.r_b), floats(point.r_b))) < 0.05);
                    lost += usize::from(!near);
                }
            }
        }
        println!("{lost} of {compared} lost");
        assert!(
            compared > 1500 && lost * 50 < compared,
            "{lost} of {compared} points lost their name, or took another's"
        );
    }
}

#[test]
fn a_small_motion_leaves_the_points_their_names() {
    for &number in NUMBERS {
        for disguised in [false, true] {
            scalars::run(number, Lasting(disguised));
        }
    }
}

fn cuboid(half: Vector, position: Vector, orientation: [f64; 4]) -> Placed {
    Placed { shape: Shape::Box { half }, position, orientation }
}

struct Resting;

impl Job for Resting {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let level = [1.0, 0.0, 0.0, 0.0];
        // A small box on a corner of a large one, 1/256 deep: the overlap reaches from -1/4 to 1/2 and from 1/8 to 1.
        let large = cuboid([0.5, 1.0, 0.5], [0.0; 3], level);
        let small = cuboid([0.5, 0.5, 0.25], [0.25, 0.625, 0.75 - 1.0 / 256.0], level);
        let manifold = Scene::<S>::new(&[large, small]).manifold(0.0).expect("they touch");
        assert_eq!(normal(&manifold), [0.0, 0.0, 1.0]);
        let mut corners: Vec<Vector> = manifold.points().iter().map(|point| floats(point.r_a)).collect();
        corners.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
        let z = 0.5 - 1.0 / 512.0;
        assert_eq!(corners, [[-0.25, 0.125, z], [-0.25, 1.0, z], [0.5, 0.125, z], [0.5, 1.0, z]]);
        assert!(manifold.points().iter().all(|point| point.separation.to_f64() == -1.0 / 256.0));
        // Turned by 45 degrees on a face of its own size, the overlap is an octagon: four points far apart are kept.
        let half = std::f64::consts::FRAC_PI_8;
        let turned = cuboid([0.5; 3], [0.0, 0.0, 1.0], [half.cos(), 0.0, 0.0, half.sin()]);
        let manifold =
            Scene::<S>::new(&[cuboid([0.5; 3], [0.0; 3], level), turned]).manifold(0.01).expect("they touch");
        let places: Vec<Vector> = manifold.points().iter().map(|point| floats(point.r_a)).collect();
        assert_eq!(places.len(), 4);
        let area = 0.5 * norm(cross(sub(places[2], places[0]), sub(places[3], places[1])));
        assert!(area > 0.55, "of 0.83 in all: {area}");
        // Two edges that cross: one point, where they do.
        let x = half;
        let about_x = cuboid([0.5; 3], [0.0; 3], [x.cos(), x.sin(), 0.0, 0.0]);
        let top = 2.0 * 0.5_f64.sqrt() - 1.0 / 256.0;
        let about_y = cuboid([0.5; 3], [0.125, 0.25, top], [x.cos(), 0.0, x.sin(), 0.0]);
        let manifold = Scene::<S>::new(&[about_x, about_y]).manifold(0.01).expect("they touch");
        let [point] = manifold.points() else { panic!("{manifold:?}") };
        let expected = [0.125, 0.0, 0.5_f64.sqrt() - 1.0 / 512.0];
        assert!(norm(sub(normal(&manifold), [0.0, 0.0, 1.0])) < 1e-6, "{manifold:?}");
        assert!(norm(sub(floats(point.r_a), expected)) < allowance::<S>(), "{manifold:?}");
        assert!((point.separation.to_f64() + 1.0 / 256.0).abs() < allowance::<S>());
        // A capsule lying on a box: two points, at its end and at the edge of the box.
        let lying = Placed {
            shape: Shape::Capsule { radius: 0.25, half: 1.0 },
            position: [0.75, 0.0, 0.75],
            orientation: [0.5_f64.sqrt(), 0.0, 0.5_f64.sqrt(), 0.0],
        };
        let manifold = Scene::<S>::new(&[lying, cuboid([0.5; 3], [0.0; 3], level)]).manifold(0.01).expect("they touch");
        let mut places: Vec<f64> = manifold.points().iter().map(|point| floats(point.r_b)[0]).collect();
        places.sort_by(f64::total_cmp);
        assert_eq!(places.len(), 2, "{manifold:?}");
        assert!((places[0] + 0.25).abs() < 1e-4 && (places[1] - 0.5).abs() < 1e-4, "{places:?}");
    }
}

#[test]
fn boxes_rest_on_the_corners_of_the_overlap() {
    for &number in NUMBERS {
        scalars::run(number, Resting);
    }
}
