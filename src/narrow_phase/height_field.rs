//! Any shape and a height field.
//!
//! A triangle pushes along its normal the corners of the shape that are over it, seen along the field's vertical axis: every
//! place is over one triangle, so that nothing is caught at an edge between two that lie in a plane or make a valley. Where they
//! make a ridge, or the field ends, the edge itself pushes, in directions between both normals. Points that are pushed the same
//! way are put together: a box on flat ground has one manifold, whatever the grid.

use super::Placed;
use super::polytope::Polytope;
use super::segment::Segment;
use crate::math::{Pose, UnitVec3, Vec3, min};
use crate::scalar::Scalar;
use crate::shape::{Closest, HeightField, ManifoldSink, Shape, Triangle};

mod patch;
mod shapes;

use patch::{Patches, Sink};

/// An edge is a ridge where the next triangle falls off below this one's plane by more than this share of the spacing, as a
/// power of two.
const RIDGE: u32 = 8;
/// The edge of a ridge pushes where a triangle does not, and this power of two beyond: rather twice than not at all.
const BEYOND: u32 = 12;
/// How deep a point may be behind a face before it is asked whether that is its way out, as a power of two of the spacing:
/// no wall is as thin, but for its crest.
const SHALLOW: u32 = 4;
/// How far a nearer way out is looked for, in spacings.
const WALL: i32 = 4;

/// A shape that meets a surface: some points with a radius around them, and what is closest to an edge.
pub(super) trait OverSurface<S: Scalar>: Shape<S> {
    /// The points by number, in the shape's frame.
    fn point(&self, index: u8) -> Option<Vec3<S>>;
    /// Around each of them.
    fn radius(&self) -> S;
    /// What is closest to an edge, in the shape's frame.
    fn beside(&self, edge: &Segment<S>) -> Option<Beside<S>>;
}

/// Where an edge passes a shape.
pub(super) struct Beside<S: Scalar> {
    /// From the shape to the edge.
    direction: Vec3<S::Unit>,
    /// The ends of the part that is as close as any, with their distances from the shape without its radius.
    ends: [(Vec3<S>, S); 2],
}

/// A shape over a field, in the field's frame.
struct Over<'a, S: Scalar, T> {
    shape: &'a T,
    pose: Pose<S>,
    field: &'a HeightField<'a, S>,
    margin: S,
}

pub(super) fn collide<S: Scalar, T: OverSurface<S>, K: ManifoldSink<S>>(
    (shape, pose): Placed<'_, S, T>,
    (field, field_pose): Placed<'_, S, HeightField<'_, S>>,
    margin: S,
    mirrored: bool,
    sink: &mut K,
) {
    let over = Over::new((shape, pose), (field, field_pose), margin);
    let d = field_pose.position - pose.position;
    let mut patches = Patches::new(Sink { sink, field_pose, origin: over.pose.position, d, mirrored });
    over.each(&mut patches);
    patches.finish();
}

/// Looks at every cell of the field.
pub(super) fn closest<S: Scalar, T: OverSurface<S>>(
    (shape, pose): Placed<'_, S, T>,
    (field, field_pose): Placed<'_, S, HeightField<'_, S>>,
) -> Option<Closest<S>> {
    let over = Over::new((shape, pose), (field, field_pose), S::LARGEST);
    let mut best: Option<Touch<S>> = None;
    over.each(&mut best);
    let Touch { normal, middle, separation, .. } = best?;
    let d = field_pose.position - pose.position;
    let down = S::opposite(&field_pose.rotation.times(normal));
    let r = field_pose.rotate(middle - over.pose.position);
    let half = Vec3::of_length(separation.lowered_by(1), down);
    Some(Closest { normal: UnitVec3::from_unit(down), separation, r_a: r - half, r_b: r + half - d })
}

/// A point of contact in the field's frame, halfway between the surfaces.
#[derive(Clone, Copy)]
struct Touch<S: Scalar> {
    /// Out of the field.
    normal: Vec3<S::Unit>,
    middle: Vec3<S>,
    separation: S,
    feature: u16,
}

impl<S: Scalar> Touch<S> {
    const NONE: Self = Self {
        normal: Vec3::new(S::Unit::ZERO, S::Unit::ZERO, S::Unit::ZERO),
        middle: Vec3::ZERO,
        separation: S::ZERO,
        feature: 0,
    };
}

