//! Random impacts of widely spread magnitudes, from a seed.

use carom::{Body, Contact, MassProperties, Quat, Scalar, UnitVec3, Vec3};

use super::format::Format;

/// SplitMix64: a small generator whose numbers are the same everywhere.
pub struct Rng(u64);

impl Rng {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5851_f42d_4c95_7f2d)
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    /// In 0..1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / 2f64.powi(53)
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Between positive ends, evenly in the logarithm.
    pub fn spread(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.log2(), high.log2()).exp2()
    }

    /// True once in `n`.
    pub fn one_in(&mut self, n: u64) -> bool {
        self.bits() % n == 0
    }

    pub fn pick(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    /// A direction, even on the sphere.
    pub fn direction(&mut self) -> [f64; 3] {
        loop {
            let v = [self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0)];
            let square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
            if square > 1e-3 && square <= 1.0 {
                return v.map(|x| x / square.sqrt());
            }
        }
    }
}

/// Two bodies, their contact and its surface.
#[derive(Clone, Copy, Debug)]
pub struct Case<S: Scalar> {
    pub a: Body<S>,
    pub b: Body<S>,
    pub contact: Contact<S>,
    pub restitution: S,
    pub friction: S,
}

impl<S: Scalar> Case<S> {
    /// The same impact with the bodies in the other order.
    pub fn swapped(&self) -> Self {
        Self { a: self.b, b: self.a, contact: self.contact.swapped(), ..*self }
    }
}

pub fn vector<S: Format>(direction: [f64; 3], length: f64) -> Vec3<S> {
    Vec3::from_array(direction.map(|x| S::nearest(x * length)))
}

fn velocity<S: Format>(rng: &mut Rng, low: f64, high: f64) -> Vec3<S> {
    let direction = rng.direction();
    match rng.pick(16) {
        0 | 1 => Vec3::ZERO,
        2 => Vec3::new(S::nearest(-high), S::nearest(high), S::nearest(if rng.one_in(2) { high } else { 0.0 })),
        _ => vector(direction, rng.spread(low, high)),
    }
}

fn normal<S: Format>(rng: &mut Rng) -> [f64; 3] {
    match rng.pick(8) {
        0 => {
            let mut axis = [0.0; 3];
            axis[rng.pick(3) as usize] = if rng.one_in(2) { 1.0 } else { -1.0 };
            axis
        }
        // As far from unit length as the constructor allows.
        1 => {
            let length = 1.0 + rng.between(-1.0, 1.0) * 7.0e-6;
            rng.direction().map(|x| x * length)
        }
        _ => rng.direction(),
    }
}

fn arm<S: Format>(rng: &mut Rng, normal: [f64; 3], low: f64, high: f64) -> Vec3<S> {
    let length = rng.spread(low, high);
    match rng.pick(16) {
        0 => Vec3::ZERO,
        // Nearly along the normal: a large arm with a small moment.
        1..=4 => {
            let (tilt, aside) = (rng.spread(1e-9, 1.0), rng.direction());
            let sign = if rng.one_in(2) { 1.0 } else { -1.0 };
            vector(std::array::from_fn(|i| (sign * normal[i] + tilt * aside[i]) / (1.0 + tilt)), length)
        }
        5 => Vec3::new(S::nearest(high), S::nearest(-high), S::nearest(rng.between(-high, high))),
        _ => vector(rng.direction(), length),
    }
}

