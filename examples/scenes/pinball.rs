//! A pinball table with three bumpers and two flippers, and a player who flips when the ball comes near one.

use carom::solver::Settings;
use carom::world::Phase;
use carom::{Body, BodyHandle, Capsule, HalfSpace, Quat, Scalar, Sphere, UnitVec3, Vec3, World};

use super::make::{ball, kernel_step, material, milli, vector};

carom::shapes! {
    /// Ball and bumpers; flippers and guides; the board and its sides.
    pub enum Piece<S> { Sphere, Capsule, HalfSpace }
}

/// Half the width and the length of the board, in thousandths of a decimetre.
pub const HALF_WIDTH: i32 = 2500;
pub const LENGTH: i32 = 8000;
/// Steps in a second, and how long three balls may last: 20 s.
pub const RATE: u16 = 240;
pub const SUB_STEPS: u8 = 1;
pub const STEPS: u32 = 4800;
pub const BALLS: u32 = 3;
/// The drain's place among the bodies: the last one before the ball.
pub const DRAIN_PLACE: usize = 11;

const RADIUS: i32 = 200;
/// Where the bumpers are, and how large.
pub const BUMPERS: [[i32; 2]; 3] = [[-1000, 5200], [1000, 5500], [0, 6600]];
const BUMPER: i32 = 350;
/// Where the right flipper turns, half its length without the round ends, its radius.
const PIVOT: [i32; 2] = [1500, 1400];
const HALF_LENGTH: i32 = 550;
const THICKNESS: i32 = 120;
/// A flip by 60 degrees takes so many steps, up or down.
const FLIP: u8 = 12;
/// That angle times the steps in a second, in thousandths.
const TURN: i32 = 1047 * RATE as i32 / FLIP as i32;
/// What a bumper adds to the speed, in thousandths of dm/s.
const KICK: i32 = 4000;
/// The board is tilted by 6.5 degrees: gravity along it and into it.
const GRAVITY: [i32; 3] = [0, -11_105, -97_469];

/// Room for the ball, three bumpers, two flippers, two guides, the board, its three sides and the drain.
pub type Room<S> = World<S, Piece<S>, 13, 6, 6>;

/// A flipper: a body that nothing moves but its own velocity.
#[derive(Clone, Copy)]
struct Flipper {
    body: BodyHandle,
    /// 1 on the right, -1 on the left.
    side: i32,
    /// Steps since it was set off.
    step: u8,
}

pub struct Pinball<'w, S: Scalar> {
    world: &'w mut Room<S>,
    settings: Settings<S>,
    ball: BodyHandle,
    bumpers: [Option<BodyHandle>; 3],
    flippers: [Flipper; 2],
    drain: BodyHandle,
    pub balls_lost: u32,
    pub hits: u32,
    pub flips: u32,
    pub score: u32,
    pub dropped: u32,
    pub saturated: bool,
}

/// The cosine of 30 degrees, in thousandths.
const COSINE_30: i32 = 866;

/// Where the middle of a flipper is at rest or raised.
fn middle<S: Scalar>(side: i32, raised: bool) -> Option<Vec3<S>> {
    let along = HALF_LENGTH * COSINE_30 / 1000;
    let up = if raised { HALF_LENGTH / 2 } else { -HALF_LENGTH / 2 };
    vector([side * (PIVOT[0] - along), PIVOT[1] + up, RADIUS])
}

/// The turn that brings the axis of a capsule, z, into the board, 30 degrees above or below x towards the middle.
fn turn<S: Scalar>(side: i32, raised: bool) -> Option<Quat<S>> {
    let unit = |n: i32| S::Unit::from_ratio(n, 1_000_000_000).ok();
    let zero = S::Unit::ZERO;
    let lying = Quat::normalize(unit(707_106_781)?, zero, unit(707_106_781)?, zero).ok()?;
    // Half of 30 or -30 degrees; of 150 or -150 on the right.
    let (cosine, sine) = if side < 0 { (965_925_826, 258_819_045) } else { (258_819_045, 965_925_826) };
    let sine = if raised { sine } else { -sine };
    Some(Quat::normalize(unit(cosine)?, zero, zero, unit(sine)?).ok()? * lying)
}

impl<'w, S: Scalar> Pinball<'w, S> {
    pub fn new(world: &'w mut Room<S>) -> Option<Self> {
        let steel = material(500, 150)?;
        let rubber = material(900, 150)?;
        world.clear();
        let fixed = Body::immovable;
        world.insert(fixed(), HalfSpace::new(UnitVec3::Z), steel).ok()?;
        world.insert(fixed().at(vector([-HALF_WIDTH, 0, 0])?), HalfSpace::new(UnitVec3::X), steel).ok()?;
        world.insert(fixed().at(vector([HALF_WIDTH, 0, 0])?), HalfSpace::new(-UnitVec3::X), steel).ok()?;
        world.insert(fixed().at(vector([0, LENGTH, 0])?), HalfSpace::new(-UnitVec3::Y), steel).ok()?;
        let capsule = Capsule::new(milli(THICKNESS)?, milli(HALF_LENGTH)?).ok()?;
        let mut flipper = |side: i32| {
            let mut arm = fixed().at(middle(side, false)?);
            arm.set_orientation(turn(side, false)?);
            // The guide from the side of the board to the flipper: the same, one length farther out.
            let mut guide = arm;
            let to_pivot = vector([side * PIVOT[0], PIVOT[1], RADIUS])? - arm.position;
            guide.position = arm.position + to_pivot + to_pivot;
            world.insert(guide, capsule, steel).ok()?;
            Some(Flipper { body: world.insert(arm, capsule, steel).ok()?, side, step: 0 })
        };
        let flippers = [flipper(-1)?, flipper(1)?];
        let mut bumpers = [None; 3];
        for ([x, y], slot) in BUMPERS.into_iter().zip(&mut bumpers) {
            let shape = Sphere::new(milli(BUMPER)?).ok()?;
            *slot = Some(world.insert(fixed().at(vector([x, y, RADIUS])?), shape, rubber).ok()?);
        }
        let below = fixed().at(vector([0, -500, 0])?);
        let drain = world.insert(below, HalfSpace::new(UnitVec3::Y), steel).ok()?;
        world.set_sensor(drain, true).ok()?;
        let (body, shape) = ball::<S>(RADIUS * 1000)?;
        let ball = world.insert(body, shape, steel).ok()?;
        let settings = Settings::new(vector(GRAVITY)?, [1, RATE], SUB_STEPS).ok()?;
        let (balls_lost, hits, flips, score, dropped, saturated) = (0, 0, 0, 0, 0, false);
        let mut pinball = Self {
            world,
            settings,
            ball,
            bumpers,
            flippers,
            drain,
            balls_lost,
            hits,
            flips,
            score,
            dropped,
            saturated,
        };
        pinball.launch()?;
        Some(pinball)
    }

