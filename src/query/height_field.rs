//! A ray and a height field: cell after cell below the ray.

use super::{CastLocal, LocalHit, LocalRay};
use crate::math::{Vec3, max, min};
use crate::scalar::Scalar;
use crate::shape::{HeightField, Triangle};

impl<S: Scalar> CastLocal<S> for HeightField<'_, S> {
    /// Looks at the cells that the box around the ray touches, seen from above.
    fn cast(&self, ray: &LocalRay<S>) -> Option<LocalHit<S>> {
        let end = ray.at(ray.length);
        let [first_column, last_column] = self.cells(false, min(ray.origin.x, end.x), max(ray.origin.x, end.x));
        let [first_row, last_row] = self.cells(true, min(ray.origin.y, end.y), max(ray.origin.y, end.y));
        let mut best: Option<LocalHit<S>> = None;
        for row in first_row..=last_row {
            for column in first_column..=last_column {
                for &above in &[false, true] {
                    let Some(triangle) = self.triangle(column, row, above) else { continue };
                    let Some(hit) = on_triangle(&triangle, ray) else { continue };
                    if best.is_none_or(|best| hit.distance < best.distance) {
                        best = Some(hit);
                    }
                }
            }
        }
        best
    }
}

fn on_triangle<S: Scalar>(triangle: &Triangle<S>, ray: &LocalRay<S>) -> Option<LocalHit<S>> {
    let height = triangle.height(ray.origin);
    if height <= S::ZERO {
        // In the field, if it is below this triangle.
        return if triangle.is_below(ray.origin) { ray.inside() } else { None };
    }
    let falls = triangle.normal.dot(ray.direction).negated();
    if falls <= S::Unit::ZERO || ray.length.times_unit(falls) < height {
        return None;
    }
    let (distance, _) = S::from_scaled(height.to_scaled() / falls.to_scaled());
    let place: Vec3<S> = ray.at(distance);
    if triangle.is_below(place) { ray.hit(distance, triangle.normal) } else { None }
}
