//! Says whether the firmware is for the micro:bit, which has 16 KB of RAM.

fn main() {
    println!("cargo::rustc-check-cfg=cfg(small)");
    if std::env::var("TARGET").is_ok_and(|target| target.starts_with("thumbv6m")) {
        println!("cargo::rustc-cfg=small");
    }
}
