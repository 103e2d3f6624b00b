//! The header, by cbindgen from the library's source.

use crate::process;
use crate::toolchain::own_cargo;
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::path::PathBuf;

/// Where it is kept.
pub fn path() -> PathBuf {
    workspace::root().join("capi/include/carom.h")
}

/// Writes it.
pub fn write() -> Result<()> {
    let path = path();
    std::fs::write(&path, generate()?).with_context(|| format!("writing {}", path.display()))?;
    println!("wrote {}", path.display());
    Ok(())
}

/// Complains where the one that is kept is another.
pub fn check() -> Result<()> {
    if std::fs::read_to_string(path()).ok() != Some(generate()?) {
        bail!("capi/include/carom.h is not what capi/src makes of it: run `cargo xtask capi header`");
    }
    println!("capi/include/carom.h is up to date");
    Ok(())
}

fn generate() -> Result<String> {
    let capi = workspace::root().join("capi");
    let config = cbindgen::Config::from_file(capi.join("cbindgen.toml")).map_err(anyhow::Error::msg)?;
    let bindings = cbindgen::Builder::new().with_config(config).with_src(expanded()?).generate()?;
    let mut text = Vec::new();
    bindings.write(&mut text);
    Ok(String::from_utf8(text)?)
}

/// The library's source with its macros expanded: cbindgen reads, and does not expand. The compiler that prints it would have to be
/// a nightly one, and takes this for it.
fn expanded() -> Result<PathBuf> {
    let folder = workspace::target_dir().join("capi-header");
    std::fs::create_dir_all(&folder)?;
    let mut cargo = own_cargo();
    cargo.env("RUSTC_BOOTSTRAP", "1").env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    cargo.args(["rustc", "--quiet", "--package", "carom-capi", "--lib", "--crate-type", "rlib", "--target-dir"]);
    cargo.arg(&folder).args(["--", "-Zunpretty=expanded"]);
    let source = process::stdout_of(&mut cargo);
    let source = source.with_context(|| format!("`{}` failed: build carom-capi to see why", process::show(&cargo)))?;
    let file = folder.join("carom_c.rs");
    std::fs::write(&file, source)?;
    Ok(file)
}
