//! Memory for what is too large to be made on the stack and moved.

use core::cell::UnsafeCell;

/// Bytes of an arena, all zero at first.
#[repr(align(8))]
pub struct Arena<const SIZE: usize>(UnsafeCell<[u8; SIZE]>);

// SAFETY: firmware that measures has one thread and no interrupts.
unsafe impl<const SIZE: usize> Sync for Arena<SIZE> {}

impl<const SIZE: usize> Arena<SIZE> {
    pub const fn new() -> Self {
        Self(UnsafeCell::new([0; SIZE]))
    }

    /// A value of which every bit is zero, in place.
    ///
    /// # Safety
    /// All bits zero is a value of `T`, and nobody uses what was given out before.
    #[expect(clippy::mut_from_ref)]
    pub unsafe fn zeroed<T>(&self) -> &mut T {
        const { assert!(size_of::<T>() <= SIZE && align_of::<T>() <= 8, "the arena is too small") };
        let place = self.0.get().cast::<T>();
        // SAFETY: the arena is large enough and aligned; the rest is the caller's promise.
        unsafe {
            place.write_bytes(0, 1);
            &mut *place
        }
    }
}