/// A body with a mass of 2^-12 to 2^12 and an inertia that goes with an arm of that length, or with nothing at all.
fn body<S: Format>(rng: &mut Rng, arm: f64) -> Body<S> {
    let inv_mass = rng.spread(2f64.powi(-12), 2f64.powi(12));
    let size = arm.max(S::magnitudes().0) * rng.spread(0.25, 8.0);
    // 1/(m k^2) for a radius of gyration k
    let inv_moment = |k: f64| inv_mass / (k * k);
    let moments = match rng.pick(8) {
        // a sphere
        0 | 1 => [inv_moment(size); 3],
        // a box of three edges of one size
        2..=4 => {
            let [x, y, z] = [rng.between(0.2, 1.0), rng.between(0.2, 1.0), rng.between(0.2, 1.0)].map(|h: f64| h * h);
            [y + z, x + z, x + y].map(|square| inv_moment(size * (square / 3.0).sqrt()))
        }
        // anything, most of it impossible
        5 => std::array::from_fn(|_| inv_moment(size * rng.spread(2f64.powi(-6), 2f64.powi(6)))),
        // a needle
        6 => {
            let thin = inv_moment(size * rng.spread(1e-3, 0.3));
            let mut moments = [inv_moment(size); 3];
            moments[rng.pick(3) as usize] = thin;
            moments
        }
        // some axes locked, or all
        _ => std::array::from_fn(|_| if rng.one_in(3) { inv_moment(size) } else { 0.0 }),
    };
    let scaled = S::nearest_scaled;
    let mass = MassProperties::from_inverses(scaled(inv_mass), moments.map(scaled)).expect("a valid body");
    let mut body = Body::dynamic(mass);
    let quarter = |rng: &mut Rng| if rng.one_in(2) { 0.5 } else { -0.5 };
    let [w, x, y, z] = match rng.pick(8) {
        0 => [1.0, 0.0, 0.0, 0.0],
        1 => [quarter(rng), quarter(rng), quarter(rng), quarter(rng)],
        _ => {
            let ([x, y, z], half) = (rng.direction(), rng.between(0.0, std::f64::consts::PI));
            [half.cos(), half.sin() * x, half.sin() * y, half.sin() * z]
        }
    };
    let unit = S::nearest_unit;
    body.set_orientation(Quat::normalize(unit(w), unit(x), unit(y), unit(z)).expect("a rotation"));
    body
}

/// An impact that in most cases approaches; one body in eight is immovable.
pub fn random_case<S: Format>(rng: &mut Rng) -> Case<S> {
    let (low, high) = S::magnitudes();
    let direction = normal::<S>(rng);
    let normal = UnitVec3::new(Vec3::from_array(direction.map(S::nearest_unit))).expect("a direction");
    let (r_a, r_b) = (arm::<S>(rng, direction, low, high), arm::<S>(rng, direction, low, high));
    let length = |v: Vec3<S>| v.to_array().map(|x| x.value().to_f64().powi(2)).iter().sum::<f64>().sqrt();
    let (mut a, mut b) = (body(rng, length(r_a)), body(rng, length(r_b)));
    match rng.pick(16) {
        0 => a = Body::immovable(),
        1 => b = Body::immovable(),
        _ => {}
    }
    for (body, r) in [(&mut a, r_a), (&mut b, r_b)] {
        body.linear_velocity = velocity(rng, low, high);
        // Turning no faster than the format can tell at the end of the arm; in some cases at any speed.
        let fastest = if rng.one_in(8) { high } else { (high / length(r).max(low)).clamp(low, high) };
        body.angular_velocity = velocity(rng, low, fastest);
    }
    let restitution = match rng.pick(4) {
        0 => S::ZERO,
        1 if S::largest() > 1.0 => S::ONE,
        _ => S::nearest(rng.unit().min(1.0 - S::ulp(0.5))),
    };
    let friction = match rng.pick(8) {
        0 => S::ZERO,
        1 => S::nearest(rng.spread(1e-3, 1e2)),
        _ => S::nearest(rng.between(0.0, 1.5)),
    };
    let mut case = Case { a, b, contact: Contact { normal, r_a, r_b }, restitution, friction };
    if !rng.one_in(8) {
        turn_towards(&mut case);
    }
    case
}

/// Turns all velocities round where the bodies part.
pub fn turn_towards<S: Format>(case: &mut Case<S>) {
    let problem = super::Problem::read(case);
    if problem.approach().is_positive() {
        for body in [&mut case.a, &mut case.b] {
            body.linear_velocity = -body.linear_velocity;
            body.angular_velocity = -body.angular_velocity;
        }
    }
}
