//! What shapes are made of: hulls of points and height fields, and what constructors refuse.
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

use carom::{
    Capsule, Collide, ConvexHull, Cuboid, HalfSpace, HeightField, HeightFieldError, HullError, Manifold, ManifoldSink,
    Pose, Quat, Shape, ShapeError, Sphere, UnitVec3, Vec3,
};
use host::{HostScalar, direction, floats, number, vector};
use random::Random;
use scalars::NUMBERS;
use tool::number::Job;
use tool::vector::{Vector, add, cross, dot, norm, scale, sub};

/// A few units of the last place, and what micromath's root lacks.
fn allowance<S: HostScalar>() -> f64 {
    16.0 * S::spacing(4.0) + if S::from_f64(2.0).expect("fits").sqrt().to_f64() == 2.0_f64.sqrt() { 0.0 } else { 1e-5 }
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
    a: &A,
    pose: &Pose<S>,
    b: &B,
    other: &Pose<S>,
) -> Vec<(u32, Manifold<S>)> {
    let mut all = All { place: Manifold::empty(UnitVec3::X), taken: vec![] };
    a.collide(pose, b, other, number(0.01), &mut all);
    all.taken
}

struct Refusals;

impl Job for Refusals {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let (one, zero) = (S::ONE, S::ZERO);
        let v = |x, y, z| vector::<S>([x, y, z]);
        assert_eq!(Sphere::new(zero), Err(ShapeError::Radius));
        assert_eq!(Sphere::new(one.negated()), Err(ShapeError::Radius));
        assert_eq!(Capsule::new(zero, one), Err(ShapeError::Radius));
        assert_eq!(Capsule::new(one, zero), Err(ShapeError::HalfLength));
        assert_eq!(Cuboid::new(v(1.0, 0.0, 1.0)), Err(ShapeError::HalfExtent));
        let square = [v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(1.0, 1.0, 0.0), v(0.0, 1.0, 0.0)];
        assert_eq!(ConvexHull::<S, 8>::new(&square[..3]).err(), Some(HullError::TooFew));
        assert_eq!(ConvexHull::<S, 8>::new(&square).err(), Some(HullError::Flat));
        assert_eq!(ConvexHull::<S, 3>::new(&square).err(), Some(HullError::TooMany));
        assert_eq!(ConvexHull::<S, 40>::new(&[v(0.0, 0.0, 0.0); 33]).err(), Some(HullError::TooMany));
        assert!(ConvexHull::<S, 8>::new(&[v(0.0, 0.0, 0.0); 5]).is_err(), "all in one place");
        let prism: Vec<_> = (0..26)
            .map(|k| {
                let angle = std::f64::consts::TAU * f64::from(k / 2) / 13.0;
                v(angle.cos(), angle.sin(), f64::from(k % 2))
            })
            .collect();
        assert_eq!(ConvexHull::<S, 26>::new(&prism).err(), Some(HullError::FaceCorners));
        let heights = [zero; 6];
        assert_eq!(HeightField::new(&heights, 1, 6, one).err(), Some(HeightFieldError::TooFew));
        assert_eq!(HeightField::new(&heights, 2, 2, one).err(), Some(HeightFieldError::Count));
        assert_eq!(HeightField::new(&heights, 2, 16384, one).err(), Some(HeightFieldError::TooMany));
        assert_eq!(HeightField::new(&heights, 2, 3, zero).err(), Some(HeightFieldError::Spacing));
        assert_eq!(HeightField::new(&heights, 2, 3, S::LARGEST).err(), Some(HeightFieldError::Spacing));
        assert!(HeightField::new(&heights, 2, 3, one).is_ok());
        let infinite = one.over(zero);
        if infinite.is_finite() {
            let small = S::from_ratio(1, 1 << 10).expect("it fits").lowered_by(6);
            let cube: Vec<_> =
                (0..8).map(|k| v((k & 1).into(), (k >> 1 & 1).into(), (k >> 2).into()) * small).collect();
            let coarse = small.bits() < 2048;
            assert_eq!(ConvexHull::<S, 8>::new(&cube).err(), coarse.then_some(HullError::TooSmall));
        } else {
            assert_eq!(Sphere::new(infinite), Err(ShapeError::Radius));
            let mut points = square;
            points[2].y = infinite;
            assert_eq!(ConvexHull::<S, 8>::new(&points).err(), Some(HullError::NotFinite));
            assert_eq!(HeightField::new(&[one, infinite, one, one], 2, 2, one).err(), Some(HeightFieldError::Height));
        }
    }
}

