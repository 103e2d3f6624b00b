//! Random impacts of widely spread magnitudes, from a seed.

use carom::{Body, Contact, MassProperties, Quat, Scalar, UnitVec3, Vec3};

use super::format::Format;
use super::random::Random;

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

fn velocity<S: Format>(random: &mut Random, low: f64, high: f64) -> Vec3<S> {
    let direction = random.direction();
    match random.pick(16) {
        0 | 1 => Vec3::ZERO,
        2 => Vec3::new(S::nearest(-high), S::nearest(high), S::nearest(if random.one_in(2) { high } else { 0.0 })),
        _ => vector(direction, random.spread(low, high)),
    }
}

fn normal<S: Format>(random: &mut Random) -> [f64; 3] {
    match random.pick(8) {
        0 => {
            let mut axis = [0.0; 3];
            axis[random.pick(3) as usize] = if random.one_in(2) { 1.0 } else { -1.0 };
            axis
        }
        // As far from unit length as the constructor allows.
        1 => {
            let length = 1.0 + random.between(-1.0, 1.0) * 7.0e-6;
            random.direction().map(|x| x * length)
        }
        _ => random.direction(),
    }
}

fn arm<S: Format>(random: &mut Random, normal: [f64; 3], low: f64, high: f64) -> Vec3<S> {
    let length = random.spread(low, high);
    match random.pick(16) {
        0 => Vec3::ZERO,
        // Nearly along the normal: a large arm with a small moment.
        1..=4 => {
            let (tilt, aside) = (random.spread(1e-9, 1.0), random.direction());
            let sign = if random.one_in(2) { 1.0 } else { -1.0 };
            vector(std::array::from_fn(|i| (sign * normal[i] + tilt * aside[i]) / (1.0 + tilt)), length)
        }
        5 => Vec3::new(S::nearest(high), S::nearest(-high), S::nearest(random.between(-high, high))),
        _ => vector(random.direction(), length),
    }
}

/// A body with a mass of 2^-12 to 2^12 and an inertia that goes with an arm of that length, or with nothing at all.
fn body<S: Format>(random: &mut Random, arm: f64) -> Body<S> {
    let inv_mass = random.spread(2f64.powi(-12), 2f64.powi(12));
    let size = arm.max(S::magnitudes().0) * random.spread(0.25, 8.0);
    // 1/(m k^2) for a radius of gyration k
    let inv_moment = |k: f64| inv_mass / (k * k);
    let moments = match random.pick(8) {
        // a sphere
        0 | 1 => [inv_moment(size); 3],
        // a box of three edges of one size
        2..=4 => {
            let [x, y, z] =
                [random.between(0.2, 1.0), random.between(0.2, 1.0), random.between(0.2, 1.0)].map(|h: f64| h * h);
            [y + z, x + z, x + y].map(|square| inv_moment(size * (square / 3.0).sqrt()))
        }
        // anything, most of it impossible
        5 => std::array::from_fn(|_| inv_moment(size * random.spread(2f64.powi(-6), 2f64.powi(6)))),
        // a needle
        6 => {
            let thin = inv_moment(size * random.spread(1e-3, 0.3));
            let mut moments = [inv_moment(size); 3];
            moments[random.pick(3) as usize] = thin;
            moments
        }
        // some axes locked, or all
        _ => std::array::from_fn(|_| if random.one_in(3) { inv_moment(size) } else { 0.0 }),
    };
    let scaled = S::nearest_scaled;
    let mass = MassProperties::from_inverses(scaled(inv_mass), moments.map(scaled)).expect("a valid body");
    let mut body = Body::dynamic(mass);
    let quarter = |random: &mut Random| if random.one_in(2) { 0.5 } else { -0.5 };
    let [w, x, y, z] = match random.pick(8) {
        0 => [1.0, 0.0, 0.0, 0.0],
        1 => [quarter(random), quarter(random), quarter(random), quarter(random)],
        _ => {
            let ([x, y, z], half) = (random.direction(), random.between(0.0, std::f64::consts::PI));
            [half.cos(), half.sin() * x, half.sin() * y, half.sin() * z]
        }
    };
    let unit = S::nearest_unit;
    body.set_orientation(Quat::normalize(unit(w), unit(x), unit(y), unit(z)).expect("a rotation"));
    body
}

/// An impact that in most cases approaches; one body in eight is immovable.
pub fn random_case<S: Format>(random: &mut Random) -> Case<S> {
    let (low, high) = S::magnitudes();
    let direction = normal::<S>(random);
    let normal = UnitVec3::new(Vec3::from_array(direction.map(S::nearest_unit))).expect("a direction");
    let (r_a, r_b) = (arm::<S>(random, direction, low, high), arm::<S>(random, direction, low, high));
    let length = |v: Vec3<S>| v.to_array().map(|x| x.value().to_f64().powi(2)).iter().sum::<f64>().sqrt();
    let (mut a, mut b) = (body(random, length(r_a)), body(random, length(r_b)));
    match random.pick(16) {
        0 => a = Body::immovable(),
        1 => b = Body::immovable(),
        _ => {}
    }
    for (body, r) in [(&mut a, r_a), (&mut b, r_b)] {
        body.linear_velocity = velocity(random, low, high);
        // Turning no faster than the format can tell at the end of the arm; in some cases at any speed.
        let fastest = if random.one_in(8) { high } else { (high / length(r).max(low)).clamp(low, high) };
        body.angular_velocity = velocity(random, low, fastest);
    }
    let restitution = match random.pick(4) {
        0 => S::ZERO,
        1 if S::largest() > 1.0 => S::ONE,
        _ => S::nearest(random.unit().min(1.0 - S::ulp(0.5))),
    };
    let friction = match random.pick(8) {
        0 => S::ZERO,
        1 => S::nearest(random.spread(1e-3, 1e2)),
        _ => S::nearest(random.between(0.0, 1.5)),
    };
    let mut case = Case { a, b, contact: Contact { normal, r_a, r_b }, restitution, friction };
    if !random.one_in(8) {
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

/// The whole state of a body that a caller can read, bit for bit.
pub fn bits<S: Format>(body: &Body<S>) -> [u64; 9] {
    let mut bits = [0; 9];
    for (i, v) in [body.position, body.linear_velocity, body.angular_velocity].into_iter().enumerate() {
        for (k, x) in v.to_array().into_iter().enumerate() {
            bits[3 * i + k] = x.raw();
        }
    }
    bits
}
