//! From points of the world to places on the display.

use embedded_graphics_core::geometry::{Point, Size};

use super::raster::{MIDDLE, SIXTEENTHS, Spot};
use crate::error::ViewError;
use crate::math::{UnitVec3, Vec3};
use crate::scalar::{Scalar, Scaled};

/// The longest side of a display, in pixels: with what lies beside it, sixteenths of them fit 16 bits.
const LONGEST: u32 = 3840;
/// Lines end this part of half the display beyond its border, where nobody sees how they were cut.
const BESIDE: [i32; 2] = [17, 16];
/// What is nearer to the eye than 2^-20 is not seen.
const NEAREST: i32 = -20;

/// A point as the eye has it: to the right, down, and ahead.
pub(super) type Seen<S> = Vec3<<S as Scalar>::Scaled>;

/// How much is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lens<S> {
    /// What is far away looks small. The number is half the width of what is seen at a distance of one: the tangent of half the
    /// horizontal angle of view, such as 0.4.
    Perspective(S),
    /// Lengths stay lengths. The number is half the width of what is seen.
    Orthographic(S),
}

/// Where the eye is, and where it looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera<S: Scalar> {
    /// The eye.
    pub eye: Vec3<S>,
    /// What is seen in the middle of the display.
    pub target: Vec3<S>,
    /// What is up on the display.
    pub up: UnitVec3<S>,
    /// How much is seen.
    pub lens: Lens<S>,
}

/// The world as a display shows it: see the [module](super).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View<S: Scalar> {
    eye: Vec3<S>,
    /// To the right, down and ahead.
    axes: [Vec3<S::Unit>; 3],
    perspective: bool,
    /// Sixteenths of a pixel for a length of one: of what is seen, or of what is seen at a distance of one.
    scale: S::Scaled,
    /// How far to each side, and up and down, lines are kept, at a distance of one or at all.
    reach: [S::Scaled; 2],
    size: Size,
    /// What of a plane is drawn: the distance of its lines, and how many on each side of the middle.
    pub(super) grid: Option<(S, u8)>,
}

impl<S: Scalar> View<S> {
    /// What a camera sees, for a display of that size in pixels.
    ///
    /// # Errors
    /// [`ViewError`] says what is wrong.
    pub fn new(size: Size, camera: &Camera<S>) -> Result<Self, ViewError> {
        let fits = |side: u32| (1..=LONGEST).contains(&side);
        if !fits(size.width) || !fits(size.height) {
            return Err(ViewError::Size);
        }
        let ahead = UnitVec3::normalize(camera.target - camera.eye).map_err(|_| ViewError::Direction)?.get();
        let right = S::Unit::normalize3(ahead.cross(camera.up.get()).to_array()).ok_or(ViewError::Up)?;
        let right = Vec3::from_array(right);
        let (perspective, half_width) = match camera.lens {
            Lens::Perspective(half) => (true, half.to_scaled()),
            Lens::Orthographic(half) => (false, half.to_scaled()),
        };
        if !half_width.is_positive() {
            return Err(ViewError::HalfWidth);
        }
        let [width, height] = [size.width, size.height].map(|side| S::Scaled::from_parts(side as i32, 0));
        let beside = half_width * S::Scaled::ratio(BESIDE[0], BESIDE[1]);
        Ok(Self {
            eye: camera.eye,
            axes: [right, ahead.cross(right), ahead],
            perspective,
            scale: width * S::Scaled::from_parts(MIDDLE, 0) / half_width,
            reach: [beside, beside * height / width],
            size,
            grid: None,
        })
    }

    /// The same, and of planes a grid around the origin of their body: so many lines on each side, in both directions, that far
    /// from each other. Without it, nothing is drawn of a plane.
    #[must_use]
    pub const fn with_grid(mut self, spacing: S, lines: u8) -> Self {
        self.grid = Some((spacing, lines));
        self
    }

    /// The pixel in which a point of the world is seen: to write something beside it. `None`: it is not on the display.
    pub fn pixel(&self, point: Vec3<S>) -> Option<Point> {
        let seen = self.seen(point);
        if !PLANES.iter().all(|plane| self.inside(&seen, *plane) >= S::Scaled::ZERO) {
            return None;
        }
        let [x, y] = self.spot(&seen).map(|at| at >> SIXTEENTHS);
        let within = |at: i32, side: u32| at >= 0 && at < side as i32;
        (within(x, self.size.width) && within(y, self.size.height)).then_some(Point::new(x, y))
    }

    pub(super) const fn size(&self) -> Size {
        self.size
    }

    pub(super) const fn is_perspective(&self) -> bool {
        self.perspective
    }

    pub(super) fn seen(&self, point: Vec3<S>) -> Seen<S> {
        let way = (point - self.eye).to_array();
        let [x, y, z] = self.axes.map(|axis| S::scaled_dot3(way, axis.to_array()));
        Vec3::new(x, y, z)
    }

    /// The place of a point within [`PLANES`].
    pub(super) fn spot(&self, seen: &Seen<S>) -> Spot {
        let scale = if self.perspective { self.scale / seen.z } else { self.scale };
        let place = |at: S::Scaled, side: u32| {
            let middle = (side as i32).wrapping_mul(MIDDLE);
            // The reach of [`BESIDE`]: rounding, or what is not finite, leads no farther.
            let far = middle.wrapping_add(side as i32 / 2);
            let nearest = (at * scale + S::Scaled::from_parts(1, -1)).integer_below();
            middle.wrapping_add(nearest.max(far.wrapping_neg()).min(far))
        };
        [place(seen.x, self.size.width), place(seen.y, self.size.height)]
    }

    /// How far a point is on the side of a plane where things are seen; of any length.
    pub(super) fn inside(&self, seen: &Seen<S>, plane: Plane) -> S::Scaled {
        let [across, down] = if self.perspective { self.reach.map(|reach| reach * seen.z) } else { self.reach };
        match plane {
            Plane::Near => seen.z - S::Scaled::from_parts(1, NEAREST),
            Plane::Left => across + seen.x,
            Plane::Right => across - seen.x,
            Plane::Top => down + seen.y,
            Plane::Bottom => down - seen.y,
        }
    }
}

/// A side of what is seen.
#[derive(Clone, Copy)]
pub(super) enum Plane {
    Near,
    Left,
    Right,
    Top,
    Bottom,
}

/// In the order in which lines are cut: the others mean something only in front of the eye.
pub(super) const PLANES: [Plane; 5] = [Plane::Near, Plane::Left, Plane::Right, Plane::Top, Plane::Bottom];
