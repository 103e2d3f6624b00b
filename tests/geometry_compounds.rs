//! Several shapes on one body: against the one shape that they make, against their parts in f64, in both orders.
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

use std::cell::Cell;
use std::collections::BTreeSet;

use carom::{
    Aabb, Closest, Collide, Compound, CompoundError, Cuboid, HalfSpace, HeightField, Manifold, ManifoldSink, Part,
    Pose, Ray, RayHit, Shape as _, Sphere, SurfacePoint, UnitVec3, Vec3,
};
use host::{HostScalar, direction, floats, number, vector};
use random::Random;
use scalars::NUMBERS;
use solids::{KINDS, height, orientation, round, shape, times};
use tool::geometry::{Placed, Shape, Solid};
use tool::number::Job;
use tool::vector::{Vector, add, dot, norm, rotation, scale, sub};

carom::shapes! {
    /// What a world holds that has compounds, too.
    enum Piece<'a, S> { Sphere, HalfSpace, Compound(Compound<'a, S, Solid<'a, S>>) }
}

const LEVEL: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

/// A dozen units of the last place of numbers up to 4, and what micromath's root lacks.
fn allowance<S: HostScalar>() -> f64 {
    24.0 * S::spacing(4.0) + if S::from_f64(2.0).expect("fits").sqrt().to_f64() == 2.0_f64.sqrt() { 0.0 } else { 1e-5 }
}

/// Shapes on a body, in f64.
#[derive(Clone, Debug)]
struct Body {
    parts: Vec<Placed>,
    position: Vector,
    orientation: [f64; 4],
}

impl Body {
    fn new(parts: Vec<Placed>) -> Self {
        Self { parts, position: [0.0; 3], orientation: LEVEL }
    }

    fn at(&self, position: Vector, orientation: [f64; 4]) -> Self {
        Self { position, orientation, ..self.clone() }
    }

    /// Where the parts are in the world.
    fn placed(&self) -> Vec<Placed> {
        let r = rotation(self.orientation);
        let place = |part: &Placed| Placed {
            position: add(self.position, r.map(|row| dot(row, part.position))),
            orientation: times(self.orientation, part.orientation),
            ..*part
        };
        self.parts.iter().map(place).collect()
    }

    fn height(&self, point: Vector) -> f64 {
        self.placed().iter().map(|part| height(part, point)).fold(f64::INFINITY, f64::min)
    }

    fn for_kernel<S: HostScalar>(&self) -> (Vec<Part<S, Solid<'static, S>>>, Pose<S>) {
        let parts = self.parts.iter().map(|part| {
            let (shape, pose) = part.for_kernel(None).expect("it fits");
            Part { pose, shape }
        });
        let whole = Placed { shape: Shape::Plane, position: self.position, orientation: self.orientation };
        (parts.collect(), whole.for_kernel::<S>(None).expect("it fits").1)
    }
}

fn cuboid(half: Vector, position: Vector) -> Placed {
    Placed { shape: Shape::Box { half }, position, orientation: LEVEL }
}

fn eighths(half: Vector) -> Body {
    let small = scale(0.5, half);
    let corner = |k: usize| [0, 1, 2].map(|axis| if k >> axis & 1 == 1 { small[axis] } else { -small[axis] });
    Body::new((0..8).map(|k| cuboid(small, corner(k))).collect())
}

fn dumbbell() -> Body {
    let ball = |z| Placed { shape: Shape::Sphere { radius: 0.375 }, position: [0.0, 0.0, z], orientation: LEVEL };
    let rod = Placed { shape: Shape::Capsule { radius: 0.125, half: 0.75 }, position: [0.0; 3], orientation: LEVEL };
    Body::new(vec![ball(-0.75), rod, ball(0.75)])
}

/// With one leg turned.
fn l_shape() -> Body {
    let leg = Placed {
        shape: Shape::Box { half: [0.125, 0.75, 0.25] },
        position: [0.5, -0.25, 0.125],
        orientation: [0.8, 0.0, 0.0, 0.6],
    };
    Body::new(vec![cuboid([0.625, 0.125, 0.25], [-0.25, 0.5, 0.0]), leg])
}

/// Every manifold with its part.
struct All<S: HostScalar> {
    place: Manifold<S>,
    taken: Vec<(u32, Manifold<S>)>,
}

impl<S: HostScalar> ManifoldSink<S> for All<S> {
    fn place(&mut self) -> &mut Manifold<S> {
        &mut self.place
    }

