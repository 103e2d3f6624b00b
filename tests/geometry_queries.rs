//! Rays, closest points and overlaps against the closed forms, and the broad phase against all pairs.
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

use carom::{Aabb, Collide, PairSink, Pairs, Ray, Shape as _, SweepAndPrune, UnitVec3, Vec3};
use host::{HostScalar, floats, vector};
use random::Random;
use scalars::NUMBERS;
use solids::{KINDS, PAIRS, height, orientation, round, shape};
use tool::geometry::Placed;
use tool::number::Job;
use tool::vector::{Vector, add, dot, norm, scale, sub};

fn direction<S: HostScalar>(d: Vector) -> UnitVec3<S> {
    UnitVec3::new(Vec3::from_array(d.map(S::unit))).expect("of unit length")
}

fn placed(kind: usize, random: &mut Random) -> Placed {
    let position = round([0, 1, 2].map(|_| random.between(-2.0, 2.0)));
    Placed { shape: shape(kind, random), position, orientation: orientation(random) }
}

/// Where a ray enters, by steps as long as nothing is near: it never passes a surface, and closes in on it.
fn march(shape: &Placed, origin: Vector, way: Vector, length: f64) -> Option<f64> {
    let mut t = 0.0;
    for _ in 0..100_000 {
        let free = height(shape, add(origin, scale(t, way)));
        if free < 1e-10 {
            return Some(t);
        }
        t += free;
        if t > length {
            return None;
        }
    }
    // Along the surface it closes in slowly: as good as met, or missed.
    None
}

fn gradient(shape: &Placed, point: Vector) -> Vector {
    let e = 1e-6;
    [0, 1, 2].map(|k| {
        let mut ahead = point;
        let mut behind = point;
        ahead[k] += e;
        behind[k] -= e;
        (height(shape, ahead) - height(shape, behind)) / (2.0 * e)
    })
}

/// A dozen units of the last place of numbers up to 4, and what micromath's root lacks.
fn allowance<S: HostScalar>() -> f64 {
    16.0 * S::spacing(4.0) + if S::from_f64(2.0).expect("fits").sqrt().to_f64() == 2.0_f64.sqrt() { 0.0 } else { 1e-5 }
}

struct Rays;

impl Job for Rays {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(1);
        let (mut hits, mut misses, mut inside, mut unclear) = (0, 0, 0, 0);
        // Boxes once more, as hulls.
        for (kind, as_hull) in (0..KINDS).map(|kind| (kind, false)).chain([(2, true)]) {
            for _ in 0..2000 {
                let target = placed(kind, &mut random);
                let disguise = if as_hull { target.disguise::<S>(1.0) } else { None };
                let origin = round([0, 1, 2].map(|_| random.between(-3.0, 3.0)));
                let towards = add(sub(target.position, origin), scale(random.between(0.0, 1.5), random.direction()));
                let way = scale(1.0 / norm(towards), towards);
                let length = (random.between(0.5, 6.0) * 65536.0).round() / 65536.0;
                let ray = Ray {
                    origin: vector(origin),
                    direction: direction::<S>(way),
                    length: S::from_f64(length).expect("fits"),
                };
                let way = ray.direction.get().to_array().map(S::unit_to_f64);
                let (solid, pose) = target.for_kernel::<S>(disguise.as_ref()).expect("it fits");
                let found = solid.cast_ray(&pose, &ray);
                let expected = march(&target, origin, way, length);
                // Where a ray grazes, or ends at the surface, rounding decides.
                let (tolerance, grazes) = match expected {
                    Some(t) if t > 0.0 => {
                        let slope = -dot(gradient(&target, add(origin, scale(t, way))), way);
                        (
                            (allowance::<S>() + 1e-9) / slope.max(0.01),
                            slope < 0.02 + 2000.0 * S::spacing(1.0) || t > length - 1e-3,
                        )
                    }
                    _ => (allowance::<S>(), false),
                };
                let (Some(hit), Some(t)) = (found, expected) else {
                    unclear += usize::from(grazes || found.is_some() != expected.is_some());
                    misses += usize::from(found.is_none() && expected.is_none());
                    continue;
                };
                if grazes {
                    unclear += 1;
                    continue;
                }
                let n = hit.normal.get().to_array().map(S::unit_to_f64);
                let distance = hit.distance.to_f64();
                assert!((distance - t).abs() <= 2.0 * tolerance, "{target:?} {ray:?}: {distance} of {t}");
                if t == 0.0 {
                    inside += 1;
                    assert!(norm(add(n, way)) < 1e-5, "against the ray: {n:?}");
                } else {
                    hits += 1;
                    let right = gradient(&target, add(origin, scale(t, way)));
                    let edge = norm(right) < 0.999;
                    assert!(
                        edge || norm(sub(n, right)) < 200.0 * tolerance + 1e-5,
                        "{target:?} {ray:?}: {n:?} of {right:?}"
                    );
                }
            }
        }
        assert!(hits > 2500 && misses > 1900 && inside > 400, "{hits} {misses} {inside}");
        assert!(unclear * 40 < hits, "{unclear} of {hits}");
    }
}

