//! The memory of each board's chip, from its data sheet, and what a firmware makes of it. `memory.x` is not asked: it may be wrong.

use anyhow::{Context, Result, bail};
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags, SectionKind, elf};
use std::fmt;
use std::ops::Range;

/// A board and its chip.
pub struct Part {
    /// Its folder in `examples/boards`.
    pub board: &'static str,
    pub target: &'static str,
    /// The number types that are built: its default, and what nothing else builds.
    pub features: &'static [&'static str],
    flash: Range<u64>,
    pub ram: Range<u64>,
    /// Where the core looks for its first stack pointer and its first instruction.
    vectors: u64,
    start: Start,
    /// Whether QEMU has a chip that runs it.
    pub emulated: bool,
}

/// What the chip wants before it looks there.
enum Start {
    Nothing,
    /// A program of 256 bytes at the start of the flash.
    Boot2,
    /// A block that begins with this word, in the first 4 KB of the flash.
    Block(u32),
}

const KB: u64 = 1024;

pub const PARTS: [Part; 4] = [
    Part {
        board: "microbit-v2",
        target: "thumbv7em-none-eabihf",
        features: &["f32"],
        flash: 0..512 * KB,
        ram: 0x2000_0000..0x2000_0000 + 128 * KB,
        vectors: 0,
        start: Start::Nothing,
        emulated: false,
    },
    Part {
        board: "pico",
        target: "thumbv6m-none-eabi",
        features: &["fixed", "f32"],
        flash: 0x1000_0000..0x1000_0000 + 2048 * KB,
        // The four striped banks, and the two small ones behind them.
        ram: 0x2000_0000..0x2000_0000 + 264 * KB,
        vectors: 0x1000_0100,
        start: Start::Boot2,
        emulated: false,
    },
    Part {
        board: "pico2",
        target: "thumbv8m.main-none-eabihf",
        features: &["f32"],
        flash: 0x1000_0000..0x1000_0000 + 4096 * KB,
        ram: 0x2000_0000..0x2000_0000 + 520 * KB,
        vectors: 0x1000_0000,
        start: Start::Block(0xffff_ded3),
        emulated: false,
    },
    Part {
        board: "stm32f4-discovery",
        target: "thumbv7em-none-eabihf",
        features: &["f32", "fixed"],
        flash: 0x0800_0000..0x0800_0000 + 1024 * KB,
        ram: 0x2000_0000..0x2000_0000 + 128 * KB,
        vectors: 0x0800_0000,
        start: Start::Nothing,
        emulated: true,
    },
];

/// Bytes of memory that a firmware takes, and what the stack is left.
#[derive(Debug, PartialEq, Eq)]
pub struct Sizes {
    flash: u64,
    ram: u64,
    stack: u64,
}

impl fmt::Display for Sizes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { flash, ram, stack } = self;
        write!(f, "{flash:>7} bytes of flash, {ram:>5} of RAM, {stack:>6} left for the stack")
    }
}

impl Part {
    /// What the firmware takes, if it fits and the chip would start it.
    pub fn weigh(&self, bytes: &[u8]) -> Result<Sizes> {
        let file = object::File::parse(bytes).context("not an ELF file")?;
        let (mut flash, mut ram, mut top) = (0, 0, self.ram.start);
        for section in file.sections().filter(takes_memory) {
            let place = section.address()..section.address() + section.size();
            let stored = section.kind() != SectionKind::UninitializedData;
            if within(&place, &self.ram) {
                ram += section.size();
                top = top.max(place.end);
            } else if !(stored && within(&place, &self.flash)) {
                let name = section.name().unwrap_or_default();
                bail!("section {name} at {:#x} to {:#x} lies in no memory of {}", place.start, place.end, self.board);
            }
            if stored {
                flash += section.size();
            }
        }
        if flash > self.flash.end - self.flash.start {
            bail!("{flash} bytes do not fit the flash of {}", self.board);
        }
        let stack =
            file.symbols().find(|symbol| symbol.name() == Ok("_stack_start")).context("no _stack_start")?.address();
        if !(top..=self.ram.end).contains(&stack) {
            bail!("the stack begins at {stack:#x}, beside the RAM that is left");
        }
        self.starts(&file, stack)?;
        Ok(Sizes { flash, ram, stack: stack - top })
    }

    /// Whether the chip finds what it looks for after a reset.
    fn starts(&self, file: &object::File<'_>, stack: u64) -> Result<()> {
        let first = word(file, self.vectors).context("no vector table where the chip looks for it")?;
        let reset = word(file, self.vectors + 4).context("no reset vector")?;
        if u64::from(first) != stack || reset & 1 == 0 || !self.flash.contains(&u64::from(reset)) {
            bail!("the vector table begins with {first:#x} and {reset:#x}");
        }
        let found = match self.start {
            Start::Nothing => true,
            Start::Boot2 => file.sections().any(|one| one.address() == self.flash.start && one.size() == 256),
            Start::Block(mark) => {
                (self.flash.start..self.flash.start + 4 * KB).step_by(4).any(|at| word(file, at) == Some(mark))
            }
        };
        if !found {
            bail!("the chip's ROM does not find what it wants at the start of the flash");
        }
        Ok(())
    }
}

/// Whether a section is there when the firmware runs.
fn takes_memory(section: &object::Section<'_, '_>) -> bool {
    let allocated = matches!(section.flags(), SectionFlags::Elf { sh_flags, .. } if sh_flags.contains(elf::SHF_ALLOC));
    allocated && section.size() > 0
}

fn within(place: &Range<u64>, memory: &Range<u64>) -> bool {
    place.start >= memory.start && place.end <= memory.end
}

/// What is stored at an address.
fn word(file: &object::File<'_>, address: u64) -> Option<u32> {
    let bytes =
        file.sections().filter(takes_memory).find_map(|section| section.data_range(address, 4).ok().flatten())?;
    Some(u32::from_le_bytes(bytes.try_into().ok()?))
}
