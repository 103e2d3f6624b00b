//! `cargo xtask elf`: what is, and is not, in linked firmware. Read from the ELF files, by following calls.

mod graph;
mod image;
mod rules;
#[cfg(test)]
mod tests;
mod thumb;

use crate::bench::image::{self as bench_image, Firmware, Opt, Recipe};
use crate::boards::{Board, FEATURES, SAMPLE_TARGETS, TARGETS};
use crate::cases;
use crate::firmware::{Build, Profile};
use crate::process;
use crate::setup;
use crate::toolchain::Toolchain;
use crate::workspace;
use anyhow::{Context, Result, bail};
use clap::builder::PossibleValuesParser;
use graph::Graph;
use image::Image;
use rayon::prelude::*;
use std::path::Path;

/// Stands for the benchmark's firmware among the examples.
const BENCH: &str = "bench";

/// What to check; everything that is not given means all.
#[derive(clap::Args, Default)]
pub struct Options {
    /// One example instead of all; `bench` is the benchmark's firmware
    #[arg(long)]
    example: Option<String>,
    /// One target instead of those of all boards
    #[arg(long, value_parser = PossibleValuesParser::new(TARGETS))]
    target: Option<String>,
    /// One feature set instead of all
    #[arg(long, value_parser = PossibleValuesParser::new(FEATURES))]
    feature: Option<String>,
    /// One profile instead of both
    #[arg(long)]
    profile: Option<Profile>,
    /// Install what is missing without asking
    #[arg(long)]
    yes: bool,
}

impl Options {
    /// All of it.
    pub fn everything(yes: bool) -> Self {
        Self { yes, ..Self::default() }
    }
}

/// Builds and checks, all of it even when something is wrong early on.
pub fn run(options: &Options) -> Result<()> {
    let toolchain = setup::ensure(options.yes)?;
    self_test(&toolchain)?;
    let examples = match &options.example {
        Some(example) if example == BENCH => Vec::new(),
        Some(example) => vec![example.clone()],
        None => workspace::board_examples()?,
    };
    let with_bench = options.example.as_deref().is_none_or(|example| example == BENCH);
    let mut repeats = Vec::new();
    // Without being asked only what some board runs.
    let on_a_board = |target: &str| Board::ALL.iter().any(|board| board.target() == target);
    let wanted = |target: &str| options.target.as_deref().map_or(on_a_board(target), |one| one == target);
    for target in TARGETS.into_iter().filter(|target| wanted(target)) {
        if with_bench && options.profile.is_none_or(|profile| profile == Profile::Release) {
            repeats.extend(check_bench(&toolchain, target, options.feature.as_deref())?);
        }
        for feature in FEATURES.into_iter().filter(|&one| options.feature.as_deref().unwrap_or(one) == one) {
            for profile in [Profile::Release, Profile::Checked] {
                // Unasked, on one core without an FPU and on one with: linking it for all takes minutes more.
                if profile == Profile::Checked && options.target.is_none() && !SAMPLE_TARGETS.contains(&target) {
                    continue;
                }
                let asked = options.example.is_some();
                let looked_at = |example: &&String| {
                    let all = asked || profile == Profile::Release || cases::also_checked(example);
                    all && cases::is_for(example, feature) && !cases::is_inlined(example, feature)
                };
                let examples: Vec<String> = examples.iter().filter(looked_at).cloned().collect();
                if !examples.is_empty() && options.profile.unwrap_or(profile) == profile {
                    repeats.extend(check_build(&toolchain, Build { target, feature, profile }, &examples)?);
                }
            }
        }
    }
    if let Some(repeat) = repeats.first() {
        bail!("{} of the firmware files must not look like this; repeat the first with `{repeat}`", repeats.len());
    }
    Ok(())
}

/// The benchmark's firmware holds every function of the kernel, and is built for size as well as for speed. Returns the
/// command for each image that failed.
fn check_bench(toolchain: &Toolchain, target: &'static str, feature: Option<&str>) -> Result<Vec<String>> {
    let brings = |firmware: &Firmware| {
        feature.is_none_or(|feature| firmware.scalars.iter().any(|scalar| scalar.feature() == feature))
    };
    let firmware: Vec<Firmware> = bench_image::OWN.into_iter().filter(brings).collect();
    // Each opt-level has a folder of its own, and compiles mostly on one core.
    let level = |opt: Opt| -> Result<Vec<String>> {
        let mut repeats = Vec::new();
        for &firmware in &firmware {
            let recipe = Recipe { firmware, target, opt };
            let file = recipe.build(toolchain)?.elf;
            let fixed = firmware.scalars.iter().all(|scalar| scalar.fraction_bits().is_some());
            let found = check_file(&file, fixed, target)?;
            print_found(&format!("  {recipe}"), &found);
            if !found.is_empty() {
                repeats.push(format!("cargo xtask elf --example {BENCH} --target {target}"));
            }
        }
        Ok(repeats)
    };
    let repeats: Vec<Vec<String>> = Opt::ALL.into_par_iter().map(level).collect::<Result<_>>()?;
    Ok(repeats.concat())
}

