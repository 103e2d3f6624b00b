//! Dice on a table, as the display shows them: with light, shadows, pips, and the way they came.

use carom::interop::embedded_graphics::{Camera, Lens, Style, View};
use carom::{BodyHandle, Cuboid, MAX_FACE_CORNERS, OutlineSink, Pose, Scalar, Shape, UnitVec3, Vec3};
use embedded_graphics_core::Drawable;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Size;
use embedded_graphics_core::pixelcolor::Rgb565;

use super::FINE_SIDE;
use super::way::{POSES, Way};
use crate::scenes::dice::{DICE, HALF, Room};
use crate::scenes::make::{milli, vector};

/// In thousandths of a decimetre, as all lengths here.
const EYE: [i32; 3] = [2450, -330, 800];
const TARGET: [i32; 3] = [1100, 100, 40];
const HALF_WIDTH: i32 = 330;
const GRID: i32 = 250;
const GRID_LINES: u8 = 16;
/// Towards the light.
const LIGHT: [i32; 3] = [-350, -550, 900];
/// The steps from darkness to full light.
const BRIGHT: u8 = 31;

const TABLE: Rgb565 = Rgb565::new(2, 10, 9);
const LINES: Rgb565 = Rgb565::new(4, 16, 13);
const SHADOW: Rgb565 = Rgb565::new(1, 5, 5);

/// A die's colours: of its faces in darkness and in full light, of its way from the beginning to the end, and others.
struct Paint {
    dark: [u8; 3],
    light: [u8; 3],
    trail: [[u8; 3]; 2],
    edge: Rgb565,
    pips: Rgb565,
}

const PAINTS: [Paint; DICE] = [
    Paint {
        dark: [11, 22, 11],
        light: [31, 62, 29],
        trail: [[3, 14, 11], [24, 52, 25]],
        edge: Rgb565::new(31, 63, 31),
        pips: Rgb565::new(3, 6, 5),
    },
    Paint {
        dark: [12, 3, 4],
        light: [29, 12, 8],
        trail: [[3, 12, 10], [28, 18, 12]],
        edge: Rgb565::new(31, 32, 24),
        pips: Rgb565::new(31, 60, 28),
    },
];

/// The corners of a face, in thousandths of half an edge.
const SQUARE: [[i32; 2]; 4] = [[-1000, -1000], [1000, -1000], [1000, 1000], [-1000, 1000]];
/// How far pips are from the middle of a face, in such thousandths, and which part of half an edge their radius is.
const PIP_PLACE: i32 = 520;
const PIP_SIZE: i32 = 5;

/// The places of pips, and which faces have them.
const PIPS: [([i32; 2], &[u8]); 7] = [
    ([0, 0], &[1, 3, 5]),
    ([-1, 1], &[2, 3, 4, 5, 6]),
    ([1, -1], &[2, 3, 4, 5, 6]),
    ([1, 1], &[4, 5, 6]),
    ([-1, -1], &[4, 5, 6]),
    ([-1, 0], &[6]),
    ([1, 0], &[6]),
];

/// A circle in thousandths.
const CIRCLE: [[i32; 2]; 12] = [
    [1000, 0],
    [866, 500],
    [500, 866],
    [0, 1000],
    [-500, 866],
    [-866, 500],
    [-1000, 0],
    [-866, -500],
    [-500, -866],
    [0, -1000],
    [500, -866],
    [866, -500],
];

/// What is on the picture.
pub struct Picture<'a, S: Scalar> {
    world: &'a Room<S>,
    way: &'a Way<S>,
    view: View<S>,
    light: UnitVec3<S>,
    /// How far a shadow falls aside for a height of one.
    fall: [S; 2],
    half: S,
}

impl<'a, S: Scalar> Picture<'a, S> {
    /// Of dice that lie, and of the way they came. `None`: a number does not fit the format.
    pub fn new(world: &'a Room<S>, way: &'a Way<S>) -> Option<Self> {
        let camera = Camera {
            eye: vector(EYE)?,
            target: vector(TARGET)?,
            up: UnitVec3::Z,
            lens: Lens::Perspective(milli(HALF_WIDTH)?),
        };
        let size = Size::new(FINE_SIDE as u32, FINE_SIDE as u32);
        Some(Self {
            world,
            way,
            view: View::new(size, &camera).ok()?.with_grid(milli(GRID)?, GRID_LINES),
            light: UnitVec3::normalize(vector(LIGHT)?).ok()?,
            fall: [S::from_ratio(LIGHT[0], LIGHT[2]).ok()?, S::from_ratio(LIGHT[1], LIGHT[2]).ok()?],
            half: milli(HALF)?,
        })
    }

    /// Draws what of it is on a target.
    pub fn draw<D: DrawTarget<Color = Rgb565>>(&self, target: &mut D) -> Result<(), D::Error> {
        target.clear(TABLE)?;
        for (handle, body, shape) in self.view.back_to_front(self.world) {
            let pose = Pose::new(body.position, body.orientation());
            match paint(handle) {
                Some(paint) => self.die(&pose, paint, target)?,
                None => {
                    self.view.shape(shape, &pose, Style::wireframe(LINES)).draw(target)?;
                    self.trail(target)?;
                    self.shadows(target)?;
                }
            }
        }
        Ok(())
    }

