//! Which bodies meet which.

/// Two bodies meet where the groups of each are among those that the other meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Filter {
    /// The groups that the body is in, one bit each.
    pub groups: u16,
    /// The groups that it meets.
    pub meets: u16,
}

impl Filter {
    /// In the first group, meets all.
    pub const ALL: Self = Self { groups: 1, meets: u16::MAX };

    /// Whether the two meet.
    #[inline(always)]
    pub const fn lets_meet(self, other: Self) -> bool {
        self.groups & other.meets != 0 && other.groups & self.meets != 0
    }
}

impl Default for Filter {
    fn default() -> Self {
        Self::ALL
    }
}
