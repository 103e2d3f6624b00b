//! The memory map of the repository's root.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "none") {
        let here = std::env::var("CARGO_MANIFEST_DIR").expect("cargo runs this");
        println!("cargo::rustc-link-search={here}/../..");
    }
}