/// Builds the examples once and checks each; returns the command for each that failed.
fn check_build(toolchain: &Toolchain, build: Build, examples: &[String]) -> Result<Vec<String>> {
    let files = build.run(toolchain, examples)?;
    let mut repeats = Vec::new();
    for (example, file) in examples.iter().zip(files) {
        let found = check_file(&file, build.feature == "fixed", build.target)?;
        print_found(&format!("  {build:<42} {example}"), &found);
        if !found.is_empty() {
            let Build { target, feature, profile } = build;
            repeats.push(format!(
                "cargo xtask elf --example {example} --target {target} --feature {feature} --profile {profile}"
            ));
        }
    }
    Ok(repeats)
}

fn print_found(what: &str, found: &[String]) {
    println!("{what:<62} {}", if found.is_empty() { "fine" } else { "FAILED" });
    for line in found {
        println!("    {line}");
    }
}

/// Everything that is wrong with one firmware; `fixed` where it computes in fixed point only.
pub fn check_file(file: &Path, fixed: bool, target: &str) -> Result<Vec<String>> {
    let bytes = std::fs::read(file).with_context(|| format!("reading {}", file.display()))?;
    check(&bytes, fixed, fixed && target.ends_with("hf"))
}

/// What by its mere name must not be in firmware that begins outside Rust: no panic, no allocator, no division of 64 bits or more,
/// and with `fixed` no float routine.
pub fn check_names(file: &Path, fixed: bool) -> Result<Vec<String>> {
    let bytes = std::fs::read(file).with_context(|| format!("reading {}", file.display()))?;
    let forbidden = |name: &str| {
        rules::is_panic(name)
            || rules::is_allocator(name)
            || rules::is_wide_division(name)
            || (fixed && rules::is_float_routine(name))
    };
    Ok(Image::parse(&bytes)?.names.into_iter().filter(|name| forbidden(name)).collect())
}

/// Everything that is wrong with one firmware. `no_floats`: no float routine may be in it; `no_fpu`: carom's functions
/// may not compute with the FPU either.
fn check(bytes: &[u8], no_floats: bool, no_fpu: bool) -> Result<Vec<String>> {
    let image = Image::parse(bytes)?;
    let graph = Graph::new(&image);
    let mut found = Vec::new();

    for name in &image.names {
        if rules::is_allocator(name) {
            found.push(format!("part of an allocator: {name}"));
        }
        if no_floats && rules::is_float_routine(name) {
            found.push(format!("a float routine in fixed-point firmware: {name}"));
        }
    }

    let named = |index: usize, rule: fn(&str) -> bool| image.functions[index].names.iter().any(|name| rule(name));
    let roots: Vec<usize> = (0..image.functions.len()).filter(|&index| named(index, rules::is_root)).collect();
    if roots.is_empty() {
        found.push("no function of carom and no `kernel_...` function to begin with: nothing was checked".to_owned());
    }
    // A panic or a division is enough: what it calls in its turn is its own affair.
    let reached = graph.reach(&roots, |index| named(index, rules::is_panic) || named(index, rules::is_wide_division));
    for &(index, _) in &reached {
        let node = graph.node(index);
        let mut report = |what: &str| found.push(format!("{what}: {}", path_to(index, &reached, &image)));
        if named(index, rules::is_panic) {
            report("a panic");
        }
        if named(index, rules::is_wide_division) {
            report("a division of 64 bits or more");
        }
        if node.calls_unknown && !named(index, rules::is_panic) {
            report("a call of something unknown");
        }
        if no_fpu && node.computes_floats {
            report("FPU arithmetic in fixed-point code");
        }
    }
    Ok(found)
}

/// How a function is reached, caller by caller.
fn path_to(index: usize, reached: &[(usize, Option<usize>)], image: &Image) -> String {
    let mut path = vec![image.functions[index].name()];
    let mut at = index;
    while let Some((_, Some(from))) = reached.iter().find(|(one, _)| *one == at) {
        at = *from;
        path.push(image.functions[at].name());
    }
    path.reverse();
    path.join(" -> ")
}

/// Compiles a program that holds everything forbidden and sees to it that all of it is found: a new compiler might
/// rename what the rules look for, and then every firmware would pass.
fn self_test(toolchain: &Toolchain) -> Result<()> {
    let folder = workspace::target_dir().join("elf-self-test");
    std::fs::create_dir_all(&folder)?;
    for target in TARGETS {
        let program = folder.join(target);
        let mut rustc = toolchain.rustc(target);
        rustc.arg(workspace::root().join("xtask/fixtures/forbidden.rs")).arg("-o").arg(&program);
        rustc.args(["--edition=2024", "-Copt-level=3", "-Cpanic=abort", "-Ccodegen-units=1"]);
        process::run(&mut rustc)?;
        let fpu = target.ends_with("hf");
        let found = check(&std::fs::read(&program)?, true, fpu)?;
        let mut wanted = vec![
            ("a panic", "kernel_index"),
            ("a panic", "kernel_through_pointer"),
            ("a division of 64 bits or more", "kernel_divide"),
            ("part of an allocator", ""),
            ("a float routine in fixed-point firmware", ""),
        ];
        if fpu {
            wanted.push(("FPU arithmetic in fixed-point code", "kernel_float"));
        }
        for (what, from) in wanted {
            let told = |line: &String| line.starts_with(what) && line.contains(from);
            if !found.iter().any(told) {
                bail!("the ELF checks missed `{what}` {from} in {}, told was only: {found:#?}", program.display());
            }
        }
    }
    Ok(())
}
