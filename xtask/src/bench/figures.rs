//! What is measured and kept: one figure for an operation in a number type on a board at an opt-level.

use super::image::Opt;
use crate::boards::{Board, Scalar};
use serde::{Deserialize, Serialize};

/// Who is not a peer.
pub const OWN: &str = "carom";

/// What tells one figure from another.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Key {
    pub board: Board,
    /// `carom`, or another library.
    pub by: String,
    pub operation: String,
    pub scalar: Scalar,
    pub opt: Opt,
}

/// What an operation costs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figure {
    #[serde(flatten)]
    pub key: Key,
    /// From the call to the return; of many impacts the median.
    pub instructions: u32,
    /// Of many impacts.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub spread: Option<Spread>,
    /// Bytes of code and constants, with all that is called.
    pub flash: u32,
    /// Bytes of stack below the call; of many impacts the most.
    pub stack: u32,
    /// Bytes of static memory.
    pub ram: u32,
    /// Of the first impact's result: the largest error of a velocity component, in m/s or rad/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
}

/// Every operation, in the order in which they are shown, and in words.
pub const OPERATIONS: [(&str, &str); 17] = [
    ("multiply", "x * y"),
    ("divide", "x / y"),
    ("reciprocal", "1 / x"),
    ("sqrt", "square root"),
    ("dot", "dot product"),
    ("cross", "cross product"),
    ("normalize", "`UnitVec3::normalize`"),
    ("set_orientation", "`Body::set_orientation`: rotates the inertia"),
    ("effective_mass", "`effective_mass`"),
    ("collision_impulse", "`collision_impulse`"),
    ("resolve", "`resolve_collision`"),
    ("resolve_immovable", "the same against an immovable body"),
    ("resolve_rows", "the same on all rows"),
    ("friction", "`resolve_collision_with_friction`"),
    ("friction_none", "the same on rows without friction"),
    ("friction_stick", "the same on rows that stick"),
    ("friction_slip", "the same on rows that slide"),
];

impl Figure {
    /// Sorts figures as they are shown and kept.
    pub fn order(&self) -> impl Ord + use<> {
        let Key { board, by, operation, scalar, opt } = &self.key;
        let place = OPERATIONS.iter().position(|(name, _)| name == operation);
        (*board, place, by != OWN, by.clone(), *scalar, *opt)
    }
}

/// How the instructions differ from impact to impact.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Spread {
    pub min: u32,
    pub max: u32,
    /// The impact of the maximum.
    pub worst: String,
    /// How many impacts.
    pub rows: u32,
    /// How many more the number type cannot hold.
    pub skipped: u32,
}
