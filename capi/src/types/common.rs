//! What is the same for all number types.

use carom::BodyHandle;
use carom::impulse::Outcome;
use carom::world::{Phase, WorldReport};

/// A body of a world, for as long as it is there. A handle of a body that was removed is refused; it never means another one,
/// until a place has been used 65,536 times. All zeros (CAROM_NO_BODY) is no body.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct carom_body_handle {
    /// To be compared, and for nothing else.
    pub bits: u32,
}

impl From<BodyHandle> for carom_body_handle {
    fn from(handle: BodyHandle) -> Self {
        // The complement, so that zeros, of which C makes handles, are the last place of all, where no body can be.
        Self { bits: !handle.to_bits() }
    }
}

impl From<carom_body_handle> for BodyHandle {
    fn from(handle: carom_body_handle) -> Self {
        Self::from_bits(!handle.bits)
    }
}

/// Which law restitution follows where friction acts with it: the `law` of a material.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum carom_restitution_law {
    /// v_n' = -e v_n, always. With friction that may raise the energy in rare eccentric impacts.
    CAROM_NEWTON = 0,
    /// The same, but where it would raise the energy the rebound is drawn back until it does not.
    CAROM_ENERGY_SAFE = 1,
}

/// What a contact did: the `outcome` of an impact.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum carom_outcome {
    /// The bodies do not approach each other at the point: nothing was changed.
    CAROM_SEPARATING = 0,
    /// The points do not slide on each other: friction held.
    CAROM_STUCK = 1,
    /// The points slide on each other, with friction at its limit, or without friction.
    CAROM_SLID = 2,
    /// Neither body can move: nothing was changed.
    CAROM_IMMOVABLE = 3,
    /// A number was not finite, or would not be: nothing was changed. Never in fixed point.
    CAROM_OUTCOME_NOT_FINITE = 4,
}

impl From<Outcome> for carom_outcome {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Separating => Self::CAROM_SEPARATING,
            Outcome::Stuck => Self::CAROM_STUCK,
            Outcome::Slid => Self::CAROM_SLID,
            Outcome::Immovable => Self::CAROM_IMMOVABLE,
            Outcome::NotFinite => Self::CAROM_OUTCOME_NOT_FINITE,
        }
    }
}

/// What a contact does in a step: the `phase` of two bodies that touch.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum carom_phase {
    /// The bodies did not touch before this step.
    CAROM_BEGAN = 0,
    /// They did, and do.
    CAROM_PERSISTS = 1,
    /// They do not any more.
    CAROM_ENDED = 2,
}

impl From<Phase> for carom_phase {
    fn from(phase: Phase) -> Self {
        match phase {
            Phase::Began => Self::CAROM_BEGAN,
            Phase::Persists => Self::CAROM_PERSISTS,
            Phase::Ended => Self::CAROM_ENDED,
        }
    }
}

/// What a step of a world has to say.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct carom_world_report {
    /// The points of contact that were solved.
    pub points: u16,
    /// The pairs of surfaces that they belong to, and those of sensors and sleeping bodies.
    pub manifolds: u16,
    /// Pairs that were left out for lack of room: those bodies did not see each other in this step. Take a larger world.
    pub dropped: u16,
    /// The bodies that sleep.
    pub asleep: u16,
    /// The bodies that took no part because a number in them is not finite.
    pub quarantined: u16,
    /// 1 where a position or velocity met the end of the format and stayed there, else 0.
    pub saturated: u16,
}

impl From<WorldReport> for carom_world_report {
    fn from(report: WorldReport) -> Self {
        let WorldReport { points, manifolds, dropped, asleep, quarantined, saturated } = report;
        Self { points, manifolds, dropped, asleep, quarantined, saturated: saturated.into() }
    }
}