#[test]
fn constructors_name_what_they_refuse() {
    for &number in NUMBERS {
        scalars::run(number, Refusals);
    }
}

/// The corners of a regular solid with edges that fit into a ball of radius one.
fn icosahedron() -> Vec<Vector> {
    let phi = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let unit = 1.0 / (1.0 + phi * phi).sqrt();
    let mut corners = Vec::new();
    for (a, b) in [(1.0, phi), (-1.0, phi), (1.0, -phi), (-1.0, -phi)] {
        for v in [[0.0, a, b], [a, b, 0.0], [b, 0.0, a]] {
            corners.push(scale(unit, v));
        }
    }
    corners
}

fn dodecahedron() -> Vec<Vector> {
    let phi = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let unit = 1.0 / 3.0_f64.sqrt();
    let mut corners = Vec::new();
    for k in 0..8 {
        corners.push([k & 1, k >> 1 & 1, k >> 2].map(|bit| if bit == 1 { unit } else { -unit }));
    }
    for (a, b) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
        for v in [[0.0, a / phi, b * phi], [a / phi, b * phi, 0.0], [b * phi, 0.0, a / phi]] {
            corners.push(scale(unit, v));
        }
    }
    corners
}

struct Hulls;

impl Job for Hulls {
    type Output = ();
    fn run<S: HostScalar>(self) {
        // The radius of the ball inside, from that of the one outside.
        let ball = |s: f64| ((5.0 + 2.0 * 5.0_f64.sqrt()) / 15.0).sqrt() * s;
        for (corners, on_face) in [(icosahedron(), 3), (dodecahedron(), 5)] {
            // Points inside change nothing.
            let mut points: Vec<Vec3<S>> = corners.iter().map(|&v| vector(v)).collect();
            points.insert(3, vector([0.25, 0.125, -0.25]));
            points.push(vector([0.0; 3]));
            let hull = ConvexHull::<S, 24>::new(&points).expect("a hull");
            assert_eq!(hull.corners().len(), corners.len());
            let inner = (&hull).inner_radius().to_f64();
            assert!((inner - ball(1.0)).abs() < 1e-3, "{inner}");
            // Turned so that a face is level, it rests on a half-space by that face.
            let mut random = Random::new(1);
            let ground = HalfSpace::new(UnitVec3::<S>::Z);
            let mut rests = 0;
            for _ in 0..400 {
                let d = random.direction();
                // The face whose middle is lowest in that direction.
                let lowest = corners.iter().map(|&c| dot(c, d)).fold(f64::INFINITY, f64::min);
                let mut near: Vec<Vector> = corners.iter().copied().filter(|&c| dot(c, d) < lowest + 1e-3).collect();
                if near.len() < 3 {
                    let mut sorted = corners.clone();
                    sorted.sort_by(|a, b| dot(*a, d).total_cmp(&dot(*b, d)));
                    let face = cross(sub(sorted[1], sorted[0]), sub(sorted[2], sorted[0]));
                    let n = scale(-1.0 / norm(face) * dot(face, sorted[0]).signum(), face);
                    let plane = corners.iter().map(|&c| dot(c, n)).fold(f64::INFINITY, f64::min);
                    near = corners.iter().copied().filter(|&c| dot(c, n) < plane + 1e-6).collect();
                    if near.len() != on_face {
                        continue;
                    }
                    let pose = Pose::new(vector([0.0, 0.0, -plane - 1.0 / 1024.0]), level(n));
                    let found = manifolds(&&hull, &pose, &ground, &Pose::IDENTITY);
                    let [(_, manifold)] = found.as_slice() else { panic!("{found:?}") };
                    assert_eq!(manifold.points().len(), on_face.min(4), "{manifold:?}");
                    for point in manifold.points() {
                        assert!((point.separation.to_f64() + 1.0 / 1024.0).abs() < 1e-4, "{manifold:?}");
                    }
                    // And on another of its kind, which is large: as it does on the half-space.
                    let plate = Cuboid::new(vector([2.0, 2.0, 0.5])).expect("a plate");
                    let on_plate = manifolds(&&hull, &pose, &plate, &Pose::at(vector([0.0, 0.0, -0.5])));
                    let [(_, on_plate)] = on_plate.as_slice() else { panic!("{on_plate:?}") };
                    assert_eq!(on_plate.points().len(), on_face.min(4), "{on_plate:?}");
                    assert!(norm(add(direction(on_plate.normal), [0.0, 0.0, 1.0])) < 1e-3, "{on_plate:?}");
                    rests += 1;
                }
            }
            assert!(rests > 100, "{rests}");
        }
    }
}

