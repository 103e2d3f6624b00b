#[path = "support/host.rs"]
mod host;
#[path = "support/scene.rs"]
mod scene;
use carom::{Body, Vec3};
use host::HostScalar;
use scene::*;

const G: f64 = 9.81;

fn len(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn toss_score<S: HostScalar>(sub: u8, mu: f64, e: f64, margin: f64) -> (f64, f64, f64) {
    let text = std::fs::read_to_string("/work/shared/validation/cube_tosses/cube_tosses_dev60.csv").unwrap();
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|l| l.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    let (mut p, mut r, mut f, mut n) = (0.0, 0.0, 0.0, 0.0);
    let mut i = 0;
    while i < rows.len() {
        let id = rows[i][0];
        let mut j = i;
        while j < rows.len() && rows[j][0] == id {
            j += 1;
        }
        let toss = &rows[i..j];
        let mut s = Scene::<S>::new([0.0, 0.0, -G], [1, 592], sub, mu, e);
        s.margin = margin;
        s.ground([0.0, 0.0, 1.0]);
        let mut b = Body::dynamic(mass(0.37, [0.00081; 3]));
        let t = &toss[0];
        b.position = vector([t[3], t[4], t[5]]);
        b.set_orientation(quat([t[6], t[7], t[8], t[9]]));
        b.linear_velocity = vector([t[10], t[11], t[12]]);
        let wb: Vec3<S> = vector([t[13], t[14], t[15]]);
        b.angular_velocity = b.orientation().rotate(wb);
        let c = s.push(b, Shape::Cuboid([0.0524; 3]));
        let (mut pe, mut re, mut last) = (0.0, 0.0, 0.0);
        for (k, row) in toss.iter().enumerate() {
            if k > 0 {
                for _ in 0..4 {
                    s.step();
                }
            }
            let q = s.orientation(c);
            let x = s.position(c);
            pe += len([x[0] - row[3], x[1] - row[4], x[2] - row[5]]) / 0.1048 * 100.0;
            let ql = q.iter().map(|x| x * x).sum::<f64>().sqrt();
            let dot = (q[0] * row[6] + q[1] * row[7] + q[2] * row[8] + q[3] * row[9]).abs() / ql;
            last = 2.0 * dot.min(1.0).acos().to_degrees();
            re += last;
        }
        let m = toss.len() as f64;
        p += pe / m;
        r += re / m;
        f += f64::from(last < 45.0);
        n += 1.0;
        i = j;
    }
    (p / n, r / n, f / n)
}

fn mean_score(sub: u8) -> (f64, f64, f64) {
    let mut sum = (0.0, 0.0, 0.0);
    let mut n = 0.0;
    for mu in [0.175, 0.18, 0.185] {
        for e in [0.115, 0.12, 0.125, 0.13, 0.135] {
            let (a, b, c) = toss_score::<f64>(sub, mu, e, MARGIN);
            sum.0 += a;
            sum.1 += b;
            sum.2 += c;
            n += 1.0;
        }
    }
    (sum.0 / n, sum.1 / n, sum.2 / n)
}
#[test]
fn tosses() {
    for sub in [1, 2, 4, 8] {
        println!("sub {sub} nominal {:.3?} mean {:.3?}", toss_score::<f64>(sub, 0.18, 0.125, 0.005), mean_score(sub));
    }
}
static MARGIN: f64 = 0.005;
#[test]
fn formats() {
    println!("f32 {:.3?}", toss_score::<f32>(8, 0.18, 0.125, MARGIN));
    println!("mm {:.3?}", toss_score::<micromath::F32>(8, 0.18, 0.125, MARGIN));
    type A = fixed::types::I16F16;
    type B = fixed::types::I12F20;
    type C = fixed::types::I8F24;
    println!("16 {:.3?}", toss_score::<A>(8, 0.18, 0.125, MARGIN));
    println!("12 {:.3?}", toss_score::<B>(8, 0.18, 0.125, MARGIN));
    println!("8 {:.3?}", toss_score::<C>(8, 0.18, 0.125, MARGIN));
    for mu in [0.1, 0.14, 0.22, 0.3] {
        println!(
            "mu {mu} {:.3?} {:.3?}",
            toss_score::<f64>(8, mu, 0.125, MARGIN),
            toss_score::<A>(8, mu, 0.125, MARGIN)
        );
    }
}

#[test]
fn bounce() {
    bounce_in::<f64>("f64");
    bounce_in::<fixed::types::I16F16>("16");
}
fn bounce_in<S: HostScalar>(name: &str) {
    for bits in [0] {
        for (e, sub) in [(1.0, 4u8), (1.0, 1), (0.8, 4), (0.5, 4), (0.3, 4), (0.0, 4)] {
            let mut s = Scene::<S>::new([0.0, -G, 0.0], [1, 60], sub, 0.0, e);

            s.ground([0.0, 1.0, 0.0]);
            let b = s.solid(1.0, Shape::Sphere(0.1), [0.0, 1.1, 0.0]);
            let mut apexes = vec![];
            let (mut y0, mut y1) = (1.1, 1.1);
            let mut k = 0;
            for _ in 0..600 {
                s.step();
                let y = s.position(b)[1];
                if y1 > y0 && y1 >= y {
                    k += 1;
                    apexes.push((1e4 * ((y1 - 0.1) / e.powi(2 * k) - 1.0)).round() / 1e4);
                }
                y0 = y1;
                y1 = y;
            }
            println!(
                "{name} {bits:?} e {e} sub {sub}: {:?} last {:?} end {} {}",
                &apexes[..apexes.len().min(5)],
                apexes.last(),
                s.position(b)[1],
                s.velocity(b)[1]
            );
        }
    }
}

#[test]
fn roll() {
    roll_in::<f64>("f64");
    roll_in::<f32>("f32");
    roll_in::<fixed::types::I16F16>("16");
    roll_in::<fixed::types::I12F20>("12");
    roll_in::<fixed::types::I8F24>("8");
}
fn roll_in<S: HostScalar>(name: &str) {
    let mut s = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.25, 0.0);
    s.ground([0.0, 1.0, 0.0]);
    let b = s.solid(1.0, Shape::Sphere(0.5), [0.0, 0.5, 0.0]);
    s.bodies[b].linear_velocity = vector([7.0, 0.0, 0.0]);
    s.run(3.0);
    println!("{name} roll {:?} {:?} y {}", s.velocity(b), s.spin(b), s.position(b)[1]);
    // box stopping at headings
    for k in 0..12 {
        let a = (k as f64) * 30f64.to_radians() + 0.1;
        let mut s = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.5, 0.0);
        s.ground([0.0, 1.0, 0.0]);
        let b = s.solid(1.0, Shape::Cuboid([0.5, 0.1, 0.5]), [0.0, 0.1, 0.0]);
        s.bodies[b].linear_velocity = vector([5.0 * a.cos(), 0.0, 5.0 * a.sin()]);
        s.run(3.0);
        let p = s.position(b);
        let d = (p[0] * p[0] + p[2] * p[2]).sqrt();
        let h = 1.0 / 240.0;
        println!(
            "  stop d {d} (ideal {} offset {}) heading err deg {}",
            2.54841997961264,
            2.54841997961264 - 5.0 * h / 2.0,
            (p[2].atan2(p[0]) - a).sin().to_degrees()
        );
    }
    // spin down
    let mut s = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.24494897427831780, 0.0);
    s.ground([0.0, 1.0, 0.0]);
    let b = s.solid(1.0, Shape::Cuboid([1.0, 1.0, 1.0]), [0.0, 1.0, 0.0]);
    s.bodies[b].angular_velocity = vector([0.0, 10.0, 0.0]);
    let mut angle = 0.0;
    let mut t = 0.0;
    for _ in 0..180 {
        s.step();
        let w = s.spin(b)[1];
        angle += w / 60.0;
        if w > 1e-3 {
            t += 1.0 / 60.0;
        }
    }
    println!("  spin-down angle {angle} (9.8089) t {t} (1.9618)");
}

