//! From pointers to references, after everything that a pointer can show was checked.

use carom::{Body, Scalar};
use core::mem::size_of;

use crate::number::Number;
use crate::status::carom_status::{self, *};

/// Not null and aligned for `T`.
pub fn check<T>(pointer: *const T) -> Result<(), carom_status> {
    if pointer.is_null() {
        return Err(CAROM_NULL);
    }
    if pointer.is_aligned() { Ok(()) } else { Err(CAROM_MISALIGNED) }
}

/// No byte of the one is a byte of the other.
pub fn check_apart<T, U>(one: *const T, other: *const U) -> Result<(), carom_status> {
    check_ranges_apart((one.addr(), size_of::<T>()), (other.addr(), size_of::<U>()))
}

/// The same for stretches of memory: where they begin, and how many bytes they have.
pub fn check_ranges_apart(one: (usize, usize), other: (usize, usize)) -> Result<(), carom_status> {
    let begins_in = |a: (usize, usize), b: (usize, usize)| a.0.wrapping_sub(b.0) < b.1;
    let apart = !begins_in(one, other) && !begins_in(other, one);
    if apart || one.1 == 0 || other.1 == 0 { Ok(()) } else { Err(CAROM_OVERLAP) }
}

/// A copy of what is there.
///
/// # Safety
/// A pointer that is neither null nor misaligned leads to a `T`.
pub unsafe fn read<T: Copy>(pointer: *const T) -> Result<T, carom_status> {
    check(pointer)?;
    // SAFETY: checked, and the caller's word for the rest. A copy outlives no borrow.
    Ok(unsafe { pointer.read() })
}

/// Writes a result.
///
/// # Safety
/// A pointer that is neither null nor misaligned leads to memory for a `T`, which nobody else uses.
pub unsafe fn write<T>(pointer: *mut T, value: T) -> Result<(), carom_status> {
    check(pointer)?;
    // SAFETY: checked, and the caller's word for the rest.
    unsafe { pointer.write(value) };
    Ok(())
}

/// Results of which the caller says how many there may be.
#[derive(Debug)]
pub struct List<T> {
    first: *mut T,
    capacity: usize,
    count: *mut usize,
    found: usize,
}

impl<T> List<T> {
    /// # Safety
    /// Pointers that are neither null nor misaligned lead to `capacity` objects and to a number, which nobody else uses as long as
    /// the list is there.
    pub unsafe fn new(first: *mut T, capacity: usize, count: *mut usize) -> Result<Self, carom_status> {
        check(count)?;
        if capacity > 0 {
            check(first)?;
        }
        Ok(Self { first, capacity, count, found: 0 })
    }

    /// Writes one more if there is room, and counts it in any case.
    pub fn push(&mut self, value: impl Into<T>) {
        if self.found < self.capacity {
            // SAFETY: below the capacity, by the word given to `new`.
            unsafe { self.first.wrapping_add(self.found).write(value.into()) };
        }
        self.found = self.found.saturating_add(1);
    }

    /// Writes how many there are.
    pub fn finish(self) -> Result<(), carom_status> {
        // SAFETY: checked in `new`, and the word given there.
        unsafe { write(self.count, self.found) }
    }
}

/// C's form of a body, which is the kernel's own: the same size, the same places of the public fields.
///
/// # Safety
/// `Self` and `Body<N>` have one layout, and all bits that the one may hold the other may: both hold nothing but integers and
/// floats. [`mirror!`] checks the first where it implements this.
pub unsafe trait Mirror<N: Number>: Sized {
    /// The body behind the pointer.
    ///
    /// # Safety
    /// A pointer that is neither null nor misaligned leads to a `Self` that outlives `'a` and that nobody else writes to.
    unsafe fn body<'a>(pointer: *const Self) -> Result<&'a Body<N>, carom_status> {
        check(pointer)?;
        // SAFETY: one layout, by the trait; checked, and the caller's word for the rest.
        made(unsafe { &*pointer.cast::<Body<N>>() })
    }

    /// The body behind the pointer, to be changed.
    ///
    /// # Safety
    /// A pointer that is neither null nor misaligned leads to a `Self` that outlives `'a` and that nobody else uses.
    unsafe fn body_mut<'a>(pointer: *mut Self) -> Result<&'a mut Body<N>, carom_status> {
        check(pointer)?;
        // SAFETY: as above.
        let body = unsafe { &mut *pointer.cast::<Body<N>>() };
        made(body)?;
        Ok(body)
    }

    /// Two bodies that are two.
    ///
    /// # Safety
    /// As for [`body_mut`](Self::body_mut), but that they are two is checked.
    unsafe fn pair<'a>(a: *mut Self, b: *mut Self) -> Result<[&'a mut Body<N>; 2], carom_status> {
        check(a)?;
        check(b)?;
        check_apart(a, b)?;
        // SAFETY: they share no byte.
        unsafe { Ok([Self::body_mut(a)?, Self::body_mut(b)?]) }
    }

    /// Writes a body.
    ///
    /// # Safety
    /// As for [`write`].
    unsafe fn put(pointer: *mut Self, body: Body<N>) -> Result<(), carom_status> {
        // SAFETY: one layout, by the trait; the rest is the caller's word.
        unsafe { write(pointer.cast::<Body<N>>(), body) }
    }
}

/// Bodies that C made by zeroing memory have no orientation.
fn made<N: Number>(body: &Body<N>) -> Result<&Body<N>, carom_status> {
    let zero = <N::Unit as Scalar>::ZERO;
    if body.orientation().to_array() == [zero; 4] { Err(CAROM_NOT_A_BODY) } else { Ok(body) }
}

/// Says that C's body mirrors the kernel's, if it does.
macro_rules! mirror {
    ($mirror:ty, $number:ty) => {
        const _: () = {
            use carom::Body;
            use core::mem::{align_of, offset_of, size_of};
            assert!(size_of::<$mirror>() == size_of::<Body<$number>>());
            assert!(align_of::<$mirror>() == align_of::<Body<$number>>());
            assert!(offset_of!($mirror, position) == offset_of!(Body<$number>, position));
            assert!(offset_of!($mirror, linear_velocity) == offset_of!(Body<$number>, linear_velocity));
            assert!(offset_of!($mirror, angular_velocity) == offset_of!(Body<$number>, angular_velocity));
            assert!(offset_of!($mirror, gravity_scale) == offset_of!(Body<$number>, gravity_scale));
            assert!(offset_of!($mirror, linear_damping) == offset_of!(Body<$number>, linear_damping));
            assert!(offset_of!($mirror, angular_damping) == offset_of!(Body<$number>, angular_damping));
        };
        // SAFETY: the layout is checked above; what is behind the public fields of a body are integers and floats too
        // (`src/body.rs`): an inverse mass and two tensors of numbers, an exponent, a quaternion, remainders.
        unsafe impl Mirror<$number> for $mirror {}
    };
}

#[cfg(feature = "f32")]
mirror!(crate::types::carom_f32_body, f32);
#[cfg(feature = "fixed")]
mirror!(crate::types::carom_q16_body, fixed::types::I16F16);
#[cfg(feature = "fixed")]
mirror!(crate::types::carom_q20_body, fixed::types::I12F20);
