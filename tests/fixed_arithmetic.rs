//! The fixed-point formats against exact integers: every operation is the exact result, rounded once to the nearest
//! with ties away from zero, or the end of the range. `CAROM_LONG=1` sweeps further.
#![cfg(feature = "fixed")]

#[path = "support/random.rs"]
mod random;

use carom::{RangeError, Scalar, Scaled, Scaled32};
use fixed::FixedI32;
use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U0, U7, U16, U20, U24, U30};
use fixed::types::{I2F30, I8F24, I12F20, I16F16};
use random::Random;

fn cases() -> u64 {
    if std::env::var_os("CAROM_LONG").is_some() { 200_000_000 } else { 1_000_000 }
}

/// `n / 2^shift` rounded to the nearest, ties away from zero, and clipped to 32 bits.
fn narrowed(n: i128, shift: u32) -> i32 {
    let magnitude = n.unsigned_abs();
    let half = if shift == 0 { 0 } else { 1u128 << (shift - 1) };
    let rounded = ((magnitude + half) >> shift) as i128;
    (if n < 0 { -rounded } else { rounded }).clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

/// `n / d` rounded to the nearest, ties away from zero, and clipped to 32 bits.
fn divided(n: i128, d: i128) -> i32 {
    let (magnitude, divisor) = (n.unsigned_abs(), d.unsigned_abs());
    let rounded = ((2 * magnitude + divisor) / (2 * divisor)) as i128;
    (if (n < 0) != (d < 0) { -rounded } else { rounded }).clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

const ENDS: [i32; 12] =
    [i32::MIN, i32::MIN + 1, -(1 << 30), -65537, -1, 0, 1, 2, 32768, 1 << 30, i32::MAX - 1, i32::MAX];

/// Any bits, with ends of the range and small numbers among them more often than by chance.
fn bits(random: &mut Random) -> i32 {
    match random.below(8) {
        0 => ENDS[random.below(ENDS.len() as u32) as usize],
        1..6 => (random.next() as i32) >> random.below(32),
        _ => random.next() as i32,
    }
}

/// What geometry is computed with: directions and lengths, products to compare, shares and steps.
fn geometry<Frac>(name: &str)
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
    FixedI32<Frac>: Scalar<Unit = I2F30, Scaled = Scaled32, Wide = i64>,
{
    let of = FixedI32::<Frac>::from_bits;
    let mut random = Random::new(u64::from(Frac::U32) + 101);
    let (mut worst_direction, mut worst_length) = (0.0_f64, 0.0_f64);
    for case in 0..cases() {
        let mut v: [i32; 3] = std::array::from_fn(|_| bits(&mut random));
        // Along an axis, and next to it: there the inverse root is at its worst.
        if case % 8 == 0 {
            v = [0, (random.next() & 1) as i32, 1 << random.below(31)];
        }
        match FixedI32::direction3(v.map(of)) {
            None => assert_eq!(v, [0; 3], "{name}"),
            Some((d, length)) => {
                let exact = v.iter().map(|&x| f64::from(x).powi(2)).sum::<f64>().sqrt();
                for (d, x) in d.iter().zip(v) {
                    worst_direction =
                        worst_direction.max((f64::from(d.to_bits()) - f64::from(x) / exact * 2f64.powi(30)).abs());
                }
                if exact < f64::from(i32::MAX) {
                    let off = (f64::from(length.to_bits()) - exact).abs() - exact * 2f64.powi(-29);
                    worst_length = worst_length.max(off);
                }
                let opposite = FixedI32::direction3(v.map(|x| of(x.saturating_neg())));
                if v.iter().all(|&x| x != i32::MIN) {
                    let (mirrored, same) = opposite.expect("a direction");
                    assert_eq!((mirrored.map(|x| -x), same), (d, length), "{name}: opposite vectors");
                }
            }
        }
        let [a, b, c, d] = std::array::from_fn(|_| bits(&mut random));
        let wide = |x: i32, y: i32| i128::from(x) * i128::from(y);
        let clip = |x: i128| x.clamp(i64::MIN.into(), i64::MAX.into()) as i64;
        assert_eq!(FixedI32::wide_product(of(a), of(b)), clip(wide(a, b)), "{name} wide_product");
        assert_eq!(FixedI32::wide_det2(of(a), of(b), of(c), of(d)), clip(wide(a, d) - wide(b, c)), "{name} wide_det2");
        let square = wide(a, a) + wide(b, b) + wide(c, c);
        assert_eq!(FixedI32::wide_dot3([a, b, c].map(of), [a, b, c].map(of)), clip(square), "{name} wide_dot3");
        assert_eq!(of(a).times_unit(I2F30::from_bits(b)).to_bits(), narrowed(wide(a, b), 30), "{name} times_unit");
        assert_eq!(of(a).times_integer(b).to_bits(), clip(wide(a, b)).clamp(i32::MIN.into(), i32::MAX.into()) as i32);
        let places = random.below(31);
        assert_eq!(of(a).lowered_by(places).to_bits(), narrowed(a.into(), places), "{name} lowered_by");
        assert_eq!(i64::from(of(a).integer_below()), i64::from(a) >> Frac::U32, "{name} integer_below");
        let (part, whole) = (a.saturating_abs().min(b.saturating_abs()), a.saturating_abs().max(b.saturating_abs()));
        if whole > 0 {
            let share = divided(i128::from(part) << 30, whole.into());
            assert_eq!(
                FixedI32::fraction(of(part), of(whole)).to_bits(),
                share,
                "{name} fraction of {part} in {whole}"
            );
        }
    }
    println!("{name}: directions off by {worst_direction:.2} units, lengths by {worst_length:.2}");
    assert!(worst_direction <= 2.0, "{name}: a direction is {worst_direction} units off");
    assert!(worst_length <= 1.0, "{name}: a length is {worst_length} units off");
}

#[test]
fn what_geometry_is_computed_with() {
    geometry::<U0>("I32F0");
    geometry::<U16>("I16F16");
    geometry::<U20>("I12F20");
    geometry::<U30>("I2F30");
}

fn sweep<Frac>(name: &str)
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
    FixedI32<Frac>: Scalar<Unit = I2F30, Scaled = Scaled32>,
{
    let of = FixedI32::<Frac>::from_bits;
    let frac = Frac::U32;
    let mut random = Random::new(u64::from(frac) + 1);
    let mut clipped = 0u64;
    for _ in 0..cases() {
        let [a, b, c, d, e, f] = std::array::from_fn(|_| bits(&mut random));
        let wide = |x: i32, y: i32| i128::from(x) * i128::from(y);
        let dot = narrowed(wide(a, d) + wide(b, e) + wide(c, f), frac);
        clipped += u64::from(dot == i32::MAX || dot == i32::MIN);
        assert_eq!(FixedI32::dot3([a, b, c].map(of), [d, e, f].map(of)).to_bits(), dot, "{name} dot3");
        let unit = narrowed(wide(a, d) + wide(b, e) + wide(c, f), 30);
        let units = [d, e, f].map(I2F30::from_bits);
        assert_eq!(FixedI32::dot3_unit([a, b, c].map(of), units).to_bits(), unit, "{name} dot3_unit");
        let det = narrowed(wide(a, d) - wide(b, c), frac);
        assert_eq!(FixedI32::det2(of(a), of(b), of(c), of(d)).to_bits(), det, "{name} det2 {a} {b} {c} {d}");
        assert_eq!(of(a).times(of(b)).to_bits(), narrowed(wide(a, b), frac), "{name} times");
        assert_eq!(of(a).plus(of(b)).to_bits(), narrowed(i128::from(a) + i128::from(b), 0), "{name} plus");
        assert_eq!(of(a).minus(of(b)).to_bits(), narrowed(i128::from(a) - i128::from(b), 0), "{name} minus");
        assert_eq!(of(a).negated().to_bits(), narrowed(-i128::from(a), 0), "{name} negated");
        if b != 0 {
            let quotient = divided(i128::from(a) << frac, b.into());
            assert_eq!(of(a).over(of(b)).to_bits(), quotient, "{name} {a} over {b}");
        }

        // Scaled and back: 30 bits, then the format.
        let (back, _) = FixedI32::<Frac>::from_scaled(of(a).to_scaled());
        assert!((i64::from(back.to_bits()) - i64::from(a)).abs() <= 1, "{name} to and from scaled: {a}");

        let root = Scalar::sqrt(of(a)).to_bits();
        let square = i128::from(a.max(0)) << frac;
        let twice = 2 * i128::from(root);
        // The nearest: root - 1/2 <= sqrt <= root + 1/2.
        let above = root == i32::MAX || (twice + 1) * (twice + 1) >= 4 * square;
        assert!(above && (root == 0 || (twice - 1) * (twice - 1) <= 4 * square), "{name} sqrt {a}: {root}");
    }
    assert!(clipped > cases() / 100 && clipped < cases() * 99 / 100, "{name}: {clipped} at the end of the range");
}

#[test]
fn every_operation_is_the_exact_result_rounded_once() {
    sweep::<U0>("U0");
    sweep::<U7>("U7");
    sweep::<U16>("U16");
    sweep::<U20>("U20");
    sweep::<U24>("U24");
    sweep::<U30>("U30");
}

/// The checker of the sweep sees a floor in the place of a rounding, and a wrapped sum.
#[test]
fn the_sweep_would_see_a_floor_or_a_wrap() {
    let (a, b) = (3, 1 << 15);
    assert_ne!((a * b) >> 16, i64::from(narrowed(a as i128 * b as i128, 16)), "a floor");
    let wide = i64::from(i32::MIN) * i64::from(i32::MIN);
    let wrapped = wide.wrapping_add(wide).wrapping_add(wide);
    assert_ne!((wrapped >> 30) as i32, narrowed(3 * i128::from(wide), 30), "a wrap");
}

/// A scaled number as an exact integer times a power of two.
fn value(x: Scaled32) -> (i128, i32) {
    if x == Scaled32::ZERO { (0, 0) } else { (x.mantissa().into(), x.exponent() - 30) }
}

/// `|x - n 2^e| <= 2^-30 |n 2^e|`, for exponents that are near each other.
fn is_rounded(x: Scaled32, n: i128, e: i32) -> bool {
    let (m, f) = value(x);
    let low = e.min(f);
    let (n, m) = (n << (e - low), m << (f - low));
    // Half a unit of the last of 30 bits: at most 2^-30 of the value.
    (m - n).unsigned_abs() << 30 <= n.unsigned_abs()
}

#[test]
fn scaled_operations_are_correctly_rounded() {
    let mut random = Random::new(7);
    let number = |random: &mut Random| {
        let exponent = random.below(40) as i32 - 20;
        Scaled32::from_parts(bits(random), exponent)
    };
    for _ in 0..cases() {
        let (x, y) = (number(&mut random), number(&mut random));
        let ((m, e), (n, f)) = (value(x), value(y));
        let low = e.min(f);
        let exact_sum = (m << (e - low)) + (n << (f - low));
        // Cancellation is exact; a sum that is far longer than 30 bits is off by the smaller operand at most.
        assert!(is_rounded(x + y, exact_sum, low) || exact_sum == 0 && (x + y) == Scaled32::ZERO, "{x:?} + {y:?}");
        assert!(is_rounded(x - y, (m << (e - low)) - (n << (f - low)), low), "{x:?} - {y:?}");
        assert!(is_rounded(x * y, m * n, e + f), "{x:?} * {y:?}");
        assert_eq!(x.partial_cmp(&y), (m << (e - low)).partial_cmp(&(n << (f - low))), "{x:?} <=> {y:?}");
        let exact = if e < 0 { m >> -e } else { m << e };
        assert_eq!(i128::from(x.integer_below()), exact.clamp(-1 << 30, 1 << 30), "the integer below {x:?}");
        if n != 0 {
            // |q - m/n| <= 2^-30 |m/n|, without a division: |q n - m| 2^30 <= |m|.
            let (q, g) = value(x / y);
            let (left, right, exponent) = (q * n, m, g + f - e);
            let (left, right) = if exponent < 0 { (left, right << -exponent) } else { (left << exponent, right) };
            assert!((left - right).unsigned_abs() << 30 <= right.unsigned_abs(), "{x:?} / {y:?}");
        }
        if m > 0 {
            // The nearest: half a unit less, squared, is below the number, and half a unit more above.
            let (r, g) = value(x.sqrt());
            let [below, above] = [2 * r - 1, 2 * r + 1].map(|twice| twice * twice);
            let four = 4 * m;
            let places = 2 * g - e;
            let (four, below, above) =
                if places < 0 { (four << -places, below, above) } else { (four, below << places, above << places) };
            assert!(below <= four && four <= above, "sqrt {x:?}");
        }
    }
}

#[test]
fn scaled_division_by_zero_is_the_largest_value_and_not_finite() {
    let one = Scaled32::ONE;
    assert!(!(one / Scaled32::ZERO).is_finite());
    assert!(one / Scaled32::ZERO > Scaled32::from_parts(i32::MAX, 1000));
    assert!(-one / Scaled32::ZERO < Scaled32::from_parts(i32::MIN, 1000));
    assert_eq!(Scaled32::ZERO / Scaled32::ZERO, Scaled32::ZERO);
    assert_eq!(one / Scaled32::from_parts(3, 0) * Scaled32::from_parts(3, 0), one);
}

/// Every root of Q16.16 below 16, and a comb over the rest of the format.
#[test]
fn square_roots_of_q16_are_the_nearest() {
    let check = |a: i32| {
        let root = i128::from(Scalar::sqrt(I16F16::from_bits(a)).to_bits());
        let square = i128::from(a) << 18;
        assert!((2 * root + 1).pow(2) >= square && (2 * root - 1).pow(2) <= square || root == 0, "{a}");
    };
    (1..1 << 20).for_each(check);
    let stride = if std::env::var_os("CAROM_LONG").is_some() { 1 } else { 1009 };
    (1 << 20..=i32::MAX).step_by(stride).for_each(check);
}

#[test]
fn directions_are_within_two_units_however_short_the_vector() {
    let mut random = Random::new(11);
    let mut worst = 0.0f64;
    for _ in 0..cases() / 4 {
        let shift = random.below(30);
        let v: [i32; 3] = std::array::from_fn(|_| (random.next() as i32) >> shift >> random.below(3));
        if v == [0; 3] {
            continue;
        }
        let unit = I16F16::normalize3(v.map(I16F16::from_bits)).expect("not zero");
        let length = v.iter().map(|&x| f64::from(x).powi(2)).sum::<f64>().sqrt();
        for (u, x) in unit.iter().zip(v) {
            worst = worst.max((u.to_bits() as f64 - f64::from(x) / length * f64::from(1 << 30)).abs());
        }
    }
    println!("directions: worst component {worst:.2} units of 2^-30");
    assert!(worst < 2.0 && worst > 0.4);
    assert_eq!(I16F16::normalize3([I16F16::ZERO; 3]), None);
}

#[test]
fn ratios_and_sub_steps_know_their_range() {
    assert_eq!(I16F16::from_ratio(1, 3).map(I16F16::to_bits), Ok(21845));
    assert_eq!(I16F16::from_ratio(-1, 3).map(I16F16::to_bits), Ok(-21845));
    assert_eq!(I16F16::from_ratio(2, 3).map(I16F16::to_bits), Ok(43691));
    assert!(I16F16::from_ratio(32768, 1).is_err() && I16F16::from_ratio(1, 0).is_err());
    assert!(I16F16::from_ratio(0, 0).is_err());
    // The lowest number has no positive counterpart; half a unit below it is the end.
    assert_eq!(I16F16::from_ratio(-32768, 1), Ok(I16F16::MIN));
    assert_eq!(I16F16::from_ratio(i32::MIN, 65536), Ok(I16F16::MIN));
    assert_eq!(I16F16::from_ratio(32768, -1), Ok(I16F16::MIN));
    assert!(I16F16::from_ratio(-32769, 1).is_err() && I16F16::from_ratio(i32::MIN, -65536).is_err());
    assert_eq!(FixedI32::<U0>::from_ratio(i32::MIN, 1), Ok(FixedI32::MIN));
    assert_eq!(I2F30::from_ratio(-2, 1), Ok(I2F30::MIN));
    let mut random = Random::new(13);
    for _ in 0..100_000 {
        // Near the lower end: n = -2^11 d, and up to two more or less.
        let d = 1 + random.below(1 << 19) as i32;
        let n = -(d << 11) + random.below(5) as i32 - 2;
        let magnitude = ((2 * i128::from(-n)) << 20) + i128::from(d);
        let rounded = magnitude / (2 * i128::from(d));
        let expected = if rounded <= 1 << 31 { Ok(rounded.wrapping_neg() as i32) } else { Err(RangeError) };
        assert_eq!(I12F20::from_ratio(n, d).map(I12F20::to_bits), expected, "{n}/{d}");
        assert_eq!(I12F20::from_ratio(-n, -d).map(I12F20::to_bits), expected, "{n}/{d}");
    }
    assert!(I12F20::from_ratio(2048, 1).is_err() && I12F20::from_ratio(2047, 1).is_ok());
    assert_eq!(I8F24::sub_step(1, 240).map(|h| h.to_bits()), Ok(8947849));
    assert!(I8F24::sub_step(1, 1).is_err() && I8F24::sub_step(-1, 240).is_err());
    assert!(I8F24::sub_step(0, 5).is_ok());
}

/// 1 mm/s over 1/240 s is 0.27 units of Q16.16: alone it rounds to nothing, carried it arrives.
#[test]
fn the_slowest_motion_arrives() {
    for sign in [1, -1] {
        let h = I16F16::sub_step(1, 240).expect("a sub-step");
        let v = I16F16::from_ratio(sign, 1000).expect("a speed");
        let (mut x, mut remainder) = (I16F16::ZERO, 0);
        for _ in 0..240_000 {
            x = x.advance(v, h, &mut remainder).0;
        }
        let expected = f64::from(v.to_bits()) * 1000.0 / 65536.0;
        let off = x.to_num::<f64>() - expected;
        assert!(off.abs() < 240_000.0 / 2f64.powi(33) + 2e-5, "1000 s at {sign} mm/s: off by {off} m");
    }
    let h = I16F16::sub_step(1, 2).expect("a sub-step");
    let mut remainder = 0;
    assert_eq!(I16F16::MAX.advance(I16F16::ONE, h, &mut remainder), (I16F16::MAX, true));
}