/// The rotation that takes a direction to straight down... by the shortest way.
fn level<S: HostScalar>(n: Vector) -> Quat<S> {
    // n is the normal along which the face is lowest: it becomes the z axis.
    let axis = cross(n, [0.0, 0.0, 1.0]);
    let [w, x, y, z] = [1.0 + n[2], axis[0], axis[1], axis[2]];
    let length = (w * w + x * x + y * y + z * z).sqrt();
    let [w, x, y, z] = if length < 1e-6 { [0.0, 1.0, 0.0, 0.0] } else { [w, x, y, z].map(|c| c / length) };
    Quat::normalize(S::unit(w), S::unit(x), S::unit(y), S::unit(z)).expect("a rotation")
}

#[test]
fn regular_solids_rest_on_their_faces() {
    for &number in NUMBERS {
        scalars::run(number, Hulls);
    }
}

/// The distance of a point from a triangle (Ericson, Real-Time Collision Detection, 5.1.5), and the nearest point.
fn to_triangle([a, b, c]: [Vector; 3], p: Vector) -> (f64, Vector) {
    let (ab, ac, ap) = (sub(b, a), sub(c, a), sub(p, a));
    let (d1, d2) = (dot(ab, ap), dot(ac, ap));
    let at = |q: Vector| (norm(sub(p, q)), q);
    if d1 <= 0.0 && d2 <= 0.0 {
        return at(a);
    }
    let bp = sub(p, b);
    let (d3, d4) = (dot(ab, bp), dot(ac, bp));
    if d3 >= 0.0 && d4 <= d3 {
        return at(b);
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return at(add(a, scale(d1 / (d1 - d3), ab)));
    }
    let cp = sub(p, c);
    let (d5, d6) = (dot(ab, cp), dot(ac, cp));
    if d6 >= 0.0 && d5 <= d6 {
        return at(c);
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return at(add(a, scale(d2 / (d2 - d6), ac)));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        return at(add(b, scale((d4 - d3) / ((d4 - d3) + (d5 - d6)), sub(c, b))));
    }
    let sum = va + vb + vc;
    at(add(a, add(scale(vb / sum, ab), scale(vc / sum, ac))))
}

/// The triangles of a field, by its documentation.
fn triangles(heights: &[f64], columns: usize, rows: usize, spacing: f64) -> Vec<[Vector; 3]> {
    let point = |c: usize, r: usize| {
        let x = (c as f64 - (columns - 1) as f64 / 2.0) * spacing;
        let y = (r as f64 - (rows - 1) as f64 / 2.0) * spacing;
        [x, y, heights[r * columns + c]]
    };
    let mut all = Vec::new();
    for r in 0..rows - 1 {
        for c in 0..columns - 1 {
            all.push([point(c, r), point(c + 1, r), point(c + 1, r + 1)]);
            all.push([point(c, r), point(c + 1, r + 1), point(c, r + 1)]);
        }
    }
    all
}

struct Bumps;

