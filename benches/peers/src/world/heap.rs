//! The heap of those who allocate.

// Brings the critical section that the heap needs.
use cortex_m as _;
use embedded_alloc::LlffHeap;

#[global_allocator]
static HEAP: LlffHeap = LlffHeap::empty();

/// From the end of statics; the stack begins at 64 KB and has what is left.
const SIZE: usize = 44 * 1024;

/// Once, before anybody allocates.
pub fn start() {
    // SAFETY: it lies between statics and stack, and this is called once.
    unsafe { HEAP.init(cortex_m_rt::heap_start().addr(), SIZE) }
}

/// Bytes in use.
pub fn used() -> usize {
    HEAP.used()
}
