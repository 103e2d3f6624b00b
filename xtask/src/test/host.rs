//! The host's stage: all tests with all features, each number type alone, and every combination of features compiles.

use crate::boards::{FEATURES, SAMPLE_TARGETS};
use crate::process;
use crate::toolchain::{Toolchain, own_cargo};
use crate::workspace;
use anyhow::Result;
use std::process::Command;
use std::time::Instant;

/// What runs in each number type alone: with all of them in one build the other tests have seen it.
const ALONE: [&str; 4] = ["--test", "determinism", "--test", "properties"];

/// Features that add other crates' traits, and the one of them that needs `std`.
const INTEROP: [&str; 5] = ["bytemuck", "defmt", "embedded-graphics", "mint", "serde"];
const INTEROP_ON_HOSTS: &str = "arbitrary";

/// Runs the stage.
pub fn run(toolchain: &Toolchain) -> Result<()> {
    // Without the examples: the boards' stage builds and runs them.
    // The examples are built by the boards' stage.
    for set in ["--tests", "--doc"] {
        timed(own_cargo().args(["test", "--quiet", "--all-features", set]))?;
    }
    // Unoptimised, as it is here already.
    timed(own_cargo().args(["test", "--quiet", "--package", "xtask"]).env("CARGO_PROFILE_TEST_OPT_LEVEL", "0"))?;
    for feature in FEATURES {
        let alone = ["--quiet", "--no-default-features", "--features", feature];
        timed(own_cargo().arg("check").args(alone).args(["--tests", "--examples"]))?;
        timed(own_cargo().arg("test").args(alone).arg("--doc"))?;
        timed(own_cargo().arg("test").args(alone).args(ALONE))?;
    }

    println!(
        "  the library in all {} combinations of features; for two targets in none, each and all",
        1 << FEATURES.len()
    );
    for chosen in combinations() {
        let features = chosen.join(",");
        let mut cargo = own_cargo();
        cargo.arg("rustc").arg("--target-dir").arg(workspace::target_dir());
        process::run(check(&mut cargo, &features))?;
        if chosen.len() > 1 && chosen.len() < FEATURES.len() {
            continue;
        }
        for target in SAMPLE_TARGETS {
            process::run(check(&mut toolchain.cargo("rustc", target), &features))?;
        }
    }
    println!("  with the traits of other crates: each feature alone, all in each number type, and all together");
    let all = |numbers: &[&str]| [numbers, &INTEROP].concat().join(",");
    let alone = INTEROP.into_iter().chain([INTEROP_ON_HOSTS]).map(str::to_owned);
    for features in alone.chain(FEATURES.map(|number| all(&[number]))) {
        let mut cargo = own_cargo();
        cargo.arg("rustc").arg("--target-dir").arg(workspace::target_dir());
        process::run(check(&mut cargo, &features))?;
    }
    for target in SAMPLE_TARGETS {
        process::run(check(&mut toolchain.cargo("rustc", target), &all(&FEATURES)))?;
    }
    Ok(())
}

/// As `cargo check`, and a warning is an error.
fn check<'a>(cargo: &'a mut Command, features: &str) -> &'a mut Command {
    cargo.args(["--quiet", "--lib", "--profile", "check", "--no-default-features", "--features", features]);
    cargo.args(["--", "-D", "warnings"])
}

/// Every subset of the features.
fn combinations() -> Vec<Vec<&'static str>> {
    let subset = |bits: usize| {
        let chosen = FEATURES.iter().enumerate().filter(|(index, _)| bits >> index & 1 == 1);
        chosen.map(|(_, feature)| *feature).collect()
    };
    (0..1 << FEATURES.len()).map(subset).collect()
}

fn timed(command: &mut Command) -> Result<()> {
    let start = Instant::now();
    println!("  {}", process::show(command));
    process::run(command)?;
    println!("    passed in {} s", start.elapsed().as_secs());
    Ok(())
}
