//! The boards that QEMU emulates for us, the number types, and what each needs to be built.

use clap::ValueEnum;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use serde::{Deserialize, Serialize};
use std::fmt;

/// The compile targets of the boards, and the one of an M33 without an FPU.
pub const TARGETS: [&str; 5] = [
    "thumbv6m-none-eabi",
    "thumbv7m-none-eabi",
    "thumbv7em-none-eabihf",
    "thumbv8m.main-none-eabihf",
    "thumbv8m.main-none-eabi",
];

/// One target without an FPU and one with: what compiles for both does so for all.
pub const SAMPLE_TARGETS: [&str; 2] = ["thumbv6m-none-eabi", "thumbv7em-none-eabihf"];

/// The compile target of the RISC-V machine.
pub const RISCV_TARGET: &str = "riscv32imac-unknown-none-elf";

/// The feature sets that firmware is built with: one number type family each.
pub const FEATURES: [&str; 4] = ["f32", "f64", "fixed", "micromath"];

/// A board in QEMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Board {
    /// Cortex-M0, 16 KB of RAM, no divide, no FPU (BBC micro:bit)
    M0,
    /// Cortex-M3, no FPU (MPS2 with AN385)
    M3,
    /// Cortex-M4 with single-precision FPU (MPS2 with AN386)
    M4f,
    /// Cortex-M7 with FPU (MPS2 with AN500)
    M7,
    /// Cortex-M33 with single-precision FPU (LM3S6965 memory map)
    M33,
    /// RISC-V of 32 bits, RV32IMAC, no FPU (QEMU's virt); for `selftest`
    Rv32,
}

impl Board {
    /// Every Cortex-M board.
    pub const ALL: &'static [Board] = &[Board::M0, Board::M3, Board::M4f, Board::M7, Board::M33];

    /// What reads a Cortex-M board, where another one is no choice.
    pub fn cortex_m() -> impl TypedValueParser<Value = Board> {
        let names = Board::ALL.iter().filter_map(Board::to_possible_value);
        PossibleValuesParser::new(names).try_map(|name| Board::from_str(&name, false))
    }

    /// Its processor, for people.
    pub fn name(self) -> &'static str {
        match self {
            Board::M0 => "M0",
            Board::M3 => "M3",
            Board::M4f => "M4F",
            Board::M7 => "M7",
            Board::M33 => "M33",
            Board::Rv32 => "RV32IMAC",
        }
    }

    /// The compile target of its firmware.
    pub fn target(self) -> &'static str {
        match self {
            Board::M0 => "thumbv6m-none-eabi",
            Board::M3 => "thumbv7m-none-eabi",
            Board::M4f | Board::M7 => "thumbv7em-none-eabihf",
            Board::M33 => "thumbv8m.main-none-eabihf",
            Board::Rv32 => RISCV_TARGET,
        }
    }

    /// The emulator that knows it.
    pub fn emulator(self) -> &'static str {
        if self == Board::Rv32 { "qemu-system-riscv32" } else { "qemu-system-arm" }
    }

    /// The options that make QEMU this board. QEMU 7.2 to 10 know these names.
    pub fn qemu_machine(self) -> &'static [&'static str] {
        match self {
            Board::M0 => &["-machine", "microbit"],
            Board::M3 => &["-machine", "mps2-an385"],
            Board::M4f => &["-machine", "mps2-an386"],
            Board::M7 => &["-machine", "mps2-an500"],
            // Of the machines whose memory fits `memory.x`, this one takes the processor as an option.
            Board::M33 => &["-machine", "lm3s6965evb", "-cpu", "cortex-m33"],
            // Without firmware of its own in machine mode.
            Board::Rv32 => &["-machine", "virt", "-bios", "none"],
        }
    }
}

impl fmt::Display for Board {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Board::M0 => "m0",
            Board::M3 => "m3",
            Board::M4f => "m4f",
            Board::M7 => "m7",
            Board::M33 => "m33",
            Board::Rv32 => "rv32",
        })
    }
}

/// A number type, as examples take it after `--scalar`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Scalar {
    /// single precision
    #[value(name = "f32")]
    F32,
    /// double precision
    #[value(name = "f64")]
    F64,
    /// fixed point, 16 bits of fraction
    #[value(name = "i16f16")]
    I16F16,
    /// fixed point, 20 bits of fraction
    #[value(name = "i12f20")]
    I12F20,
    /// fixed point, 24 bits of fraction
    #[value(name = "i8f24")]
    I8F24,
    /// single precision with micromath's approximate roots
    #[value(name = "micromath")]
    Micromath,
}

impl Scalar {
    /// Every number type.
    pub const ALL: &'static [Scalar] =
        &[Scalar::F32, Scalar::F64, Scalar::I16F16, Scalar::I12F20, Scalar::I8F24, Scalar::Micromath];

    /// The cargo feature that brings it.
    pub fn feature(self) -> &'static str {
        match self {
            Scalar::F32 => "f32",
            Scalar::F64 => "f64",
            Scalar::I16F16 | Scalar::I12F20 | Scalar::I8F24 => "fixed",
            Scalar::Micromath => "micromath",
        }
    }
}

impl Scalar {
    /// Bits behind the point, in fixed point.
    pub fn fraction_bits(self) -> Option<u32> {
        match self {
            Scalar::F32 | Scalar::F64 | Scalar::Micromath => None,
            Scalar::I16F16 => Some(16),
            Scalar::I12F20 => Some(20),
            Scalar::I8F24 => Some(24),
        }
    }
}

impl fmt::Display for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Scalar::F32 => "f32",
            Scalar::F64 => "f64",
            Scalar::I16F16 => "i16f16",
            Scalar::I12F20 => "i12f20",
            Scalar::I8F24 => "i8f24",
            Scalar::Micromath => "micromath",
        })
    }
}
