//! What is measured and kept: one figure for an operation in a number type on a board at an opt-level.

use super::image::Opt;
use crate::boards::{Board, Scalar};
use serde::{Deserialize, Serialize};

/// What tells one figure from another.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
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