    /// Where the dice were, the longer ago the darker.
    fn trail<D: DrawTarget<Color = Rgb565>>(&self, target: &mut D) -> Result<(), D::Error> {
        let die = Cuboid::new(Vec3::new(self.half, self.half, self.half));
        let Ok(die) = die else { return Ok(()) };
        for (age, poses) in (1u8..).zip(self.way.poses()) {
            for (pose, paint) in poses.iter().zip(&PAINTS) {
                let color = between(paint.trail, age, POSES as u8);
                self.view.shape(&die, pose, Style::wireframe(color)).draw(target)?;
            }
        }
        Ok(())
    }

    fn shadows<D: DrawTarget<Color = Rgb565>>(&self, target: &mut D) -> Result<(), D::Error> {
        let mut shadow = Shadow { picture: self, target, outcome: Ok(()) };
        for (handle, body, shape) in self.world.bodies_with_shapes() {
            if paint(handle).is_some() {
                shape.outline(&Pose::new(body.position, body.orientation()), &mut shadow);
            }
        }
        shadow.outcome
    }

    fn die<D: DrawTarget<Color = Rgb565>>(
        &self,
        pose: &Pose<S>,
        paint: &Paint,
        target: &mut D,
    ) -> Result<(), D::Error> {
        for face in 1..=6u8 {
            let color = between([paint.dark, paint.light], self.brightness(pose, face), BRIGHT);
            let corners = SQUARE.map(|at| pose.to_world(self.on_face(face, at)));
            self.view.face(&corners, Style::solid(paint.edge, color)).draw(target)?;
            for (middle, _) in PIPS.iter().filter(|(_, faces)| faces.contains(&face)) {
                let pip = CIRCLE.map(|[x, y]| {
                    let at = |middle: i32, way: i32| middle.wrapping_mul(PIP_PLACE).wrapping_add(way / PIP_SIZE);
                    pose.to_world(self.on_face(face, [at(middle[0], x), at(middle[1], y)]))
                });
                self.view.face(&pip, Style::filled(paint.pips)).draw(target)?;
            }
        }
        Ok(())
    }

    /// A point of a die's face, from its middle in thousandths of half an edge. Opposite faces add up to seven.
    fn on_face(&self, face: u8, at: [i32; 2]) -> Vec3<S> {
        let part = |thousandths| self.half.times(milli(thousandths).unwrap_or(S::ZERO));
        let [a, b] = at.map(part);
        match face {
            1 => Vec3::new(self.half, a, b),
            2 => Vec3::new(b, self.half, a),
            3 => Vec3::new(a, b, self.half),
            4 => Vec3::new(b, a, self.half.negated()),
            5 => Vec3::new(a, self.half.negated(), b),
            _ => Vec3::new(self.half.negated(), b, a),
        }
    }

    /// How much light a face has, up to [`BRIGHT`].
    fn brightness(&self, pose: &Pose<S>, face: u8) -> u8 {
        let [x, y, z] = pose.rotation.columns().map(|axis| axis.dot(self.light.get()));
        let [x, y, z] = [x, y, z].map(|cosine| S::ONE.times_unit(cosine).times_integer(BRIGHT.into()).integer_below());
        let sides = [x, y, z, z.wrapping_neg(), y.wrapping_neg(), x.wrapping_neg()];
        let level = sides.get(usize::from(face).wrapping_sub(1)).copied().unwrap_or(0);
        level.max(0).min(BRIGHT.into()) as u8
    }
}

fn paint(handle: BodyHandle) -> Option<&'static Paint> {
    PAINTS.get(handle.index().wrapping_sub(1))
}

/// A colour on the way from one to another.
fn between([from, to]: [[u8; 3]; 2], part: u8, whole: u8) -> Rgb565 {
    let [part, whole] = [part, whole].map(u16::from);
    let mix = |(from, to): (u8, u8)| {
        let sum = u16::from(from).wrapping_mul(whole.wrapping_sub(part)).wrapping_add(u16::from(to).wrapping_mul(part));
        sum.checked_div(whole).unwrap_or(0) as u8
    };
    let [[a, b, c], [d, e, f]] = [from, to];
    Rgb565::new(mix((a, d)), mix((b, e)), mix((c, f)))
}

/// Draws the shadow of a shape on the table: what the light sees of it, as it sees it.
struct Shadow<'a, S: Scalar, D: DrawTarget> {
    picture: &'a Picture<'a, S>,
    target: &'a mut D,
    outcome: Result<(), D::Error>,
}

impl<S: Scalar, D: DrawTarget<Color = Rgb565>> OutlineSink<S> for Shadow<'_, S, D> {
    fn face(&mut self, corners: &[Vec3<S>]) {
        let Picture { view, fall, .. } = self.picture;
        let mut fallen = [Vec3::ZERO; MAX_FACE_CORNERS];
        for (fallen, corner) in fallen.iter_mut().zip(corners) {
            let [x, y] = fall.map(|fall| corner.z.times(fall));
            *fallen = Vec3::new(corner.x.minus(x), corner.y.minus(y), S::ZERO);
        }
        let fallen = fallen.get(..corners.len()).unwrap_or_default();
        if self.outcome.is_ok() {
            self.outcome = view.face(fallen, Style::filled(SHADOW)).draw(self.target);
        }
    }

    // Dice have nothing but faces.
    fn segment(&mut self, _: [Vec3<S>; 2]) {}
    fn rod(&mut self, _: [Vec3<S>; 2], _: S) {}
    fn plane(&mut self, _: Vec3<S>, _: UnitVec3<S>) {}
}
