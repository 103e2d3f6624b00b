//! A scene played step by step.

use super::{Call, counter, stack};

/// Three seconds.
const STEPS: u32 = 180;
/// As many at the end make the mean.
const LAST: u32 = 60;

/// Somebody's world with something in it.
pub trait Play {
    /// What is measured: a step.
    fn step(&mut self) -> Call;

    /// What goes before each step and is not measured.
    fn prepare(&mut self) {}
}

/// The instructions of a step.
pub struct Instructions {
    /// Of the last sixty steps.
    pub mean: u32,
    /// Of all steps.
    pub min: u32,
    pub max: u32,
    /// The step of the maximum.
    pub worst: u32,
}

/// Plays it to the end; `None` when a step took longer than the counter counts.
pub fn instructions(scene: &mut impl Play) -> Option<Instructions> {
    let (mut sum, mut min, mut max, mut worst) = (0, u32::MAX, 0, 0);
    for step in 0..STEPS {
        scene.prepare();
        let count = counter::instructions(&scene.step())?;
        if step >= STEPS - LAST {
            sum += count;
        }
        if count > max {
            (max, worst) = (count, step);
        }
        min = min.min(count);
    }
    Some(Instructions { mean: (sum + LAST / 2) / LAST, min, max, worst })
}

/// Plays it to the end: the most stack of any step. `None` when one used all that was painted.
pub fn stack(scene: &mut impl Play) -> Option<u32> {
    let mut most = 0;
    for _ in 0..STEPS {
        scene.prepare();
        most = stack::bytes(&scene.step())?.max(most);
    }
    Some(most)
}