    fn take(&mut self, part: u32) {
        assert!(!self.place.is_empty());
        self.taken.push((part, self.place));
    }
}

fn manifolds<S: HostScalar, A: Collide<S, B>, B>(
    (a, pose): (&A, &Pose<S>),
    (b, other): (&B, &Pose<S>),
) -> Vec<(u32, Manifold<S>)> {
    let mut all = All { place: Manifold::empty(UnitVec3::X), taken: vec![] };
    a.collide(pose, b, other, number(0.02), &mut all);
    all.taken.sort_by_key(|(part, _)| *part);
    all.taken
}

struct AsOne;

impl Job for AsOne {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(1);
        let (mut compared, mut overlapping) = (0, 0);
        for kind in 0..KINDS {
            for _ in 0..400 {
                let Shape::Box { half } = shape(2, &mut random) else { panic!("a box") };
                let half = half.map(|h| (h * 1024.0).round() / 1024.0);
                let (position, turn) = (round([0, 1, 2].map(|_| random.between(-1.5, 1.5))), orientation(&mut random));
                let (parts, pose) = eighths(half).at(position, turn).for_kernel::<S>();
                let compound = Compound::new(&parts).expect("eight parts");
                let (whole, _) = cuboid(half, position).for_kernel::<S>(None).expect("it fits");
                let way = round([0, 1, 2].map(|_| random.between(-1.5, 1.5)));
                let other =
                    Placed { shape: shape(kind, &mut random), position: way, orientation: orientation(&mut random) };
                let (other, other_pose) = other.for_kernel::<S>(None).expect("it fits");
                let one = whole.closest(&pose, &other, &other_pose).expect("a distance");
                let eight = compound.closest(&pose, &other, &other_pose).expect("a distance");
                let back = other.closest(&other_pose, &compound, &pose).expect("a distance");
                assert_eq!(back.swapped(), eight);
                // Where a surface inside does not count.
                let (apart, tolerance) = (one.separation.to_f64() > 2.0 * allowance::<S>(), allowance::<S>());
                assert_eq!(compound.overlaps(&pose, &other, &other_pose), eight.separation <= S::ZERO);
                if !apart {
                    overlapping += usize::from(eight.separation.to_f64() < tolerance);
                    continue;
                }
                let error = (one.separation.to_f64() - eight.separation.to_f64()).abs();
                assert!(error <= tolerance, "{half:?}: {one:?}, {eight:?}");
                let ends = [
                    add(floats(pose.position), floats(eight.r_a)),
                    add(floats(other_pose.position), floats(eight.r_b)),
                ];
                let gap = sub(ends[1], ends[0]);
                let across = sub(gap, scale(eight.separation.to_f64(), direction(eight.normal)));
                assert!(norm(across) < 2.0 * tolerance, "the arms lead to both ends of the gap: {eight:?}");
                compared += 1;
            }
        }
        assert!(compared > 500 && overlapping > 300, "{compared}, {overlapping}");
    }
}

#[test]
fn eight_boxes_are_as_far_away_as_the_one_that_they_make() {
    for &number in NUMBERS {
        scalars::run(number, AsOne);
    }
}

struct Resting;

