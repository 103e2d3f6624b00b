//! `cargo xtask view`: an example's run as a page in three dimensions, or as a picture.

use crate::boards::{Board, Scalar};
use crate::cases;
use crate::firmware::{Build, Profile};
use crate::host::{self, Optimised};
use crate::{qemu, setup, workspace};
use anyhow::{Context, Result, bail};
use carom_view::image::{self, Size};
use carom_view::{Replay, Trace, Words};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

const PNG: Size = Size { width: 1280, height: 720, closer: 1.0 };
const GIF: Size = Size { width: 800, height: 380, closer: 1.0 };

/// The option by which examples write a trace.
pub const TRACE: &str = "--trace";

/// What to show, and as what.
#[derive(clap::Args, Clone)]
pub struct Options {
    /// An example that takes --trace: dice, say
    pub example: String,
    /// Run its firmware on this board in QEMU; without it, it runs on this machine
    #[arg(long, value_parser = Board::cortex_m())]
    pub board: Option<Board>,
    /// The number type
    #[arg(long, default_value_t = Scalar::F32)]
    pub scalar: Scalar,
    /// Run it on this machine in that number type, too, and show it as a ghost: f64, say
    #[arg(long, value_name = "SCALAR")]
    pub compare: Option<Scalar>,
    /// Where the page goes [default: target/view/EXAMPLE.html, unless only pictures are asked for]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// A picture of the moment at which the two part, or of a third of the way
    #[arg(long, value_name = "FILE")]
    pub png: Option<PathBuf>,
    /// An animation
    #[arg(long, value_name = "FILE")]
    pub gif: Option<PathBuf>,
    /// Seconds after which a run is stopped
    #[arg(long, default_value_t = 300, value_name = "SECONDS")]
    pub timeout: u64,
    /// Install what is missing without asking
    #[arg(long)]
    pub yes: bool,
    /// Arguments for the example
    #[arg(last = true)]
    pub args: Vec<String>,
}

impl Options {
    /// A run of an example, without pictures.
    pub fn new(example: &str, board: Option<Board>, scalar: Scalar, yes: bool) -> Self {
        Self {
            example: example.to_owned(),
            board,
            scalar,
            compare: None,
            out: None,
            png: None,
            gif: None,
            timeout: 180,
            yes,
            args: Vec::new(),
        }
    }
}

/// Runs, reads, writes.
pub fn run(options: &Options) -> Result<()> {
    let traced = traced_examples()?;
    if !traced.contains(&options.example) {
        bail!("`{}` writes no trace; the examples that do are: {}", options.example, traced.join(", "));
    }
    if let Some(board) = options.board {
        cases::check_room(&options.example, board)?;
    }
    let options = &absolute(options)?;
    let stages = 3 + u64::from(options.compare.is_some()) * 2 + u64::from(options.board.is_some());
    let progress = Progress::new(stages);
    let trace = Trace::read(&record(options, TRACE, options.board, options.scalar, &progress)?)?;
    let here = |scalar| Trace::read(&record(options, TRACE, None, scalar, &progress)?);
    let other = options.compare.map(here).transpose()?;
    progress.stage("looking at the trace");
    let replay = Replay::new(&trace, other.as_ref(), words(options))?;
    progress.end();
    write(options, &replay)
}

/// Writes the page and the pictures, and says where.
fn write(options: &Options, replay: &Replay) -> Result<()> {
    let only_pictures = options.out.is_none() && (options.png.is_some() || options.gif.is_some());
    if !only_pictures {
        let usual = workspace::target_dir().join("view").join(format!("{}.html", options.example));
        let path = options.out.clone().unwrap_or(usual);
        save(&path, carom_view::page(replay)?.as_bytes())?;
        println!("{}: open it in a browser", path.display());
    }
    if let Some(path) = &options.png {
        save(path, &image::png(replay, moment(replay), PNG)?)?;
        println!("{}", path.display());
    }
    if let Some(path) = &options.gif {
        let progress = Progress::new(0);
        let gif = image::gif(replay, GIF, |done, all| progress.count("drawing", done, all))?;
        progress.end();
        save(path, &gif)?;
        println!("{}: {} bytes", path.display(), gif.len());
    }
    Ok(())
}

/// The moment that a single picture shows: soon after the two runs have parted, or a third of the way.
fn moment(replay: &Replay) -> usize {
    let parted = replay.ghost.as_ref().and_then(|ghost| ghost.parted);
    let time = parted.map_or(replay.times[replay.len() - 1] / 3.0, |parted| parted + 0.1);
    replay.times.partition_point(|other| *other < time).min(replay.len() - 1)
}

/// Writes a file, and makes the folder it lies in.
pub fn save(path: &Path, bytes: &[u8]) -> Result<()> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).with_context(|| format!("creating {}", folder.display()))?;
    }
    std::fs::write(path, bytes).with_context(|| format!("writing {}", path.display()))
}