#[test]
fn stack() {
    stack_in::<f64>("f64");
    stack_in::<f32>("f32");
    stack_in::<fixed::types::I16F16>("16");
    stack_in::<fixed::types::I12F20>("12");
    stack_in::<fixed::types::I8F24>("8");
}
fn stack_in<S: HostScalar>(name: &str) {
    for n in [1usize, 8] {
        let mut s = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.5, 0.0);
        s.ground([0.0, 1.0, 0.0]);
        for i in 0..n {
            s.solid(1.0, Shape::Sphere(0.5), [0.0, 0.5 + i as f64, 0.0]);
        }
        s.run(3.0);
        println!("{name} {n} spheres top {:?} v {:?}", s.position(n), s.velocity(n));
    }
}

macro_rules! all {
    ($f:ident) => {
        $f::<f64>("f64");
        $f::<f32>("f32");
        $f::<fixed::types::I16F16>("16");
        $f::<fixed::types::I12F20>("12");
        $f::<fixed::types::I8F24>("8");
    };
}
#[test]
fn top() {
    all!(top_in);
}
fn top_in<S: HostScalar>(name: &str) {
    let text = std::fs::read_to_string("/work/shared/validation/oracles/torque_free_top.csv").unwrap();
    let rows: Vec<(String, Vec<f64>)> = text
        .lines()
        .skip(1)
        .map(|l| {
            let (a, b) = l.split_once(',').unwrap();
            (a.to_string(), b.split(',').map(|x| x.parse().unwrap()).collect())
        })
        .collect();
    let moments: &[(&str, [f64; 3])] = &TOPS;
    for (case, i) in moments {
        let rows: Vec<&Vec<f64>> = rows.iter().filter(|r| r.0 == *case).map(|r| &r.1).collect();
        let mut s = Scene::<S>::new([0.0; 3], [1, 240], 1, 0.0, 0.0);
        let mut b = Body::dynamic(mass(1.0, *i));
        b.angular_velocity = vector([rows[0][1], rows[0][2], rows[0][3]]);
        let b = s.push(b, Shape::Sphere(0.1));
        let (mut worst, mut k) = (0.0f64, 0);
        let l0 = len([0, 1, 2].map(|a| i[a] * rows[0][1 + a]));
        let e0: f64 = (0..3).map(|a| i[a] * rows[0][1 + a].powi(2)).sum();
        let (mut lw, mut ew, mut at5) = (0.0f64, 0.0f64, 0.0);
        for row in &rows {
            let n = (row[0] * 240.0).round() as usize;
            while k < n {
                s.step();
                k += 1;
            }
            let q = s.orientation(b);
            let ql = q.iter().map(|x| x * x).sum::<f64>().sqrt();
            let d = (0..4).map(|a| q[a] * row[4 + a]).sum::<f64>().abs() / ql;
            let a = 2.0 * d.min(1.0).acos().to_degrees();
            if row[0] <= 5.0 {
                worst = worst.max(a);
                at5 = a;
            }
            let w = s.spin(b);
            // into body
            let [qw, qx, qy, qz] = q.map(|x| x / ql);
            let u = [-qx, -qy, -qz];
            let c = |a: [f64; 3], b: [f64; 3]| {
                [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            };
            let t = c(u, w);
            let t2 = [t[0] + qw * w[0], t[1] + qw * w[1], t[2] + qw * w[2]];
            let t3 = c(u, t2);
            let wb = [w[0] + 2.0 * t3[0], w[1] + 2.0 * t3[1], w[2] + 2.0 * t3[2]];
            let l = len([0, 1, 2].map(|a| i[a] * wb[a]));
            let e: f64 = (0..3).map(|a| i[a] * wb[a].powi(2)).sum();
            lw = lw.max((l / l0 - 1.0).abs());
            ew = ew.max((e / e0 - 1.0).abs());
        }
        println!(
            "{name} {case} attitude max to 5 s {worst:.3} at 5 {at5:.3} L {lw:.1e} E {ew:.1e} (to {} s)",
            rows.last().unwrap()[0]
        );
    }
}

#[test]
fn edges() {
    all!(edges_in);
}
fn edges_in<S: HostScalar>(name: &str) {
    for (half, m) in [(0.5, 1.0), (0.05, 0.37)] {
        for past in [0.5, 0.1, 0.05, 0.01] {
            let mut line = format!("{name} half {half} past {past}:");
            for side in [1.0f64, -1.0] {
                let mut s = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.5, 0.0);
                s.ground([0.0, 1.0, 0.0]);
                let a = (45.0f64 + side * past).to_radians(); // rotation about z: edge below
                let d = half * 2f64.sqrt();
                let i = s.solid(m, Shape::Cuboid([half; 3]), [0.0, d * (side * past).to_radians().cos(), 0.0]);
                let _ = d;
                s.bodies[i].set_orientation(quat([(a / 2.0).cos(), 0.0, 0.0, (a / 2.0).sin()]));
                let mut t = None;
                for k in 0..1200 {
                    s.step();
                    let q = s.orientation(i);
                    let ang = 2.0 * (q[3]).atan2(q[0]);
                    let deg = ang.to_degrees();
                    if t.is_none() && ((deg - 45.0).abs() > 40.0) {
                        t = Some((k as f64 / 60.0, deg));
                    }
                }
                line += &format!(" {t:.3?}");
            }
            println!("{line}");
        }
    }
}

