//! Unit vectors, tangents, quaternions and rotated tensors against f64.

#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/host.rs"]
mod host;
#[path = "support/random.rs"]
mod random;
#[path = "support/rotation.rs"]
mod rotation;

use carom::{DirectionError, OrientationError, Quat, SymMat3, UnitVec3, Vec3};
use host::HostScalar;
use random::Random;
use rotation::matrix;

fn unit3<S: HostScalar>(v: Vec3<S::Unit>) -> [f64; 3] {
    v.to_array().map(S::unit_to_f64)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn random_direction<S: HostScalar>(random: &mut Random) -> UnitVec3<S> {
    loop {
        let v: [f64; 3] = std::array::from_fn(|_| random.between(-1.0, 1.0));
        if let [Some(x), Some(y), Some(z)] = v.map(S::from_f64) {
            return UnitVec3::normalize(Vec3::new(x, y, z)).expect("not zero");
        }
    }
}

fn name<S>() -> &'static str {
    std::any::type_name::<S>()
}

/// One unit of the last place of a component near one: 2^-30 in fixed point.
fn unit_spacing<S: HostScalar>() -> f64 {
    // Fixed point has the same spacing everywhere, at zero too.
    if S::spacing(0.0) > 0.0 { 2f64.powi(-30) } else { S::spacing(1.0) }
}

/// What micromath's root leaves of the length of a vector.
fn root_error<S: HostScalar>() -> f64 {
    if name::<S>().starts_with("micromath") { 1.6e-6 } else { 0.0 }
}

fn tangents<S: HostScalar>() {
    let mut random = Random::new(3);
    let axes = [UnitVec3::<S>::X, UnitVec3::Y, UnitVec3::Z, -UnitVec3::X, -UnitVec3::Y, -UnitVec3::Z];
    let bound = 4.0 * unit_spacing::<S>() + 2.0 * root_error::<S>();
    for case in 0..20_000 {
        let n = axes.get(case).copied().unwrap_or_else(|| random_direction(&mut random));
        let (t1, t2) = n.tangents();
        let [n64, a, b] = [n, t1, t2].map(|u| unit3::<S>(u.get()));
        let pairs = [dot(n64, a), dot(n64, b), dot(a, b), dot(a, a) - 1.0, dot(b, b) - 1.0];
        assert!(pairs.iter().all(|x| x.abs() <= bound), "{}: {pairs:?} for {n64:?}", name::<S>());
        let cross = [n64[1] * a[2] - n64[2] * a[1], n64[2] * a[0] - n64[0] * a[2], n64[0] * a[1] - n64[1] * a[0]];
        assert!(dot(cross, b) > 0.999, "{}: left-handed for {n64:?}", name::<S>());
        let (u1, u2) = (-n).tangents();
        assert!(u1 == t1 && u2 == -t2, "{}: the opposite direction has another frame", name::<S>());
    }
}

