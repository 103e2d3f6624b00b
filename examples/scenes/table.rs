//! A billiard table without a cloth: sixteen balls that roll nowhere but fly flat, and four cushions.
//!
//! Lengths are decimetres, masses kilograms: in these units a table fits every fixed format, down to I8F24's +-128.

use carom::impulse::{Impact, Outcome, resolve_collision_with_friction};
use carom::{Body, Contact, Material, Scalar, Scaled, Solid, StateHash, UnitVec3, Vec3};

/// Balls on the table, the cue ball first.
pub const BALLS: usize = 16;
/// Length and width of the table between the cushions, in thousandths of a decimetre.
pub const WIDTH: i32 = 25_400;
pub const HEIGHT: i32 = 12_700;
/// Sub-steps of 1/480 s: two seconds.
pub const STEPS: u32 = 960;

/// Radius of a ball: 57.15 mm across.
const RADIUS: i32 = 285_750;
/// Gap between the balls of the rack.
const GAP: i32 = 1_000;
/// Passes over the pairs in a sub-step, for what one impact sets off in the next ball of a chain.
const PASSES: u32 = 4;

/// A ball, with what its position could not yet hold.
#[derive(Clone, Copy)]
struct Ball<S: Scalar> {
    body: Body<S>,
    remainder: [S::Remainder; 2],
}

/// The balls, the cushions, and what happened so far.
pub struct Table<S: Scalar> {
    balls: [Ball<S>; BALLS],
    cushion: Body<S>,
    ball_material: Material<S>,
    cushion_material: Material<S>,
    radius: S,
    diameter_squared: S,
    h: S::SubStep,
    size: [S; 2],
    mass: S,
    /// Momentum that the cushions have taken up, in kg dm/s.
    given: Vec3<S>,
    pub ball_impacts: u32,
    pub cushion_impacts: u32,
}

/// `n` millionths.
fn micro<S: Scalar>(n: i32) -> Option<S> {
    S::from_ratio(n, 1_000_000).ok()
}

impl<S: Scalar> Table<S> {
    /// The rack, and the cue ball on its way to it at 8 m/s, a little off the centre line.
    pub fn new() -> Option<Self> {
        let milli = |n| S::from_ratio(n, 1000).ok();
        let radius = micro::<S>(RADIUS)?;
        let mass = milli(170)?;
        let solid = Solid::sphere(radius).ok()?.with_mass(mass).ok()?;
        let ball = Ball { body: Body::dynamic(solid), remainder: Default::default() };
        let mut balls = [ball; BALLS];

        let (cue, rack) = balls.split_first_mut()?;
        cue.body.position = Vec3::new(milli(WIDTH / 4)?, milli(HEIGHT / 2 + 20)?, S::ZERO);
        cue.body.linear_velocity = Vec3::new(milli(80_000)?, S::ZERO, S::ZERO);
        let mut slots = rack.iter_mut();
        let pitch = 2 * RADIUS + GAP;
        for row in 0..5 {
            for place in 0..=row {
                // Rows of a triangle are sqrt(3)/2 = 0.8660 of the pitch apart.
                let x = 3 * WIDTH / 4 * 100 + row * (pitch / 10 * 866 / 1000);
                let y = HEIGHT / 2 * 100 + (2 * place - row) * (pitch / 20);
                slots.next()?.body.position =
                    Vec3::new(S::from_ratio(x, 100_000).ok()?, S::from_ratio(y, 100_000).ok()?, S::ZERO);
            }
        }
        Some(Self {
            balls,
            cushion: Body::immovable(),
            ball_material: Material::new(milli(950)?, milli(60)?).ok()?,
            cushion_material: Material::new(milli(750)?, milli(140)?).ok()?,
            radius,
            diameter_squared: S::from_ratio(4, 1).ok()?.times(radius.times(radius)),
            h: S::sub_step(1, 480).ok()?,
            size: [milli(WIDTH)?, milli(HEIGHT)?],
            mass,
            given: Vec3::ZERO,
            ball_impacts: 0,
            cushion_impacts: 0,
        })
    }

    /// One sub-step: all balls move, then all that touch and approach exchange impulses.
    pub fn step(&mut self) {
        for ball in &mut self.balls {
            let (p, v) = (&mut ball.body.position, ball.body.linear_velocity);
            let [rx, ry] = &mut ball.remainder;
            p.x = p.x.advance(v.x, self.h, rx).0;
            p.y = p.y.advance(v.y, self.h, ry).0;
        }
        for _ in 0..PASSES {
            let before = self.ball_impacts;
            self.strike_balls();
            if self.ball_impacts == before {
                break;
            }
        }
        self.strike_cushions();
    }

