//! What a step takes at most.

/// How the instructions of a step grow, on one part and in one number format: the constants of the bound in `docs/cost.md`, which
/// `cargo xtask bench` measures. They are those of its compiler and shapes, with 15 % to spare; measure your own firmware where a
/// deadline is hard. Instructions are not cycles.
///
/// ```
/// use carom::world::{StepCost, StepWork};
///
/// // Balls and planes in I16F16 on an M3 at opt-level 3, and eight balls that all touch: how many sub-steps do 100,000 instructions
/// // allow at most?
/// const M3: StepCost = StepCost { step: 2_300, body: 3_100, body_and_sub_step: 420, pair: 4_200, point_and_sub_step: 970 };
/// const WORK: StepWork = StepWork { bodies: 8, pairs: 8, points: 8 };
/// const SUB_STEPS: u8 = M3.max_sub_steps(WORK, 100_000);
/// assert_eq!(SUB_STEPS, 3);
/// assert!(M3.instructions(WORK, SUB_STEPS) <= 100_000);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepCost {
    /// A step of an empty world.
    pub step: u32,
    /// Each body that moves.
    pub body: u32,
    /// Each body that moves, in each sub-step.
    pub body_and_sub_step: u32,
    /// Each pair of bodies whose boxes overlap.
    pub pair: u32,
    /// Each point of contact, in each sub-step.
    pub point_and_sub_step: u32,
}

/// What there is to do in a step, at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepWork {
    /// The bodies that move.
    pub bodies: u32,
    /// The pairs of bodies whose boxes overlap.
    pub pairs: u32,
    /// The points of contact: [`WorldReport::points`](crate::world::WorldReport::points).
    pub points: u32,
}

impl StepCost {
    /// The bound on a step in so many sub-steps; `u32::MAX` where it is beyond that.
    #[must_use]
    pub const fn instructions(&self, work: StepWork, sub_steps: u8) -> u32 {
        let each = self.each_sub_step(work).saturating_mul(sub_steps as u32);
        self.once(work).saturating_add(each)
    }

    /// The most sub-steps with which the bound on a step is within the `budget`; zero where not even one is.
    #[must_use]
    pub const fn max_sub_steps(&self, work: StepWork, budget: u32) -> u8 {
        let mut sub_steps = 0;
        while sub_steps < u8::MAX && self.instructions(work, sub_steps.wrapping_add(1)) <= budget {
            sub_steps = sub_steps.wrapping_add(1);
        }
        sub_steps
    }

    /// What does not depend on the sub-steps: the first part of a [split step](crate::World::split_step) and the end of its last.
    #[must_use]
    pub const fn once(&self, work: StepWork) -> u32 {
        let bodies = self.body.saturating_mul(work.bodies);
        self.step.saturating_add(bodies).saturating_add(self.pair.saturating_mul(work.pairs))
    }

    /// What each sub-step takes.
    #[must_use]
    pub const fn each_sub_step(&self, work: StepWork) -> u32 {
        let bodies = self.body_and_sub_step.saturating_mul(work.bodies);
        bodies.saturating_add(self.point_and_sub_step.saturating_mul(work.points))
    }
}
