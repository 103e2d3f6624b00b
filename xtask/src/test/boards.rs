//! The boards' stage: every example on every board in QEMU, its text compared with this machine's.

use crate::boards::{Board, FEATURES, Scalar};
use crate::cases::{self, Case, VALIDATION};
use crate::firmware::{Build, Profile};
use crate::host::{self, Optimised};
use crate::qemu;
use crate::toolchain::Toolchain;
use crate::workspace;
use anyhow::{Context, Result, bail};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitStatus;
use std::time::{Duration, Instant};

/// Nothing that is run here should take a minute.
const LIMIT: Duration = Duration::from_secs(180);

/// One example in one number type, on some boards.
struct Job {
    example: String,
    scalar: Scalar,
    boards: &'static [Board],
    arguments: Vec<String>,
}

/// Runs the stage.
pub fn run(toolchain: &Toolchain) -> Result<()> {
    let jobs = jobs()?;
    for feature in FEATURES {
        let jobs: Vec<&Job> = jobs.iter().filter(|job| job.scalar.feature() == feature).collect();
        let expected = run_on_host(feature, &jobs)?;
        let mut targets: Vec<&'static str> = Board::ALL.iter().map(|board| board.target()).collect();
        targets.dedup();
        for target in targets {
            let here: Vec<(&Job, Vec<Board>)> = jobs
                .iter()
                .map(|job| (*job, job.boards.iter().copied().filter(|board| board.target() == target).collect()))
                .filter(|(_, boards): &(&Job, Vec<Board>)| !boards.is_empty())
                .collect();
            let examples = names(here.iter().map(|(job, _)| *job));
            if examples.is_empty() {
                continue;
            }
            let build = Build { target, feature, profile: Profile::Release };
            let files = build.run(toolchain, &examples)?;
            let files: BTreeMap<String, PathBuf> = examples.into_iter().zip(files).collect();
            // An emulator keeps one core busy.
            let runs: Vec<(&Job, Board)> =
                here.into_iter().flat_map(|(job, boards)| boards.into_iter().map(move |board| (job, board))).collect();
            runs.par_iter()
                .try_for_each(|&(job, board)| job.compare(board, &files[&job.example], &expected[&job.key()]))?;
        }
    }
    Ok(())
}

impl Job {
    fn key(&self) -> (String, String) {
        (self.example.clone(), format!("{} {}", self.scalar, self.arguments.join(" ")))
    }

    fn compare(&self, board: Board, elf: &Path, expected: &[u8]) -> Result<()> {
        let Job { example, scalar, arguments, .. } = self;
        let start = Instant::now();
        let run = qemu::Run { example, elf, board, scalar: *scalar, arguments, limit: LIMIT, icount: None };
        let tail = self.tail();
        let again = format!("cargo xtask qemu {example} --board {board} --scalar {scalar}{tail}");
        let (status, text) = run.capture().with_context(|| format!("repeat with `{again}`"))?;
        if !status.success() {
            print!("{}", String::from_utf8_lossy(&text));
            bail!("{example} in {scalar} failed on {board} ({status}); repeat with `{again}`");
        }
        if text != expected {
            bail!(
                "{example} in {scalar} prints another text on {board} than on this machine:\n{}\
                 compare `{again}` with `cargo xtask host {example} --scalar {scalar}{tail}`",
                first_difference(&text, expected)
            );
        }
        let lines = text.iter().filter(|&&byte| byte == b'\n').count();
        let seconds = start.elapsed().as_secs_f32();
        println!("  {example:<16} {scalar:<9} {board:<3}  {lines} lines as on this machine, {seconds:.1} s");
        Ok(())
    }

    fn tail(&self) -> String {
        if self.arguments.is_empty() { String::new() } else { format!(" -- {}", self.arguments.join(" ")) }
    }
}

