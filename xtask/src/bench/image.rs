//! Building the firmware that measures: one image for a target, an opt-level and a family of number types.

use crate::boards::Scalar;
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

/// A program that measures.
#[derive(Clone, Copy, Debug)]
pub struct Firmware {
    package: &'static str,
    /// The folder of its workspace.
    workspace: &'static str,
    feature: Option<&'static str>,
    /// What it can be asked for.
    pub scalars: &'static [Scalar],
}

/// Carom in fixed point, and in floating point.
pub const OWN: [Firmware; 2] = [
    Firmware {
        package: "carom-bench",
        workspace: ".",
        feature: Some("fixed"),
        scalars: &[Scalar::I16F16, Scalar::I12F20, Scalar::I8F24],
    },
    Firmware {
        package: "carom-bench",
        workspace: ".",
        feature: Some("float"),
        scalars: &[Scalar::F32, Scalar::Micromath],
    },
];

/// Other libraries.
pub const PEERS: Firmware = Firmware {
    package: "carom-bench-peers",
    workspace: "benches/peers",
    feature: None,
    scalars: &[Scalar::F32, Scalar::I16F16],
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
        let Recipe { firmware: Firmware { package, workspace, feature, .. }, target, opt } = self;
        let mut cargo = toolchain.cargo("rustc", target);
        cargo.arg("--manifest-path").arg(workspace::root().join(workspace).join("Cargo.toml"));
        cargo.args(["--quiet", "--locked", "--package", package, "--profile", opt.profile()]);
        cargo.args(feature.iter().flat_map(|feature| ["--features", feature]));
        let folder = toolchain.target_dir().join(target).join(opt.profile());
        let object = folder.join(format!("{package}-{}.o", feature.unwrap_or("all")));
        // The linked file, and the very object that it was linked from. `memory.x` lies in the root.
        cargo.args(["--", "--emit"]).arg(format!("link,obj={}", object.display()));
        cargo.arg(format!("-Clink-arg=-L{}", workspace::root().display()));
        process::run(&mut cargo).with_context(|| format!("building {self}"))?;
        Ok(Image { elf: folder.join(package), object })
    }
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Recipe { firmware: Firmware { package, feature, .. }, target, opt } = self;
        write!(f, "{package} {} for {target} at opt-level {opt}", feature.unwrap_or_default())
    }
}