impl Job for Resting {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let deep = 1.0 / 512.0;
        let half = [0.5, 0.25, 0.375];
        let (parts, _) = eighths(half).for_kernel::<S>();
        let compound = Compound::new(&parts).expect("eight parts");
        let whole = Cuboid::new(vector::<S>(half)).expect("a box");
        let ground = HalfSpace::new(UnitVec3::<S>::Z);
        let pose = Pose::at(vector([0.25, 0.125, half[2] - deep]));
        let at = Pose::IDENTITY;
        let one = manifolds((&whole, &pose), (&ground, &at));
        let eight = manifolds((&compound, &pose), (&ground, &at));
        // The four parts at the bottom, by their numbers, each on its four corners.
        assert_eq!(eight.iter().map(|(part, _)| *part).collect::<Vec<_>>(), [0, 1 << 24, 2 << 24, 3 << 24]);
        for (_, manifold) in &eight {
            assert_eq!((manifold.points().len(), manifold.normal), (4, one[0].1.normal));
        }
        for corner in one[0].1.points() {
            let same = eight.iter().flat_map(|(_, manifold)| manifold.points());
            let same: Vec<_> =
                same.filter(|p| (p.r_a, p.r_b, p.separation) == (corner.r_a, corner.r_b, corner.separation)).collect();
            assert_eq!(same.len(), 1, "{corner:?} of {eight:?}");
        }
        // A flat field is a ground as well, and tells no other parts.
        let heights = [S::ZERO; 81];
        let field = HeightField::new(&heights, 9, 9, number(0.25)).expect("a field");
        let on_field = manifolds((&compound, &pose), (&field, &at));
        assert_eq!(on_field.len(), 4);
        let names: BTreeSet<u32> = on_field.iter().map(|(part, _)| *part >> 16).collect();
        assert_eq!(names, BTreeSet::from([0, 1 << 8, 2 << 8, 3 << 8]));
        assert!(on_field.iter().all(|(part, _)| part & 0xffff == on_field[0].0 & 0xffff));
        // A compound on a compound: each of the upper four on one of the lower four. (Those beside each other touch as well, at
        // their sides.)
        let above = Pose::at(vector([0.25, 0.125, 3.0 * half[2] - 2.0 * deep]));
        let stacked = manifolds((&compound, &pose), (&compound, &above));
        let upright = stacked.iter().filter(|(_, manifold)| direction(manifold.normal)[2] > 0.5);
        let faces: Vec<_> = upright.map(|(part, manifold)| (*part, manifold.points().len())).collect();
        let numbers = [4 << 24, 5 << 24 | 1 << 16, 6 << 24 | 2 << 16, 7 << 24 | 3 << 16];
        assert_eq!(faces, numbers.map(|part| (part, 4)));
        // In a set, beside others; and a compound of compounds, whose parts all have numbers of their own.
        let [piece, floor] = [Piece::from(compound), Piece::from(ground)];
        assert_eq!(manifolds((&piece, &pose), (&floor, &at)), eight);
        let twice = [-1.0, 1.0].map(|x| Part { pose: Pose::at(vector::<S>([x, 0.0, 0.0])), shape: compound });
        let twice = Compound::new(&twice).expect("two parts");
        let parts: Vec<_> = manifolds((&twice, &pose), (&ground, &at)).iter().map(|(part, _)| *part >> 24).collect();
        assert_eq!(parts, [0, 1, 2, 3, 4, 5, 6, 7]);
    }
}

#[test]
fn eight_boxes_rest_as_the_one_that_they_make() {
    for &number in NUMBERS {
        scalars::run(number, Resting);
    }
}

struct InF64;

impl Job for InF64 {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(2);
        let (mut apart, mut touching, mut hits) = (0, 0, 0);
        for case in 0..1500 {
            let body = [dumbbell(), l_shape()][case % 2]
                .at(round([0, 1, 2].map(|_| random.between(-1.0, 1.0))), orientation(&mut random));
            let (parts, pose) = body.for_kernel::<S>();
            let compound = Compound::new(&parts).expect("some parts");
            let tolerance = allowance::<S>();
            // A ball, by what is left between its middle and the parts.
            let radius = (random.between(0.05, 0.5) * 4096.0).round() / 4096.0;
            let centre = round(add(body.position, scale(random.between(0.2, 2.5), random.direction())));
            let (ball, at) = (Sphere::new(number::<S>(radius)).expect("a ball"), Pose::at(vector(centre)));
            let (right, free) = (body.height(centre) - radius, body.height(centre));
            let closest = compound.closest(&pose, &ball, &at).expect("a distance");
            assert!(
                (closest.separation.to_f64() - right).abs() <= tolerance,
                "{body:?} {centre:?}: {closest:?}, {right}"
            );
            let found = manifolds((&compound, &pose), (&ball, &at));
            if (right - 0.02).abs() > tolerance {
                assert_eq!(found.is_empty(), right > 0.02, "{body:?} {centre:?}: {right}");
            }
            for (part, manifold) in &found {
                let part = &body.placed()[(part >> 24) as usize];
                let [point] = manifold.points() else { panic!("{manifold:?}") };
                let surface = add(
                    add(body.position, floats(point.r_a)),
                    scale(-0.5 * point.separation.to_f64(), direction(manifold.normal)),
                );
                assert!(height(part, surface).abs() <= 2.0 * tolerance, "{part:?}: {manifold:?}");
                touching += 1;
            }
            let near = compound.closest_point(&pose, vector(centre)).expect("a point");
            assert!((near.separation.to_f64() - free).abs() <= tolerance);
            assert!(free < 0.0 || body.height(floats(near.point)).abs() <= tolerance);
            apart += usize::from(right > 0.0);
            // A ray, by steps as long as nothing is near.
            let towards = add(sub(body.position, centre), scale(0.7, random.direction()));
            let toward = UnitVec3::<S>::normalize(vector(towards)).expect("a direction");
            let way = direction(toward);
            let ray = Ray { origin: vector(centre), direction: toward, length: number(3.0) };
            let mut t = 0.0;
            while t < 3.0 && body.height(add(centre, scale(t, way))) > 1e-7 {
                t += body.height(add(centre, scale(t, way)));
            }
            let hit = compound.cast_ray(&pose, &ray);
            let (inside, e) = (free < -tolerance, 1e-3);
            let slope = if inside { 1.0 } else { (body.height(add(centre, scale(t - e, way)))) / e };
            if slope > 0.2 && free.abs() > tolerance && t < 2.99 {
                let hit = hit.expect("it meets it");
                assert!((hit.distance.to_f64() - t).abs() < 10.0 * tolerance + 1e-5, "{body:?} {ray:?}: {hit:?}, {t}");
                hits += 1;
            }
            // And the box is around all.
            let Aabb { min, max } = compound.aabb(&pose);
            for placed in body.placed() {
                for axis in 0..3 {
                    let mut n = [0.0; 3];
                    n[axis] = 1.0;
                    assert!(placed.reach(n) <= floats(max)[axis] + tolerance);
                    assert!(-placed.reach(scale(-1.0, n)) >= floats(min)[axis] - tolerance);
                }
            }
        }
        assert!(apart > 700 && touching > 200 && hits > 400, "{apart} {touching} {hits}");
    }
}

