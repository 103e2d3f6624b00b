//! `cargo xtask new`: firmware of one's own to begin with, in a folder outside this clone.

use crate::boards::{Board, Scalar};
use crate::qemu;
use crate::setup;
use crate::toolchain::Toolchain;
use crate::workspace;
use anyhow::{Context, Result, bail};
use clap::ValueEnum;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::fs;
use std::path::{Path, PathBuf};

/// How the template names itself, and where it finds carom.
const NAME: &str = "my-firmware";
const PATH: &str = "\"../..\"";

/// What the template has for its number type, and what takes its place for f32.
const FIXED: &str = "fixed = { version = \"1.30\", default-features = false }\n";
const FIXED_MILLI: &str = "/// Thousandths, rounded. In 64 bits: a thousand times 3 m/s is beyond the format.
fn to_milli(x: Real) -> i32 {
    let half = 1 << (Real::FRAC_NBITS - 1);
    ((i64::from(x.to_bits()) * 1000 + half) >> Real::FRAC_NBITS) as i32
}
";
const F32_MILLI: &str = "/// Thousandths, rounded.
fn to_milli(x: Real) -> i32 {
    (x * 1000.0 + if x < 0.0 { -0.5 } else { 0.5 }) as i32
}
";

/// What the firmware begins with.
#[derive(Clone, Copy)]
pub enum Scene {
    Maze,
    Ball,
}

/// The template's folder.
pub fn template() -> PathBuf {
    workspace::root().join("examples/template")
}

/// The number types that firmware begins with.
pub fn scalars() -> impl TypedValueParser<Value = Scalar> {
    let all = [Scalar::F32, Scalar::I16F16, Scalar::I12F20];
    PossibleValuesParser::new(all.iter().filter_map(Scalar::to_possible_value))
        .try_map(|name| Scalar::from_str(&name, false))
}

/// Writes the package.
pub fn run(folder: &Path, board: Board, scalar: Option<Scalar>, scene: Scene, yes: bool) -> Result<()> {
    let scalar = scalar.unwrap_or(if board.target().ends_with("hf") { Scalar::F32 } else { Scalar::I12F20 });
    let folder = resolved(folder)?;
    if folder.starts_with(workspace::root().canonicalize()?) {
        bail!("{} lies in carom's own folder, whose settings would reach it: name one outside", folder.display());
    }
    if fs::read_dir(&folder).is_ok_and(|mut entries| entries.next().is_some()) {
        bail!("{} is there and not empty: name another folder", folder.display());
    }
    let toolchain = setup::ensure_for(board, yes)?;
    let (main, what) = match scene {
        Scene::Maze => ("src/main.rs", "a marble maze"),
        Scene::Ball => ("src/bin/empty.rs", "a ball on a floor"),
    };
    put(&folder.join("memory.x"), &read("memory.x")?)?;
    put(&folder.join("src/main.rs"), &with_scalar(&read(main)?, scalar)?)?;
    put(&folder.join("Cargo.toml"), &manifest(&folder, scalar)?)?;
    put(&folder.join(".cargo/config.toml"), &config(&toolchain, board))?;
    put(&folder.join(".gitignore"), "/target\n")?;
    println!("{what} for {board} in {scalar}: `cd {} && cargo run --release`", folder.display());
    Ok(())
}

/// Where the folder is or will be, without `..` and links in what is there already.
fn resolved(folder: &Path) -> Result<PathBuf> {
    let folder = std::path::absolute(folder)?;
    match (folder.canonicalize(), folder.parent(), folder.file_name()) {
        (Ok(there), ..) => Ok(there),
        (Err(_), Some(parent), Some(name)) => Ok(resolved(parent)?.join(name)),
        (Err(error), ..) => Err(error).with_context(|| format!("looking for {}", folder.display())),
    }
}

