//! What is drawn first: the ground, then what is far away.

use super::view::View;
use crate::body::Body;
use crate::scalar::{Scalar, Scaled};
use crate::shape::Shape;
use crate::world::{BodyHandle, World};

impl<S: Scalar> View<S> {
    /// The bodies of a world in the order in which they are to be drawn: first what has no end, such as planes and height
    /// fields, then the others, the farthest first, by their positions. A body hides those before it. What is not finite is left
    /// out.
    ///
    /// The time grows with the square of their number: it needs no memory.
    pub fn back_to_front<'w, Sh: Shape<S>, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>(
        &self,
        world: &'w World<S, Sh, BODIES, MANIFOLDS, POINTS>,
    ) -> impl Iterator<Item = (BodyHandle, &'w Body<S>, &'w Sh)> {
        let mut last: Option<Rank<S>> = None;
        core::iter::from_fn(move || {
            let mut next: Option<(Rank<S>, _)> = None;
            for (place, found) in (0u32..).zip(world.bodies_with_shapes()) {
                let Some(rank) = self.rank(place, found.1, found.2) else { continue };
                let is_left = last.is_none_or(|last| last.is_before(&rank));
                if is_left && next.as_ref().is_none_or(|(first, _)| rank.is_before(first)) {
                    next = Some((rank, found));
                }
            }
            let (rank, found) = next?;
            last = Some(rank);
            Some(found)
        })
    }

    fn rank<Sh: Shape<S>>(&self, place: u32, body: &Body<S>, shape: &Sh) -> Option<Rank<S>> {
        let seen = self.seen(body.position);
        let distance = if self.is_perspective() { seen.x * seen.x + seen.y * seen.y + seen.z * seen.z } else { seen.z };
        let endless = shape.outer_radius() == S::LARGEST;
        distance.is_finite().then_some(Rank { endless, distance, place })
    }
}

/// A body's turn.
#[derive(Clone, Copy)]
struct Rank<S: Scalar> {
    endless: bool,
    distance: S::Scaled,
    place: u32,
}

impl<S: Scalar> Rank<S> {
    fn is_before(&self, other: &Self) -> bool {
        if self.endless != other.endless {
            return self.endless;
        }
        self.distance > other.distance || (self.distance == other.distance && self.place < other.place)
    }
}
