//! What a world knows of a body beside its motion, its shape and its material.

use super::filter::Filter;
use super::handle::BodyHandle;
use crate::scalar::Scalar;

/// What a body does in this step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum State {
    /// There is none in this place.
    Vacant,
    /// It stands, and nothing moves it.
    Fixed,
    /// Nothing moves it but its own velocity, which the caller gave it.
    Driven,
    Awake,
    Asleep,
    /// A number in it is not finite: it takes no part until the caller mends it.
    Quarantined,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Slot<S: Scalar> {
    pub generation: u16,
    pub state: State,
    pub sensor: bool,
    /// It was touched from outside: its place, its shape or its velocity may be another.
    pub touched: bool,
    /// Steps for which it has been still.
    pub still: u8,
    /// Of the first body of an island: the least of that of its bodies.
    pub still_together: u8,
    pub filter: Filter,
    /// The body of its island with the lowest number; of a sleeping body the island it fell asleep in.
    pub island: u16,
    /// The fastest it was in the first half of the time that it has been still.
    pub fastest: S,
    /// How far around its box others count in this step.
    pub reach: S,
    /// The size of the shape: tolerances are relative to it.
    pub size: S,
    /// It is as far from its centre to its surface everywhere.
    pub ball: bool,
    /// How much of that its turning may bring.
    pub swing: S,
    /// The part of the step after which something turns it aside from its way.
    pub aside: S::Unit,
}

impl<S: Scalar> Slot<S> {
    pub const VACANT: Self = Self {
        generation: 0,
        state: State::Vacant,
        sensor: false,
        touched: false,
        still: 0,
        still_together: 0,
        filter: Filter { groups: 0, meets: 0 },
        island: 0,
        fastest: S::ZERO,
        reach: S::ZERO,
        size: S::ZERO,
        ball: false,
        swing: S::ZERO,
        aside: S::Unit::ZERO,
    };

    /// Whether it may run into others.
    #[inline(always)]
    pub fn is_active(&self) -> bool {
        matches!(self.state, State::Awake | State::Driven)
    }

    /// Whether it wakes what it comes near: not what is as slow as sleepers are, or two that lie beside each other would
    /// wake one another for ever.
    #[inline(always)]
    pub fn is_loud(&self) -> bool {
        self.is_driven() || self.is_awake() && self.still == 0
    }

    #[inline(always)]
    pub fn is_awake(&self) -> bool {
        self.state == State::Awake
    }

    #[inline(always)]
    pub fn is_driven(&self) -> bool {
        self.state == State::Driven
    }

    #[inline(always)]
    pub fn is_asleep(&self) -> bool {
        self.state == State::Asleep
    }

    /// Whether both are there, and let each other meet.
    #[inline(always)]
    pub fn meets(&self, other: &Self) -> bool {
        let there = |slot: &Self| !matches!(slot.state, State::Vacant | State::Quarantined);
        there(self) && there(other) && self.filter.lets_meet(other.filter)
    }

    #[inline(always)]
    pub fn handle(&self, index: u16) -> BodyHandle {
        BodyHandle { index, generation: self.generation }
    }

    pub fn wake(&mut self) {
        if self.is_asleep() {
            self.state = State::Awake;
            self.still = 0;
        }
    }

    pub fn fall_asleep(&mut self) {
        self.state = State::Asleep;
    }
}
