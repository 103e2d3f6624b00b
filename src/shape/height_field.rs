//! The height field: ground that is not flat, such as a track or a maze, from heights in flash.

use crate::aabb::Aabb;
use crate::error::HeightFieldError;
use crate::math::{Pose, Vec3, max, min};
use crate::query::{self, Ray, RayHit, SurfacePoint};
use crate::scalar::Scalar;
use crate::shape::{OutlineSink, Shape, is_positive};

/// The most columns or rows.
const MOST: u16 = (1 << 14) - 1;

/// Everything below a surface over a grid in the x-y plane of its frame, whose middle is the origin. It belongs on an immovable
/// body.
///
/// Heights stand row by row: in a row x grows, and from row to row y. The four of a cell make two triangles, divided from the
/// corner with the smallest x and y to the one with the largest. What is below the surface, however deep, is in it; beside the
/// grid there is nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeightField<'a, S> {
    heights: &'a [S],
    columns: u16,
    rows: u16,
    spacing: S,
    /// The corner with the smallest x and y.
    corner: [S; 2],
    /// The height halfway between the lowest and the highest point, and how far these are from it.
    middle: S,
    relief: S,
}

/// A triangle of the surface, counter-clockwise seen from above.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle<S: Scalar> {
    pub corners: [Vec3<S>; 3],
    /// Upwards.
    pub normal: Vec3<S::Unit>,
}

impl<S: Scalar> Triangle<S> {
    fn new(corners: [Vec3<S>; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let (u, _) = S::direction3((b - a).to_array())?;
        let (v, _) = S::direction3((c - a).to_array())?;
        let (normal, _) = S::Unit::direction3(Vec3::from_array(u).cross(Vec3::from_array(v)).to_array())?;
        Some(Self { corners, normal: Vec3::from_array(normal) })
    }

    /// Whether a point is above or below it along the vertical axis: to the left of all sides, or on them.
    pub fn is_below(&self, point: Vec3<S>) -> bool {
        let [a, b, c] = self.corners;
        is_left(a, b, point) && is_left(b, c, point) && is_left(c, a, point)
    }

    /// The height above its plane, along the normal.
    #[inline(always)]
    pub fn height(&self, point: Vec3<S>) -> S {
        (point - self.corners[0]).along(self.normal)
    }
}

/// Always computed from the same end, so that of the two triangles at a side one at least has the point.
fn is_left<S: Scalar>(from: Vec3<S>, to: Vec3<S>, point: Vec3<S>) -> bool {
    let turned = from.y > to.y || (from.y == to.y && from.x > to.x);
    let (a, b) = if turned { (to, from) } else { (from, to) };
    let left = S::wide_product(b.x.minus(a.x), point.y.minus(a.y));
    let right = S::wide_product(b.y.minus(a.y), point.x.minus(a.x));
    if turned { left <= right } else { left >= right }
}

impl<'a, S: Scalar> HeightField<'a, S> {
    /// Heights of `columns` points in each of `rows` rows, each that far from the next, m.
    ///
    /// # Errors
    /// [`HeightFieldError`] names what does not fit.
    pub fn new(heights: &'a [S], columns: u16, rows: u16, spacing: S) -> Result<Self, HeightFieldError> {
        if columns < 2 || rows < 2 {
            return Err(HeightFieldError::TooFew);
        }
        if columns > MOST || rows > MOST {
            return Err(HeightFieldError::TooMany);
        }
        if heights.len() != usize::from(columns) * usize::from(rows) {
            return Err(HeightFieldError::Count);
        }
        let extent = |points: u16| spacing.times_integer(i32::from(points) - 1);
        let [x, y] = [extent(columns), extent(rows)];
        if !is_positive(spacing) || !x.is_finite() || !y.is_finite() || x == S::LARGEST || y == S::LARGEST {
            return Err(HeightFieldError::Spacing);
        }
        let (mut highest, mut lowest) = (S::LARGEST.negated(), S::LARGEST);
        for &height in heights {
            if !height.is_finite() {
                return Err(HeightFieldError::Height);
            }
            highest = max(highest, height);
            lowest = min(lowest, height);
        }
        let corner = [x.lowered_by(1).negated(), y.lowered_by(1).negated()];
        let (highest, lowest) = (highest.lowered_by(1), lowest.lowered_by(1));
        let (middle, relief) = (highest.plus(lowest), highest.minus(lowest).plus(S::STEP));
        Ok(Self { heights, columns, rows, spacing, corner, middle, relief })
    }