/// Every job that can be done here; says which cannot.
fn jobs() -> Result<Vec<Job>> {
    let validation = validation()?;
    let mut jobs = Vec::new();
    for example in workspace::board_examples()? {
        let (possible, impossible): (Vec<&Case>, Vec<&Case>) =
            cases::cases(&example).iter().partition(|case| validation.is_some() || !case.needs_validation());
        if !impossible.is_empty() {
            println!(
                "  NOT RUN: {example}: it reads measured data that is not part of the repository, and \
                 CAROM_VALIDATION, which names the folder of that data, is not set"
            );
        }
        for case in possible {
            let folder = validation.as_deref().unwrap_or_default();
            let arguments: Vec<String> = case.arguments.iter().map(|text| text.replace(VALIDATION, folder)).collect();
            let Case { scalars, boards, .. } = case;
            jobs.extend(scalars.iter().map(|&scalar| Job {
                example: example.clone(),
                scalar,
                boards,
                arguments: arguments.clone(),
            }));
        }
    }
    Ok(jobs)
}

/// The folder of measured data, if it was given. In CI it has to be.
fn validation() -> Result<Option<String>> {
    match std::env::var("CAROM_VALIDATION").ok().filter(|folder| !folder.is_empty()) {
        Some(folder) if Path::new(&folder).is_dir() => Ok(Some(folder)),
        Some(folder) => bail!("CAROM_VALIDATION names `{folder}`, and there is no such folder"),
        None if std::env::var("CI").is_ok_and(|ci| ci == "true") => {
            bail!("CAROM_VALIDATION is not set, and in CI (CI=true) nothing is left out")
        }
        None => Ok(None),
    }
}

/// What each job prints on this machine.
fn run_on_host(feature: &str, jobs: &[&Job]) -> Result<BTreeMap<(String, String), Vec<u8>>> {
    let examples = names(jobs.iter().copied());
    let programs = host::build(feature, Optimised::Release, &examples)?;
    let in_debug: Vec<String> = examples.iter().filter(|example| cases::also_in_debug(example)).cloned().collect();
    let debug_programs =
        if in_debug.is_empty() { Vec::new() } else { host::build(feature, Optimised::Debug, &in_debug)? };

    let text = |job: &&Job| {
        let find = |names: &[String], programs: &[PathBuf]| {
            names.iter().position(|name| *name == job.example).map(|index| programs[index].clone())
        };
        let program = find(&examples, &programs).context("an example was not built")?;
        let text = job.run_here(&program)?;
        if let Some(program) = find(&in_debug, &debug_programs) {
            if job.run_here(&program)? != text {
                bail!("{} in {} prints another text in a debug build on this machine", job.example, job.scalar);
            }
            println!("  {:<16} {:<9} this machine, debug as release", job.example, job.scalar);
        }
        Ok((job.key(), text))
    };
    jobs.par_iter().map(text).collect()
}

impl Job {
    fn run_here(&self, program: &Path) -> Result<Vec<u8>> {
        let again = format!("cargo xtask host {} --scalar {}{}", self.example, self.scalar, self.tail());
        let (status, text): (ExitStatus, Vec<u8>) = host::capture(program, self.scalar, &self.arguments, LIMIT)?;
        if !status.success() {
            print!("{}", String::from_utf8_lossy(&text));
            bail!("{} in {} failed on this machine ({status}); repeat with `{again}`", self.example, self.scalar);
        }
        if text.is_empty() {
            bail!("{} in {} prints nothing: there is nothing to compare; `{again}`", self.example, self.scalar);
        }
        Ok(text)
    }
}

fn names<'a>(jobs: impl Iterator<Item = &'a Job>) -> Vec<String> {
    let mut names: Vec<String> = jobs.map(|job| job.example.clone()).collect();
    names.sort();
    names.dedup();
    names
}

/// The first line in which two texts differ.
fn first_difference(board: &[u8], host: &[u8]) -> String {
    let (board, host) = (String::from_utf8_lossy(board), String::from_utf8_lossy(host));
    let (mut board, mut host) = (board.lines(), host.lines());
    for number in 1.. {
        let (board, host) = (board.next(), host.next());
        if board != host || board.is_none() {
            let [board, host] = [board, host].map(|line| line.unwrap_or("(nothing)"));
            return format!("  line {number}\n    board: {board}\n    here:  {host}\n");
        }
    }
    String::new()
}