impl Job for Bumps {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let mut random = Random::new(2);
        let heights: Vec<f64> = (0..63).map(|_| (random.between(-0.25, 0.25) * 4096.0).round() / 4096.0).collect();
        let stored: Vec<S> = heights.iter().map(|&h| number(h)).collect();
        let field = HeightField::new(&stored, 9, 7, number(0.5)).expect("a field");
        let all = triangles(&heights, 9, 7, 0.5);
        let (mut compared, mut on_ridges) = (0, 0);
        for _ in 0..2000 {
            let radius = (random.between(0.05, 0.3) * 4096.0).round() / 4096.0;
            let centre = [random.between(-1.75, 1.75), random.between(-1.25, 1.25), random.between(-0.1, 0.6)];
            let centre = centre.map(|x| (x * 4096.0).round() / 4096.0);
            // Above the surface, the distance from it is the least to any triangle.
            let below = all.iter().find(|t| {
                let side =
                    |a: Vector, b: Vector| (b[0] - a[0]) * (centre[1] - a[1]) - (b[1] - a[1]) * (centre[0] - a[0]);
                side(t[0], t[1]) >= 0.0 && side(t[1], t[2]) >= 0.0 && side(t[2], t[0]) >= 0.0
            });
            let below = below.expect("over the field");
            let n = cross(sub(below[1], below[0]), sub(below[2], below[0]));
            if dot(n, sub(centre, below[0])) / norm(n) < 0.01 {
                continue;
            }
            let (right, nearest) = all
                .iter()
                .map(|&t| to_triangle(t, centre))
                .reduce(|a, b| if a.0 <= b.0 { a } else { b })
                .expect("some");
            let ball = Sphere::new(number::<S>(radius)).expect("a ball");
            let pose = Pose::at(vector(centre));
            let closest = ball.closest(&pose, &field, &Pose::IDENTITY).expect("a distance");
            let error = (closest.separation.to_f64() - (right - radius)).abs();
            assert!(error <= allowance::<S>(), "{centre:?}, radius {radius}: {closest:?}, {right} to {nearest:?}");
            let away = scale(1.0 / right, sub(centre, nearest));
            let wrong = norm(add(direction(closest.normal), away));
            // Beside the end of a ridge, places whose squares differ by a rounding are equally near.
            assert!(wrong < 1e-4 + 3.0 * allowance::<S>().sqrt(), "{centre:?}: {closest:?}, not {away:?}");
            compared += 1;
            on_ridges +=
                usize::from(all.iter().filter(|&&t| (to_triangle(t, centre).0 - right).abs() < 1e-9).count() > 1);
            // Nothing else is nearer than the margin but what the manifolds say, and all of it is on the surface.
            for (_, manifold) in manifolds(&ball, &pose, &field, &Pose::IDENTITY) {
                for point in manifold.points() {
                    let surface = add(
                        add(centre, floats(point.r_a)),
                        scale(0.5 * point.separation.to_f64(), direction(manifold.normal)),
                    );
                    let off = all.iter().map(|&t| to_triangle(t, surface).0).fold(f64::INFINITY, f64::min);
                    assert!(off <= allowance::<S>(), "{off} off the surface");
                }
            }
        }
        assert!(compared > 1200 && on_ridges > 100, "{compared}, {on_ridges}");
    }
}

#[test]
fn a_ball_is_as_far_from_a_field_as_from_its_triangles() {
    for &number in NUMBERS {
        scalars::run(number, Bumps);
    }
}

struct Ground;

