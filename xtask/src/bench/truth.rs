//! What is right for an impact, in f64: the velocities v_a, w_a, v_b, w_b after it. Without friction by (10), (2) and (3)
//! word for word; with friction where it holds, so that the points stick.

use super::impacts::{Body, Impact};
use super::run::Words;
use crate::boards::Scalar;
use anyhow::{Result, bail};

type Vector = [f64; 3];
type Velocities = [f64; 12];

/// The largest error of a component, in m/s or rad/s, to two digits.
pub fn error(truth: &Velocities, words: &Words, scalar: Scalar) -> f64 {
    let errors = truth.iter().zip(words).map(|(truth, &word)| (value(word, scalar) - truth).abs());
    let largest = errors.fold(0.0, f64::max);
    format!("{largest:.1e}").parse().unwrap_or(f64::NAN)
}

/// The number with these bits.
pub fn value(word: u32, scalar: Scalar) -> f64 {
    match scalar.fraction_bits() {
        Some(bits) => f64::from(word.cast_signed()) / f64::from(bits).exp2(),
        None => f64::from(f32::from_bits(word)),
    }
}

/// Without friction.
pub fn resolve(impact: &Impact) -> Velocities {
    let n = impact.normal;
    let approach = dot(relative_velocity(impact), n);
    let j = -(1.0 + impact.restitution) * approach / dot(response(impact, n), n);
    after(impact, scale(j, n))
}

/// With friction; an error where the points would slide.
pub fn stick(impact: &Impact) -> Result<Velocities> {
    let n = impact.normal;
    let v = relative_velocity(impact);
    let change = sub(scale(-impact.restitution * dot(v, n), n), v);
    // Cramer's rule for the symmetric 3x3 inverse mass.
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| response(impact, axis));
    let determinant = dot(x, cross(y, z));
    let cofactors = [dot(change, cross(y, z)), dot(x, cross(change, z)), dot(x, cross(y, change))];
    let impulse = scale(1.0 / determinant, cofactors);
    let normal = dot(impulse, n);
    let tangential = sub(impulse, scale(normal, n));
    if dot(tangential, tangential).sqrt() > impact.friction * normal {
        bail!("the impact {} slides", impact.id);
    }
    Ok(after(impact, impulse))
}

fn relative_velocity(impact: &Impact) -> Vector {
    let [a, b] = impact.bodies.map(|body| add(body.velocity, cross(body.spin, body.arm)));
    sub(b, a)
}

/// The change of the relative velocity by an impulse.
fn response(impact: &Impact, impulse: Vector) -> Vector {
    impact.bodies.iter().fold([0.0; 3], |sum, body| {
        let turn = cross(turn(body, impulse), body.arm);
        add(sum, add(scale(body.inv_mass, impulse), turn))
    })
}

fn after(impact: &Impact, impulse: Vector) -> Velocities {
    let [a, b] = &impact.bodies;
    let of = |body: &Body, impulse| {
        [add(body.velocity, scale(body.inv_mass, impulse)), add(body.spin, turn(body, impulse))].concat()
    };
    let all = [of(a, scale(-1.0, impulse)), of(b, impulse)].concat();
    std::array::from_fn(|i| all[i])
}

/// R I^-1 R^T (r x J)
fn turn(body: &Body, impulse: Vector) -> Vector {
    let [w, x, y, z] = body.orientation;
    let rotation = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ];
    let torque = cross(body.arm, impulse);
    let local: Vector =
        std::array::from_fn(|i| body.inv_moments[i] * (0..3).map(|k| rotation[k][i] * torque[k]).sum::<f64>());
    rotation.map(|row| dot(row, local))
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] + b[i])
}

fn sub(a: Vector, b: Vector) -> Vector {
    add(a, scale(-1.0, b))
}

fn scale(k: f64, v: Vector) -> Vector {
    v.map(|x| k * x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::impacts;

    #[test]
    fn restitution_holds_and_points_stick() {
        let impact = &impacts::all().expect("the table is there")[impacts::REFERENCE];
        let points = |v: Velocities| {
            let mut after = impact.clone();
            for (body, v) in after.bodies.iter_mut().zip(v.chunks(6)) {
                body.velocity = [v[0], v[1], v[2]];
                body.spin = [v[3], v[4], v[5]];
            }
            relative_velocity(&after)
        };
        let wanted = -impact.restitution * dot(relative_velocity(impact), impact.normal);
        assert!((dot(points(resolve(impact)), impact.normal) - wanted).abs() < 1e-12);
        let stuck = points(stick(impact).expect("it is chosen so"));
        assert!(sub(stuck, scale(wanted, impact.normal)).iter().all(|x| x.abs() < 1e-12));
    }

    #[test]
    fn words_of_each_number_type() {
        let truth = [1.5; 12];
        assert_eq!(error(&truth, &[1.5f32.to_bits(); 12], Scalar::F32), 0.0);
        assert_eq!(error(&truth, &[3 << 15; 12], Scalar::I16F16), 0.0);
        assert_eq!(error(&truth, &[0; 12], Scalar::I8F24), 1.5);
    }
}
