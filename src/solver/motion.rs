//! How a body moves within a step.

use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::{Column, Scalar, StepArithmetic};

/// A body's velocities within a step, in the units of the step: working space that the caller lends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<S: Scalar> {
    pub(super) now: Velocity<S>,
    /// Without what contacts did in this sub-step.
    pub(super) free: Velocity<S>,
    /// The sum over the sub-steps so far.
    pub(super) sum: Velocity<S>,
    pub(super) size: <S::Step as StepArithmetic<S>>::Places,
    pub(super) part: Part,
    pub(super) isotropic: bool,
}

/// What part a body takes in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// Contacts and gravity move it.
    Moves,
    /// Only the caller moves it.
    Immovable,
    /// It stays where it is.
    Held,
    /// Its numbers are not finite: it touches nothing.
    Lost,
}

/// A linear and an angular velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Velocity<S: Scalar> {
    pub v: Vec3<S>,
    pub w: Vec3<S>,
}

impl<S: Scalar> Velocity<S> {
    pub const ZERO: Self = Self { v: Vec3::ZERO, w: Vec3::ZERO };

    #[inline(always)]
    pub fn plus(&self, other: &Self) -> Self {
        Self { v: self.v + other.v, w: self.w + other.w }
    }

    #[inline(always)]
    pub fn minus(&self, other: &Self) -> Self {
        Self { v: self.v - other.v, w: self.w - other.w }
    }
}

impl<S: Scalar> Motion<S> {
    /// Working space for one body.
    pub const NEW: Self = Self {
        now: Velocity::ZERO,
        free: Velocity::ZERO,
        sum: Velocity::ZERO,
        size: S::Step::NO_PLACES,
        part: Part::Immovable,
        isotropic: true,
    };

    pub(super) fn of(body: &Body<S>) -> Self {
        if !body.is_finite() {
            return Self { part: Part::Lost, ..Self::NEW };
        }
        if body.is_immovable() {
            return Self::NEW;
        }
        let size = S::Step::size(body.inv_mass, body.exponent);
        Self { size, part: Part::Moves, isotropic: body.is_isotropic(), ..Self::NEW }
    }

    #[inline(always)]
    pub(super) fn moves(&self) -> bool {
        self.part == Part::Moves
    }
}

/// The velocities of the bodies of a manifold, of which the first may be one that does not move.
#[derive(Clone, Copy)]
pub(super) struct Pair<S: Scalar> {
    pub a: Option<Velocity<S>>,
    pub b: Velocity<S>,
}

impl<S: Scalar> Pair<S> {
    /// The relative speed along a direction.
    #[inline(always)]
    pub fn speed(&self, d: &Vec3<S::Unit>, [column_a, column_b]: &[Column<S>; 2]) -> S {
        match &self.a {
            Some(a) => S::Step::pair_speed(d, [&a.v, &self.b.v], [&a.w, &self.b.w], [column_a, column_b]),
            None => S::Step::lone_speed(d, &self.b.v, &self.b.w, column_b),
        }
    }

    /// An impulse along a direction.
    #[inline(always)]
    pub fn push(&mut self, d: &Vec3<S::Unit>, [column_a, column_b]: &[Column<S>; 2], impulse: S) {
        if let Some(a) = &mut self.a {
            S::Step::pull(&mut a.v, &mut a.w, d, column_a, impulse);
        }
        S::Step::push(&mut self.b.v, &mut self.b.w, d, column_b, impulse);
    }
}
