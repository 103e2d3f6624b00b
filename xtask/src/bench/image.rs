//! Building the firmware that measures: one image for a target, an opt-level and a family of number types.

use crate::boards::{Board, Scalar};
use crate::process;
use crate::toolchain::Toolchain;
use crate::workspace;
use anyhow::{Context, Result};
use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::path::PathBuf;

/// How far the compiler goes, and for what.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Opt {
    /// speed
    #[value(name = "3")]
    #[serde(rename = "3")]
    Speed,
    /// size
    S,
    /// size above all
    Z,
}

impl Opt {
    pub const ALL: [Opt; 3] = [Opt::Speed, Opt::S, Opt::Z];

    /// The cargo profile.
    pub fn profile(self) -> &'static str {
        match self {
            Opt::Speed => "release",
            Opt::S => "release-s",
            Opt::Z => "release-z",
        }
    }
}

impl fmt::Display for Opt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Opt::Speed => "3",
            Opt::S => "s",
            Opt::Z => "z",
        })
    }
}

/// What a program measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Part {
    /// single operations on single impacts
    Operations,
    /// whole steps of worlds
    World,
}

/// A program that measures.
#[derive(Clone, Copy, Debug)]
pub struct Firmware {
    pub part: Part,
    package: &'static str,
    /// The name of the program.
    binary: &'static str,
    /// A program of the same package that does the same and measures nothing, to be weighed.
    plain: Option<&'static str>,
    /// The folder of its workspace.
    workspace: &'static str,
    /// Takes more RAM than the micro:bit has, where there is more.
    large: bool,
    feature: Option<&'static str>,
    /// What it can be asked for.
    pub scalars: &'static [Scalar],
    /// Where it runs.
    pub boards: &'static [Board],
}

/// Carom's operations in fixed point.
const FIXED: Firmware = Firmware {
    part: Part::Operations,
    package: "carom-bench",
    binary: "carom-bench",
    plain: None,
    workspace: ".",
    large: false,
    feature: Some("fixed"),
    scalars: &[Scalar::I16F16, Scalar::I12F20, Scalar::I8F24],
    boards: Board::ALL,
};

/// Carom's worlds in fixed point.
const WORLD_FIXED: Firmware = Firmware {
    part: Part::World,
    package: "carom-bench-world",
    binary: "carom-bench-world",
    plain: Some("carom-bench-spheres"),
    large: true,
    scalars: &[Scalar::I16F16],
    ..FIXED
};

/// Carom's operations, in floating point too.
pub const OWN: [Firmware; 2] =
    [FIXED, Firmware { feature: Some("float"), scalars: &[Scalar::F32, Scalar::Micromath], ..FIXED }];

/// Carom's worlds, in floating point too where there is an FPU.
pub const WORLD: [Firmware; 2] = [
    WORLD_FIXED,
    Firmware {
        feature: Some("float"),
        scalars: &[Scalar::F32],
        boards: &[Board::M4f, Board::M7, Board::M33],
        ..WORLD_FIXED
    },
];

/// Other libraries' operations.
pub const PEERS: Firmware = Firmware {
    package: "carom-bench-peers",
    binary: "carom-bench-peers",
    workspace: "benches/peers",
    feature: None,
    scalars: &[Scalar::F32, Scalar::I16F16],
    ..FIXED
};

/// Other libraries' worlds, on a board with an FPU and on one without.
pub const PEERS_WORLD: Firmware = Firmware {
    part: Part::World,
    binary: "carom-bench-peers-world",
    large: true,
    feature: Some("world"),
    scalars: &[Scalar::F32],
    boards: &[Board::M3, Board::M4f],
    ..PEERS
};

/// What an image is built from, and for.
#[derive(Clone, Copy, Debug)]
pub struct Recipe {
    pub firmware: Firmware,
    pub target: &'static str,
    pub opt: Opt,
}

/// A firmware, linked and not yet linked.
pub struct Image {
    pub elf: PathBuf,
    /// All code after link-time optimisation, in one object file.
    pub object: PathBuf,
}

impl Recipe {
    /// Compiles it. The files stay what they are until the same package is built for the same target and opt-level.
    pub fn build(self, toolchain: &Toolchain) -> Result<Image> {
        self.build_binary(toolchain, self.firmware.binary)
    }

    /// The firmware to be weighed, where there is one.
    pub fn build_plain(self, toolchain: &Toolchain) -> Result<Option<PathBuf>> {
        self.firmware.plain.map(|binary| Ok(self.build_binary(toolchain, binary)?.elf)).transpose()
    }

    fn build_binary(self, toolchain: &Toolchain, binary: &str) -> Result<Image> {
        let Recipe { firmware: Firmware { package, workspace, large, feature, .. }, target, opt } = self;
        let mut cargo = toolchain.cargo("rustc", target);
        cargo.arg("--manifest-path").arg(workspace::root().join(workspace).join("Cargo.toml"));
        cargo.args(["--quiet", "--locked", "--package", package, "--bin", binary]);
        cargo.args(["--profile", opt.profile()]);
        cargo.args(feature.iter().flat_map(|feature| ["--features", feature]));
        let folder = toolchain.target_dir().join(target).join(opt.profile());
        let object = folder.join(format!("{binary}-{}.o", feature.unwrap_or("all")));
        // The linked file, and the very object that it was linked from.
        cargo.args(["--", "--emit"]).arg(format!("link,obj={}", object.display()));
        // `memory.x` lies in the root. It says what the micro:bit has; the others have 64 KB of RAM at least.
        cargo.arg(format!("-Clink-arg=-L{}", workspace::root().display()));
        if large && target != Board::M0.target() {
            cargo.arg("-Clink-arg=--defsym=_stack_start=0x20010000");
        }
        process::run(&mut cargo).with_context(|| format!("building {self}"))?;
        Ok(Image { elf: folder.join(binary), object })
    }
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Recipe { firmware: Firmware { package, feature, .. }, target, opt } = self;
        write!(f, "{package} {} for {target} at opt-level {opt}", feature.unwrap_or_default())
    }
}