/// What takes the points.
trait Gather<S: Scalar> {
    fn add(&mut self, touch: &Touch<S>);
}

impl<S: Scalar> Gather<S> for Option<Touch<S>> {
    fn add(&mut self, touch: &Touch<S>) {
        if self.is_none_or(|best| touch.separation < best.separation) {
            *self = Some(*touch);
        }
    }
}

/// The triangles of the cells that are that near a place, seen from above.
struct Triangles<'a, S: Scalar> {
    field: &'a HeightField<'a, S>,
    columns: [i32; 2],
    last_row: i32,
    /// The one that comes next.
    next: (i32, i32, bool),
}

impl<'a, S: Scalar> Triangles<'a, S> {
    fn around(field: &'a HeightField<'a, S>, place: Vec3<S>, distance: S) -> Self {
        let columns = field.cells(false, place.x.minus(distance), place.x.plus(distance));
        let [first_row, last_row] = field.cells(true, place.y.minus(distance), place.y.plus(distance));
        Self { field, columns, last_row, next: (columns[0], first_row, false) }
    }
}

impl<S: Scalar> Iterator for Triangles<'_, S> {
    type Item = Triangle<S>;

    fn next(&mut self) -> Option<Triangle<S>> {
        loop {
            let (column, row, above) = self.next;
            if row > self.last_row {
                return None;
            }
            self.next = match above {
                false => (column, row, true),
                true if column < self.columns[1] => (column.wrapping_add(1), row, false),
                true => (self.columns[0], row.wrapping_add(1), false),
            };
            if let Some(triangle) = self.field.triangle(column, row, above) {
                return Some(triangle);
            }
        }
    }
}

/// A side of a triangle, counter-clockwise: its ends, and what is beyond.
struct Side<S: Scalar> {
    ends: [Vec3<S>; 2],
    /// The numbers of the third corner of the triangle beyond.
    opposite: [i32; 2],
    /// The triangle beyond: its cell, and whether it is the one above the diagonal.
    next: (i32, i32, bool),
}

impl<'a, S: Scalar, T: OverSurface<S>> Over<'a, S, T> {
    fn new((shape, pose): Placed<'a, S, T>, (field, field_pose): Placed<'a, S, HeightField<'a, S>>, margin: S) -> Self {
        let rotation = field_pose.rotation.transposed().times_mat3(&pose.rotation);
        let pose = Pose { position: field_pose.unrotate(pose.position - field_pose.position), rotation };
        Self { shape, pose, field, margin }
    }

    /// Every point that is pushed.
    fn each(&self, gather: &mut impl Gather<S>) {
        let bounds = self.shape.aabb(&self.pose).expanded(self.margin);
        let [first_column, last_column] = self.field.cells(false, bounds.min.x, bounds.max.x);
        let [first_row, last_row] = self.field.cells(true, bounds.min.y, bounds.max.y);
        // One more: a triangle has the edges at its left and below it.
        for row in first_row..=last_row.wrapping_add(1) {
            for column in first_column..=last_column.wrapping_add(1) {
                for &above in &[false, true] {
                    self.on_triangle((column, row, above), gather);
                }
            }
        }
    }

    fn on_triangle(&self, (column, row, above): (i32, i32, bool), gather: &mut impl Gather<S>) {
        // Beyond the last row or column there is none.
        let Some(triangle) = self.field.triangle(column, row, above) else { return };
        let mut index = 0;
        while let Some(point) = self.shape.point(index) {
            self.on_point(&triangle, self.pose.to_world(point), index, gather);
            index = index.wrapping_add(1);
        }
        let mut number = 0;
        for side in &sides(&triangle, (column, row, above)) {
            self.on_side(&triangle, side, number, gather);
            number = number.wrapping_add(1);
        }
    }

    #[inline(never)]
    fn on_point(&self, triangle: &Triangle<S>, point: Vec3<S>, index: u8, gather: &mut impl Gather<S>) {
        let height = triangle.height(point);
        let separation = height.minus(self.shape.radius());
        if separation > self.margin {
            return;
        }
        let foot = point - Vec3::of_length(height, triangle.normal);
        if triangle.is_below(foot) && self.is_way_out(triangle, point, height) {
            let middle = foot + Vec3::of_length(separation.lowered_by(1), triangle.normal);
            gather.add(&Touch { normal: triangle.normal, middle, separation, feature: u16::from(index) });
        }
    }

