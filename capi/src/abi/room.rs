//! Worlds in the caller's memory.
//!
//! The memory begins with a head that says what the rest is: a tag by which memory that was never initialised, or holds a world of
//! another number type, is told apart, and the function that knows the capacity. So one function steps worlds of all
//! capacities, and only those capacities are linked whose `init` is called.

use carom::World;
use carom::solver::Settings;
use core::ffi::c_void;

use super::pointer::check;
use crate::number::Number;
use crate::shape::Set;
use crate::status::carom_status::{self, *};
use crate::world::AnyWorld;

/// What the memory of a world begins with.
#[repr(C)]
#[allow(missing_debug_implementations)]
pub struct Head<N: Number> {
    tag: u32,
    find: unsafe fn(*mut Head<N>) -> *mut dyn AnyWorld<N>,
    settings: Settings<N>,
}

/// The memory of a world.
#[repr(C)]
#[allow(missing_debug_implementations)]
pub struct Room<N: Number, Sh, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize> {
    head: Head<N>,
    world: World<N, Sh, BODIES, MANIFOLDS, POINTS>,
}

/// How memory for a world has to be aligned: as that of `uint64_t`, which is what it is declared as.
pub(super) const ALIGN: usize = align_of::<u64>();

#[allow(private_bounds)]
impl<N: Number, Sh: Set<N> + 'static, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>
    Room<N, Sh, BODIES, MANIFOLDS, POINTS>
{
    /// Makes a world of `SIZE` bytes, the number in the header, in the caller's memory.
    ///
    /// # Safety
    /// Memory that is neither null nor misaligned has `size` bytes, which nobody else uses.
    pub unsafe fn init<const SIZE: usize>(
        memory: *mut c_void,
        size: usize,
        settings: Settings<N>,
    ) -> Result<*mut Head<N>, carom_status> {
        const {
            assert!(
                size_of::<Self>() <= SIZE,
                "the size in the header is too small: see `cargo test -p carom-capi sizes`"
            );
            assert!(align_of::<Self>() <= ALIGN);
        }
        check(memory.cast::<u64>())?;
        if size < SIZE {
            return Err(CAROM_TOO_SMALL);
        }
        let room = memory.cast::<Self>();
        // SAFETY: `memory` is aligned for a u64 and so for a room, and has room for it; nothing is read. The head comes last,
        // field by field so that the world, which is zeros, does not go over the stack.
        unsafe {
            (&raw mut (*room).world).write(const { World::new() });
            (&raw mut (*room).head).write(Head { tag: N::TAG, find: Self::find, settings });
        }
        Ok(room.cast())
    }

    /// The world behind a head.
    ///
    /// # Safety
    /// The head is that of a room of this very type.
    unsafe fn find(head: *mut Head<N>) -> *mut dyn AnyWorld<N> {
        let room = head.cast::<Self>();
        // SAFETY: it is the room's first field, and the pointer came with the whole of the memory.
        unsafe { &raw mut (*room).world }
    }
}

/// A world and its settings.
pub(super) type Inside<'a, N> = (&'a mut dyn AnyWorld<N>, &'a mut Settings<N>);

/// The world in that memory.
///
/// # Safety
/// A pointer that is neither null nor misaligned leads to memory that begins with four bytes that may be read; where these are the
/// number type's tag, [`Room::init`] has made a world there, which outlives `'a` and which nobody else uses.
pub(super) unsafe fn enter<'a, N: Number, T>(world: *mut T) -> Result<Inside<'a, N>, carom_status> {
    check(world.cast::<u64>())?;
    let head = world.cast::<Head<N>>();
    // SAFETY: the caller's word; the tag is at the beginning.
    unsafe {
        if world.cast::<u32>().read() != N::TAG {
            return Err(CAROM_NOT_A_WORLD);
        }
        let find = (*head).find;
        // The world and the settings are different fields.
        Ok((&mut *find(head), &mut (*head).settings))
    }
}
