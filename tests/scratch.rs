use carom::*;
use fixed::types::*;
use micromath::F32;
use fixed::traits::*;
trait Host: Scalar { fn of(x: f64) -> Self; fn unit(x: f64) -> Self::Unit; fn f(self) -> f64; fn sc(x: f64)->Self::Scaled; }
fn parts(x: f64)->(i32,i32){ if x==0.0 {return (0,0)} let e = x.abs().log2().floor() as i32 - 29; ((x / 2f64.powi(e)).round() as i32, e) }
macro_rules! fl { ($t:ty, $w:expr, $u:expr) => { impl Host for $t { fn of(x:f64)->Self{$w(x)} fn unit(x:f64)->Self{$w(x)} fn f(self)->f64{$u(self)} fn sc(x:f64)->Self{$w(x)} } } }
fl!(f32, |x| x as f32, |x:f32| x as f64);
fl!(f64, |x| x, |x:f64| x);
fl!(F32, |x| F32(x as f32), |x:F32| x.0 as f64);
macro_rules! fx { ($t:ty) => { impl Host for $t { fn of(x:f64)->Self{<$t>::from_num(x)} fn unit(x:f64)->I2F30{I2F30::from_num(x)} fn f(self)->f64{self.to_num()} fn sc(x:f64)->Scaled32{let(m,e)=parts(x);Scaled::from_parts(m,e)} } } }
fx!(I16F16); fx!(I12F20); fx!(I8F24);
fn run<S: Host>(name: &str, q16: bool, lim: f64) {
    let mut rd = csv::Reader::from_path("tests/data/two_body_impulse_dev.csv").unwrap();
    let h: std::collections::HashMap<String,usize> = rd.headers().unwrap().iter().enumerate().map(|(i,s)|(s.to_string(),i)).collect();
    let mut worst = (0.0f64,0.0f64,0.0f64); let mut ej: Vec<f64> = vec![]; let mut rel=vec![]; let mut bad=0; let mut skipped=0; let mut modes=0;
    for r in rd.records() { let r = r.unwrap();
        let g = |k: &str| r[h[k]].parse::<f64>().unwrap();
        if q16 && (&r[h["q16"]] != "1" || &r[h["cat"]]=="E") {continue;}
        let keys = ["r1x","r1y","r1z","r2x","r2y","r2z","v1x","v1y","v1z","v2x","v2y","v2z","w1x","w1y","w1z","w2x","w2y","w2z","vp1x","vp1y","vp1z","vp2x","vp2y","vp2z","wp1x","wp1y","wp1z","wp2x","wp2y","wp2z","jn","jt"];
        if keys.iter().any(|k| g(k).abs()>=lim) { skipped+=1; continue; }
        let v3 = |p: &str| Vec3::new(S::of(g(&format!("{p}x"))),S::of(g(&format!("{p}y"))),S::of(g(&format!("{p}z"))));
        let body = |k: usize| { let m = g(&format!("m{k}"));
            let mut b = if m == 0.0 { Body::immovable() } else { 
              Body::dynamic(MassProperties::from_inverses(S::sc(1.0/m), ["x","y","z"].map(|a| S::sc(1.0/g(&format!("I{k}{a}"))))).unwrap()) };
            let q = ["w","x","y","z"].map(|a| g(&format!("q{k}{a}"))); let l = q.iter().map(|x|x*x).sum::<f64>().sqrt();
            b.set_orientation(Quat::new(S::unit(q[0]/l),S::unit(q[1]/l),S::unit(q[2]/l),S::unit(q[3]/l)).unwrap());
            b.linear_velocity = v3(&format!("v{k}")); b.angular_velocity = v3(&format!("w{k}")); b };
        let (mut a, mut b) = (body(1), body(2));
        let n = ["nx","ny","nz"].map(|k| g(k)); let l = n.iter().map(|x|x*x).sum::<f64>().sqrt();
        let c = Contact{ normal: UnitVec3::new(Vec3::new(S::unit(n[0]/l),S::unit(n[1]/l),S::unit(n[2]/l))).unwrap(), r_a: v3("r1"), r_b: v3("r2") };
        let mat = Material::new(S::of(g("e")), S::of(g("mu"))).unwrap();
        let k = { let em = impulse::effective_mass(&a,&b,&c,c.normal).f(); 1.0/em };
        let s: f64 = ["v1","v2"].iter().map(|p| v3(p).to_array().iter().map(|x|x.f()*x.f()).sum::<f64>().sqrt()).sum::<f64>() + (1..=2).map(|k| v3(&format!("w{k}")).length().f()*v3(&format!("r{k}")).length().f()).sum::<f64>();
        let i = impulse::resolve_collision_with_friction(&mut a,&mut b,&c,&mat);
        let mode = &r[h["mode"]]; let want = match mode { "stick"=>impulse::Outcome::Stuck, "slip"|"frictionless"=>impulse::Outcome::Slid, "separating"=>impulse::Outcome::Separating, x=>panic!("{x}") };
        if i.outcome != want { modes+=1; println!("{name} row {} mode {mode} got {:?}", &r[0], i.outcome); }
        let nn = n.map(|x| x/l);
        let f = i.friction_impulse.to_array(); let jn = i.normal_impulse.f();
        let d: f64 = (0..3).map(|q| (nn[q]*jn + f[q].f() - g(["Jx","Jy","Jz"][q])).powi(2)).sum::<f64>().sqrt();
        let jj = g("jn").hypot(g("jt"));
        ej.push(d/jj.max(s/k)); if jj>0.0 {rel.push(d/jj);} if d > 5e-6*jj.max(s/k) {bad+=1; if bad<5 {println!("bad {} {} d {d} J {jj} s/k {}", &r[0], mode, s/k)}}
        for (k,body) in [(1,&a),(2,&b)] { for (ax,(v,w)) in ["x","y","z"].iter().zip(body.linear_velocity.to_array().iter().zip(body.angular_velocity.to_array())) {
            let dv = (v.f()-g(&format!("vp{k}{ax}"))).abs(); let dw=(w.f()-g(&format!("wp{k}{ax}"))).abs();
            worst.0=worst.0.max(dv); worst.1=worst.1.max(dw); } }
    }
    ej.sort_by(|a,b| a.total_cmp(b)); rel.sort_by(|a,b| a.total_cmp(b));
    println!("{name}: n {} skipped {skipped} modes {modes} J err/max(J,s/K): med {:.2e} p99 {:.2e} max {:.2e}; rel med {:.2e} p99.5 {:.2e} max {:.2e}; dv {:.2e} dw {:.2e} bad {bad}", ej.len(), ej[ej.len()/2], ej[ej.len()*99/100], ej.last().unwrap(), rel[rel.len()/2], rel[rel.len()*995/1000], rel.last().unwrap(), worst.0, worst.1);
}
#[test] fn scratch() {
    run::<f64>("f64", false, 1e300); run::<f32>("f32", false,1e300); run::<F32>("micromath", false,1e300);
    run::<I16F16>("i16f16 q16", true, 32768.0); run::<I16F16>("i16f16", false, 32768.0); run::<I12F20>("i12f20", false, 2048.0); run::<I8F24>("i8f24", false, 128.0);
}
