//! Free rotation, by the solver.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed"))]

#[path = "support/bounds.rs"]
mod bounds;
#[macro_use]
#[path = "support/each_number.rs"]
mod each_number;
#[path = "support/host.rs"]
mod host;
#[path = "support/scene.rs"]
mod scene;
#[path = "support/validation.rs"]
mod validation;

use carom::Body;
use host::HostScalar;
use scene::{Scene, Shape, mass, vector};

each_number!(free_tops);

/// The principal moments of the cases.
const TOPS: [(&str, [f64; 3]); 7] = [
    ("dzhanibekov_123", [1.0, 2.0, 3.0]),
    ("thandle_small", [0.00025, 0.0005, 0.000625]),
    ("box123_rapier", [208.0, 160.0, 80.0]),
    ("long_axis_spin", [1.0, 2.0, 3.0]),
    ("short_axis_spin", [1.0, 2.0, 3.0]),
    ("near_separatrix", [1.0, 2.0, 3.0]),
    ("nearly_symmetric", [1.0, 1.000_976_562_5, 2.0]),
];
const RATE: f64 = 240.0;

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn into_body([w, x, y, z]: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let u = [-x, -y, -z];
    let t = cross(u, v);
    let turned = cross(u, [t[0] + w * v[0], t[1] + w * v[1], t[2] + w * v[2]]);
    [v[0] + 2.0 * turned[0], v[1] + 2.0 * turned[1], v[2] + 2.0 * turned[2]]
}

fn free_tops<S: HostScalar>(name: &str) {
    let Some(file) = validation::file("oracles/torque_free_top.csv") else { return };
    let text = std::fs::read_to_string(file).expect("a readable file");
    let mut compared = 0;
    for (case, moments) in TOPS {
        let rows: Vec<Vec<f64>> = text
            .lines()
            .filter_map(|line| line.strip_prefix(case)?.strip_prefix(','))
            .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
            .collect();
        let mut scene = Scene::<S>::new([0.0; 3], [1, 240], 1, 0.0, 0.0);
        let mut top = Body::dynamic(mass(1.0, moments));
        top.angular_velocity = vector([rows[0][1], rows[0][2], rows[0][3]]);
        let top = scene.push(top, Shape::Sphere(0.1));
        let momentum = |w: [f64; 3]| (0..3).map(|i| (moments[i] * w[i]).powi(2)).sum::<f64>().sqrt();
        let energy = |w: [f64; 3]| (0..3).map(|i| moments[i] * w[i] * w[i]).sum::<f64>();
        let start = [rows[0][1], rows[0][2], rows[0][3]];
        let mut steps = 0.0;
        for row in &rows {
            while steps < (row[0] * RATE).round() {
                scene.step();
                steps += 1.0;
            }
            let q = scene.orientation(top);
            let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
            let q = q.map(|x| x / length);
            let w = into_body(q, scene.spin(top));
            let (l, e) = (momentum(w) / momentum(start) - 1.0, energy(w) / energy(start) - 1.0);
            assert!(l.abs() <= bounds::TOP[0], "{name}, {case} at {} s: |L| {l:.1e}", row[0]);
            assert!(e.abs() <= bounds::TOP[1], "{name}, {case} at {} s: energy {e:.1e}", row[0]);
            // The small top turns twice as fast again: 3 degrees a step.
            let on_a_step = (row[0] * RATE - steps).abs() < 1e-6;
            if row[0] <= 5.0 && on_a_step && case != "thandle_small" {
                let cosine = (0..4).map(|i| q[i] * row[4 + i]).sum::<f64>().abs().min(1.0);
                let angle = 2.0 * cosine.acos().to_degrees();
                assert!(angle <= bounds::TOP[2], "{name}, {case} at {} s: {angle} degrees", row[0]);
                compared += 1;
            }
        }
    }
    assert!(compared >= 200, "{name}: {compared} attitudes");
}
