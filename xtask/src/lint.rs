//! Clippy for firmware, which plain `cargo clippy` does not see.

use crate::boards::{FEATURES, SAMPLE_TARGETS};
use crate::process;
use crate::setup;
use anyhow::Result;

/// Runs clippy on the library and the examples, for every number type, and on the firmware of the benchmark; a warning is
/// an error.
pub fn run(yes: bool) -> Result<()> {
    let toolchain = setup::ensure_clippy(yes)?;
    for target in SAMPLE_TARGETS {
        for feature in FEATURES {
            println!("clippy: {target} {feature}");
            let mut cargo = toolchain.cargo("clippy", target);
            cargo.args(["--quiet", "--lib", "--examples", "--no-default-features"]);
            // With this one all examples are there.
            cargo.arg("--features").arg(format!("{feature},embedded-graphics"));
            process::run(cargo.args(["--", "-D", "warnings"]))?;
        }
        println!("clippy: {target} benches");
        let mut cargo = toolchain.cargo("clippy", target);
        cargo.args(["--quiet", "--package", "carom-bench", "--package", "carom-bench-world", "--all-features"]);
        process::run(cargo.args(["--", "-D", "warnings"]))?;
    }
    Ok(())
}
