//! Building the firmware that measures: one image for a target, an opt-level and a family of number types.

use crate::process;
use crate::toolchain::Toolchain;
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

/// What an image is built from, and for.
#[derive(Clone, Copy, Debug)]
pub struct Recipe {
    pub target: &'static str,
    pub feature: &'static str,
    pub opt: Opt,
}

/// A firmware, linked and not yet linked.
pub struct Image {
    pub elf: PathBuf,
    /// All code after link-time optimisation, in one object file.
    pub object: PathBuf,
}

const PACKAGE: &str = "carom-bench";

impl Recipe {
    /// Compiles it. The files stay what they are until the same package is built for the same target and opt-level.
    pub fn build(self, toolchain: &Toolchain) -> Result<Image> {
        let Recipe { target, feature, opt } = self;
        let mut cargo = toolchain.cargo("rustc", target);
        cargo.args(["--quiet", "--package", PACKAGE, "--profile", opt.profile(), "--features", feature]);
        let folder = toolchain.target_dir().join(target).join(opt.profile());
        let object = folder.join(format!("{PACKAGE}-{feature}.o"));
        // The linked file, and the very object that it was linked from.
        cargo.args(["--", "--emit"]).arg(format!("link,obj={}", object.display()));
        process::run(&mut cargo).with_context(|| format!("building {self}"))?;
        Ok(Image { elf: folder.join(PACKAGE), object })
    }
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} opt-level {}", self.target, self.feature, self.opt)
    }
}
