//! Mass and inertia: of solids against published figures and numerical integration, of given tensors, in the world's frame.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/host.rs"]
mod host;
#[path = "support/random.rs"]
mod random;

use carom::{Body, MassError, MassProperties, Quat, Scaled, Solid, SolidError, SymMat3, Vec3};
use host::HostScalar;
use random::Random;

/// Runs a generic check in every number type of the features under test.
macro_rules! in_all {
    ($check:ident) => {
        #[cfg(feature = "f32")]
        $check::<f32>();
        #[cfg(feature = "f64")]
        $check::<f64>();
        #[cfg(feature = "micromath")]
        $check::<micromath::F32>();
        #[cfg(feature = "fixed")]
        {
            $check::<fixed::types::I16F16>();
            $check::<fixed::types::I12F20>();
            $check::<fixed::types::I8F24>();
        }
    };
}

/// The spacing of intermediate numbers just above one: what a single operation may lose, relatively.
fn epsilon<S: HostScalar>() -> f64 {
    S::scaled_to_f64(S::Scaled::EPSILON)
}

fn number<S: HostScalar>(x: f64) -> S {
    S::from_f64(x).expect("within the format")
}

fn name<S: HostScalar>() -> String {
    let path = std::any::type_name::<S>();
    let fixed = path.contains("FixedI32");
    if fixed { format!("fixed point with steps of {:.1e}", S::spacing(1.0)) } else { path.to_owned() }
}

/// Mass and principal moments, read back from the inverses that a body has.
fn read<S: HostScalar>(properties: MassProperties<S>) -> [f64; 4] {
    let body = Body::dynamic(properties);
    let [x, xy, xz, y, yz, z] = body.inv_inertia_local().map(S::scaled_to_f64);
    assert_eq!([xy, xz, yz], [0.0; 3]);
    [S::scaled_to_f64(body.inv_mass()), x, y, z].map(|inverse| 1.0 / inverse)
}

#[track_caller]
fn assert_near(found: f64, right: f64, bound: f64, what: &str) {
    let error = (found / right - 1.0).abs();
    assert!(error <= bound, "{what}: {found} instead of {right}, off by {error:e}, more than {bound:e}");
}

/// One row of published mass properties.
struct Published {
    line: &'static str,
    shape: &'static str,
    dimensions: Vec<f64>,
    density: f64,
    volume: f64,
    /// Mass and moments.
    values: [f64; 4],
}

fn published() -> Vec<Published> {
    let rows = include_str!("data/mass_properties.csv").lines().skip(1).map(|line| {
        let cells: Vec<&'static str> = line.split(',').collect();
        let parse = |text: &str| text.parse::<f64>().expect("a number");
        let dimensions = cells[1].split_whitespace().map(|word| parse(word.rsplit('=').next().expect("a value")));
        Published {
            line,
            shape: cells[0],
            dimensions: dimensions.collect(),
            density: parse(cells[2]),
            volume: parse(cells[3]),
            values: [4, 5, 6, 7].map(|column| parse(cells[column])),
        }
    });
    rows.collect()
}

fn solids_are_as_published<S: HostScalar>() {
    let mut compared = 0;
    let rows = published();
    for row in &rows {
        let dimensions: Option<Vec<S>> = row.dimensions.iter().map(|&x| S::from_f64(x)).collect();
        let (Some(d), Some(density)) = (dimensions, S::from_f64(row.density)) else { continue };
        let solid = match row.shape {
            "sphere" => Solid::sphere(d[0]),
            "box" => Solid::cuboid(Vec3::new(d[0], d[1], d[2])),
            "capsule_z" => Solid::capsule(d[0], d[1]),
            other => panic!("a {other}"),
        }
        .expect("good dimensions");
        // The rounding of the dimensions: three times in the volume, five times in a moment.
        let rounding = |x: f64| (number::<S>(x).to_f64() / x - 1.0).abs();
        let given: f64 = row.dimensions.iter().filter(|x| **x != 0.0).map(|&x| rounding(x)).fold(0.0, f64::max);
        let own = (16.0 * epsilon::<S>()).min(1e-6);
        let what = |value: &str| format!("{}: {value} of {}", name::<S>(), row.line);
        assert_near(S::scaled_to_f64(solid.measure()), row.volume, 3.1 * given + own, &what("the volume"));
        let found = read(solid.with_density(density).expect("a good density"));
        let given = 5.1 * given + rounding(row.density);
        for (k, value) in ["mass", "Ixx", "Iyy", "Izz"].iter().enumerate() {
            // The file has 15 digits.
            assert_near(found[k], row.values[k], given + own + 2e-14, &what(value));
        }
        compared += 1;
    }
    // A density of 1000 is beyond I8F24.
    let expected = if S::from_f64(1000.0).is_some() { 14 } else { 11 };
    assert_eq!((rows.len(), compared), (14, expected), "{}", name::<S>());
}

