//! Sliding, rolling and sticking, by the solver.
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

each_number!(slides_then_rolls, rows_of_sliding, stops_straight, spins_down, slopes);

const G: f64 = 9.81;
const H: f64 = 1.0 / 240.0;

fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn rows(name: &str) -> Option<Vec<Vec<String>>> {
    let text = std::fs::read_to_string(validation::file(name)?).expect("a readable file");
    Some(text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect())
}

fn slides_then_rolls<S: HostScalar>(name: &str) {
    let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.25, 0.0);
    scene.ground([0.0, 1.0, 0.0]);
    let ball = scene.solid(1.0, Shape::Sphere(0.5), [0.0, 0.5, 0.0]);
    scene.bodies[ball].linear_velocity = vector([7.0, 0.0, 0.0]);
    scene.run(0.75);
    assert!(scene.velocity(ball)[0] > 5.1, "{name}: rolls too early");
    scene.run(2.25);
    let (v, w) = (scene.velocity(ball), scene.spin(ball));
    assert!((v[0] - 5.0).abs() <= bounds::ROLLING, "{name}: {v:?}");
    assert!((w[2] + 10.0).abs() <= 2.0 * bounds::ROLLING, "{name}: {w:?}");
}

fn rows_of_sliding<S: HostScalar>(name: &str) {
    let Some(rows) = rows("oracles/sliding_to_rolling.csv") else { return };
    let (mut compared, mut worst) = (0, 0f64);
    for row in &rows {
        let row: Vec<f64> = row.iter().map(|cell| cell.parse().expect("a number")).collect();
        let [k, m, r, mu, v0x, v0y, w0x, w0y, w0z] = *row[1..].first_chunk().expect("nine numbers");
        let (t, v) = (row[18], [row[19], row[20]]);
        if [row[16], row[17]].iter().any(|x| S::from_f64(*x).is_none()) {
            continue;
        }
        let mut scene = Scene::<S>::new([0.0, 0.0, -G], [1, 240], 1, mu, 0.0);
        scene.ground([0.0, 0.0, 1.0]);
        let mut ball = Body::dynamic(mass(m, [k * m * r * r; 3]));
        ball.position = vector([0.0, 0.0, r]);
        ball.linear_velocity = vector([v0x, v0y, 0.0]);
        ball.angular_velocity = vector([w0x, w0y, w0z]);
        let ball = scene.push(ball, Shape::Sphere(r));
        let steps = (t / H).round();
        (0..steps as usize).for_each(|_| scene.step());
        // Between two steps the velocity changes by up to mu g times what the time is off.
        let off = (steps * H - t).abs() * mu * G;
        let found = scene.velocity(ball);
        let start = v0x.hypot(v0y).max(w0x.hypot(w0y) * r);
        worst = worst.max(((found[0] - v[0]).hypot(found[1] - v[1]) - off) / start);
        compared += 1;
    }
    assert!(compared >= 180, "{name}: {compared} of {} rows", rows.len());
    assert!(worst <= bounds::SLIDING_ROW, "{name}: {worst:.1e}");
}

fn stops_straight<S: HostScalar>(name: &str) {
    let (mu, v) = (0.5, 5.0);
    // Symplectic Euler takes the first change of speed before the first way: v h / 2 less.
    let right = v * v / (2.0 * mu * G) - v * H / 2.0;
    for heading in 0..12 {
        let angle = 0.1 + f64::from(heading) * 30f64.to_radians();
        let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, mu, 0.0);
        scene.ground([0.0, 1.0, 0.0]);
        let slab = scene.solid(1.0, Shape::Cuboid([0.5, 0.1, 0.5]), [0.0, 0.1, 0.0]);
        scene.bodies[slab].linear_velocity = vector([v * angle.cos(), 0.0, v * angle.sin()]);
        scene.run(3.0);
        let [x, _, z] = scene.position(slab);
        let off = (z.atan2(x) - angle).sin().to_degrees();
        assert!((x.hypot(z) / right - 1.0).abs() <= bounds::STOPPING, "{name}, heading {heading}: {}", x.hypot(z));
        assert!(off.abs() <= bounds::HEADING, "{name}, heading {heading}: {off} degrees aside");
    }
}

