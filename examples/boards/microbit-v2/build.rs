//! The memory map of this board.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=memory.x");
    let here = std::env::var("CARGO_MANIFEST_DIR").expect("cargo runs this");
    println!("cargo::rustc-link-search={here}");
}
