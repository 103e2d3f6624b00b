//! One run beside another: how far apart they are, and from when on.

use crate::algebra::{length, sub};
use crate::trace::Trace;
use anyhow::{Result, bail};

/// Two runs of one scene.
pub struct Comparison {
    /// In each frame of the first the largest distance between a body and itself in the other run, m.
    pub distance: Vec<f64>,
    /// From which distance on they count as parted, m.
    pub bound: f64,
    /// The first frame in which they have.
    pub parted: Option<usize>,
}

/// The part of a body's thickness from which on one sees two bodies.
const PART: f64 = 0.1;

impl Comparison {
    pub fn new(trace: &Trace, other: &Trace) -> Result<Self> {
        let shapes = |trace: &Trace| trace.bodies.iter().map(|body| (body.look, body.is_fixed())).collect::<Vec<_>>();
        if (trace.rate, trace.sub_steps) != (other.rate, other.sub_steps) || shapes(trace) != shapes(other) {
            bail!("the two traces are of different scenes: other bodies, or other steps");
        }
        let movers: Vec<usize> = (0..trace.bodies.len()).filter(|body| !trace.bodies[*body].is_fixed()).collect();
        let thickness = movers.iter().map(|body| 2.0 * trace.bodies[*body].size()).fold(f64::INFINITY, f64::min);
        let bound = PART * thickness * trace.unit;
        let distance: Vec<f64> = trace
            .frames
            .iter()
            .enumerate()
            .map(|(index, frame)| {
                // A run that ended before stays as it was.
                let theirs = &other.frames[index.min(other.frames.len() - 1)];
                let place = |body: usize| (frame.motions[body].position, theirs.motions[body].position);
                let apart = movers.iter().map(|body| {
                    let (mine, theirs) = place(*body);
                    length(sub(mine, theirs)) * trace.unit
                });
                apart.fold(0.0, f64::max)
            })
            .collect();
        let parted = distance.iter().position(|distance| *distance > bound);
        Ok(Self { distance, bound, parted })
    }
}
