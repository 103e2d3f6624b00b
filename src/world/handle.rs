//! The name of a body in a world.

/// A body of a [`World`](super::World), for as long as it is there: a place, and how often the place was given away before.
///
/// A handle of a body that was removed is refused; it never means another one, until a place has been used 65,536 times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
    /// The handle as a number, for messages and for other languages: [`from_bits`](Self::from_bits) takes it back.
    #[inline]
    pub const fn to_bits(self) -> u32 {
        (self.generation as u32) << 16 | self.index as u32
    }

    /// The handle that gave this number. Of any other number there is no body in the world, or another one.
    #[inline]
    pub const fn from_bits(bits: u32) -> Self {
        Self { index: bits as u16, generation: (bits >> 16) as u16 }
    }
}
