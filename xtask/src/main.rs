//! carom's driver: `cargo xtask COMMAND`.

mod bench;
mod boards;
mod capi;
mod cases;
mod demo;
mod drawing;
mod elf;
mod firmware;
mod guide;
mod host;
mod licences;
mod lint;
mod new;
mod process;
mod qemu;
mod setup;
mod test;
mod toolchain;
mod view;
mod workspace;

use anyhow::Result;
use boards::{Board, Scalar};
use clap::{Parser, Subcommand};
use firmware::{Build, Profile};
use new::Scene;
use std::path::PathBuf;
use std::process::{ExitCode, ExitStatus};
use std::time::Duration;

/// Set up, run and test carom's firmware.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
struct Cli {
    #[command(subcommand)]
    command: Action,
}

#[derive(Subcommand)]
enum Action {
    /// Install what is missing: QEMU and the Rust targets of the boards
    ///
    /// Says what it will install and why, and asks first when it runs in a terminal. QEMU comes from the system's
    /// package manager. The targets come from rustup; where rustup is not there or fails, from Debian's packages
    /// rustc-web, cargo-web, rust-web-src and lld, out of which `core` is built into a private folder under target/.
    /// The environment variable CAROM_THUMB=debian picks Debian's way outright. The other commands do this by
    /// themselves.
    Setup(Yes),
    /// Throw dice on two boards and on this machine, and compare them bit for bit
    Demo(Yes),
    /// Run everything: host tests in all feature sets, every example on every board, ELF checks, the page in a browser
    ///
    /// The measured data sets that are not part of the repository are found through the environment variable
    /// CAROM_VALIDATION; without it, what needs them is not run, and is named.
    Test {
        /// Only this stage
        #[arg(long, value_name = "STAGE")]
        only: Option<test::Stage>,
        /// Remove what a stage has built once it has passed, where the disk is small
        #[arg(long)]
        tidy: bool,
        #[command(flatten)]
        yes: Yes,
    },
    /// Begin firmware of your own: a marble maze in a folder outside this one, which `cargo run --release` runs in QEMU
    New {
        /// A folder that is empty or not there yet
        folder: PathBuf,
        /// The board
        #[arg(long, default_value_t = Board::M0, value_parser = Board::cortex_m())]
        board: Board,
        /// The number type; on boards with an FPU f32, else i12f20
        #[arg(long, value_parser = new::scalars())]
        scalar: Option<Scalar>,
        /// No maze: a floor and a ball
        #[arg(long)]
        empty: bool,
        #[command(flatten)]
        yes: Yes,
    },
    /// Run an example on a board in QEMU
    ///
    /// The firmware is given `EXAMPLE --scalar SCALAR ARGS`. The status is the firmware's.
    Qemu {
        /// An example, `quickstart` say
        example: String,
        /// The board
        #[arg(long)]
        board: Board,
        /// The number type
        #[arg(long, default_value_t = Scalar::F32)]
        scalar: Scalar,
        /// Seconds after which QEMU is stopped
        #[arg(long, default_value_t = 120, value_name = "SECONDS")]
        timeout: u64,
        #[command(flatten)]
        yes: Yes,
        /// Arguments for the example
        #[arg(last = true)]
        args: Vec<String>,
    },
    /// Run an example on this machine, built with the same feature as for a board
    Host {
        /// An example, `quickstart` say
        example: String,
        /// The number type
        #[arg(long, default_value_t = Scalar::F32)]
        scalar: Scalar,
        /// Seconds after which it is stopped
        #[arg(long, default_value_t = 120, value_name = "SECONDS")]
        timeout: u64,
        /// Arguments for the example
        #[arg(last = true)]
        args: Vec<String>,
    },
    /// Show an example's run: a page with a replay in three dimensions, or a picture
    ///
    /// Runs it with --trace, on a board in QEMU or on this machine, and writes one page that needs no network: the replay with
    /// contacts and impulses, energy, momentum, and with --compare a ghost in another number type with its distance.
    View(view::Options),
    /// Draw thrown dice on a display of 240 x 240 pixels, on a board in QEMU or on this machine, and keep the frame as a PNG
    Draw(drawing::Options),
    /// Check linked firmware: no panics, no allocator, no 64-bit division, no floats in fixed point
    ///
    /// Follows the calls from every function of carom, and from every `kernel_...` function of an example. Without
    /// options it builds and checks every example for every target and number type, and most of them with every check on for two targets.
    Elf(elf::Options),
    /// Count what carom's operations cost on the boards: instructions, flash, stack
    ///
    /// Builds release firmware at opt-level 3, s and z and runs it in QEMU, which counts instructions exactly.
    Bench(bench::Options),
    /// Draw the tables and the chart of the documentation from the snapshot of the figures, without measuring
    Chart,
    /// Make the guide of docs/ a book, and check the links of all pages
    Guide,
    /// The C library: its header, its archives, its package
    #[command(subcommand)]
    Capi(capi::Action),
    /// Run clippy for the boards (the host has plain `cargo clippy`)
    Lint(Yes),
    /// Check the licences of what the library depends on, in all its features, against deny.toml
    Licences,
}

#[derive(clap::Args)]
struct Yes {
    /// Install what is missing without asking
    #[arg(long)]
    yes: bool,
}

fn main() -> ExitCode {
    match run(Cli::parse().command) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(action: Action) -> Result<ExitCode> {
    match action {
        Action::Setup(Yes { yes }) => {
            setup::ensure(yes)?;
            println!("setup: all there");
        }
        Action::Demo(Yes { yes }) => demo::run(yes)?,
        Action::Test { only, tidy, yes: Yes { yes } } => test::run(only, yes, tidy)?,
        Action::New { folder, board, scalar, empty, yes: Yes { yes } } => {
            new::run(&folder, board, scalar, if empty { Scene::Ball } else { Scene::Maze }, yes)?;
        }
        Action::Qemu { example, board, scalar, timeout, yes: Yes { yes }, args } => {
            workspace::check_example(&example)?;
            cases::check_room(&example, board)?;
            let toolchain = setup::ensure_for(board, yes)?;
            let build = Build { target: board.target(), feature: scalar.feature(), profile: Profile::Release };
            let elf = &build.run(&toolchain, std::slice::from_ref(&example))?[0];
            let limit = Duration::from_secs(timeout);
            let run = qemu::Run { example: &example, elf, board, scalar, arguments: &args, limit, icount: None };
            return Ok(status(run.stream()?));
        }
        Action::Host { example, scalar, timeout, args } => {
            let program = &host::build(scalar.feature(), host::Optimised::Release, std::slice::from_ref(&example))?[0];
            return Ok(status(host::stream(program, scalar, &args, Duration::from_secs(timeout))?));
        }
        Action::View(options) => view::run(&options)?,
        Action::Draw(options) => drawing::run(&options)?,
        Action::Elf(options) => elf::run(&options)?,
        Action::Bench(options) => bench::run(&options)?,
        Action::Chart => bench::document()?,
        Action::Guide => guide::build()?,
        Action::Capi(action) => capi::run(action)?,
        Action::Lint(Yes { yes }) => lint::run(yes)?,
        Action::Licences => licences::run()?,
    }
    Ok(ExitCode::SUCCESS)
}

/// Another program's status as our own.
fn status(status: ExitStatus) -> ExitCode {
    // No code means that a signal ended it.
    let code = status.code().and_then(|code| u8::try_from(code).ok());
    code.map_or(ExitCode::FAILURE, ExitCode::from)
}
