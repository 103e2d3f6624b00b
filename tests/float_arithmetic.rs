//! The floating-point types: square roots against correctly rounded values, and the ends of the range.
#![cfg(any(feature = "f32", feature = "micromath", feature = "f64"))]

#[cfg(all(feature = "f32", feature = "f64"))]
#[path = "support/random.rs"]
mod random;

use carom::Scalar;
#[cfg(feature = "f32")]
use carom::Scaled;

/// The rows of one function of the table of correctly rounded values: bits of x, bits of y.
#[cfg(any(feature = "f32", feature = "micromath"))]
fn table(function: &str) -> Vec<(f32, f32)> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/f32_unary.csv");
    let mut reader = csv::Reader::from_path(path).expect("the table");
    let float = |bits: &str| f32::from_bits(u32::from_str_radix(bits, 16).expect("bits"));
    let rows: Vec<_> = reader
        .records()
        .map(|row| row.expect("a row"))
        .filter(|row| &row[0] == function)
        .map(|row| (float(&row[1]), float(&row[3])))
        .collect();
    assert!(rows.len() > 400, "{} rows of {function}", rows.len());
    rows
}

#[cfg(feature = "f32")]
#[test]
fn f32_roots_and_quotients_are_correctly_rounded() {
    for (x, y) in table("sqrt") {
        assert_eq!(Scalar::sqrt(x).to_bits(), y.to_bits(), "sqrt {x}");
    }
    for (x, y) in table("recip") {
        assert_eq!(1f32.over(x).to_bits(), y.to_bits(), "1/{x}");
    }
    // Against the host's own root, which is correctly rounded too: a comb over all positive numbers.
    for bits in (0..0x7f80_0000).step_by(9973) {
        let x = f32::from_bits(bits);
        assert_eq!(Scalar::sqrt(x).to_bits(), x.sqrt().to_bits(), "sqrt {x}");
    }
    assert!(Scalar::sqrt(-1f32).is_nan());
}

#[cfg(feature = "f64")]
#[test]
fn f64_roots_are_correctly_rounded() {
    for bits in (0..0x7ff0_0000_0000_0000u64).step_by(99_999_999_999_989) {
        let x = f64::from_bits(bits);
        assert_eq!(Scalar::sqrt(x).to_bits(), x.sqrt().to_bits(), "sqrt {x}");
    }
}

/// Every mantissa under both parities of the exponent, and the table over the whole range.
#[cfg(feature = "micromath")]
#[test]
fn micromath_roots_are_within_their_bound() {
    use micromath::F32;
    let off = |x: f32| {
        let exact = f64::from(x).sqrt();
        ((f64::from(Scalar::sqrt(F32(x)).0) - exact) / exact).abs()
    };
    let worst = (0x3f80_0000..0x4080_0000).step_by(3).map(|bits| off(f32::from_bits(bits))).fold(0.0, f64::max);
    println!("micromath: worst root off by {worst:.2e}, micromath's own by {:.2e}", {
        let own = |x: f32| ((f64::from(F32(x).sqrt().0) - f64::from(x).sqrt()) / f64::from(x).sqrt()).abs();
        (0x3f80_0000..0x4080_0000).step_by(1001).map(|bits| own(f32::from_bits(bits))).fold(0.0, f64::max)
    });
    assert!(worst < 1e-5 && worst > 1e-7);
    for (x, y) in table("sqrt") {
        assert!(((Scalar::sqrt(F32(x)).0 - y) / y).abs() < 1e-5, "sqrt {x}");
    }
    // All the small subnormal numbers and a comb over the others, up to the first normal one.
    for bits in (1..=4096).chain((4096..=0x0080_0000).step_by(101)) {
        let x = f32::from_bits(bits);
        assert!(off(x) < 1e-5, "sqrt {x:e}: off by {:e}", off(x));
    }
    assert_eq!(Scalar::sqrt(F32(0.0)).0, 0.0);
    assert_eq!(Scalar::sqrt(F32(f32::INFINITY)).0, f32::INFINITY);
    assert!(Scalar::sqrt(F32(-1.0)).0.is_nan() && Scalar::sqrt(F32(f32::NAN)).0.is_nan());
}