#[test]
fn rays_meet_shapes_where_the_surface_is() {
    for &number in NUMBERS {
        scalars::run(number, Rays);
    }
}

struct ClosestPoints;

impl Job for ClosestPoints {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(2);
        let (mut outside, mut inside) = (0, 0);
        for kind in 0..KINDS {
            for _ in 0..1000 {
                let target = placed(kind, &mut random);
                let point = round(add(target.position, scale(random.between(0.0, 2.0), random.direction())));
                let (solid, pose) = target.for_kernel::<S>(None).expect("it fits");
                let found = solid.closest_point(&pose, vector(point)).expect("there is one");
                let (right, tolerance) = (height(&target, point), allowance::<S>());
                let separation = found.separation.to_f64();
                assert!((separation - right).abs() <= tolerance, "{target:?} {point:?}: {separation} of {right}");
                let n = found.normal.get().to_array().map(S::unit_to_f64);
                let on_surface = floats(found.point);
                assert!(height(&target, on_surface).abs() <= tolerance, "{target:?} {point:?}: {found:?}");
                let back = add(on_surface, scale(separation, n));
                assert!(norm(sub(back, point)) <= tolerance, "{target:?} {point:?}: {found:?}");
                *(if right > 0.0 { &mut outside } else { &mut inside }) += 1;
            }
        }
        assert!(outside > 1000 && inside > 500, "{outside} {inside}");
    }
}

#[test]
fn closest_points_lie_on_the_surface_at_the_distance() {
    for &number in NUMBERS {
        scalars::run(number, ClosestPoints);
    }
}

struct Overlaps;

impl Job for Overlaps {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(3);
        let (mut yes, mut no) = (0, 0);
        for (a, b) in PAIRS {
            for _ in 0..300 {
                let shapes = [placed(a, &mut random), placed(b, &mut random)];
                let [(a, pose_a), (b, pose_b)] = shapes.map(|placed| placed.for_kernel::<S>(None).expect("it fits"));
                let closest = a.closest(&pose_a, &b, &pose_b).expect("they can meet");
                let overlaps = a.overlaps(&pose_a, &b, &pose_b);
                if closest.separation.to_f64().abs() > allowance::<S>() {
                    assert_eq!(overlaps, closest.separation < S::ZERO);
                    *(if overlaps { &mut yes } else { &mut no }) += 1;
                }
                // Boxes around shapes that overlap do so, too.
                let slack = S::from_f64(allowance::<S>()).expect("it fits");
                let boxes = [a.aabb(&pose_a).expanded(slack), b.aabb(&pose_b).expanded(slack)];
                assert!(!overlaps || boxes[0].overlaps(&boxes[1]));
            }
        }
        assert!(yes > 500 && no > 500, "{yes} {no}");
    }
}

#[test]
fn overlaps_are_distances_below_zero() {
    for &number in NUMBERS {
        scalars::run(number, Overlaps);
    }
}

struct Bounds;

impl Job for Bounds {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(4);
        for kind in 0..3 {
            for _ in 0..500 {
                let target = placed(kind, &mut random);
                let (solid, pose) = target.for_kernel::<S>(None).expect("it fits");
                let Aabb { min, max } = solid.aabb(&pose);
                for (axis, (low, high)) in floats(min).into_iter().zip(floats(max)).enumerate() {
                    let mut n = [0.0; 3];
                    n[axis] = 1.0;
                    let (above, below) = (target.reach(n), -target.reach(scale(-1.0, n)));
                    assert!((high - above).abs() < allowance::<S>() && (low - below).abs() < allowance::<S>());
                }
            }
        }
    }
}

#[test]
fn bounding_boxes_reach_as_far_as_the_shape() {
    for &number in NUMBERS {
        scalars::run(number, Bounds);
    }
}

struct Sweeps;

impl Job for Sweeps {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(5);
        let mut sweep = SweepAndPrune::new([0; 40]);
        let mut found = 0;
        let mut places: Vec<[Vector; 2]> = Vec::new();
        for step in 0..600 {
            // From none to more than there is memory for, and back; what is there moves on.
            let count = [0, 1, 7, 40, 48, 33, 64, 5][step / 20 % 8];
            places.truncate(count);
            while places.len() < count {
                let stretch = if step / 160 % 2 == 0 { [8.0, 2.0, 1.0] } else { [1.0, 2.0, 8.0] };
                let centre = stretch.map(|x: f64| random.between(-x, x));
                places.push([centre, [0, 1, 2].map(|_| random.between(0.0, 1.0))]);
            }
            for [centre, _] in &mut places {
                *centre = add(*centre, scale(0.05, random.direction()));
            }
            let mut boxes: Vec<Aabb<S>> =
                places.iter().map(|[centre, half]| Aabb::around(vector(*centre), vector(*half))).collect();
            if let Some(ground) = boxes.get_mut(3) {
                *ground = Aabb::unbounded();
            }
            let mut pairs = Pairs::new([[0; 2]; 1000]);
            sweep.sweep(&boxes, &mut pairs);
            let apart = |a: Vec3<S>, b: Vec3<S>| a.x < b.x || a.y < b.y || a.z < b.z;
            let mut right = BTreeSet::new();
            for (a, first) in boxes.iter().enumerate() {
                for (b, second) in boxes.iter().enumerate().skip(a + 1) {
                    if !apart(first.max, second.min) && !apart(second.max, first.min) {
                        right.insert([a as u16, b as u16]);
                    }
                }
            }
            assert_eq!(pairs.found().iter().copied().collect::<BTreeSet<_>>(), right, "step {step}");
            assert_eq!(pairs.found().len(), right.len(), "each once");
            assert_eq!(pairs.missed(), 0);
            // With room for ten, the others are counted.
            let mut few = Pairs::new([[0; 2]; 10]);
            sweep.sweep(&boxes, &mut few);
            assert_eq!(few.found(), &pairs.found()[..right.len().min(10)], "in the same order");
            assert_eq!(few.missed(), right.len().saturating_sub(10));
            found += right.len();
        }
        assert!(found > 20_000, "{found}");
    }
}

