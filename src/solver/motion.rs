//! How a body moves within a step.

use super::constraint::ManifoldConstraint;
use crate::body::Body;
use crate::math::Vec3;
use crate::scalar::{Column, Scalar, StepArithmetic, Velocity};

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
    /// Its inertia is not the same about every axis.
    pub(super) uneven: bool,
}

/// What part a body takes in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// Only the caller moves it. The first, so that new motions are zeros and a static world lies in `.bss`.
    Immovable,
    /// Contacts and gravity move it.
    Moves,
    /// It stays where it is.
    Held,
    /// Its numbers are not finite: it touches nothing.
    Lost,
}

impl<S: Scalar> Motion<S> {
    /// Working space for one body.
    pub const NEW: Self = Self {
        now: Velocity::ZERO,
        free: Velocity::ZERO,
        sum: Velocity::ZERO,
        size: S::Step::NO_PLACES,
        part: Part::Immovable,
        uneven: false,
    };

    /// Reads what a body is, not yet how it moves.
    pub(super) fn take_up(&mut self, body: &Body<S>) {
        self.size = S::Step::NO_PLACES;
        self.part = if !body.is_finite() {
            Part::Lost
        } else if body.is_immovable() {
            Part::Immovable
        } else {
            self.size = S::Step::size(body.inv_mass, body.exponent);
            self.uneven = !body.is_isotropic();
            Part::Moves
        };
    }

    #[inline(always)]
    pub(super) fn moves(&self) -> bool {
        self.part == Part::Moves
    }
}

/// The motions of the bodies of a manifold, of which the first may be one that does not move.
pub(super) struct Pair<'m, S: Scalar> {
    a: Option<&'m mut Motion<S>>,
    b: &'m mut Motion<S>,
}

impl<'m, S: Scalar> Pair<'m, S> {
    /// Those of two different bodies.
    #[inline(always)]
    pub fn of(motions: &'m mut [Motion<S>], manifold: &ManifoldConstraint<S>) -> Option<Self> {
        let b = usize::from(manifold.b);
        let Some(a) = manifold.a else { return Some(Self { a: None, b: motions.get_mut(b)? }) };
        let a = usize::from(a);
        if a < b {
            let [a, .., b] = motions.get_mut(a..b.wrapping_add(1))? else { return None };
            Some(Self { a: Some(a), b })
        } else {
            let [b, .., a] = motions.get_mut(b..a.wrapping_add(1))? else { return None };
            Some(Self { a: Some(a), b })
        }
    }

    /// The relative speed along a direction.
    #[inline(always)]
    pub fn speed(&self, d: &Vec3<S::Unit>, columns: &[Column<S>; 2]) -> S {
        let b = &self.b.now;
        match &self.a {
            Some(a) => S::Step::pair_speed(d, [&a.now, b], columns),
            None => S::Step::lone_speed(d, b, &columns[1]),
        }
    }

    /// The sum of it over the sub-steps so far.
    #[inline(always)]
    pub fn way(&self, d: &Vec3<S::Unit>, columns: &[Column<S>; 2]) -> S {
        let b = &self.b.sum;
        match &self.a {
            Some(a) => S::Step::pair_speed(d, [&a.sum, b], columns),
            None => S::Step::lone_speed(d, b, &columns[1]),
        }
    }

    /// An impulse along a direction.
    #[inline(always)]
    pub fn push(&mut self, d: &Vec3<S::Unit>, columns: &[Column<S>; 2], impulse: S) {
        if impulse == S::ZERO {
            return;
        }
        match &mut self.a {
            Some(a) => S::Step::push_pair([&mut a.now, &mut self.b.now], d, columns, impulse),
            None => S::Step::push(&mut self.b.now, d, &columns[1], impulse),
        }
    }

    /// The relative speed of the centres of mass along a direction.
    #[inline(always)]
    pub fn central_speed(&self, d: &Vec3<S::Unit>) -> S {
        central(self.a.as_ref().map(|a| &a.now.v), &self.b.now.v, d)
    }

    /// The sum of it over the sub-steps so far.
    #[inline(always)]
    pub fn central_way(&self, d: &Vec3<S::Unit>) -> S {
        central(self.a.as_ref().map(|a| &a.sum.v), &self.b.sum.v, d)
    }

    /// An impulse that goes through the centres of mass.
    #[inline(always)]
    pub fn push_centrally(&mut self, d: &Vec3<S::Unit>, [column_a, column_b]: &[Column<S>; 2], impulse: S) {
        if impulse == S::ZERO {
            return;
        }
        if let Some(a) = &mut self.a {
            S::Step::thrust(&mut a.now.v, d, column_a.share, impulse.negated());
        }
        S::Step::thrust(&mut self.b.now.v, d, column_b.share, impulse);
    }
}

#[inline(always)]
fn central<S: Scalar>(a: Option<&Vec3<S>>, b: &Vec3<S>, d: &Vec3<S::Unit>) -> S {
    match a {
        Some(a) => S::Step::central_speed(d, [a, b]),
        None => S::Step::along(b, d),
    }
}