#[cfg(feature = "f32")]
#[test]
fn directions_of_very_short_and_very_long_vectors() {
    for size in [1e-45f32, 1e-40, 1e-30, 1e-10, 1.0, 1e10, 1e30, 2e38] {
        let [x, y, z] = f32::normalize3([size, -size, 0.0]).expect("a direction");
        assert!((x - 0.5f32.sqrt()).abs() < 1e-6 && (y + 0.5f32.sqrt()).abs() < 1e-6 && z == 0.0, "{size}: {x} {y}");
    }
    assert_eq!(f32::normalize3([0.0; 3]), None);
    assert_eq!(f32::normalize3([f32::NAN, 1.0, 1.0]), None);
    assert_eq!(f32::normalize3([f32::INFINITY, 1.0, 1.0]), None);
}

/// Operands up to 2^24 are exact in f32, and their quotient is rounded once; larger ones are rounded before.
#[cfg(all(feature = "f32", feature = "f64"))]
#[test]
fn ratios_of_f32_are_rounded_once_up_to_2_to_the_24() {
    let mut random = random::Random::new(17);
    let mut worst = 0.0f64;
    for case in 0..200_000 {
        let bits = if case % 2 == 0 { 8 } else { 1 };
        let (n, d) = ((random.next() as i32) >> bits, ((random.next() >> 1) as i32 >> (bits - 1)).max(1));
        let (exact, ratio) = (f64::from(n) / f64::from(d), f32::from_ratio(n, d).expect("a ratio"));
        if bits == 8 {
            // In f64 the quotient of 24 bits by 24 bits is too precise for a second rounding to matter.
            assert_eq!(ratio.to_bits(), (exact as f32).to_bits(), "{n}/{d}");
        } else {
            let ulp = f64::from(f32::EPSILON) * exact.abs().log2().floor().exp2();
            worst = worst.max((f64::from(ratio) - exact).abs() / ulp);
        }
    }
    println!("f32: ratios of operands of 31 bits are off by up to {worst:.2} units");
    assert!(worst <= 2.5 && worst > 1.5);
    assert!(f32::sub_step(i32::MAX - 1, i32::MAX).is_err(), "rounds to one");
    assert!(f64::sub_step(i32::MAX - 1, i32::MAX).is_ok());
    assert!(f32::sub_step((1 << 24) - 2, (1 << 24) - 1).is_ok());
}

#[cfg(feature = "f32")]
#[test]
fn lengths_keep_their_digits_where_their_squares_are_normal_numbers() {
    use carom::Vec3;
    for size in [1.1e-19f32, 1e-10, 1.0, 1e10, 3.6e18] {
        let length = Vec3::new(3.0 * size, -4.0 * size, 0.0).length();
        assert!((length / (5.0 * size) - 1.0).abs() < 2.0 * f32::EPSILON, "{size}: {length}");
    }
    assert_eq!(Vec3::new(1e-23f32, 0.0, 0.0).length(), 0.0);
    assert_eq!(Vec3::new(2e19f32, 0.0, 0.0).length(), f32::INFINITY);
}

#[cfg(feature = "f32")]
#[test]
fn scaled_parts_reach_every_exponent() {
    assert_eq!(f32::from_parts(3, -149), f32::from_bits(3));
    assert_eq!(f32::from_parts(1, 127), 2f32.powi(127));
    assert_eq!(f32::from_parts(1, 1000), f32::INFINITY);
    assert_eq!(f32::from_parts(-1, -1000), -0.0);
    assert_eq!(f32::from_parts(1 << 29, -29), 1.0);
}

/// 10 mm/s at 10 km over 1/240 s is a twentieth of f32's spacing there: carried, it arrives.
#[cfg(feature = "f32")]
#[test]
fn the_slowest_motion_arrives_far_from_the_origin() {
    let h = f32::sub_step(1, 240).expect("a sub-step");
    let (mut x, mut remainder) = (10_000.0f32, 0.0);
    for _ in 0..24_000 {
        x = x.advance(0.01, h, &mut remainder).0;
    }
    assert!((x - 10_001.0).abs() < 2e-3, "{x}");
    let plain = (0..24_000).fold(10_000.0f32, |x, _| x + 0.01 * h);
    assert_eq!(plain, 10_000.0, "without the carry it would stand still");
}
