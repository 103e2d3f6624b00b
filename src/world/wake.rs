//! Waking what touches what.

use super::contacts::Entry;
use super::slot::Slot;
use crate::scalar::Scalar;

/// Wakes a body: if it sleeps, its whole island; if not, the islands that it touches, as the ground of sleeping ones does.
pub(super) fn wake<S: Scalar>(slots: &mut [Slot<S>], contacts: &[Entry<S>], index: u16) {
    wake_island(slots, index);
    for entry in contacts {
        if let Some(other) = entry.key.partner(index) {
            wake_island(slots, other);
        }
    }
}

/// Wakes the island of a body that sleeps; whether there was one.
pub(super) fn wake_island<S: Scalar>(slots: &mut [Slot<S>], index: u16) -> bool {
    let island = match slots.get(usize::from(index)) {
        Some(slot) if slot.is_asleep() => slot.island,
        _ => return false,
    };
    for slot in slots.iter_mut() {
        if slot.island == island {
            slot.wake();
        }
    }
    true
}