/// The file that the example writes on a board, or on this machine, if it is called with that option. To be called in the root of
/// the repository.
pub fn record(
    options: &Options,
    option: &str,
    place: Option<Board>,
    scalar: Scalar,
    progress: &Progress,
) -> Result<Vec<u8>> {
    let Options { example, timeout, .. } = options;
    let limit = Duration::from_secs(*timeout);
    let examples = std::slice::from_ref(example);
    let name = place.map_or_else(|| "host".to_owned(), |board| board.to_string());
    let path = file(example, option, scalar, &name)?;
    let mut arguments = options.args.clone();
    arguments.extend([option.to_owned(), path.display().to_string()]);
    let (status, text) = match place {
        Some(board) => {
            let toolchain = progress.pause(|| setup::ensure(options.yes))?;
            progress.stage(&format!("building {example} in {scalar} for {board}"));
            let build = Build { target: board.target(), feature: scalar.feature(), profile: Profile::Release };
            let elf = progress.pause(|| build.run(&toolchain, examples))?.remove(0);
            progress.stage(&format!("running it on {board}, in QEMU"));
            let run = qemu::Run { example, elf: &elf, board, scalar, arguments: &arguments, limit, icount: None };
            run.capture()?
        }
        None => {
            progress.stage(&format!("building {example} in {scalar} for this machine"));
            let program = progress.pause(|| host::build(scalar.feature(), Optimised::Release, examples))?.remove(0);
            progress.stage("running it");
            host::capture(&program, scalar, &arguments, limit)?
        }
    };
    if !status.success() {
        std::io::stderr().write_all(&text)?;
        bail!("{example} in {scalar} failed on {name} ({status})");
    }
    std::fs::read(&path).with_context(|| format!("reading {}", path.display()))
}

/// Where a run writes its file: by a short path, since a board takes a short command line. Nothing old is there.
fn file(example: &str, option: &str, scalar: Scalar, place: &str) -> Result<PathBuf> {
    let folder = workspace::target_dir().join("view");
    std::fs::create_dir_all(&folder).with_context(|| format!("creating {}", folder.display()))?;
    let path = folder.join(format!("{example}-{scalar}-{place}.{}", option.trim_start_matches('-')));
    let _ = std::fs::remove_file(&path);
    // Runs begin in the root of the repository.
    Ok(path.strip_prefix(workspace::root()).map(Path::to_path_buf).unwrap_or(path))
}

/// The same options with paths that hold wherever we are; then we go to the root of the repository.
fn absolute(options: &Options) -> Result<Options> {
    let mut options = options.clone();
    for path in [&mut options.out, &mut options.png, &mut options.gif].into_iter().flatten() {
        *path = std::path::absolute(&*path)?;
    }
    std::env::set_current_dir(workspace::root())?;
    Ok(options)
}

fn words(options: &Options) -> Words {
    const HERE: &str = "this machine";
    let place = options.board.map_or(HERE.to_owned(), |board| format!("a Cortex-{}", board.name()));
    let mut command = format!("cargo xtask view {}", options.example);
    if let Some(board) = options.board {
        command.push_str(&format!(" --board {board}"));
    }
    command.push_str(&format!(" --scalar {}", options.scalar));
    if let Some(scalar) = options.compare {
        command.push_str(&format!(" --compare {scalar}"));
    }
    if !options.args.is_empty() {
        command.push_str(&format!(" -- {}", options.args.join(" ")));
    }
    Words { example: options.example.clone(), place, ghost_place: HERE.to_owned(), command }
}

/// The examples whose source writes a trace.
pub fn traced_examples() -> Result<Vec<String>> {
    let mut names = workspace::board_examples()?;
    names.retain(|name| {
        let file = workspace::root().join("examples").join(format!("{name}.rs"));
        std::fs::read_to_string(file).is_ok_and(|text| text.contains("Trace::start"))
    });
    Ok(names)
}

/// A bar on a terminal, lines elsewhere.
pub struct Progress(ProgressBar);

impl Progress {
    pub fn new(stages: u64) -> Self {
        let bar = if std::io::stderr().is_terminal() { ProgressBar::new(stages) } else { ProgressBar::hidden() };
        let style = ProgressStyle::with_template("{spinner} [{bar:24}] {msg} ({elapsed})");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()).progress_chars("=> "));
        bar.enable_steady_tick(Duration::from_millis(120));
        Self(bar)
    }

    fn stage(&self, what: &str) {
        if self.0.is_hidden() {
            println!("view: {what}");
        }
        if !self.0.message().is_empty() {
            self.0.inc(1);
        }
        self.0.set_message(what.to_owned());
    }

    fn count(&self, what: &'static str, done: usize, all: usize) {
        self.0.set_length(all as u64);
        self.0.set_position(done as u64);
        self.0.set_message(what);
    }

    /// Leaves the terminal to what may ask something, or says itself what it does.
    fn pause<T>(&self, work: impl FnOnce() -> T) -> T {
        self.0.suspend(work)
    }

    fn end(&self) {
        self.0.finish_and_clear();
    }
}