impl Job for Ground {
    type Output = ();
    fn run<S: HostScalar>(self) {
        let deep = 1.0 / 1024.0;
        // Exactly so, but for micromath's root.
        let level = if allowance::<S>() > 16.0 * S::spacing(4.0) { 5e-6 } else { f64::MIN_POSITIVE };
        let flat = [S::ZERO; 81];
        let field = HeightField::new(&flat, 9, 9, number::<S>(0.25)).expect("a field");
        let mut random = Random::new(3);
        for case in 0..300 {
            // On grid lines and corners of the grid as often as elsewhere.
            let step = if case % 2 == 0 { 8.0 } else { 4096.0 };
            let place = [0, 1].map(|_| (random.between(-0.5, 0.5) * step).round() / step);
            let ball = Sphere::new(number::<S>(0.125)).expect("a ball");
            let found =
                manifolds(&ball, &Pose::at(vector([place[0], place[1], 0.125 - deep])), &field, &Pose::IDENTITY);
            let [(_, manifold)] = found.as_slice() else { panic!("{place:?}: {found:?}") };
            assert!(
                norm(sub(direction(manifold.normal), [0.0, 0.0, -1.0])) < level && manifold.points().len() == 1,
                "{place:?}"
            );
            let cuboid = Cuboid::new(vector::<S>([0.375, 0.25, 0.125])).expect("a box");
            let found =
                manifolds(&cuboid, &Pose::at(vector([place[0], place[1], 0.125 - deep])), &field, &Pose::IDENTITY);
            let [(_, manifold)] = found.as_slice() else { panic!("{place:?}: {found:?}") };
            assert!(
                norm(sub(direction(manifold.normal), [0.0, 0.0, -1.0])) < level && manifold.points().len() == 4,
                "{place:?}"
            );
            assert!(manifold.points().iter().all(|point| (point.separation.to_f64() + deep).abs() <= level));
        }
        // Beside the grid there is nothing.
        let ball = Sphere::new(number::<S>(0.125)).expect("a ball");
        assert!(manifolds(&ball, &Pose::at(vector([1.5, 0.0, 0.0])), &field, &Pose::IDENTITY).is_empty());
        // A groove along y holds a ball by both its walls; seen from the field, the same mirrored.
        let groove: Vec<S> =
            (0..15).map(|k| number(if k % 5 == 2 { 0.0 } else { 0.5 * f64::from((k % 5 - 2_i32).abs()) })).collect();
        let field = HeightField::new(&groove, 5, 3, number::<S>(0.5)).expect("a field");
        let top = 0.25 * 2.0_f64.sqrt() - deep;
        let ball = Sphere::new(number::<S>(0.25)).expect("a ball");
        let pose = Pose::at(vector([0.0, 0.125, top]));
        let found = manifolds(&ball, &pose, &field, &Pose::IDENTITY);
        assert_eq!(found.len(), 2, "{found:?}");
        assert_ne!(found[0].0, found[1].0, "two parts");
        for (_, manifold) in &found {
            let n = direction(manifold.normal);
            assert!((n[0].abs() - 0.5_f64.sqrt()).abs() < 1e-3 && (n[2] + 0.5_f64.sqrt()).abs() < 1e-3, "{n:?}");
            assert!((manifold.points()[0].separation.to_f64() + deep * 0.5_f64.sqrt()).abs() < allowance::<S>());
        }
        let mut mirrored = manifolds(&field, &Pose::IDENTITY, &ball, &pose);
        mirrored.iter_mut().for_each(|(_, manifold)| manifold.swap());
        assert_eq!(mirrored, found);
        // On a ridge a box balances: two points on the edge of the ridge, straight down.
        let ridge: Vec<S> = groove.iter().map(|h| h.negated()).collect();
        let field = HeightField::new(&ridge, 5, 3, number::<S>(0.5)).expect("a field");
        let cuboid = Cuboid::new(vector::<S>([0.25, 0.125, 0.125])).expect("a box");
        let found = manifolds(&cuboid, &Pose::at(vector([0.0, 0.25, 0.125 - deep])), &field, &Pose::IDENTITY);
        let [(_, manifold)] = found.as_slice() else { panic!("{found:?}") };
        assert!(norm(sub(direction(manifold.normal), [0.0, 0.0, -1.0])) < 1e-6, "{manifold:?}");
        let mut places: Vec<f64> = manifold.points().iter().map(|point| floats(point.r_a)[1]).collect();
        places.sort_by(f64::total_cmp);
        assert_eq!(places.len(), 2, "{manifold:?}");
        assert!((places[0] + 0.125).abs() < 1e-3 && (places[1] - 0.125).abs() < 1e-3, "{places:?}");
    }
}

#[test]
fn ground_pushes_where_it_is() {
    for &number in NUMBERS {
        scalars::run(number, Ground);
    }
}
