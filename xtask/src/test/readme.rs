//! The README's programs in the number type that the comment on their first names: nothing else in the file changes, they say.

use crate::process;
use crate::toolchain::own_cargo;
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

/// The line that says it.
const CLAIM: (&str, &str, &str) = ("type Real = ", "; // or ", ": nothing else in this file changes\n");
/// How many programs have it, so that none is lost when they are written anew.
const PROGRAMS: usize = 2;
/// A cold build takes most of it.
const LIMIT: Duration = Duration::from_secs(300);

/// Compiles and runs each in both types, and holds the numbers that they end with against each other.
pub fn run() -> Result<()> {
    let text = fs::read_to_string(workspace::root().join("README.md")).context("reading README.md")?;
    let programs: Vec<_> = text.split("```rust\n").skip(1).filter_map(|rest| both(rest.split("```").next()?)).collect();
    if programs.len() != PROGRAMS {
        bail!("{} programs of the README name two number types, not {PROGRAMS}", programs.len());
    }
    let folder = tempfile::tempdir()?;
    let package = folder.path();
    fs::create_dir_all(package.join("src"))?;
    let root = workspace::root().display().to_string();
    let manifest = format!(
        "[workspace]\n[package]\nname = \"readme\"\nedition = \"2024\"\n[dependencies]\n\
         carom = {{ path = {root:?}, features = [\"fixed\"] }}\nfixed = {{ version = \"1.30\", default-features = false }}\n"
    );
    fs::write(package.join("Cargo.toml"), manifest)?;
    for (names, programs) in programs {
        let [first, second] = [last_line(package, &programs[0])?, last_line(package, &programs[1])?];
        println!("  README, {}: {first}; {}: {second}", names[0], names[1]);
        if !alike(&first, &second) {
            bail!("a program of the README ends otherwise in {} than in {}", names[1], names[0]);
        }
    }
    Ok(())
}

/// The names of both types, and the program in each.
fn both(program: &str) -> Option<([&str; 2], [String; 2])> {
    let (before, rest) = program.split_once(CLAIM.0)?;
    let (claim, after) = rest.split_once(CLAIM.2)?;
    let (first, second) = claim.split_once(CLAIM.1)?;
    Some(([first, second], [first, second].map(|name| format!("{before}{}{name};\n{after}", CLAIM.0))))
}

/// What a program prints last.
fn last_line(package: &Path, program: &str) -> Result<String> {
    fs::write(package.join("src/main.rs"), program)?;
    let mut cargo = own_cargo();
    cargo.args(["run", "--quiet", "--manifest-path"]).arg(package.join("Cargo.toml"));
    cargo.arg("--target-dir").arg(workspace::target_dir());
    let end = process::run_for(cargo.stdout(Stdio::piped()), LIMIT)?;
    let text = String::from_utf8_lossy(&end.stdout);
    if !end.status.is_some_and(|status| status.success()) {
        bail!("this program of the README fails:\n{program}\n{text}");
    }
    Ok(text.lines().last().context("a program of the README prints nothing")?.to_owned())
}

/// The same words, and numbers within a hundredth.
fn alike(a: &str, b: &str) -> bool {
    let words = |text: &str| text.split([' ', ',']).map(str::to_owned).collect::<Vec<_>>();
    let same = |a: &String, b: &String| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() <= 0.01 * a.abs(),
        _ => a == b,
    };
    let (a, b) = (words(a), words(b));
    a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| same(a, b))
}