#[test]
fn compounds_are_what_their_parts_are() {
    for &number in NUMBERS {
        scalars::run(number, InF64);
    }
}

struct Mirrored;

impl Job for Mirrored {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(3);
        let (mut compared, mut parts_met) = (0, BTreeSet::new());
        let bodies = [dumbbell(), l_shape(), eighths([0.5, 0.375, 0.25])];
        let place = |random: &mut Random, far: f64| round([0, 1, 2].map(|_| random.between(-far, far)));
        for case in 0..600 {
            let a = bodies[case % 3].at(place(&mut random, 0.7), orientation(&mut random));
            let b = bodies[case / 3 % 3].at(place(&mut random, 0.7), orientation(&mut random));
            let ((parts_a, pose_a), (parts_b, pose_b)) = (a.for_kernel::<S>(), b.for_kernel::<S>());
            let (a, b) = (Compound::new(&parts_a).expect("parts"), Compound::new(&parts_b).expect("parts"));
            let there = manifolds((&a, &pose_a), (&b, &pose_b));
            let mut back = manifolds((&b, &pose_b), (&a, &pose_a));
            for (part, manifold) in &mut back {
                manifold.swap();
                *part = *part << 8 & 0xff00_0000 | *part >> 8 & 0x00ff_0000 | *part & 0xffff;
            }
            back.sort_by_key(|(part, _)| *part);
            assert_eq!(there, back);
            compared += there.len();
            assert_eq!(there.iter().map(|(part, _)| *part).collect::<BTreeSet<_>>().len(), there.len(), "one each");
            parts_met.extend(there.iter().map(|(part, _)| *part));
            // The same for the other shapes, and moved by a hair the parts keep their numbers.
            let kind = case % KINDS;
            let other =
                Placed { shape: shape(kind, &mut random), position: place(&mut random, 0.7), orientation: LEVEL };
            let (other, other_pose) = other.for_kernel::<S>(None).expect("it fits");
            let there = manifolds((&a, &pose_a), (&other, &other_pose));
            let mut back = manifolds((&other, &other_pose), (&a, &pose_a));
            for (part, manifold) in &mut back {
                manifold.swap();
                *part <<= 8;
            }
            assert_eq!(there, back);
            let mut moved = pose_a;
            moved.position += vector(scale(1e-4, random.direction()));
            let after: BTreeSet<u32> =
                manifolds((&a, &moved), (&other, &other_pose)).iter().map(|(part, _)| *part).collect();
            let near = |manifold: &Manifold<S>| manifold.points().iter().any(|p| p.separation.to_f64() < 0.019);
            assert!(there.iter().all(|(part, manifold)| !near(manifold) || after.contains(part)));
        }
        assert!(compared > 1000 && parts_met.len() == 64, "{compared}, {}", parts_met.len());
    }
}