#[test]
fn sweep_and_prune_finds_what_all_pairs_do() {
    for &number in NUMBERS {
        scalars::run(number, Sweeps);
    }
}

/// Counts what a sweep does.
#[derive(Default)]
struct Work {
    pairs: usize,
    compared: usize,
}

impl PairSink for Work {
    fn pair(&mut self, _: u16, _: u16) {
        self.pairs += 1;
    }

    fn compared(&mut self, count: usize) {
        self.compared += count;
    }
}

struct Costs;

impl Job for Costs {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(6);
        for count in [8_usize, 16, 32, 64] {
            let n = count as f64;
            let side = n.cbrt().ceil();
            // In a row, in a pile of as many to each side, at random in a hall that is longer the more there are.
            let place = |kind: usize, k: usize, random: &mut Random| match kind {
                0 => [0.99 * k as f64 - 0.5 * n, 0.0, 0.0],
                1 => {
                    let (x, y, z) =
                        (k as f64 % side, (k as f64 / side).floor() % side, (k as f64 / side / side).floor());
                    [0.99 * x, 0.99 * y, 0.99 * z]
                }
                _ => [random.between(-0.5 * n, 0.5 * n), random.between(-2.0, 2.0), random.between(-2.0, 2.0)],
            };
            for kind in 0..3 {
                let mut places: Vec<Vector> = (0..count).map(|k| place(kind, k, &mut random)).collect();
                let mut sweep = SweepAndPrune::new([0; 64]);
                let (mut most, mut along) = (0, 0);
                for step in 0..40 {
                    for place in &mut places {
                        *place = add(*place, scale(0.002, random.direction()));
                    }
                    let boxes: Vec<Aabb<S>> =
                        places.iter().map(|&place| Aabb::around(vector(place), vector([0.5; 3]))).collect();
                    let mut work = Work::default();
                    sweep.sweep(&boxes, &mut work);
                    if step > 0 {
                        most = most.max(work.compared);
                    }
                    // What is side by side along the axis has to be compared, whatever it is.
                    let beside = |a: &Vector, b: &Vector, axis: usize| (a[axis] - b[axis]).abs() <= 1.0;
                    let pairs = |axis: usize| {
                        (0..count)
                            .map(|i| (0..i).filter(|&j| beside(&places[i], &places[j], axis)).count())
                            .sum::<usize>()
                    };
                    along = along.max([0, 1, 2].map(pairs).into_iter().max().expect("three"));
                    let all = places.iter().enumerate();
                    let right = all.flat_map(|(i, a)| places[..i].iter().map(move |b| (a, b)));
                    let right =
                        right.filter(|(a, b)| (0..3).all(|axis| (a[axis] - b[axis]).abs() <= 1.0 - 1e-4)).count();
                    assert!(work.pairs >= right, "{} of {right}", work.pairs);
                }
                println!("{count} boxes, kind {kind}: {most} comparisons, {along} beside each other");
                let linear = match kind {
                    // One to keep the order, the next one, and the one at which to stop.
                    0 => 4 * count,
                    // Where those of a layer begin is noise, and put in order each time.
                    1 => 8 * count + along,
                    _ => 6 * count,
                };
                assert!(most <= linear, "{count} boxes, kind {kind}: {most} comparisons, more than {linear}");
            }
        }
        // What finds no room is counted.
        let heap = [Aabb::around(Vec3::<S>::ZERO, vector([0.5; 3])); 10];
        let (mut sweep, mut few) = (SweepAndPrune::new([0; 10]), Pairs::new([[0; 2]; 4]));
        sweep.sweep(&heap, &mut few);
        assert_eq!((few.found(), few.missed()), (&[[0, 1], [0, 2], [0, 3], [0, 4]][..], 41));
    }
}

#[test]
fn a_sweep_takes_little_more_work_than_there_are_boxes() {
    for &number in NUMBERS {
        scalars::run(number, Costs);
    }
}