#[test]
fn slow() {
    all!(slow_in);
}
fn slow_in<S: HostScalar>(name: &str) {
    for far in [0.0, 1000.0] {
        for v in [0.001, 0.01, 0.1] {
            if name == "8" && far > 0.0 {
                continue;
            }
            let mut s = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.5, 0.0);
            s.ground([0.0, 1.0, 0.0]);
            let i = s.solid(1.0, Shape::Sphere(0.1), [far, 0.1, 0.0]);
            s.bodies[i].linear_velocity = vector([v, 0.0, 0.0]);
            s.bodies[i].angular_velocity = vector([0.0, 0.0, -v / 0.1]);
            let v0 = s.velocity(i)[0];
            s.run(10.0);
            println!("{name} far {far} v {v} dist/ideal {:.5} (v0 {v0:.6})", (s.position(i)[0] - far) / (10.0 * v));
        }
    }
}

#[test]
fn incline() {
    all!(incline_in);
}
fn incline_in<S: HostScalar>(name: &str) {
    let text = std::fs::read_to_string("/work/shared/validation/oracles/incline.csv").unwrap();
    let (mut worst, mut n, mut creep, mut vend) = (0.0f64, 0, 0.0f64, 0.0f64);
    let mut worst_row = String::new();
    for l in text.lines().skip(1) {
        let f: Vec<&str> = l.split(',').collect();
        let (kind, theta, mu): (&str, f64, f64) = (f[0], f[1].parse().unwrap(), f[2].parse().unwrap());
        if kind.starts_with("solid_cyl") {
            continue;
        }
        let accel: f64 = f[5].parse().unwrap();
        if kind == "box" && theta.to_radians().tan() > 5.0 {
            continue;
        }
        let th = theta.to_radians();
        let mut s = Scene::<S>::new([G * th.sin(), -G * th.cos(), 0.0], [1, 60], 4, mu, 0.0);
        s.ground([0.0, 1.0, 0.0]);
        let i = if kind == "box" {
            s.solid(1.0, Shape::Cuboid([0.5, 0.1, 0.5]), [0.0, 0.1, 0.0])
        } else {
            let k: f64 = f[3].parse().unwrap();
            let r = 0.5;
            let mut b = Body::dynamic(mass(1.0, [k * r * r; 3]));
            b.position = vector([0.0, r, 0.0]);
            s.push(b, Shape::Sphere(r))
        };
        s.run(1.0);
        let h = 1.0 / 240.0;
        let (x, v) = (s.position(i)[0], s.velocity(i)[0]);
        let want = accel / 2.0 * (1.0 + h);
        if accel == 0.0 {
            s.run(4.0);
            let c = s.position(i)[0].abs();
            if c > 3e-4 {
                println!("   creeps {c:.2e} {kind} {theta} {mu} v {:.2e}", len(s.velocity(i)));
            }
            creep = creep.max(if th.tan() < mu * 0.999 { c } else { 0.0 });
            vend = vend.max(len(s.velocity(i)));
            continue;
        }
        s.run(1.0);
        let dv = s.velocity(i)[0] - v;
        let e = ((x - want).abs() - 1e-2 * want).max(0.0).max((dv / accel - 1.0).abs());
        if e > worst {
            worst = e;
            worst_row = format!("{kind} {theta} {mu} x {x} want {want} v {v} want {accel}");
        }
        n += 1;
    }
    println!("{name} incline {n} rows worst {worst:.2e} ({worst_row}) creep {creep:.2e} v {vend:.2e}");
}