/// To the last bit.
#[test]
fn in_the_other_order_parts_and_manifolds_are_mirrored() {
    for &number in NUMBERS {
        scalars::run(number, Mirrored);
    }
}

/// A ball that counts how often it is asked.
#[derive(Clone, Copy)]
struct Counted<'a, S> {
    ball: Sphere<S>,
    asked: &'a Cell<usize>,
}

impl<S: HostScalar> carom::Shape<S> for Counted<'_, S> {
    fn aabb(&self, pose: &Pose<S>) -> Aabb<S> {
        self.ball.aabb(pose)
    }

    fn inner_radius(&self) -> S {
        self.ball.inner_radius()
    }

    fn outer_radius(&self) -> S {
        self.ball.outer_radius()
    }

    fn cast_ray(&self, pose: &Pose<S>, ray: &Ray<S>) -> Option<RayHit<S>> {
        self.ball.cast_ray(pose, ray)
    }

    fn closest_point(&self, pose: &Pose<S>, point: Vec3<S>) -> Option<SurfacePoint<S>> {
        self.ball.closest_point(pose, point)
    }
}

impl<S: HostScalar> Collide<S, Sphere<S>> for Counted<'_, S> {
    fn collide<K: ManifoldSink<S>>(
        &self,
        pose: &Pose<S>,
        other: &Sphere<S>,
        other_pose: &Pose<S>,
        margin: S,
        sink: &mut K,
    ) {
        self.asked.set(self.asked.get() + 1);
        self.ball.collide(pose, other, other_pose, margin, sink);
    }

    fn closest(&self, pose: &Pose<S>, other: &Sphere<S>, other_pose: &Pose<S>) -> Option<Closest<S>> {
        self.asked.set(self.asked.get() + 1);
        self.ball.closest(pose, other, other_pose)
    }
}

struct Refusals;

impl Job for Refusals {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let ball = Sphere::new(number::<S>(0.25)).expect("a ball");
        let part = Part { pose: Pose::IDENTITY, shape: ball };
        assert_eq!(Compound::<S, Sphere<S>>::new(&[]).err(), Some(CompoundError::Empty));
        assert_eq!(Compound::new(&[part; 256]).err(), Some(CompoundError::TooMany));
        assert!(Compound::new(&[part; 255]).is_ok());
        let endless = S::ONE.over(S::ZERO);
        if !endless.is_finite() {
            let away = Part { pose: Pose::at(Vec3::new(S::ZERO, endless, S::ZERO)), shape: ball };
            assert_eq!(Compound::new(&[part, away]).err(), Some(CompoundError::Pose));
        }
        // What has no end: so has the compound.
        let room = [UnitVec3::<S>::X, -UnitVec3::X].map(|n| {
            let wall = direction(-n)[0];
            Part { pose: Pose::at(vector([wall, 0.0, 0.0])), shape: HalfSpace::new(n) }
        });
        let room = Compound::new(&room).expect("two walls");
        assert_eq!(room.aabb(&Pose::IDENTITY), Aabb::unbounded());
        let inside = room.closest(&Pose::IDENTITY, &ball, &Pose::at(vector([0.5, 0.0, 0.0]))).expect("a distance");
        assert_eq!((inside.separation, direction(inside.normal)), (number(0.25), [-1.0, 0.0, 0.0]));
        // Of a row of balls, those far from the other one are not asked.
        let asked = Cell::new(0);
        let row = [0, 1, 2, 3, 4, 5, 6, 7]
            .map(|k| Part { pose: Pose::at(vector([f64::from(k), 0.0, 0.0])), shape: Counted { ball, asked: &asked } });
        let row = Compound::new(&row).expect("eight");
        let mut manifold = Manifold::empty(UnitVec3::X);
        let place = Pose::at(vector([3.25, 0.25, 0.0]));
        row.collide(&Pose::IDENTITY, &ball, &place, number(0.02), &mut manifold);
        assert_eq!((asked.get(), manifold.points().len()), (1, 1));
        // For the distance, only as long as they come nearer.
        asked.set(0);
        assert!(row.closest(&Pose::IDENTITY, &ball, &place).is_some());
        assert_eq!(asked.get(), 4);
    }
}

#[test]
fn compounds_refuse_and_reject() {
    for &number in NUMBERS {
        scalars::run(number, Refusals);
    }
}
