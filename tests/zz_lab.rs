#[path = "support/host.rs"]
mod host;
#[path = "support/scene.rs"]
mod scene;
use host::HostScalar;
use scene::*;
use carom::{Body, Vec3};

const G: f64 = 9.81;

fn len(v: [f64;3]) -> f64 { v.iter().map(|x| x*x).sum::<f64>().sqrt() }

fn toss_score<S: HostScalar>(sub: u8, mu: f64, e: f64, margin: f64) -> (f64,f64,f64) {
    let text = std::fs::read_to_string("/work/shared/validation/cube_tosses/cube_tosses_dev60.csv").unwrap();
    let rows: Vec<Vec<f64>> = text.lines().skip(1).map(|l| l.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    let (mut p, mut r, mut f, mut n) = (0.0, 0.0, 0.0, 0.0);
    let mut i = 0;
    while i < rows.len() {
        let id = rows[i][0];
        let mut j = i; while j < rows.len() && rows[j][0] == id { j += 1; }
        let toss = &rows[i..j];
        let mut s = Scene::<S>::new([0.0,0.0,-G], [1, 592], sub, mu, e);
        s.margin = margin;
        s.ground([0.0,0.0,1.0]);
        let mut b = Body::dynamic(mass(0.37, [0.00081;3]));
        let t = &toss[0];
        b.position = vector([t[3],t[4],t[5]]);
        b.set_orientation(quat([t[6],t[7],t[8],t[9]]));
        b.linear_velocity = vector([t[10],t[11],t[12]]);
        let wb: Vec3<S> = vector([t[13],t[14],t[15]]);
        b.angular_velocity = b.orientation().rotate(wb);
        let c = s.push(b, Shape::Cuboid([0.0524;3]));
        let (mut pe, mut re, mut last) = (0.0, 0.0, 0.0);
        for (k, row) in toss.iter().enumerate() {
            if k > 0 { for _ in 0..4 { s.step(); } }
            let q = s.orientation(c); let x = s.position(c);
            pe += len([x[0]-row[3], x[1]-row[4], x[2]-row[5]])/0.1048*100.0;
            let ql = q.iter().map(|x| x*x).sum::<f64>().sqrt();
            let dot = (q[0]*row[6]+q[1]*row[7]+q[2]*row[8]+q[3]*row[9]).abs()/ql;
            last = 2.0*dot.min(1.0).acos().to_degrees();
            re += last;
        }
        let m = toss.len() as f64;
        p += pe/m; r += re/m; f += f64::from(last < 45.0); n += 1.0;
        i = j;
    }
    (p/n, r/n, f/n)
}

#[test]
fn tosses() {
    for sub in [1, 2, 4] { for margin in [0.0, 0.02] {
        println!("f64 sub {sub} margin {margin} {:?}", toss_score::<f64>(sub, 0.18, 0.125, margin));
    }}
    println!("f32 {:?}", toss_score::<f32>(4, 0.18, 0.125, 0.02));
    for mu in [0.1,0.14,0.22,0.3] { println!("mu {mu} {:?}", toss_score::<f64>(4, mu, 0.125, 0.02)); }
}

#[test]
fn bounce() {
    bounce_in::<f64>("f64"); bounce_in::<f32>("f32");
}
fn bounce_in<S: HostScalar>(name: &str) {
    for (e, sub) in [(1.0,4u8),(1.0,1),(0.8,4),(0.5,4),(0.3,4),(0.0,4)] {
        let mut s = Scene::<S>::new([0.0,-G,0.0], [1,60], sub, 0.0, e);
        s.ground([0.0,1.0,0.0]);
        let b = s.solid(1.0, Shape::Sphere(0.1), [0.0,1.1,0.0]);
        let mut apexes = vec![]; let (mut y0, mut y1) = (1.1, 1.1);
        for _ in 0..600 { s.step(); let y = s.position(b)[1]; if y1 > y0 && y1 >= y { apexes.push(y1-0.1);} y0=y1; y1=y; }
        println!("{name} e {e} sub {sub}: {:?} last {:?} end {} {}", &apexes[..apexes.len().min(5)], apexes.last(), s.position(b)[1], s.velocity(b)[1]);
    }
}

#[test]
fn roll() {
    roll_in::<f64>("f64"); roll_in::<f32>("f32");
}
fn roll_in<S: HostScalar>(name: &str) {
    let mut s = Scene::<S>::new([0.0,-G,0.0], [1,60], 4, 0.25, 0.0);
    s.ground([0.0,1.0,0.0]);
    let b = s.solid(1.0, Shape::Sphere(0.5), [0.0,0.5,0.0]);
    s.bodies[b].linear_velocity = vector([7.0,0.0,0.0]);
    s.run(3.0);
    println!("{name} roll {:?} {:?} y {}", s.velocity(b), s.spin(b), s.position(b)[1]);
    // box stopping at headings
    for k in 0..12 {
        let a = (k as f64)*30f64.to_radians()+0.1;
        let mut s = Scene::<S>::new([0.0,-G,0.0], [1,60], 4, 0.5, 0.0);
        s.ground([0.0,1.0,0.0]);
        let b = s.solid(1.0, Shape::Cuboid([0.5,0.1,0.5]), [0.0,0.1,0.0]);
        s.bodies[b].linear_velocity = vector([5.0*a.cos(),0.0,5.0*a.sin()]);
        s.run(3.0);
        let p = s.position(b); let d = (p[0]*p[0]+p[2]*p[2]).sqrt();
        let h = 1.0/240.0;
        println!("  stop d {d} (ideal {} offset {}) heading err deg {}", 2.54841997961264, 2.54841997961264 - 5.0*h/2.0, (p[2].atan2(p[0])-a).sin().to_degrees());
    }
    // spin down
    let mut s = Scene::<S>::new([0.0,-G,0.0], [1,60], 4, 0.24494897427831780, 0.0);
    s.ground([0.0,1.0,0.0]);
    let b = s.solid(1.0, Shape::Cuboid([1.0,1.0,1.0]), [0.0,1.0,0.0]);
    s.bodies[b].angular_velocity = vector([0.0,10.0,0.0]);
    let mut angle=0.0; let mut t=0.0; 
    for _ in 0..180 { s.step(); let w=s.spin(b)[1]; angle += w/60.0; if w>1e-3 {t+=1.0/60.0;} }
    println!("  spin-down angle {angle} (9.8089) t {t} (1.9618)");
}

#[test]
fn stack() { stack_in::<f64>("f64"); stack_in::<f32>("f32"); }
fn stack_in<S: HostScalar>(name: &str) {
    for n in [1usize, 8] {
        let mut s = Scene::<S>::new([0.0,-G,0.0], [1,60], 4, 0.5, 0.0);
        s.ground([0.0,1.0,0.0]);
        for i in 0..n { s.solid(1.0, Shape::Sphere(0.5), [0.0,0.5+i as f64,0.0]); }
        s.run(3.0);
        println!("{name} {n} spheres top {:?} v {:?}", s.position(n), s.velocity(n));
    }
}

#[test]
fn top() { top_in::<f64>("f64"); top_in::<f32>("f32"); }
fn top_in<S: HostScalar>(name: &str) {
    let text = std::fs::read_to_string("/work/shared/validation/oracles/torque_free_top.csv").unwrap();
    let rows: Vec<(String, Vec<f64>)> = text.lines().skip(1).map(|l| { let (a,b)=l.split_once(',').unwrap(); (a.to_string(), b.split(',').map(|x| x.parse().unwrap()).collect()) }).collect();
    let mut cases: Vec<String> = rows.iter().map(|r| r.0.clone()).collect(); cases.dedup();
    let py = std::fs::read_to_string("/work/shared/validation/oracles/torque_free_top.py").unwrap();
    if name=="f64" { println!("{}", &py[py.len().saturating_sub(2500)..]); }
    for c in cases { println!("{name} case {c} {:?}", rows.iter().find(|r| r.0==c).unwrap().1); }
}