#[test]
fn spheres_boxes_and_capsules_are_as_published() {
    in_all!(solids_are_as_published);
}

/// Simpson's rule.
fn integral(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    const STEPS: usize = 2000;
    let h = (to - from) / STEPS as f64;
    let weight = |k| if k == 0 || k == STEPS { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
    (0..=STEPS).map(|k| weight(k) * f(from + h * k as f64)).sum::<f64>() * h / 3.0
}

/// Measure and moments per mass of a stack of elliptical discs with semi-axes a(z), b(z), about its centre of mass.
fn stack(from: f64, to: f64, axes: impl Fn(f64) -> [f64; 2]) -> [f64; 4] {
    use std::f64::consts::PI;
    let area = |z: f64| PI * axes(z)[0] * axes(z)[1];
    let volume = integral(from, to, area);
    let centre = integral(from, to, |z| z * area(z)) / volume;
    let [x2, y2] = [0, 1].map(|k| integral(from, to, |z| area(z) * axes(z)[k].powi(2) / 4.0) / volume);
    let z2 = integral(from, to, |z| (z - centre).powi(2) * area(z)) / volume;
    [volume, y2 + z2, x2 + z2, x2 + y2]
}

/// The same of a stack of rings with radius R and width 2 pi R dl.
fn rings(from: f64, to: f64, ring: impl Fn(f64) -> [f64; 3]) -> [f64; 4] {
    // Of a parameter: the radius, the height, and dl by it.
    let width = |t: f64| std::f64::consts::TAU * ring(t)[0] * ring(t)[2];
    let area = integral(from, to, width);
    let r2 = integral(from, to, |t| ring(t)[0].powi(2) * width(t)) / area;
    let z2 = integral(from, to, |t| ring(t)[1].powi(2) * width(t)) / area;
    [area, r2 / 2.0 + z2, r2 / 2.0 + z2, r2]
}

fn solids_are_as_integrated<S: HostScalar>() {
    use std::f64::consts::PI;
    for [a, b, c] in [[0.5, 1.25, 2.0], [3.0, 0.25, 0.75], [0.0625, 0.125, 0.03125], [1.0, 1.0, 1.0]] {
        // Exact in every format.
        let [x, y, z] = [a, b, c].map(number::<S>);
        let half_disc = |r: f64, z: f64| (r * r - z * z).max(0.0).sqrt();
        for (what, solid, right) in [
            ("ellipsoid", Solid::ellipsoid(Vec3::new(x, y, z)), {
                stack(-c, c, |z| [a, b].map(|axis| axis * (1.0 - (z / c).powi(2)).max(0.0).sqrt()))
            }),
            ("sphere", Solid::sphere(x), stack(-a, a, |z| [half_disc(a, z); 2])),
            ("cylinder", Solid::cylinder(x, y), stack(-b, b, |_| [a, a])),
            ("cone", Solid::cone(x, y), stack(0.0, b, |z| [a * (1.0 - z / b); 2])),
            ("tube", Solid::tube(x, y), rings(-b, b, |z| [a, z, 1.0])),
            ("shell", Solid::spherical_shell(x), rings(0.0, PI, |t| [a * t.sin(), a * t.cos(), a])),
            ("capsule", Solid::capsule(x, y), {
                // Three pieces, for the rule to be exact on each.
                let ends = |z: f64| [half_disc(a, z.abs() - b); 2];
                let pieces = [(-b - a, -b), (-b, b), (b, b + a)].map(|(from, to)| {
                    let axes = |z: f64| if z.abs() <= b { [a, a] } else { ends(z) };
                    let [volume, ..] = stack(from, to, axes);
                    let second = integral(from, to, |z| z * z * PI * axes(z)[0].powi(2));
                    let across = integral(from, to, |z| PI * axes(z)[0].powi(4) / 4.0);
                    [volume, second, across]
                });
                let [volume, z2, r2] = [0, 1, 2].map(|k| pieces.iter().map(|piece| piece[k]).sum::<f64>());
                [volume, (z2 + r2) / volume, (z2 + r2) / volume, 2.0 * r2 / volume]
            }),
        ] {
            let solid = solid.expect("good dimensions");
            let bound = (16.0 * epsilon::<S>()).clamp(1e-12, 1e-6);
            let what = format!("{}: {what} of {a}, {b}, {c}", name::<S>());
            assert_near(S::scaled_to_f64(solid.measure()), right[0], bound, &what);
            let moments = solid.moments().map(S::scaled_to_f64);
            for k in 0..3 {
                assert_near(moments[k], right[k + 1], bound, &what);
            }
            let properties = solid.with_mass(number(2.5)).expect("a good mass");
            for (found, right) in read(properties).into_iter().zip([1.0, right[1], right[2], right[3]]) {
                assert_near(found, 2.5 * right, 2.0 * bound, &what);
            }
        }
    }
}

#[test]
fn solids_are_as_integrated_over_their_volume() {
    in_all!(solids_are_as_integrated);
}

type Matrix = [[f64; 3]; 3];

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

fn transposed(a: &Matrix) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| a[j][i]))
}