/// The manifest with the folder's name, as far as packages may have it, and the place of this clone.
fn manifest(folder: &Path, scalar: Scalar) -> Result<String> {
    let mut text = read("Cargo.toml")?;
    if !text.contains(NAME) || !text.contains(PATH) {
        bail!("examples/template/Cargo.toml has no {NAME} or no path {PATH}");
    }
    if scalar == Scalar::F32 {
        text = replaced(&text, "features = [\"fixed\"]", "features = [\"f32\"]")?;
        text = replaced(&text, FIXED, "")?;
    }
    let name = folder.file_name().and_then(|name| name.to_str()).unwrap_or(NAME);
    let letter = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    let fits = name.starts_with(|c: char| c.is_ascii_alphabetic()) && name.chars().all(letter);
    let root = workspace::root().display().to_string();
    // What is said of the template is not true of its copy.
    let text = text.trim_start_matches(|c| c != '[');
    Ok(text.replace(NAME, if fits { name } else { NAME }).replace(PATH, &format!("{root:?}")))
}

/// The program with that number type.
fn with_scalar(program: &str, scalar: Scalar) -> Result<String> {
    let [fixed, f32] = ["type Real = fixed::types::I12F20;", "type Real = f32;"];
    match scalar {
        Scalar::F32 => {
            let program = replaced(program, fixed, f32)?;
            let program = replaced(
                &program,
                "/// The number type. With an FPU: `f32`, and carom's feature of that name.",
                "/// The number type.",
            )?;
            let program = program.replace(FIXED_MILLI, F32_MILLI);
            if program.contains("FRAC_NBITS") {
                bail!("examples/template has what f32 has not, and not as this once:\n{FIXED_MILLI}");
            }
            Ok(program)
        }
        _ => replaced(program, fixed, &format!("type Real = fixed::types::{};", format!("{scalar}").to_uppercase())),
    }
}

/// What stands in the template once, replaced.
fn replaced(text: &str, from: &str, to: &str) -> Result<String> {
    if text.matches(from).count() != 1 {
        bail!("examples/template should have this once:\n{from}");
    }
    Ok(text.replacen(from, to, 1))
}

/// Cargo's settings: the target, QEMU as its runner, and the compiler, where it is not cargo's own.
fn config(toolchain: &Toolchain, board: Board) -> String {
    let target = board.target();
    let runner = [&[board.emulator()], board.qemu_machine(), &qemu::QUIET, &["-semihosting-config", qemu::SEMIHOSTING]];
    let runner = runner.concat().join(" ");
    let mut flags = vec!["-C".to_owned(), "link-arg=-Tlink.x".to_owned()];
    let (mut tools, mut linker) = (String::new(), String::new());
    if let Toolchain::Debian { rustc: program, linker: lld, sysroot, .. } = toolchain {
        flags.extend(["--sysroot".to_owned(), sysroot.display().to_string()]);
        tools = format!("rustc = {program:?}\nrustdoc = {:?}\n", program.with_file_name("rustdoc"));
        linker = format!("linker = {lld:?}\nrustdocflags = {:?}\n", &flags[2..]);
    }
    format!(
        "[build]\ntarget = \"{target}\"\n{tools}\n[target.{target}]\nrunner = \"{runner} -kernel\"\n{linker}rustflags = {flags:?}\n"
    )
}

fn read(file: &str) -> Result<String> {
    let path = template().join(file);
    fs::read_to_string(&path).with_context(|| format!("reading {}", path.display()))
}

fn put(path: &Path, text: &str) -> Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).with_context(|| format!("making {}", folder.display()))?;
    }
    fs::write(path, text).with_context(|| format!("writing {}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::{read, resolved, with_scalar};
    use crate::boards::Scalar;
    use crate::workspace;

    #[test]
    fn programs_take_any_of_the_number_types() {
        for program in ["src/main.rs", "src/bin/empty.rs"] {
            let program = read(program).expect("a program");
            let f32 = with_scalar(&program, Scalar::F32).expect("in f32");
            assert!(f32.contains("type Real = f32;") && !f32.contains("fixed"), "{f32}");
            let i16f16 = with_scalar(&program, Scalar::I16F16).expect("in fixed point");
            assert!(i16f16.contains("type Real = fixed::types::I16F16;"), "{i16f16}");
        }
    }

    #[test]
    fn beside_the_clone_is_outside() {
        let root = workspace::root().canonicalize().expect("a folder");
        let resolved = |path: &str| resolved(&root.join(path)).expect("a place");
        assert_eq!(resolved("../my-marble-that-is-not-there"), root.with_file_name("my-marble-that-is-not-there"));
        assert_eq!(resolved("src/../not/there"), root.join("not/there"));
        assert_eq!(resolved("src"), root.join("src"));
    }
}