#[test]
fn rocking() {
    all!(rocking_in);
}
fn rocking_in<S: HostScalar>(name: &str) {
    let mut s = Scene::<S>::new([0.0, -G, 0.0], [1, 60], 4, 0.5, 0.0);
    s.ground([0.0, 1.0, 0.0]);
    let h = [0.1, 0.5, 0.5];
    let a: f64 = 0.15;
    // pivot on the corner edge (x=+0.1): centre relative
    let i = s.solid(1.0, Shape::Cuboid(h), [0.0, 0.5 * a.cos() + 0.1 * a.sin(), 0.0]);
    s.bodies[i].set_orientation(quat([(a / 2.0).cos(), 0.0, 0.0, (a / 2.0).sin()]));
    let mut peaks = vec![];
    let (mut a0, mut a1) = (a, a);
    for _ in 0..1200 {
        s.step();
        let q = s.orientation(i);
        let x = (2.0 * q[3].atan2(q[0])).abs();
        if a1 > a0 && a1 >= x {
            peaks.push((a1 * 1e5).round() / 1e5);
        }
        a0 = a1;
        a1 = x;
    }
    println!("{name} peaks {:?}", &peaks[..peaks.len().min(12)]);
}

#[test]
fn sliding_rows() {
    all!(rows_in);
}
fn rows_in<S: HostScalar>(name: &str) {
    let text = std::fs::read_to_string("/work/shared/validation/oracles/sliding_to_rolling.csv").unwrap();
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|l| l.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    let (mut worst, mut which, mut n) = (0.0f64, 0.0, 0);
    let mut wx = 0.0f64;
    for r in &rows {
        // id,k,m,r,mu,v0x,v0y,w0x,w0y,w0z,t_stick,vfx,vfy,wfx,wfy,wfz,x,y,t,vx,vy,wx,wy
        let mut s = Scene::<S>::new([0.0, 0.0, -G], [1, 240], 1, r[4], 0.0);
        if [r[5], r[6], r[7], r[8], r[9], r[16], r[17]].iter().any(|x| S::from_f64(*x).is_none()) {
            continue;
        }
        s.ground([0.0, 0.0, 1.0]);
        let mut b = Body::dynamic(mass(r[2], [r[1] * r[2] * r[3] * r[3]; 3]));
        b.position = vector([0.0, 0.0, r[3]]);
        b.linear_velocity = vector([r[5], r[6], 0.0]);
        b.angular_velocity = vector([r[7], r[8], r[9]]);
        let i = s.push(b, Shape::Sphere(r[3]));
        let steps = (r[18] * 240.0).round();
        for _ in 0..steps as usize {
            s.step();
        }
        let v = s.velocity(i);
        let scale = (r[5] * r[5] + r[6] * r[6]).sqrt().max((r[7].powi(2) + r[8].powi(2)).sqrt() * r[3]);
        let dtt = (steps / 240.0 - r[18]).abs() * r[4] * G;
        let e = ((v[0] - r[19]).hypot(v[1] - r[20]) - dtt).max(0.0) / scale;
        let sx = (s.position(i)[0]).hypot(s.position(i)[1]);
        let _ = sx;
        wx = wx.max(0.0);
        if e > worst {
            worst = e;
            which = r[0];
        }
        n += 1;
    }
    println!("{name} sliding rows {n} of {} worst |dv|/scale {worst:.2e} in {which}", rows.len());
}
static TOPS: [(&str, [f64; 3]); 7] = [
    ("dzhanibekov_123", [1.0, 2.0, 3.0]),
    ("thandle_small", [0.00025, 0.0005, 0.000625]),
    ("box123_rapier", [208.0, 160.0, 80.0]),
    ("long_axis_spin", [1.0, 2.0, 3.0]),
    ("short_axis_spin", [1.0, 2.0, 3.0]),
    ("near_separatrix", [1.0, 2.0, 3.0]),
    ("nearly_symmetric", [1.0, 1.0009765625, 2.0]),
];