fn diagonal(d: [f64; 3]) -> Matrix {
    [[d[0], 0.0, 0.0], [0.0, d[1], 0.0], [0.0, 0.0, d[2]]]
}

fn largest_difference(a: &Matrix, b: &Matrix) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

fn full([xx, xy, xz, yy, yz, zz]: [f64; 6]) -> Matrix {
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// By Rodrigues' formula, not by the kernel's products of quaternion components.
fn rotation(q: [f64; 4]) -> Matrix {
    let sine = (q[1] * q[1] + q[2] * q[2] + q[3] * q[3]).sqrt();
    if sine == 0.0 {
        return diagonal([1.0; 3]);
    }
    let angle = 2.0 * sine.atan2(q[0]);
    let [x, y, z] = [q[1], q[2], q[3]].map(|c| c / sine);
    let cross = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    let square = product(&cross, &cross);
    let entry = |i: usize, j: usize| {
        f64::from(u8::from(i == j)) + angle.sin() * cross[i][j] + (1.0 - angle.cos()) * square[i][j]
    };
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
}

/// A reproducible spread of orientations: w, x, y, z of unit length.
fn orientations() -> Vec<[f64; 4]> {
    let mut random = Random::new(15);
    let mut all = vec![[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, -1.0], [0.5, -0.5, 0.5, 0.5]];
    while all.len() < 1000 {
        let q: [f64; 4] = std::array::from_fn(|_| random.between(-1.0, 1.0));
        let length = q.iter().map(|c| c * c).sum::<f64>().sqrt();
        if (0.1..=1.0).contains(&length) {
            all.push(q.map(|c| c / length));
        }
    }
    all
}

fn orientation<S: HostScalar>(q: [f64; 4]) -> Quat<S> {
    let [w, x, y, z] = q.map(S::unit);
    Quat::new(w, x, y, z).expect("of unit length")
}

fn symmetric<S: HostScalar>(m: &Matrix) -> SymMat3<S> {
    let entry = |i: usize, j: usize| number(m[i][j]);
    SymMat3 { xx: entry(0, 0), xy: entry(0, 1), xz: entry(0, 2), yy: entry(1, 1), yz: entry(1, 2), zz: entry(2, 2) }
}

const PRINCIPAL: [[f64; 3]; 4] = [[3.0, 4.0, 5.0], [1.0, 1.0, 1.9375], [40.0, 40.0, 1.25], [0.5, 7.0, 7.25]];

fn tensors_are_inverted<S: HostScalar>() {
    let mut worst = 0.0_f64;
    // Of any size that a float holds: the determinant is of the third power.
    let sizes: &[f64] = match S::from_f64(1e200) {
        Some(_) => &[1.0, 1e-250, 1e-105, 1e105, 1e250],
        None if S::from_f64(1e30).is_some() => &[1.0, 1e-30, 1e-20, 1e-14, 1e12, 1e20, 1e30],
        None => &[1.0],
    };
    for (moments, size) in PRINCIPAL.iter().flat_map(|&moments| sizes.iter().map(move |&size| (moments, size))) {
        for q in orientations() {
            let r = rotation(q);
            let sized = diagonal(moments.map(|x| x * size));
            let tensor: SymMat3<S> = symmetric(&product(&product(&r, &sized), &transposed(&r)));
            let SymMat3 { xx, xy, xz, yy, yz, zz } = tensor;
            let stored = full([xx, xy, xz, yy, yz, zz].map(S::to_f64));
            let properties = MassProperties::new(number(2.0), tensor).expect("a good tensor");
            let body = Body::dynamic(properties);
            assert_eq!(S::scaled_to_f64(body.inv_mass()), 0.5);
            let inverse = full(body.inv_inertia_local().map(S::scaled_to_f64));
            // The cofactors lose what their terms cancel, and all are rounded on the scale of the largest entry.
            let condition =
                moments.iter().fold(0.0, |m: f64, &x| m.max(x)) / moments.iter().fold(f64::MAX, |m, &x| m.min(x));
            let bound = 4.0 * condition * condition * epsilon::<S>();
            let error = largest_difference(&product(&stored, &inverse), &diagonal([1.0; 3]));
            worst = worst.max(error / bound);
            assert!(error <= bound, "{}, {moments:?} * {size:e}, {q:?}: {error:e} of {bound:e}", name::<S>());
        }
    }
    println!("{}: {worst:.2} of the bound", name::<S>());
}

#[test]
fn an_inverse_tensor_times_the_tensor_is_one() {
    in_all!(tensors_are_inverted);
}

fn world_tensors<S: HostScalar>() {
    let mut worst = 0.0_f64;
    for inverse in [[0.5, 0.25, 2.0], [1e-4, 3e-4, 2e-4], [6e4, 5e4, 1e4], [1.0, 1.0, 40.0]] {
        let properties = MassProperties::<S>::from_inverses(S::scaled(1.0), inverse.map(S::scaled));
        let mut body = Body::dynamic(properties.expect("good inverses"));
        let trace: f64 = inverse.iter().sum();
        for q in orientations() {
            body.set_orientation(orientation(q));
            let r = rotation(q);
            let right = product(&product(&r, &diagonal(inverse)), &transposed(&r));
            let found = full(body.inv_inertia_world().map(S::scaled_to_f64));
            let (error, bound) = (largest_difference(&found, &right) / trace, 8.0 * epsilon::<S>());
            worst = worst.max(error / bound);
            assert!(error <= bound, "{}, {inverse:?}, {q:?}: {error:e} of {bound:e}", name::<S>());
            let [xx, _, _, yy, _, zz] = body.inv_inertia_local().map(S::scaled_to_f64);
            assert_near(xx + yy + zz, trace, 4.0 * epsilon::<S>(), "the local tensor stays");
        }
    }
    println!("{}: {worst:.2} of the bound", name::<S>());
}

#[test]
fn world_tensors_are_the_local_ones_turned() {
    in_all!(world_tensors);
}

fn isotropic_tensors<S: HostScalar>() {
    for radius in [0.03125, 0.3, 2.0] {
        let solid = Solid::<S>::sphere(number(radius)).expect("a radius");
        let mut body = Body::dynamic(solid.with_mass(number(0.75)).expect("a mass"));
        let before = body.inv_inertia_world();
        for q in orientations() {
            body.set_orientation(orientation(q));
            assert_eq!(body.inv_inertia_world(), before, "{}: bit for bit", name::<S>());
        }
    }
}

#[test]
fn the_tensor_of_a_sphere_turns_into_itself() {
    in_all!(isotropic_tensors);
}

/// Zero, and numbers that are negative or, in floating point, not finite.
fn bad_dimensions<S: HostScalar>() -> Vec<S> {
    let mut bad = vec![S::ZERO, number(-1.0)];
    let odd = [S::ONE.over(S::ZERO), S::ONE.negated().over(S::ZERO), S::ZERO.over(S::ZERO)];
    bad.extend(odd.into_iter().filter(|x| !x.is_finite()));
    bad
}

fn bad_solids<S: HostScalar>() {
    let good: S = number(0.5);
    for bad in bad_dimensions::<S>() {
        assert_eq!(Solid::sphere(bad), Err(SolidError::Radius));
        assert_eq!(Solid::spherical_shell(bad), Err(SolidError::Radius));
        assert_eq!(Solid::cylinder(bad, good), Err(SolidError::Radius));
        assert_eq!(Solid::cylinder(good, bad), Err(SolidError::HalfLength));
        assert_eq!(Solid::tube(bad, good), Err(SolidError::Radius));
        assert_eq!(Solid::tube(good, bad), Err(SolidError::HalfLength));
        assert_eq!(Solid::cone(bad, good), Err(SolidError::Radius));
        assert_eq!(Solid::cone(good, bad), Err(SolidError::Height));
        assert_eq!(Solid::capsule(bad, good), Err(SolidError::Radius));
        assert_eq!(Solid::capsule(bad, S::ZERO), Err(SolidError::Radius));
        // A capsule without a cylinder is a sphere.
        let capsule = if bad == S::ZERO { Solid::sphere(good) } else { Err(SolidError::HalfLength) };
        assert_eq!(Solid::capsule(good, bad), capsule);
        for place in 0..3 {
            let mut v = [good; 3];
            v[place] = bad;
            assert_eq!(Solid::cuboid(Vec3::from_array(v)), Err(SolidError::HalfExtent));
            assert_eq!(Solid::ellipsoid(Vec3::from_array(v)), Err(SolidError::SemiAxis));
        }
        let solid = Solid::sphere(good).expect("a radius");
        assert_eq!(solid.with_mass(bad), Err(MassError::Mass));
        assert_eq!(solid.with_density(bad), Err(MassError::Density));
        let tensor = SymMat3::diagonal(good, good, good);
        assert_eq!(MassProperties::new(bad, tensor), Err(MassError::Mass));
        for place in 0..3 {
            let mut d = [good; 3];
            d[place] = bad;
            let tensor = SymMat3::diagonal(d[0], d[1], d[2]);
            assert_eq!(MassProperties::new(good, tensor), Err(MassError::Inertia), "{}: {d:?}", name::<S>());
        }
        if !bad.is_finite() {
            let tensor = SymMat3 { yz: bad, ..tensor };
            assert_eq!(MassProperties::new(good, tensor), Err(MassError::Inertia), "{}: {tensor:?}", name::<S>());
        }
    }
}

#[test]
fn bad_dimensions_and_masses_are_named() {
    in_all!(bad_solids);
}

/// Positive and finite, and still no solid in a float: 10^k and 10^-k are, for k from `cube` on, beyond its range in the
/// third power, from `square` on in the second.
#[cfg(any(feature = "f32", feature = "f64", feature = "micromath"))]
fn beyond_the_float<S: HostScalar>(cube: i32, square: i32) {
    let power = |k: i32| number::<S>(10f64.powi(k));
    let one = S::ONE;
    for sign in [1, -1] {
        let (cubed, squared) = (power(sign * cube), power(sign * square));
        for r in [cubed, squared] {
            assert_eq!(Solid::sphere(r), Err(SolidError::Radius));
            assert_eq!(Solid::capsule(r, S::ZERO), Err(SolidError::Radius));
            assert_eq!(Solid::capsule(r, r), Err(SolidError::Radius));
            assert_eq!(Solid::cylinder(r, r), Err(SolidError::Radius));
            assert_eq!(Solid::cone(r, r), Err(SolidError::Radius));
            assert_eq!(Solid::cuboid(Vec3::new(r, r, r)), Err(SolidError::HalfExtent));
            assert_eq!(Solid::ellipsoid(Vec3::new(r, r, r)), Err(SolidError::SemiAxis));
        }
        assert!(Solid::spherical_shell(cubed).is_ok() && Solid::tube(cubed, cubed).is_ok());
        assert_eq!(Solid::spherical_shell(squared), Err(SolidError::Radius));
        assert_eq!(Solid::tube(squared, squared), Err(SolidError::Radius));
    }
    // One dimension of two.
    let long = power(square);
    assert_eq!(Solid::cylinder(long, one), Err(SolidError::Radius));
    assert_eq!(Solid::cylinder(one, long), Err(SolidError::HalfLength));
    assert_eq!(Solid::tube(one, long), Err(SolidError::HalfLength));
    assert_eq!(Solid::capsule(one, long), Err(SolidError::HalfLength));
    assert_eq!(Solid::cone(one, long), Err(SolidError::Height));
    assert_eq!(Solid::cuboid(Vec3::new(one, long, one)), Err(SolidError::HalfExtent));
    assert_eq!(Solid::ellipsoid(Vec3::new(one, one, long)), Err(SolidError::SemiAxis));

    // The product with the mass: of 10^2k/3 and a moment of 10^k/2.
    for sign in [1, -1] {
        let k = 2 * square * sign;
        let solid = Solid::sphere(power(k / 4)).expect("a sphere");
        assert_eq!(solid.with_mass(power(2 * k / 3)), Err(MassError::Mass));
        assert_eq!(solid.with_density(power(k / 2)), Err(MassError::Density));
        let near = Solid::sphere(power(k / 8)).expect("a sphere");
        assert!(near.with_mass(power(k / 2)).is_ok() && near.with_density(power(k / 4)).is_ok());
    }
    // A tensor up to the ends of the range.
    for sign in [1, -1] {
        let moment = power(sign * (2 * square - 5));
        let found = read(MassProperties::new(one, SymMat3::diagonal(moment, moment, moment)).expect("a tensor"));
        assert_near(found[1], moment.to_f64(), 2.0 * epsilon::<S>(), &name::<S>());
    }
    // A moment has all its digits, or there is none: below the normal numbers it would be off by up to a third.
    for k in -square * 2..-cube {
        if let Ok(shell) = Solid::<S>::spherical_shell(power(k)) {
            let right = power(k).to_f64().powi(2) * 2.0 / 3.0;
            assert_near(S::scaled_to_f64(shell.moments()[0]), right, 4.0 * epsilon::<S>(), &name::<S>());
        }
    }
}

#[cfg(any(feature = "f32", feature = "f64", feature = "micromath"))]
#[test]
fn what_a_float_cannot_hold_is_named() {
    #[cfg(feature = "f32")]
    beyond_the_float::<f32>(14, 20);
    #[cfg(feature = "micromath")]
    beyond_the_float::<micromath::F32>(14, 20);
    #[cfg(feature = "f64")]
    beyond_the_float::<f64>(106, 156);
}

fn bad_tensors<S: HostScalar>() {
    let mass: S = number(1.0);
    let new = |m: [f64; 6]| {
        let [xx, xy, xz, yy, yz, zz] = m.map(number::<S>);
        MassProperties::new(mass, SymMat3 { xx, xy, xz, yy, yz, zz })
    };
    // Symmetric, but with a negative or a vanishing eigenvalue.
    assert_eq!(new([1.0, 2.0, 0.0, 1.0, 0.0, 1.0]), Err(MassError::Inertia));
    assert_eq!(new([1.0, 1.0, 0.0, 1.0, 0.0, 1.0]), Err(MassError::Inertia));
    assert_eq!(new([2.0, 0.0, 1.5, 2.0, 1.5, 2.0]), Err(MassError::Inertia));
    // No distribution of mass has them: the third moment exceeds the sum of the others, in whatever frame.
    assert_eq!(new([1.0, 0.0, 0.0, 1.0, 0.0, 2.125]), Err(MassError::Triangle));
    assert_eq!(new([2.125, 0.0, 0.0, 1.0, 0.0, 1.0]), Err(MassError::Triangle));
    for q in orientations().into_iter().take(50) {
        let r = rotation(q);
        let turned = |moments| symmetric::<S>(&product(&product(&r, &diagonal(moments)), &transposed(&r)));
        assert_eq!(MassProperties::new(mass, turned([1.0, 2.0, 3.125])), Err(MassError::Triangle));
        // A lamina is just possible.
        assert!(MassProperties::new(mass, turned([1.0, 2.0, 3.0])).is_ok(), "{}: {q:?}", name::<S>());
    }
    assert!(new([1.0, 0.0, 0.0, 1.0, 0.0, 2.0]).is_ok());

    let inverses = |m: f64, i: [f64; 3]| MassProperties::<S>::from_inverses(S::scaled(m), i.map(S::scaled));
    assert_eq!(inverses(0.0, [1.0; 3]), Err(MassError::Mass));
    assert_eq!(inverses(-1.0, [1.0; 3]), Err(MassError::Mass));
    assert_eq!(inverses(1.0, [1.0, -1.0, 1.0]), Err(MassError::Inertia));
    assert_eq!(inverses(1.0, [1.0, 1.0, -1e-3]), Err(MassError::Inertia));
}

#[test]
fn impossible_tensors_are_named() {
    in_all!(bad_tensors);
}

fn locked<S: HostScalar>() {
    let solid = Solid::<S>::cuboid(Vec3::new(number(0.5), number(1.0), number(0.25))).expect("a box");
    let free = solid.with_mass(number(2.0)).expect("a mass");
    let mut body = Body::dynamic(free.with_locked_rotation());
    body.set_orientation(orientation([0.5, 0.5, -0.5, 0.5]));
    assert_eq!(body.inv_inertia_world(), [S::Scaled::ZERO; 6]);
    assert_eq!(body.inv_mass(), Body::dynamic(free).inv_mass());
    assert!(!body.is_immovable() && Body::<S>::immovable().is_immovable());
    // About one axis only.
    let about_z =
        MassProperties::<S>::from_inverses(S::scaled(1.0), [S::Scaled::ZERO, S::Scaled::ZERO, S::scaled(3.0)]);
    let about_z = Body::dynamic(about_z.expect("a hinge")).inv_inertia_local().map(S::scaled_to_f64);
    assert_eq!(about_z, [0.0, 0.0, 0.0, 0.0, 0.0, 3.0]);
}

#[test]
fn rotation_can_be_locked() {
    in_all!(locked);
}

fn tiny_and_huge<S: HostScalar>() {
    // 1 cm and 10 g: an inverse inertia of 2.5e6, far beyond the format.
    let (radius, mass) = (number::<S>(0.01), number::<S>(0.01));
    let found = read(Solid::sphere(radius).expect("a sphere").with_mass(mass).expect("a mass"));
    let (radius, mass) = (radius.to_f64(), mass.to_f64());
    for moment in &found[1..] {
        assert_near(*moment, 0.4 * mass * radius * radius, 8.0 * epsilon::<S>(), &name::<S>());
    }
    // The largest number of a fixed-point format, cubed and multiplied with itself.
    let largest = if S::from_f64(3e4).is_some() { 3e4 } else { 120.0 };
    let solid = Solid::<S>::sphere(number(largest)).expect("a sphere");
    let found = read(solid.with_density(number(largest)).expect("a density"));
    let volume = 4.0 / 3.0 * std::f64::consts::PI * largest.powi(3);
    assert_near(found[0], volume * largest, 16.0 * epsilon::<S>(), &name::<S>());
    assert_near(found[1], 0.4 * volume * largest.powi(3), 16.0 * epsilon::<S>(), &name::<S>());
}

#[test]
fn a_format_holds_the_inertia_of_any_solid_it_can_measure() {
    in_all!(tiny_and_huge);
}