    /// The next ball, up along the right side.
    fn launch(&mut self) -> Option<()> {
        let body = self.world.body_mut(self.ball).ok()?;
        body.position = vector([2100, 2600, RADIUS])?;
        let number = self.balls_lost as i32;
        body.linear_velocity = vector([-900 - 700 * number, 11_500 + 500 * number, 0])?;
        body.angular_velocity = Vec3::ZERO;
        Some(())
    }

    /// A step; whether the game goes on.
    pub fn step(&mut self) -> bool {
        self.play();
        let report = kernel_step(self.world, &self.settings);
        self.dropped = self.dropped.wrapping_add(u32::from(report.dropped));
        self.saturated |= report.saturated;
        self.bump();
        let drain = self.drain;
        let lost = self.world.contacts().any(|contact| {
            contact.phase == Phase::Began && contact.bodies.contains(&drain) && contact.bodies.contains(&self.ball)
        });
        if lost {
            self.balls_lost = self.balls_lost.wrapping_add(1);
            if self.balls_lost < BALLS {
                return self.launch().is_some();
            }
        }
        self.balls_lost < BALLS
    }

    /// Flips where the ball comes near, and moves what has been set off.
    fn play(&mut self) {
        let Some(ball) = self.ball() else { return };
        let near = |height| milli::<S>(height).is_some_and(|height| ball.y < height);
        let reach = milli::<S>(PIVOT[0]).unwrap_or(S::ZERO);
        for index in 0..self.flippers.len() {
            let Some(mut flipper) = self.flippers.get(index).copied() else { continue };
            let over = (ball.x > S::ZERO) == (flipper.side > 0) && ball.x < reach && ball.x > reach.negated();
            if flipper.step == 0 && over && near(PIVOT[1] + 50) && !near(PIVOT[1] - 600) {
                flipper.step = 1;
                self.flips = self.flips.wrapping_add(1);
            } else if flipper.step > 0 {
                flipper.step = if flipper.step == 2 * FLIP { 0 } else { flipper.step.wrapping_add(1) };
            }
            let _ = self.swing(&flipper);
            if let Some(place) = self.flippers.get_mut(index) {
                *place = flipper;
            }
        }
    }

    /// Gives a flipper the velocity of this step: up, then down, about its pivot.
    fn swing(&mut self, flipper: &Flipper) -> Option<()> {
        let Flipper { body, side, step } = *flipper;
        let arm = self.world.body_mut(body).ok()?;
        // What small steps along the tangent have added up to is taken out at either end.
        if step == 0 || step == FLIP + 1 {
            arm.position = middle(side, step > 0)?;
            arm.set_orientation(turn(side, step > 0)?);
        }
        let turning = match step {
            0 => 0,
            1..=FLIP => -side * TURN,
            _ => side * TURN,
        };
        arm.angular_velocity = vector([0, 0, turning])?;
        let pivot = vector([side * PIVOT[0], PIVOT[1], RADIUS])?;
        arm.linear_velocity = arm.angular_velocity.cross(arm.position - pivot);
        Some(())
    }

    /// Counts blows on bumpers, which kick the ball.
    fn bump(&mut self) {
        let mut kick = Vec3::ZERO;
        let Some(ball) = self.ball() else { return };
        for impact in self.world.impacts() {
            let bumper = self.bumpers.iter().flatten().find(|bumper| impact.bodies.contains(bumper));
            if let Some(bumper) = bumper.and_then(|bumper| self.world.body(*bumper).ok()) {
                self.hits = self.hits.wrapping_add(1);
                self.score = self.score.wrapping_add(100);
                if let (Ok(away), Some(speed)) = (UnitVec3::normalize(ball - bumper.position), milli(KICK)) {
                    kick = away.times(speed);
                }
            }
        }
        if kick != Vec3::ZERO
            && let Ok(body) = self.world.body_mut(self.ball)
        {
            body.linear_velocity += kick;
        }
    }

    /// Where the ball is.
    pub fn ball(&self) -> Option<Vec3<S>> {
        self.world.body(self.ball).ok().map(|body| body.position)
    }

    /// Where the flippers are.
    pub fn arms(&self) -> impl Iterator<Item = Vec3<S>> {
        self.flippers.iter().filter_map(|flipper| self.world.body(flipper.body).ok()).map(|body| body.position)
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

/// The hash at the end of the game.
pub fn hash<S: Scalar>() -> Option<u64> {
    let mut world = Room::<S>::new();
    let mut pinball = Pinball::new(&mut world)?;
    for _ in 0..STEPS {
        if !pinball.step() {
            break;
        }
    }
    Some(pinball.hash())
}
