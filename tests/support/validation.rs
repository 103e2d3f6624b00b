//! Data sets that others measured: not in the repository, found through `CAROM_VALIDATION`.

#![allow(dead_code)]

use std::path::{Path, PathBuf};

/// The file of that name in the folder that `CAROM_VALIDATION` names.
///
/// Without the variable the test that asks says that it was not run and why; under `CI` that is a failure.
pub fn file(name: &str) -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("CAROM_VALIDATION") else {
        assert!(std::env::var_os("CI").is_none(), "CAROM_VALIDATION is not set: {name} would go unchecked");
        println!("NOT RUN: {name} is not part of the repository; set CAROM_VALIDATION (see docs/validation.md)");
        return None;
    };
    let path = Path::new(&folder).join(name);
    assert!(path.is_file(), "{} is missing from the folder that CAROM_VALIDATION names", path.display());
    Some(path)
}