#[test]
fn networks() {
    use carom::solver::*;
    use carom::*;
    for name in ["box_stacks82", "spheres_tower356"] {
        let rd = |k: &str| -> Vec<Vec<f64>> {
            std::fs::read_to_string(format!("/work/shared/validation/fclib_scenes/{name}_{k}.csv"))
                .unwrap()
                .lines()
                .skip(1)
                .map(|l| l.split(',').map(|x| x.parse().unwrap()).collect())
                .collect()
        };
        let (bodies, contacts) = (rd("bodies"), rd("contacts"));
        let mut line = String::new();
        for n in [1u16, 4, 500, 1000, 4000] {
            let mut world: Vec<Body<f64>> = bodies
                .iter()
                .map(|b| {
                    let mut x = Body::dynamic(mass(b[1], [b[2], b[3], b[4]]));
                    x.linear_velocity = vector([b[5], b[6], b[7]]);
                    x.angular_velocity = vector([b[8], b[9], b[10]]);
                    x
                })
                .collect();
            let ground = world.len() as u16;
            world.push(Body::immovable());
            let mut motions = vec![Motion::NEW; world.len()];
            let mut mans = vec![ManifoldConstraint::NEW; contacts.len()];
            let mut pts = vec![PointConstraint::NEW; contacts.len()];
            let settings = Settings::new(vector([0.0, -9.81, 0.0]), [1, 60], 4).unwrap();
            let mut step = Step::begin(
                &mut world,
                Buffers { motions: &mut motions, manifolds: &mut mans, points: &mut pts },
                &settings,
            );
            for c in &contacts {
                let b = c[1] as u16;
                let a = if c[2] < 0.0 { ground } else { c[2] as u16 };
                let mut m = Manifold::empty(UnitVec3::normalize(vector([c[3], c[4], c[5]])).unwrap());
                m.push(ManifoldPoint {
                    r_a: vector([c[9], c[10], c[11]]),
                    r_b: vector([c[6], c[7], c[8]]),
                    separation: 0.0,
                    feature: FeatureId(0),
                });
                step.add([a, b], &m, &Material::new(0.0, c[12]).unwrap(), &[]);
            }
            step.finish_rigid(n);
            let (mut e, mut f) = (0.0, 0.0);
            for (x, b) in world.iter().zip(&bodies) {
                let v = x.linear_velocity;
                for k in 0..3 {
                    e += (v.to_array()[k] - b[11 + k]).powi(2);
                    f += (b[5 + k] - b[11 + k]).powi(2);
                }
            }
            line += &format!(" {n}:{:.3e}", (e / f).sqrt());
        }
        println!("{name} {line}");
    }
}

