//! `cargo xtask capi`: carom for C and C++.

mod archive;
mod consumer;
mod gcc;
mod guide;
mod header;
mod package;
#[path = "../../examples/scenes/pins.rs"]
mod pins;
pub mod stage;

use crate::boards::TARGETS;
use crate::setup;
use anyhow::Result;
use clap::Subcommand;
use clap::builder::PossibleValuesParser;
use std::path::PathBuf;

/// What to do.
#[derive(Subcommand)]
pub enum Action {
    /// Write capi/include/carom.h anew from capi/src
    Header {
        /// Write nothing: fail where the header is stale
        #[arg(long)]
        check: bool,
    },
    /// Build libcarom.a, and say where it is
    Build {
        /// The processor; without it, this machine
        #[arg(long, value_parser = PossibleValuesParser::new(TARGETS))]
        target: Option<String>,
        /// Install what is missing without asking
        #[arg(long)]
        yes: bool,
    },
    /// Install the library for this machine, and for boards, with a CMake package and a pkg-config file
    Install {
        /// The folder that gets include/ and lib/
        #[arg(long)]
        prefix: PathBuf,
        /// A processor to install it for, too; may be given several times
        #[arg(long, value_parser = PossibleValuesParser::new(TARGETS))]
        target: Vec<String>,
        /// Install what is missing without asking
        #[arg(long)]
        yes: bool,
    },
}

/// Does it.
pub fn run(action: Action) -> Result<()> {
    match action {
        Action::Header { check: true } => header::check(),
        Action::Header { check: false } => header::write(),
        Action::Build { target, yes } => {
            let archive = match target {
                Some(target) => archive::build(&setup::ensure_target(&target, yes)?, &target)?,
                None => archive::build_for_host()?,
            };
            println!("{}", archive.display());
            Ok(())
        }
        Action::Install { prefix, target, yes } => {
            let toolchains =
                target.iter().map(|target| setup::ensure_target(target, yes)).collect::<Result<Vec<_>>>()?;
            println!("installing (each archive is compiled first, some minutes):");
            package::install(&prefix, toolchains.last().map(|toolchain| (toolchain, &target[..])))
        }
    }
}