/// Four corners rub at their distance from the middle: w' = mu g sqrt(2) a m / I.
fn spins_down<S: HostScalar>(name: &str) {
    let Some(rows) = rows("oracles/angular_friction_box.csv") else { return };
    for row in &rows {
        let [a, h, mu, w, slope, stop, angle] = *row
            .iter()
            .map(|cell| cell.parse::<f64>().expect("a number"))
            .collect::<Vec<_>>()
            .first_chunk()
            .expect("seven");
        let mut scene = Scene::<S>::new([0.0, -G, 0.0], [1, 240], 4, mu, 0.0);
        scene.ground([0.0, 1.0, 0.0]);
        let slab = scene.solid(1.0, Shape::Cuboid([a, h, a]), [0.0, h, 0.0]);
        scene.bodies[slab].angular_velocity = vector([0.0, w, 0.0]);
        let (mut turned, mut time) = (0.0, 0.0);
        while scene.spin(slab)[1] > 1e-3 * w && time < 2.0 * stop {
            scene.step();
            turned += scene.spin(slab)[1] * H;
            time += H;
        }
        // The spin at the end of each step: w h / 2 less.
        let right = angle - w * H / 2.0;
        assert!((turned / right - 1.0).abs() <= bounds::SPIN_DOWN, "{name}, a = {a}: {turned} for {right}");
        assert!((time - stop).abs() <= bounds::SPIN_DOWN * stop + H, "{name}, a = {a}: {time} for {stop}, {slope}");
    }
}

fn slopes<S: HostScalar>(name: &str) {
    let Some(rows) = rows("oracles/incline.csv") else { return };
    let (mut moving, mut resting) = (0, 0);
    for row in &rows {
        let number = |i: usize| row[i].parse::<f64>().expect("a number");
        let (kind, degrees, mu, right) = (row[0].as_str(), number(1), number(2), number(5));
        let angle = degrees.to_radians();
        let shape = if kind == "box" { Shape::Cuboid([0.5, 0.1, 0.5]) } else { Shape::Sphere(0.5) };
        if !["box", "solid_sphere", "hollow_sphere"].contains(&kind) {
            continue;
        }
        let mut scene = Scene::<S>::new([G * angle.sin(), -G * angle.cos(), 0.0], [1, 60], 4, mu, 0.0);
        scene.ground([0.0, 1.0, 0.0]);
        let body = match shape {
            Shape::Sphere(r) => {
                let mut ball = Body::dynamic(mass(1.0, [number(3) * r * r; 3]));
                ball.position = vector([0.0, r, 0.0]);
                scene.push(ball, shape)
            }
            _ => scene.solid(1.0, shape, [0.0, 0.1, 0.0]),
        };
        let at = format!("{name}: {kind} at {degrees} degrees, friction {mu}");
        if right == 0.0 {
            // At the threshold itself nothing holds what the first sub-steps let go.
            if angle.tan() < 0.999 * mu {
                scene.run(4.0);
                let before = scene.position(body)[0];
                scene.run(1.0);
                let (way, last) = (scene.position(body)[0].abs(), (scene.position(body)[0] - before).abs());
                assert!(way <= bounds::CREEP[0] && last <= bounds::CREEP[1], "{at}: creeps {way} m, {last} m/s");
                // What the last places of positions shake it by.
                let noise = length(scene.velocity(body));
                assert!(noise <= bounds::NOISE + 20.0 * S::spacing(1.0), "{at}: {noise} m/s at rest");
                resting += 1;
            }
            continue;
        }
        // After the first contact has settled.
        scene.run(0.5);
        let start = scene.velocity(body)[0];
        scene.run(1.0);
        let found = scene.velocity(body)[0] - start;
        let bound = if right < 0.01 { bounds::SLOPE_AT_THRESHOLD } else { bounds::SLOPE };
        assert!((found / right - 1.0).abs() <= bound, "{at}: {found} for {right}");
        moving += 1;
    }
    assert!(moving >= 150 && resting >= 20, "{name}: {moving} moving, {resting} resting");
}
