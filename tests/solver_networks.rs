//! Networks of contacts with a known solution, solved as rigid ones.
#![cfg(feature = "f64")]

#[path = "support/bounds.rs"]
mod bounds;
#[path = "support/validation.rs"]
mod validation;

use carom::solver::{Buffers, ManifoldConstraint, Motion, PointConstraint, Settings, Step};
use carom::{Body, FeatureId, Manifold, ManifoldPoint, MassProperties, Material, UnitVec3, Vec3};

fn rows(name: &str) -> Option<Vec<Vec<f64>>> {
    let text = std::fs::read_to_string(validation::file(name)?).expect("a readable file");
    let numbers = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    Some(text.lines().skip(1).map(numbers).collect())
}

fn vector(row: &[f64]) -> Vec3<f64> {
    Vec3::new(row[0], row[1], row[2])
}

/// |v - v*| over the linear velocities, for the velocities after some sweeps.
fn solved(bodies: &[Vec<f64>], contacts: &[Vec<f64>], sweeps: u16) -> Vec<Vec3<f64>> {
    let mut world: Vec<Body<f64>> = bodies
        .iter()
        .map(|row| {
            let inverses = [1.0 / row[2], 1.0 / row[3], 1.0 / row[4]];
            let mut body = Body::dynamic(MassProperties::from_inverses(1.0 / row[1], inverses).expect("a mass"));
            body.linear_velocity = vector(&row[5..]);
            body.angular_velocity = vector(&row[8..]);
            body
        })
        .collect();
    let ground = world.len() as u16;
    world.push(Body::immovable());
    let mut motions = vec![Motion::NEW; world.len()];
    let mut manifolds = vec![ManifoldConstraint::NEW; contacts.len()];
    let mut points = vec![PointConstraint::NEW; contacts.len()];
    let settings = Settings::new(Vec3::ZERO, [1, 60], 4).expect("settings");
    let buffers = Buffers { motions: &mut motions, manifolds: &mut manifolds, points: &mut points };
    let mut step = Step::begin(&mut world, buffers, &settings);
    for row in contacts {
        let b = row[1] as u16;
        let a = if row[2] < 0.0 { ground } else { row[2] as u16 };
        // Their normals point to body 1.
        let mut manifold = Manifold::empty(UnitVec3::normalize(vector(&row[3..])).expect("a direction"));
        let (r_a, r_b) = (vector(&row[9..]), vector(&row[6..]));
        manifold.push(ManifoldPoint { r_a, r_b, separation: 0.0, feature: FeatureId(0) });
        assert!(step.add([a, b], &manifold, &Material::new(0.0, row[12]).expect("a material"), &[]));
    }
    step.finish_rigid(sweeps);
    world[..bodies.len()].iter().map(|body| body.linear_velocity).collect()
}

fn distance(a: &[Vec3<f64>], b: &[Vec3<f64>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (*a - *b).dot(*a - *b)).sum::<f64>().sqrt()
}

/// The errors that a row-wise solver leaves after so many sweeps, as published with the networks.
fn network(name: &str, contacts: usize, curve: &[(u16, f64)]) {
    let (Some(bodies), Some(rows)) =
        (rows(&format!("fclib_scenes/{name}_bodies.csv")), rows(&format!("fclib_scenes/{name}_contacts.csv")))
    else {
        return;
    };
    assert_eq!(rows.len(), contacts);
    let published: Vec<_> = bodies.iter().map(|row| vector(&row[11..])).collect();
    let free: Vec<_> = bodies.iter().map(|row| vector(&row[5..])).collect();
    let scale = distance(&free, &published);
    // The files have ten digits: so near is their solution to the one of what they say.
    let exact = solved(&bodies, &rows, 4000);
    assert!(distance(&exact, &published) / scale < 1e-9, "{name}");
    for &(sweeps, left) in curve {
        let found = distance(&solved(&bodies, &rows, sweeps), &exact) / scale;
        assert!(found <= bounds::NETWORK * left, "{name} after {sweeps} sweeps: {found:.4e} for {left:.1e}");
        assert!(sweeps > 1 || found > 0.5 * left, "{name}: too good to be this problem");
    }
}

#[test]
fn box_stacks() {
    let curve = [(1, 0.23), (4, 0.0185), (8, 0.0024), (10, 0.0011), (20, 2e-5), (50, 3e-10)];
    network("box_stacks82", 82, &curve);
}

#[test]
fn spheres_tower() {
    let curve = [
        (1, 0.54),
        (4, 0.375),
        (8, 0.30),
        (10, 0.265),
        (20, 0.144),
        (50, 0.037),
        (100, 0.014),
        (200, 0.0013),
        (500, 1.4e-11),
    ];
    network("spheres_tower356", 356, &curve);
}