    /// Whether the face pushes a point that is behind it: not one in the open, on the other side of a wall, nor one to which
    /// a face is nearer that pushes the other way.
    #[inline(always)]
    fn is_way_out(&self, triangle: &Triangle<S>, point: Vec3<S>, height: S) -> bool {
        height >= self.field.spacing().lowered_by(SHALLOW).negated() || self.is_deep_way_out(triangle, point, height)
    }

    #[cold]
    #[inline(never)]
    fn is_deep_way_out(&self, triangle: &Triangle<S>, point: Vec3<S>, height: S) -> bool {
        let triangles = |depth| Triangles::around(self.field, point, depth);
        let spacing = self.field.spacing();
        let above = triangles(spacing.lowered_by(SHALLOW)).find(|other| other.is_below(point));
        if above.is_none_or(|surface| surface.height(point) >= S::ZERO) {
            return false;
        }
        !triangles(min(height.negated(), spacing.times_integer(WALL))).any(|other| {
            let nearer = other.height(point);
            nearer > height
                && nearer < S::ZERO
                && other.normal.dot(triangle.normal) < S::Unit::ZERO
                && other.is_below(point - Vec3::of_length(nearer, other.normal))
        })
    }

    /// The edge pushes if it is a ridge or the field ends there; of the two triangles at a ridge, the first one asks.
    #[inline(never)]
    fn on_side(&self, triangle: &Triangle<S>, side: &Side<S>, number: u16, gather: &mut impl Gather<S>) {
        let [from, to] = side.ends;
        let (column, row, above) = side.next;
        let next = match self.field.point(side.opposite[0], side.opposite[1]) {
            Some(opposite) => {
                let fall = triangle.height(opposite).negated();
                // The triangle above the diagonal has that and the edge to its left, the other one the edge below it.
                let asks = number == 0 || (number == 2 && !above);
                if !asks || fall <= self.field.spacing().lowered_by(RIDGE) {
                    return;
                }
                self.field.triangle(column, row, above)
            }
            None => None,
        };
        let Some((along, _)) = S::direction3((to - from).to_array()) else { return };
        let along = Vec3::from_array(along);
        let half = (to - from).along(along).lowered_by(1);
        let local = |v: Vec3<S>| self.pose.to_local(v);
        let edge = Segment {
            middle: local(from + Vec3::of_length(half, along)),
            axis: self.pose.rotation.transposed().times(along),
            half,
        };
        let Some(Beside { direction, ends }) = self.shape.beside(&edge) else { return };
        let normal = S::opposite(&self.pose.rotation.times(direction));
        let slack = S::Unit::ONE.lowered_by(BEYOND).negated();
        if normal.dot(along.cross(triangle.normal)) < slack || normal.dot(triangle.normal) < slack {
            return;
        }
        if let Some(next) = next
            && normal.dot(next.normal.cross(along)) < slack
        {
            return;
        }
        let mut feature = 256 | number;
        for &(place, height) in &ends {
            let separation = height.minus(self.shape.radius());
            if separation <= self.margin {
                let middle = self.pose.to_world(place) + Vec3::of_length(separation.lowered_by(1), normal);
                gather.add(&Touch { normal, middle, separation, feature });
            }
            feature = feature.wrapping_add(16);
        }
    }
}

fn sides<S: Scalar>(triangle: &Triangle<S>, (c, r, above): (i32, i32, bool)) -> [Side<S>; 3] {
    let [p, q, s] = triangle.corners;
    let side = |ends, opposite, next| Side { ends, opposite, next };
    let (left, right, down, up) = (c.wrapping_sub(1), c.wrapping_add(1), r.wrapping_sub(1), r.wrapping_add(1));
    if above {
        [
            side([p, q], [right, r], (c, r, false)),
            side([q, s], [right, up.wrapping_add(1)], (c, up, false)),
            side([s, p], [left, r], (left, r, false)),
        ]
    } else {
        [
            side([p, q], [c, down], (c, down, true)),
            side([q, s], [right.wrapping_add(1), up], (right, r, true)),
            side([s, p], [c, up], (c, r, true)),
        ]
    }
}
