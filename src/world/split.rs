//! A step in parts.

use super::World;
use super::step::WorldReport;
use crate::scalar::Scalar;
use crate::shape::Collide;
use crate::solver::{Paused, Settings};

/// A step that is made in parts, for those who have other things to do in between: [`World::split_step`].
///
/// It borrows the world, so that nobody can change it between the parts. Dropped, it is finished first: no step is left half made.
#[derive(Debug)]
pub struct SplitStep<'w, S, Sh, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
where
    S: Scalar,
    Sh: Collide<S, Sh>,
{
    world: &'w mut World<S, Sh, BODIES, MANIFOLDS, POINTS>,
    settings: Settings<S>,
    /// `None` when it is finished.
    paused: Option<Paused<S>>,
    report: WorldReport,
}

impl<S: Scalar, Sh: Collide<S, Sh>, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
    World<S, Sh, BODIES, MANIFOLDS, POINTS>
{
    /// A [step](Self::step) in parts: this one finds the contacts and prepares them, [`SplitStep::advance`] makes as many sub-steps as
    /// there is time for, and [`SplitStep::finish`] the rest. Every bit of the result is that of one call of `step`.
    ///
    /// What each part takes at most: of the bound in `docs/cost.md` ([`StepCost`](crate::world::StepCost)) the first has what does not depend on
    /// the sub-steps, a sub-step what does.
    ///
    /// ```
    /// # #[cfg(feature = "f32")] {
    /// # use carom::{Body, HalfSpace, Material, Solid, Sphere, UnitVec3, Vec3, World, solver::Settings};
    /// # carom::shapes! { enum Piece<S> { Sphere, HalfSpace } }
    /// # let mut world = World::<f32, Piece<f32>, 2, 4, 8>::new();
    /// # let settings = Settings::new(Vec3::new(0.0, 0.0, -9.81), [1, 60], 4)?;
    /// let mut step = world.split_step(&settings);
    /// while step.advance(1) > 0 {
    ///     // Read the buttons, feed the watchdog.
    /// }
    /// let report = step.finish();
    /// # assert_eq!(report.dropped, 0);
    /// # }
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn split_step(&mut self, settings: &Settings<S>) -> SplitStep<'_, S, Sh, BODIES, MANIFOLDS, POINTS> {
        let (paused, report) = self.begin(settings);
        SplitStep { world: self, settings: *settings, paused: Some(paused), report }
    }
}

impl<S: Scalar, Sh: Collide<S, Sh>, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
    SplitStep<'_, S, Sh, BODIES, MANIFOLDS, POINTS>
{
    /// Makes up to `sub_steps` of the sub-steps that are left, and says how many are left then.
    pub fn advance(&mut self, sub_steps: u8) -> u8 {
        match &mut self.paused {
            Some(paused) => self.world.advance(paused, &self.settings, sub_steps),
            None => 0,
        }
    }

    /// Makes what is left of the step.
    pub fn finish(mut self) -> WorldReport {
        self.complete();
        self.report
    }

    fn complete(&mut self) {
        if let Some(paused) = self.paused.take() {
            self.world.finish(&paused, &self.settings, &mut self.report);
        }
    }
}

impl<S: Scalar, Sh: Collide<S, Sh>, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize> Drop
    for SplitStep<'_, S, Sh, BODIES, MANIFOLDS, POINTS>
{
    fn drop(&mut self) {
        self.complete();
    }
}
