//! Building examples as firmware.

use crate::cases;
use crate::process;
use crate::toolchain::Toolchain;
use crate::workspace;
use anyhow::Result;
use clap::ValueEnum;
use std::fmt;
use std::path::PathBuf;

/// How firmware is optimised and checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Profile {
    /// what a product would ship
    Release,
    /// release with overflow checks and debug assertions
    Checked,
}

impl fmt::Display for Profile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Profile::Release => "release",
            Profile::Checked => "checked",
        })
    }
}

/// What firmware is built for, and with which number types.
#[derive(Clone, Copy, Debug)]
pub struct Build {
    pub target: &'static str,
    pub feature: &'static str,
    pub profile: Profile,
}

impl Build {
    /// Compiles the examples in one go and returns their ELF files, in the same order. The files stay what they are
    /// until the same examples are built for the same target again.
    pub fn run(self, toolchain: &Toolchain, examples: &[String]) -> Result<Vec<PathBuf>> {
        let Build { target, feature, profile } = self;
        let mut cargo = toolchain.cargo("build", target);
        cargo.args(["--quiet", "--no-default-features", "--features", &cases::features(feature, examples)]);
        cargo.args(["--profile", &profile.to_string()]);
        for example in examples {
            workspace::check_example(example)?;
            cargo.args(["--example", example]);
        }
        process::run_watched(&mut cargo, &format!("compiling {} in {feature} for {target}", examples.join(", ")))?;
        let folder = toolchain.target_dir().join(target).join(profile.to_string()).join("examples");
        Ok(examples.iter().map(|example| folder.join(example)).collect())
    }
}

impl fmt::Display for Build {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&format!("{} {} {}", self.target, self.feature, self.profile))
    }
}
