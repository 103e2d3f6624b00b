//! The name of a body in a world.

/// A body of a [`World`](super::World), for as long as it is there: a place, and how often the place was given away before.
///
/// A handle of a body that was removed is refused; it never means another one, until a place has been used 65,536 times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyHandle {
    pub(super) index: u16,
    pub(super) generation: u16,
}

impl BodyHandle {
    /// The place, from 0 to the world's number of bodies: for tables of the caller's own beside the world.
    #[inline]
    pub const fn index(self) -> usize {
        self.index as usize
    }
}
