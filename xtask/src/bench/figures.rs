//! What is measured and kept: one figure for an operation in a number type on a board at an opt-level.

use super::bound::Bound;
use super::image::{Opt, Part};
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
    /// Of a scene.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub scene: Option<Scene>,
    /// Of a step of a kind of world; its instructions are those of the highest stack.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound: Option<Bound>,
}

/// What came of a scene, and what its steps are made of.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// The height of the highest piece's centre, m, or the speed at which the ball rolls, m/s.
    pub outcome: f64,
    /// Bytes of flash of firmware that does this and no more.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub image: Option<u32>,
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub stages: Option<Stages>,
}

/// Instructions of the stages of a step. What is left of a step is the world's own: who is awake, what touches what.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Stages {
    pub broad: u32,
    pub narrow: u32,
    pub prepare: u32,
    pub solve: u32,
    pub integrate: u32,
    pub keep: u32,
}

/// Their names, in the order of [`Stages::all`].
pub const STAGES: [&str; 6] = ["broad", "narrow", "prepare", "solve", "integrate", "keep"];

impl Stages {
    pub fn all(self) -> [u32; 6] {
        let Self { broad, narrow, prepare, solve, integrate, keep } = self;
        [broad, narrow, prepare, solve, integrate, keep]
    }
}

/// Every scene, in the order in which they are shown, what its measured firmware is linked for, and in words.
pub const SCENES: [(&str, &str, &str); 7] = [
    ("spheres_1", "spheres", "ball at rest"),
    ("spheres_4", "spheres", "stack of 4 balls"),
    ("spheres_8", "spheres", "stack of 8 balls"),
    ("slide", "spheres", "sliding ball"),
    ("boxes_1", "boxes", "box at rest"),
    ("boxes_4", "boxes", "stack of 4 boxes"),
    ("boxes_8", "boxes", "stack of 8 boxes"),
];

/// The kinds of worlds that have a bound: the operation, the kind, in words, and the points between two.
pub const KINDS: [(&str, &str, &str, u32); 2] =
    [("bound_spheres", "spheres", "balls and planes", 1), ("bound_boxes", "boxes", "boxes and planes", 4)];

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

/// Where it stands among what is measured of worlds.
fn world_place(operation: &str) -> Option<usize> {
    let mut names = SCENES.iter().map(|(name, ..)| *name).chain(KINDS.iter().map(|(name, ..)| *name));
    names.position(|name| name == operation)
}

/// What measures it.
pub fn part(operation: &str) -> Part {
    if world_place(operation).is_some() { Part::World } else { Part::Operations }
}

impl Figure {
    /// Sorts figures as they are shown and kept.
    pub fn order(&self) -> impl Ord + use<> {
        let Key { board, by, operation, scalar, opt } = &self.key;
        let place = OPERATIONS.iter().position(|(name, _)| name == operation);
        (*board, world_place(operation), place, by != OWN, by.clone(), *scalar, *opt)
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
