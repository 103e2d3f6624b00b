//! A break of six balls on a table of 2.54 m by 1.27 m, with a cloth on which balls slide and roll, and cushions.
//!
//! What the cloth takes from rolling balls is a damping of both their motions, the same for both, so that they go on rolling.

use carom::solver::Settings;
use carom::{Body, BodyHandle, HalfSpace, Scalar, Scaled, UnitVec3, Vec3, World};

use super::make::{ball, kernel_step, material, milli, settings, square, vector};

carom::shapes! {
    /// A ball; the cloth or a cushion.
    pub enum Piece<S> { Sphere, HalfSpace }
}

/// The cue ball first.
pub const BALLS: usize = 7;
/// Half the length and width between the cushions, in thousandths of a decimetre.
pub const HALF: [i32; 2] = [12_700, 6_350];
/// Four seconds.
pub const RATE: u16 = 240;
pub const SUB_STEPS: u8 = 2;
pub const STEPS: u32 = 960;

/// The radius of a ball in millionths of a decimetre: 57.15 mm across. Between balls of the rack is a gap of 1 mm.
const RADIUS: i32 = 285_750;
const PITCH: i32 = 2 * RADIUS + 10_000;
/// The break, in thousandths of dm/s.
const SPEED: i32 = 60_000;

/// Room for the balls, the cloth and the cushions, for each ball on the cloth and as many blows at a time.
pub type Room<S> = World<S, Piece<S>, { BALLS + 5 }, 13, 13>;

pub struct Billiards<'w, S: Scalar> {
    world: &'w mut Room<S>,
    settings: Settings<S>,
    balls: [Option<BodyHandle>; BALLS],
    pub dropped: u32,
    pub most: u16,
    pub saturated: bool,
    /// Blows between balls, and on cushions.
    pub ball_impacts: u32,
    pub cushion_impacts: u32,
}

/// Where ball number `index` stands, in millionths: the cue ball, then the triangle of six.
fn place(index: i32) -> Option<[i32; 2]> {
    // Rows of the triangle have 1, 2, 3 balls, sqrt(3)/2 = 0.8660 of the pitch apart.
    let rows = [1, 2, 3];
    if index == 0 {
        return Some([-6_350_000, 20_000]);
    }
    let mut first = 1;
    for (row, count) in (0i32..).zip(rows) {
        if index < first + count {
            let across = 2 * (index - first) - (count - 1);
            return Some([6_350_000 + row * (PITCH / 10 * 866 / 100), across * (PITCH / 2)]);
        }
        first += count;
    }
    None
}

impl<'w, S: Scalar> Billiards<'w, S> {
    /// The rack, and the cue ball on its way.
    pub fn new(world: &'w mut Room<S>) -> Option<Self> {
        let surface = material(900, 120)?;
        world.clear();
        world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), surface).ok()?;
        let [length, width] = HALF;
        for (at, inwards) in [
            ([-length, 0, 0], UnitVec3::X),
            ([length, 0, 0], -UnitVec3::X),
            ([0, -width, 0], UnitVec3::Y),
            ([0, width, 0], -UnitVec3::Y),
        ] {
            world.insert(Body::immovable().at(vector(at)?), HalfSpace::new(inwards), surface).ok()?;
        }
        let mut balls = [None; BALLS];
        for (index, slot) in (0i32..).zip(&mut balls) {
            let (mut body, shape) = ball::<S>(RADIUS)?;
            let [x, y] = place(index)?;
            let millionths = |n| S::from_ratio(n, 1_000_000).ok();
            body.position = Vec3::new(millionths(x)?, millionths(y)?, millionths(RADIUS)?);
            body.linear_damping = milli(250)?;
            body.angular_damping = body.linear_damping;
            if index == 0 {
                body.linear_velocity.x = milli(SPEED)?;
            }
            *slot = Some(world.insert(body, shape, surface).ok()?);
        }
        let settings = settings(RATE, SUB_STEPS)?;
        Some(Self {
            world,
            settings,
            balls,
            dropped: 0,
            most: 0,
            saturated: false,
            ball_impacts: 0,
            cushion_impacts: 0,
        })
    }

    pub fn step(&mut self) {
        let report = kernel_step(self.world, &self.settings);
        self.dropped = self.dropped.wrapping_add(u32::from(report.dropped));
        self.most = self.most.max(report.manifolds);
        self.saturated |= report.saturated;
        for impact in self.world.impacts() {
            // The cloth has the first place, the cushions the next four.
            let [first, second] = impact.bodies.map(BodyHandle::index);
            if first > 4 && second > 4 {
                self.ball_impacts = self.ball_impacts.wrapping_add(1);
            } else if first > 0 {
                self.cushion_impacts = self.cushion_impacts.wrapping_add(1);
            }
        }
    }

    /// The balls, the cue ball first.
    pub fn balls(&self) -> impl Iterator<Item = &Body<S>> {
        self.balls.iter().filter_map(|ball| self.world.body((*ball)?).ok())
    }

    /// The energy of motion in thousandths of what the cue ball was given.
    pub fn energy(&self) -> S {
        let radius = S::Scaled::ratio(RADIUS, 1_000_000);
        let inertia = S::Scaled::ratio(2, 5) * radius * radius;
        let energy = self.balls().fold(S::Scaled::ZERO, |sum, body| {
            sum + square(body.linear_velocity) + inertia * square(body.angular_velocity)
        });
        let given = S::Scaled::ratio(SPEED, 1000);
        S::from_scaled(energy / (given * given)).0
    }

    /// Balls that roll: whose lowest point rests on the cloth, to 5 mm/s.
    pub fn rolling(&self) -> usize {
        let radius = S::from_ratio(RADIUS, 1_000_000).unwrap_or(S::ONE);
        let slow = S::from_ratio(1, 20).unwrap_or(S::ZERO);
        let slips = self.balls().map(|body| {
            let (v, w) = (body.linear_velocity, body.angular_velocity);
            let [x, y] = [v.x.minus(w.y.times(radius)), v.y.plus(w.x.times(radius))];
            Vec3::new(x, y, S::ZERO).length()
        });
        slips.filter(|slip| *slip < slow).count()
    }

    /// All that there is.
    pub fn world(&self) -> &Room<S> {
        self.world
    }

    pub fn settings(&self) -> &Settings<S> {
        &self.settings
    }

    pub fn hash(&self) -> u64 {
        self.world.hash()
    }
}

/// The hash after all steps.
pub fn hash<S: Scalar>() -> Option<u64> {
    let mut world = Room::<S>::new();
    let mut billiards = Billiards::new(&mut world)?;
    (0..STEPS).for_each(|_| billiards.step());
    Some(billiards.hash())
}
