//! How much room what happens takes, in metres.

use crate::algebra::{add, scale};
use crate::trace::{Frame, Shape, Trace};

pub struct Extent {
    pub low: [f64; 3],
    pub high: [f64; 3],
    /// Half the thickness of the thickest body with an end, and of the thinnest one with a mass.
    pub largest: f64,
    pub smallest: f64,
    /// Places that bodies reach.
    pub points: Vec<[f64; 3]>,
}

/// So many moments show where a body goes.
const MOMENTS: usize = 200;

impl Extent {
    /// Of everything that has an end.
    pub fn of(trace: &Trace) -> Self {
        let seen = &trace.frames[opening(trace)..];
        let (mut largest, mut smallest, mut points) = (0.0f64, f64::INFINITY, Vec::new());
        for (index, subject) in trace.bodies.iter().enumerate() {
            let size = subject.size();
            if !size.is_finite() {
                continue;
            }
            largest = largest.max(size);
            if !subject.is_fixed() {
                smallest = smallest.min(size);
            }
            let moves = trace.moving(index);
            let reach = match subject.shape {
                Shape::Cuboid { half } if !moves => half,
                Shape::Capsule { radius, half_length } => [radius + half_length; 3],
                _ => [size; 3],
            };
            let stride = if moves { seen.len().div_ceil(MOMENTS) } else { seen.len() };
            for frame in seen.iter().step_by(stride) {
                let place = frame.motions[index].position;
                points.extend(corners(reach).map(|corner| scale(add(place, corner), trace.unit)));
            }
        }
        if points.is_empty() {
            (largest, smallest) = (0.1, 0.1);
            points.extend(corners([1.0; 3]));
        } else {
            (largest, smallest) = (largest * trace.unit, smallest * trace.unit);
        }
        let bound = |of: fn(f64, f64) -> f64| {
            let first = points[0];
            points.iter().fold(first, |bound, point| [0, 1, 2].map(|axis| of(bound[axis], point[axis])))
        };
        let (low, high) = (bound(f64::min), bound(f64::max));
        Self { low, high, largest, smallest, points }
    }
}

fn corners(half: [f64; 3]) -> impl Iterator<Item = [f64; 3]> {
    let side = |corner: usize, axis: usize| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 };
    (0..8).map(move |corner| [0, 1, 2].map(|axis| side(corner, axis) * half[axis]))
}

/// The frame from which on everything has to be seen: what is thrown comes flying into the picture.
fn opening(trace: &Trace) -> usize {
    let strikes = |frame: &Frame| frame.touches.iter().any(|touch| !touch.sensor && touch.approach > 0.0);
    let first = trace.frames.iter().position(strikes).unwrap_or(0);
    if first < trace.frames.len() / 3 { first.saturating_sub(4) } else { 0 }
}