#[test]
fn piles() {
    all!(piles_in);
}
fn piles_in<S: HostScalar>(name: &str) {
    let run = |what: &str, half: f64, masses: &[f64], secs: f64, g: f64| {
        let mut s = Scene::<S>::new([0.0, -g, 0.0], [1, 60], 4, 0.5, 0.0);
        s.ground([0.0, 1.0, 0.0]);
        for (k, m) in masses.iter().enumerate() {
            s.solid(*m, Shape::Cuboid([half; 3]), [0.0, half * (1.0 + 2.0 * k as f64), 0.0]);
        }
        let n = masses.len();
        s.run(secs);
        let (mut drift, mut drop, mut speed, mut tilt) = (0.0f64, 0.0f64, 0.0f64, 0.0f64);
        for k in 0..n {
            let p = s.position(k + 1);
            drift = drift.max(p[0].hypot(p[2]));
            drop = drop.max(half * (1.0 + 2.0 * k as f64) - p[1]);
            speed = speed.max(len(s.velocity(k + 1)));
            tilt = tilt.max(1.0 - s.orientation(k + 1)[0].abs());
        }
        println!(
            "{name} {what}: drift {:.2e} drop {:.2e} (of box) speed {speed:.1e} tilt {tilt:.1e} sat {}",
            drift / half / 2.0,
            drop / half / 2.0,
            s.saturated
        );
    };
    run("10 unit", 0.5, &[1.0; 10], 10.0, G);
    run("10 of 10cm", 0.05, &[0.37; 10], 10.0, G);
    run("4 + 100", 0.5, &[1.0, 1.0, 1.0, 1.0, 100.0], 10.0, G);
    run("4 of 2cm 10g", 0.01, &[0.01; 4], 10.0, G);
    run("10 of 2cm 10g", 0.01, &[0.01; 10], 10.0, G);
    if name != "8" {
        run("4 of 2 [cm], 10 [g]", 1.0, &[10.0; 4], 10.0, 981.0);
    }
}
#[test]
fn sway() {
    for sub in [4u8, 8] {
        for n in [3usize, 5, 10] {
            let mut s = Scene::<f64>::new([0.0, -G, 0.0], [1, 60], sub, 0.5, 0.0);
            s.ground([0.0, 1.0, 0.0]);
            for k in 0..n {
                s.solid(1.0, Shape::Cuboid([0.5; 3]), [0.0, 0.5 + k as f64, 0.0]);
            }
            let mut line = String::new();
            for _ in 0..8 {
                let mut m = 0.0f64;
                for _ in 0..300 {
                    s.step();
                    m = m.max(len(s.velocity(n)));
                }
                line += &format!(" {m:.1e} {:?}|", s.velocity(n).map(|x| (x * 1e5).round() / 1e5));
            }
            println!("sub {sub} n {n} {line} x {:?}", s.position(n));
        }
    }
}
