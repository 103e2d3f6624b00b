//! The board's side of the shim: semihosting, the debug channel that QEMU and debug probes serve.

use super::Exit;
use super::text::{FileError, Line};
use core::cell::UnsafeCell;
use core::fmt::{self, Write};
use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

// The same interface on two families of processors.
#[cfg(target_arch = "arm")]
use cortex_m_semihosting::{debug, nr, syscall, syscall1};
#[cfg(target_arch = "riscv32")]
use riscv_semihosting::{debug, nr, syscall, syscall1};

/// Longest command line and longest path, in bytes, with the zero byte behind it. `cargo xtask qemu` knows it too.
const NAME: usize = 256;

/// What semihosting calls answer on failure: -1.
const FAILED: usize = usize::MAX;

/// Ends the program; QEMU exits with status 0 or 1.
pub fn exit(exit: Exit) -> ! {
    loop {
        debug::exit(match exit {
            Exit::Success => debug::EXIT_SUCCESS,
            Exit::Failure => debug::EXIT_FAILURE,
        });
    }
}

/// The program's arguments, without its name.
pub fn args() -> impl Iterator<Item = &'static str> {
    static COMMAND_LINE: Shared<[u8; NAME]> = Shared(UnsafeCell::new([0; NAME]));
    static READ: AtomicBool = AtomicBool::new(false);

    if !READ.load(Ordering::Relaxed) {
        // SAFETY: one core, no interrupt handler that comes back: nobody else looks at the buffer now, and references
        // to it are handed out only below, after its one and only filling.
        let buffer = unsafe { &mut *COMMAND_LINE.0.get() };
        let mut block = [buffer.as_mut_ptr() as usize, NAME];
        // SAFETY: SYS_GET_CMDLINE takes the address of a block with the address and the size of a buffer, writes the text
        // into the buffer and its length into the block.
        // When it fails (a debug probe may know of no command line), the buffer stays empty: no arguments.
        unsafe { syscall1(nr::GET_CMDLINE, block.as_mut_ptr() as usize) };
        READ.store(true, Ordering::Relaxed);
    }
    // SAFETY: the buffer is never written again, see above.
    let buffer: &'static [u8] = unsafe { &*COMMAND_LINE.0.get() };
    let text = buffer.split(|&byte| byte == 0).next().unwrap_or_default();
    let text = core::str::from_utf8(text).unwrap_or_default();
    text.split_ascii_whitespace().skip(1)
}

/// `println!` without the macro.
pub fn println_fmt(arguments: fmt::Arguments<'_>) {
    let mut output = Output(Line::new());
    let _ = output.write_fmt(arguments);
    output.byte(b'\n');
    output.flush();
}

/// `print!` without the macro.
pub fn print_fmt(arguments: fmt::Arguments<'_>) {
    let mut output = Output(Line::new());
    let _ = output.write_fmt(arguments);
    output.flush();
}

/// Standard output, gathered so that a line is one semihosting call.
struct Output(Line);

impl Output {
    fn byte(&mut self, byte: u8) {
        if !self.0.push(byte) {
            self.flush();
            self.0.push(byte);
        }
    }

    fn flush(&mut self) {
        // The handle of standard output once it is open. Load and store are all the atomics that an M0 has.
        static HANDLE: AtomicUsize = AtomicUsize::new(FAILED);

        let mut handle = HANDLE.load(Ordering::Relaxed);
        if handle == FAILED {
            handle = open_handle(":tt", nr::open::W_TRUNC).unwrap_or(FAILED);
            HANDLE.store(handle, Ordering::Relaxed);
        }
        // Output that cannot be written must not look like a good run.
        if write_all(handle, self.0.bytes()).is_err() {
            exit(Exit::Failure);
        }
        self.0.clear();
    }
}

impl fmt::Write for Output {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        text.bytes().for_each(|byte| self.byte(byte));
        Ok(())
    }
}

/// An open file of the machine at the other end of the debug channel.
pub struct File(usize);

impl File {
    pub fn open(path: &str) -> Result<Self, FileError> {
        open_handle(path, nr::open::R_BINARY).map(File).ok_or(FileError::Open)
    }