    /// A point of the surface, if there is one with these numbers.
    pub fn point(&self, column: i32, row: i32) -> Option<Vec3<S>> {
        if column < 0 || column >= i32::from(self.columns) || row < 0 {
            return None;
        }
        let index = row.wrapping_mul(i32::from(self.columns)).wrapping_add(column);
        let height = *self.heights.get(index as usize)?;
        let at = |corner: S, n: i32| corner.plus(self.spacing.times_integer(n));
        Some(Vec3::new(at(self.corner[0], column), at(self.corner[1], row), height))
    }

    /// The triangle below the diagonal of a cell, or above it.
    pub(crate) fn triangle(&self, column: i32, row: i32, above: bool) -> Option<Triangle<S>> {
        let (next_column, next_row) = (column.wrapping_add(1), row.wrapping_add(1));
        let (first, last) = (self.point(column, row)?, self.point(next_column, next_row)?);
        if above {
            Triangle::new([first, last, self.point(column, next_row)?])
        } else {
            Triangle::new([first, self.point(next_column, row)?, last])
        }
    }

    /// The cells that a range of x or of y touches: the first and the last, within the grid.
    pub(crate) fn cells(&self, along_y: bool, low: S, high: S) -> [i32; 2] {
        let [x, y] = self.corner;
        let (corner, points) = if along_y { (y, self.rows) } else { (x, self.columns) };
        let last = i32::from(points).wrapping_sub(2);
        let cell = |x: S| {
            let cell = x.minus(corner).over(self.spacing).integer_below();
            if cell < 0 {
                0
            } else if cell > last {
                last
            } else {
                cell
            }
        };
        [cell(low), cell(high)]
    }

    /// The shortest distance of two points of the grid.
    pub(crate) const fn spacing(&self) -> S {
        self.spacing
    }
}

impl<S: Scalar> Shape<S> for HeightField<'_, S> {
    /// From the lowest point without end downwards.
    fn aabb(&self, pose: &Pose<S>) -> Aabb<S> {
        let [x, y] = self.corner;
        let middle = Vec3::new(S::ZERO, S::ZERO, self.middle);
        let half = Vec3::new(x.negated(), y.negated(), self.relief);
        let bounds = Aabb::of_box(pose.to_world(middle), half, &pose.rotation);
        // What lies below the surface reaches down, whichever way that is.
        let far = S::LARGEST;
        let down = pose.rotation.columns()[2];
        let low = |bound: S, d: S::Unit| if d > S::Unit::ZERO { far.negated() } else { bound };
        let high = |bound: S, d: S::Unit| if d < S::Unit::ZERO { far } else { bound };
        Aabb {
            min: Vec3::new(low(bounds.min.x, down.x), low(bounds.min.y, down.y), low(bounds.min.z, down.z)),
            max: Vec3::new(high(bounds.max.x, down.x), high(bounds.max.y, down.y), high(bounds.max.z, down.z)),
        }
    }

    #[inline(always)]
    fn inner_radius(&self) -> S {
        S::LARGEST
    }

    fn cast_ray(&self, pose: &Pose<S>, ray: &Ray<S>) -> Option<RayHit<S>> {
        query::cast(self, pose, ray)
    }

    fn closest_point(&self, pose: &Pose<S>, point: Vec3<S>) -> Option<SurfacePoint<S>> {
        query::closest_point(self, pose, point)
    }

    /// The lines from sample to sample along both axes.
    fn outline<K: OutlineSink<S>>(&self, pose: &Pose<S>, sink: &mut K) {
        for row in 0..i32::from(self.rows) {
            for column in 0..i32::from(self.columns) {
                let Some(from) = self.point(column, row) else { continue };
                let from = pose.to_world(from);
                for next in [[column.wrapping_add(1), row], [column, row.wrapping_add(1)]] {
                    if let Some(to) = self.point(next[0], next[1]) {
                        sink.segment([from, pose.to_world(to)]);
                    }
                }
            }
        }
    }
}
