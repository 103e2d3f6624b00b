//! The library as C projects find it: a folder with the header, the archives, a CMake package and a pkg-config file.

use super::{archive, header};
use crate::toolchain::Toolchain;
use crate::workspace;
use anyhow::{Context, Result};
use std::fs;
use std::path::Path;

/// Puts it there: for this machine, and for these processors.
pub fn install(prefix: &Path, boards: Option<(&Toolchain, &[String])>) -> Result<()> {
    copy(&header::path(), &prefix.join("include/carom.h"))?;
    copy(&archive::build_for_host()?, &prefix.join("lib/libcarom.a"))?;
    if let Some((toolchain, targets)) = boards {
        for target in targets {
            copy(&archive::build(toolchain, target)?, &prefix.join("lib/carom").join(target).join("libcarom.a"))?;
        }
    }
    for (template, place) in [
        ("caromConfig.cmake", "lib/cmake/carom/caromConfig.cmake"),
        ("caromConfigVersion.cmake.in", "lib/cmake/carom/caromConfigVersion.cmake"),
        ("carom.pc.in", "lib/pkgconfig/carom.pc"),
    ] {
        let template = workspace::root().join("capi/package").join(template);
        let text = fs::read_to_string(&template).with_context(|| format!("reading {}", template.display()))?;
        put(text.replace("@VERSION@", &version()?).as_bytes(), &prefix.join(place))?;
    }
    Ok(())
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    put(&fs::read(from).with_context(|| format!("reading {}", from.display()))?, to)
}

fn put(bytes: &[u8], to: &Path) -> Result<()> {
    if let Some(folder) = to.parent() {
        fs::create_dir_all(folder).with_context(|| format!("making {}", folder.display()))?;
    }
    fs::write(to, bytes).with_context(|| format!("writing {}", to.display()))?;
    println!("  {}", to.display());
    Ok(())
}

/// The version of carom-capi.
fn version() -> Result<String> {
    let manifest = fs::read_to_string(workspace::root().join("capi/Cargo.toml"))?;
    let line = manifest.lines().find_map(|line| line.strip_prefix("version = \""));
    Ok(line.context("capi/Cargo.toml states no version")?.trim_end_matches('"').to_owned())
}