fn quaternions<S: HostScalar>() {
    let mut random = Random::new(5);
    let bound = unit_spacing::<S>();
    let mut worst = [0f64; 4];
    let mut last: Option<Quat<S>> = None;
    for _ in 0..20_000 {
        let raw: [f64; 4] = std::array::from_fn(|_| random.between(-0.9, 0.9));
        let [w, x, y, z] = raw.map(S::unit);
        let given = [w, x, y, z].map(S::unit_to_f64);
        let length = given.iter().map(|c| c * c).sum::<f64>().sqrt();
        let q = Quat::<S>::normalize(w, x, y, z).expect("not zero");
        let stored = q.to_array().map(S::unit_to_f64);
        for (c, g) in stored.iter().zip(given) {
            worst[0] = worst[0].max((c - g / length).abs() / bound);
        }
        for (row, expected) in q.to_mat3().rows.iter().zip(matrix(stored)) {
            for (m, e) in unit3::<S>(*row).iter().zip(expected) {
                worst[1] = worst[1].max((m - e).abs() / bound);
            }
        }
        if let Some(p) = last {
            let ([a, b, c, d], [e, f, g, h]) = (p.to_array().map(S::unit_to_f64), stored);
            let expected = [
                a * e - b * f - c * g - d * h,
                a * f + b * e + c * h - d * g,
                a * g - b * h + c * e + d * f,
                a * h + b * g - c * f + d * e,
            ];
            for (m, e) in (p * q).to_array().map(S::unit_to_f64).iter().zip(expected) {
                worst[2] = worst[2].max((m - e).abs() / bound);
            }
        }
        last = Some(q);

        let v: [f64; 3] = std::array::from_fn(|_| random.between(-50.0, 50.0));
        let [vx, vy, vz] = v.map(|x| S::from_f64(x).expect("in range"));
        let rotated = q.rotate(Vec3::new(vx, vy, vz)).to_array().map(S::to_f64);
        let exact = [vx, vy, vz].map(S::to_f64);
        let length = dot(exact, exact).sqrt();
        let unit = S::spacing(length) + length * bound;
        for (r, row) in rotated.iter().zip(matrix(stored)) {
            worst[3] = worst[3].max((r - dot(row, exact)).abs() / unit);
        }
    }
    println!("{}: worst units of normalize, matrix, product, rotate: {worst:.2?}", name::<S>());
    let root = root_error::<S>() / bound;
    assert!(
        worst[0] <= 3.0 + root && worst[1] <= 2.0 && worst[2] <= 2.0 && worst[3] <= 1.5,
        "{}: {worst:?}",
        name::<S>()
    );
}

/// The square of a quaternion may be far beyond the format of its components: up to 16 where they end at 2, and in floats
/// anything at all.
fn quaternions_of_any_length<S: HostScalar>() {
    let mut random = Random::new(6);
    let bound = unit_spacing::<S>();
    let is_fixed = S::spacing(0.0) > 0.0;
    let sizes: &[f64] = match S::from_f64(1e200) {
        Some(_) => &[1.99, 1e-200, 1e-150, 1e150, 1e200],
        None if is_fixed => &[1.99, 1.0, 1e-3],
        None => &[1.99, 1e-30, 1e-19, 1e19, 1e25, 1e38],
    };
    let mut worst = 0f64;
    for case in 0..5_000 {
        let signs = std::array::from_fn(|i| if case >> i & 1 == 0 { 1.0 } else { -1.0 });
        let raw: [f64; 4] = if case < 16 { signs } else { std::array::from_fn(|_| random.between(-1.0, 1.0)) };
        for size in sizes {
            let [w, x, y, z] = raw.map(|c| S::unit(c * size));
            let given = [w, x, y, z].map(|c| S::unit_to_f64(c) / size);
            let length = given.iter().map(|c| c * c).sum::<f64>().sqrt();
            let q = Quat::<S>::normalize(w, x, y, z).unwrap_or_else(|e| panic!("{}: {size} {raw:?}: {e}", name::<S>()));
            for (c, g) in q.to_array().map(S::unit_to_f64).iter().zip(given) {
                worst = worst.max((c - g / length).abs() / bound);
            }
        }
    }
    println!("{}: worst units of normalize at any length: {worst:.2}", name::<S>());
    assert!(worst <= 3.0 + root_error::<S>() / bound, "{}: {worst}", name::<S>());
}

