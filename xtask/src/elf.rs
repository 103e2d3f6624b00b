//! `cargo xtask elf`: what is, and is not, in linked firmware. Read from the ELF files, by following calls.

mod graph;
mod image;
mod rules;
mod thumb;

use crate::boards::{FEATURES, TARGETS};
use crate::firmware::{Build, Profile};
use crate::process;
use crate::setup;
use crate::toolchain::Toolchain;
use crate::workspace;
use anyhow::{Context, Result, bail};
use clap::builder::PossibleValuesParser;
use graph::Graph;
use image::Image;
use std::path::Path;

/// What to check; everything that is not given means all.
#[derive(clap::Args, Default)]
pub struct Options {
    /// One example instead of all
    #[arg(long)]
    example: Option<String>,
    /// One target instead of all
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

/// Builds and checks; the error names the first build that has something in it that must not be there.
pub fn run(options: &Options) -> Result<()> {
    let toolchain = setup::ensure(options.yes)?;
    self_test(&toolchain)?;
    let examples = match &options.example {
        Some(example) => vec![example.clone()],
        None => workspace::board_examples()?,
    };
    for target in TARGETS.into_iter().filter(|&one| options.target.as_deref().unwrap_or(one) == one) {
        for feature in FEATURES.into_iter().filter(|&one| options.feature.as_deref().unwrap_or(one) == one) {
            for profile in [Profile::Release, Profile::Checked] {
                if options.profile.unwrap_or(profile) == profile {
                    check_build(&toolchain, Build { target, feature, profile }, &examples)?;
                }
            }
        }
    }
    Ok(())
}

/// Builds the examples once and checks each.
fn check_build(toolchain: &Toolchain, build: Build, examples: &[String]) -> Result<()> {
    let files = build.run(toolchain, examples)?;
    let mut failed = Vec::new();
    for (example, file) in examples.iter().zip(files) {
        let found = check_file(&file, build)?;
        for line in &found {
            eprintln!("  {example}: {line}");
        }
        if !found.is_empty() {
            failed.push(example.as_str());
        }
    }
    if !failed.is_empty() {
        bail!(
            "{build}: {} must not look like this; repeat with `cargo xtask elf --example {} --target {} --feature {} \
             --profile {}`",
            failed.join(", "),
            failed[0],
            build.target,
            build.feature,
            build.profile
        );
    }
    println!("  {build}: {} fine", examples.join(", "));
    Ok(())
}

/// Everything that is wrong with one firmware.
fn check_file(file: &Path, build: Build) -> Result<Vec<String>> {
    let bytes = std::fs::read(file).with_context(|| format!("reading {}", file.display()))?;
    let fixed = build.feature == "fixed";
    check(&bytes, fixed, fixed && build.target.ends_with("hf"))
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

    let root = |index: &usize| image.functions[*index].names.iter().any(|name| rules::is_root(name));
    let roots: Vec<usize> = (0..image.functions.len()).filter(root).collect();
    if roots.is_empty() {
        found.push("no function of carom and no `kernel_...` function to begin with: nothing was checked".to_owned());
    }
    let reached = graph.reach(&roots);
    for &(index, _) in &reached {
        let named = |rule: fn(&str) -> bool| image.functions[index].names.iter().any(|name| rule(name));
        let node = graph.node(index);
        let mut report = |what: &str| found.push(format!("{what}: {}", path_to(index, &reached, &image)));
        if named(rules::is_panic) {
            report("a panic");
        }
        if named(rules::is_wide_division) {
            report("a division of 64 bits or more");
        }
        if node.calls_unknown {
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
