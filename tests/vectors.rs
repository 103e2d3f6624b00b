//! Published and computed vectors for scalar and quaternion arithmetic.

#[path = "support/validation.rs"]
mod validation;

#[cfg(feature = "f32")]
use carom::Quat;
#[cfg(any(feature = "fixed", feature = "f32"))]
use carom::Scalar;

/// Correctly rounded Q16.16 values. Where the exact value is a tie the table goes to even and carom away from zero.
#[cfg(feature = "fixed")]
#[test]
fn q16_operations_are_the_nearest() {
    use fixed::types::I16F16;
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/q16_16.csv");
    let (mut counts, mut ties) = ([0; 4], 0);
    for row in csv::Reader::from_path(path).expect("the table").records() {
        let row = row.expect("a row");
        let bits = |column: usize| row[column].parse::<i32>().expect("bits");
        let number = |column| I16F16::from_bits(bits(column));
        let (kind, result) = match &row[0] {
            "sqrt" => (0, Scalar::sqrt(number(1))),
            "recip" => (1, I16F16::ONE.over(number(1))),
            "mul" => (2, number(1).times(number(2))),
            "div" => (3, number(1).over(number(2))),
            _ => continue,
        };
        counts[kind] += 1;
        if result.to_bits() != bits(3) {
            let exact: f64 = row[5].parse().expect("the exact value");
            let tie = (exact * 65536.0).fract().abs() == 0.5;
            assert!(tie && (result.to_bits() - bits(3)).abs() == 1, "{row:?}: {}", result.to_bits());
            ties += 1;
        }
    }
    println!("sqrt, recip, mul, div: {counts:?} rows, {ties} ties");
    assert!(counts.iter().all(|&count| count > 250) && ties < 20, "{counts:?}, {ties} ties");
}

/// Patterns of CMSIS-DSP: the columns of one name, as floats.
#[cfg(feature = "f32")]
fn pattern(path: &std::path::Path, which: &str) -> Vec<f32> {
    let mut reader = csv::Reader::from_path(path).expect("the patterns");
    let rows = reader.records().map(|row| row.expect("a row")).filter(|row| &row[0] == which);
    rows.map(|row| f32::from_bits(u32::from_str_radix(row[2].trim_start_matches("0x"), 16).expect("bits"))).collect()
}

#[cfg(feature = "f32")]
#[test]
fn quaternions_agree_with_the_patterns_of_cmsis() {
    let Some(path) = validation::file("mathvec/cmsis_quaternion_f32.csv") else { return };
    let near = |got: &[f32], wanted: &[f32], scale: f32, what: &str| {
        for (g, w) in got.iter().zip(wanted) {
            assert!((g * scale - w).abs() <= 2e-6 * scale.max(1.0), "{what}: {got:?} times {scale}, not {wanted:?}");
        }
    };
    let read = |which: &str| pattern(&path, which);
    let (inputs, norms) = (read("Input1"), read("Reference1"));
    let (conjugates, units, products, matrices) =
        (read("Reference3"), read("Reference4"), read("Reference5"), read("Reference6"));
    let seconds = read("Input2");
    let length = |q: &[f32]| q.iter().map(|c| c * c).sum::<f32>().sqrt();
    let unit = |q: &[f32]| Quat::<f32>::normalize(q[0], q[1], q[2], q[3]).expect("not zero");
    let mut compared = 0;
    for (index, q) in inputs.chunks_exact(4).enumerate() {
        let of = |all: &'_ [f32]| <[f32; 4]>::try_from(&all[4 * index..4 * index + 4]).expect("four");
        let (norm, second) = (length(q), of(&seconds));
        assert!((norm - norms[index]).abs() <= 2e-6 * norm);
        near(&unit(q).to_array(), &of(&units), 1.0, "normalize");
        near(&unit(q).conjugate().to_array(), &of(&conjugates), norm, "conjugate");
        near(&(unit(q) * unit(&second)).to_array(), &of(&products), norm * length(&second), "product");
        compared += 1;
    }
    assert_eq!(compared, 128);
    // The rotations belong to the unit quaternions of the fourth reference.
    let mut rotations = 0;
    for (q, matrix) in units.chunks_exact(4).zip(matrices.chunks_exact(9)) {
        let rows = unit(q).to_mat3().rows.map(|row| row.to_array());
        let same = rows.concat().iter().zip(matrix).all(|(a, b)| (a - b).abs() < 2e-6);
        rotations += usize::from(same);
    }
    assert!(rotations >= 128, "{rotations} of 128 rotation matrices agree");
}

#[cfg(feature = "f32")]
#[test]
fn roots_agree_with_the_patterns_of_cmsis() {
    let Some(path) = validation::file("mathvec/cmsis_fastmath.csv") else { return };
    let mut rows = 0;
    for row in csv::Reader::from_path(path).expect("the patterns").records() {
        let row = row.expect("a row");
        if (&row[0], &row[1]) != ("sqrt", "f32") {
            continue;
        }
        let float = |column: usize| {
            f32::from_bits(u32::from_str_radix(row[column].trim_start_matches("0x"), 16).expect("bits"))
        };
        let (x, y) = (float(2), float(4));
        if x >= 0.0 {
            assert!((Scalar::sqrt(x) - y).abs() <= 1e-6 * y, "sqrt {x}: not {y}");
            rows += 1;
        }
    }
    assert!(rows > 900, "{rows}");
}