    pub fn create(path: &str) -> Result<Self, FileError> {
        open_handle(path, nr::open::W_TRUNC_BINARY).map(File).ok_or(FileError::Open)
    }

    /// Reads some bytes; none means the end of the file.
    pub fn read(&mut self, buffer: &mut [u8]) -> Result<usize, FileError> {
        let block = [self.0, buffer.as_mut_ptr() as usize, buffer.len()];
        // SAFETY: SYS_READ takes a handle, an address and a size, and writes inside `buffer`.
        let not_read = unsafe { syscall(nr::READ, &block) };
        buffer.len().checked_sub(not_read).ok_or(FileError::Read)
    }

    pub fn write_all(&mut self, bytes: &[u8]) -> Result<(), FileError> {
        write_all(self.0, bytes)
    }
}

impl Drop for File {
    fn drop(&mut self) {
        let block = [self.0];
        // SAFETY: SYS_CLOSE takes a handle, this one is open.
        unsafe { syscall(nr::CLOSE, &block) };
    }
}

fn open_handle(path: &str, mode: usize) -> Option<usize> {
    // The path goes over with a zero byte behind it, which the length does not count.
    let mut name = [0; NAME];
    let (room, _zero) = name.split_at_mut_checked(NAME - 1)?;
    room.get_mut(..path.len())?.iter_mut().zip(path.bytes()).for_each(|(slot, byte)| *slot = byte);
    let block = [name.as_ptr() as usize, mode, path.len()];
    // SAFETY: SYS_OPEN takes the address of a zero-terminated name, a mode and the name's length.
    let handle = unsafe { syscall(nr::OPEN, &block) };
    (handle != FAILED).then_some(handle)
}

fn write_all(handle: usize, mut bytes: &[u8]) -> Result<(), FileError> {
    while !bytes.is_empty() {
        let block = [handle, bytes.as_ptr() as usize, bytes.len()];
        // SAFETY: SYS_WRITE takes a handle, an address and a size, and only reads `bytes`.
        let left = unsafe { syscall(nr::WRITE, &block) };
        // The answer is the number of bytes that were not written.
        let written = bytes.len().checked_sub(left).ok_or(FileError::Write)?;
        if written == 0 {
            return Err(FileError::Write);
        }
        bytes = bytes.get(written..).unwrap_or_default();
    }
    Ok(())
}

/// Says one line, without any formatting, and ends the run with a failure.
fn abort(line: &str) -> ! {
    if let Some(handle) = open_handle(":tt", nr::open::W_TRUNC) {
        let _ = write_all(handle, line.as_bytes());
    }
    exit(Exit::Failure)
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    abort("panic\n")
}

// What faults is most often a stack that has grown out of the RAM: the handler begins with a fresh one.
#[cfg(target_arch = "arm")]
core::arch::global_asm!(
    ".section .HardFault.board, \"ax\"",
    ".global HardFault",
    ".type HardFault, %function",
    ".thumb_func",
    "HardFault:",
    "ldr r0, =_stack_start",
    "mov sp, r0",
    "bl {hard_fault}",
    ".pool",
    ".size HardFault, . - HardFault",
    hard_fault = sym hard_fault,
);

#[cfg(target_arch = "arm")]
extern "C" fn hard_fault() -> ! {
    abort("hard fault (did the stack outgrow the RAM?)\n")
}

// SAFETY: the handler only talks to the debug channel and never returns.
#[cfg(target_arch = "arm")]
#[cortex_m_rt::exception]
unsafe fn DefaultHandler(_: i16) -> ! {
    abort("unexpected exception\n")
}

/// Whatever riscv-rt's vector finds no other handler for.
// SAFETY: the name that riscv-rt's linker script looks for, once in a firmware; it never returns.
#[cfg(target_arch = "riscv32")]
#[unsafe(export_name = "ExceptionHandler")]
extern "C" fn exception() -> ! {
    abort("unexpected exception (did the stack outgrow the RAM?)\n")
}

/// A static that the shim fills once, see its uses.
struct Shared<T>(UnsafeCell<T>);

// SAFETY: a board runs one thread on one core, and no interrupt handler touches these.
unsafe impl<T> Sync for Shared<T> {}