fn tensors<S: HostScalar>() {
    let mut random = Random::new(9);
    let bound = 6.0 * unit_spacing::<S>();
    for _ in 0..5_000 {
        let [xx, xy, xz, yy, yz, zz] = std::array::from_fn(|_| S::unit(random.between(-0.28, 0.28)));
        let a = SymMat3 { xx, xy, xz, yy, yz, zz };
        let [w, x, y, z] = std::array::from_fn(|_| S::unit(random.between(-0.9, 0.9)));
        let q = Quat::<S>::normalize(w, x, y, z).expect("not zero");
        let r = matrix(q.to_array().map(S::unit_to_f64));
        let [xx, xy, xz, yy, yz, zz] = [xx, xy, xz, yy, yz, zz].map(S::unit_to_f64);
        let full = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let b = a.rotated(&q.to_mat3());
        let rotated = [[b.xx, b.xy, b.xz], [b.xy, b.yy, b.yz], [b.xz, b.yz, b.zz]];
        for i in 0..3 {
            for j in 0..3 {
                let exact: f64 = (0..3).map(|k| r[i][k] * dot(full[k], r[j])).sum();
                let off = (S::unit_to_f64(rotated[i][j]) - exact).abs();
                // The lengths of the stored quaternion and of its rows count here: R R^T = 1 within a few units.
                assert!(off <= bound + root_error::<S>(), "{}: {off:e} at {i}{j}", name::<S>());
            }
        }
        let isotropic = SymMat3::diagonal(a.xx, a.xx, a.xx);
        assert_eq!(isotropic.rotated(&q.to_mat3()), isotropic);
    }
}

fn refusals<S: HostScalar>() {
    let (one, zero) = (S::unit(1.0), S::unit(0.0));
    let half = S::unit(0.5);
    assert_eq!(UnitVec3::<S>::new(Vec3::new(one, zero, zero)), Ok(UnitVec3::X));
    assert_eq!(UnitVec3::<S>::new(Vec3::new(half, zero, zero)), Err(DirectionError::NotUnit));
    assert_eq!(UnitVec3::<S>::new(Vec3::new(zero, zero, zero)), Err(DirectionError::Zero));
    assert_eq!(UnitVec3::<S>::normalize(Vec3::ZERO), Err(DirectionError::Zero));
    assert!(UnitVec3::<S>::new(Vec3::new(S::unit(1.0 - 1e-4), zero, zero)).is_err());
    assert_eq!(Quat::<S>::new(one, zero, zero, zero), Ok(Quat::IDENTITY));
    assert!(Quat::<S>::new(half, half, half, half).is_ok());
    assert_eq!(Quat::<S>::new(half, half, half, zero), Err(OrientationError::NotUnit));
    assert_eq!(Quat::<S>::new(zero, zero, zero, zero), Err(OrientationError::Zero));
    assert_eq!(Quat::<S>::normalize(zero, zero, zero, zero), Err(OrientationError::Zero));
}

macro_rules! in_every_type {
    ($($test:ident)+) => {$(
        mod $test {
            #[cfg(feature = "f32")]
            #[test]
            fn f32() {
                super::super::$test::<f32>();
            }
            #[cfg(feature = "f64")]
            #[test]
            fn f64() {
                super::super::$test::<f64>();
            }
            #[cfg(feature = "micromath")]
            #[test]
            fn micromath() {
                super::super::$test::<micromath::F32>();
            }
            #[cfg(feature = "fixed")]
            #[test]
            fn fixed() {
                super::super::$test::<fixed::types::I16F16>();
                super::super::$test::<fixed::types::I12F20>();
                super::super::$test::<fixed::types::I8F24>();
            }
        }
    )+};
}

mod scalars {
    in_every_type! { tangents quaternions quaternions_of_any_length tensors refusals }
}

#[cfg(feature = "f32")]
#[test]
fn what_is_not_finite_is_refused_by_name() {
    let nan = f32::NAN;
    assert_eq!(UnitVec3::<f32>::new(Vec3::new(nan, 0.0, 1.0)), Err(DirectionError::NotFinite));
    assert_eq!(UnitVec3::<f32>::normalize(Vec3::new(0.0, f32::INFINITY, 1.0)), Err(DirectionError::NotFinite));
    assert_eq!(Quat::<f32>::new(1.0, nan, 0.0, 0.0), Err(OrientationError::NotFinite));
    assert_eq!(Quat::<f32>::normalize(1.0, f32::INFINITY, 0.0, 0.0), Err(OrientationError::NotFinite));
}