    fn strike_balls(&mut self) {
        let mut rest = &mut self.balls[..];
        while let Some((first, others)) = rest.split_first_mut() {
            for second in others.iter_mut() {
                let between = second.body.position - first.body.position;
                // In the formats with a short range a far ball is at the end of it, and far enough.
                if between.dot(between) > self.diameter_squared {
                    continue;
                }
                let Ok(normal) = UnitVec3::normalize(between) else { continue };
                let contact = contact(normal, self.radius, self.radius);
                let impact = kernel_strike(&mut first.body, &mut second.body, &contact, &self.ball_material);
                self.ball_impacts = self.ball_impacts.wrapping_add(u32::from(impact.outcome != Outcome::Separating));
            }
            rest = others;
        }
    }

    fn strike_cushions(&mut self) {
        for ball in &mut self.balls {
            let Vec3 { x, y, .. } = ball.body.position;
            let [width, height] = self.size;
            let r = self.radius;
            let walls = [
                (x < r, UnitVec3::X),
                (x > width.minus(r), -UnitVec3::X),
                (y < r, UnitVec3::Y),
                (y > height.minus(r), -UnitVec3::Y),
            ];
            for (touches, normal) in walls {
                if !touches {
                    continue;
                }
                let contact = contact(normal, S::ZERO, r);
                let impact = kernel_strike(&mut self.cushion, &mut ball.body, &contact, &self.cushion_material);
                if impact.outcome == Outcome::Separating {
                    continue;
                }
                self.cushion_impacts = self.cushion_impacts.wrapping_add(1);
                // The cushion takes up the opposite of what the ball gets.
                let axis = normal.times(impact.normal_impulse);
                self.given = self.given - axis - impact.friction_impulse;
            }
        }
    }

    /// The bodies, the cue ball first.
    pub fn bodies(&self) -> impl Iterator<Item = &Body<S>> {
        self.balls.iter().map(|ball| &ball.body)
    }

    /// Momentum of all balls in kg m/s: along the table, across it.
    pub fn momentum(&self) -> [S; 2] {
        metres(self.bodies().fold(Vec3::ZERO, |sum, body| sum + body.linear_velocity * self.mass))
    }

    /// Momentum that the cushions have taken up, in kg m/s.
    pub fn given(&self) -> [S; 2] {
        metres(self.given)
    }

    /// Kinetic energy of all balls in joules.
    pub fn energy(&self) -> S {
        let energy = self.bodies().fold(S::Scaled::ZERO, |sum, body| {
            // m/2 (v^2 + 2/5 r^2 w^2)
            let square = |v: Vec3<S>| {
                let [x, y, z] = v.to_array().map(S::to_scaled);
                x * x + y * y + z * z
            };
            let r = self.radius.to_scaled();
            let spin = S::Scaled::ratio(2, 5) * r * r * square(body.angular_velocity);
            sum + self.mass.to_scaled() * (square(body.linear_velocity) + spin)
        });
        // Half, and from kg dm^2/s^2.
        S::from_scaled(energy * S::Scaled::ratio(1, 200)).0
    }

    /// The hash of all balls.
    pub fn hash(&self) -> u64 {
        let mut hash = StateHash::new();
        for body in self.bodies() {
            hash.add_body(body);
        }
        hash.get()
    }
}

/// The hash after the break.
pub fn hash<S: Scalar>() -> Option<u64> {
    let mut table = Table::<S>::new()?;
    (0..STEPS).for_each(|_| table.step());
    Some(table.hash())
}

/// From decimetres.
fn metres<S: Scalar>(v: Vec3<S>) -> [S; 2] {
    [v.x, v.y].map(|x| S::from_scaled(x.to_scaled() * S::Scaled::ratio(1, 10)).0)
}

/// A contact of round bodies: the arms are radii along the normal.
fn contact<S: Scalar>(normal: UnitVec3<S>, radius_a: S, radius_b: S) -> Contact<S> {
    Contact { normal, r_a: normal.times(radius_a), r_b: -normal.times(radius_b) }
}

#[inline(never)]
fn kernel_strike<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    material: &Material<S>,
) -> Impact<S> {
    resolve_collision_with_friction(a, b, contact, material)
}
