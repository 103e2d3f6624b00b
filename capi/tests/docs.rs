//! The sizes in docs/c.md are those of the header.
#![cfg(all(feature = "f32", feature = "fixed"))]

use carom_c::abi::*;

const PAGE: &str = include_str!("../../docs/c.md");

fn thousands(n: usize) -> String {
    if n < 1000 { n.to_string() } else { format!("{},{:03}", n / 1000, n % 1000) }
}

#[test]
fn sizes_of_worlds() {
    for (name, float, fixed) in [
        ("world_4x12", CAROM_F32_WORLD_4X12_SIZE, CAROM_Q16_WORLD_4X12_SIZE),
        ("world_16x12", CAROM_F32_WORLD_16X12_SIZE, CAROM_Q16_WORLD_16X12_SIZE),
        ("world_16x64", CAROM_F32_WORLD_16X64_SIZE, CAROM_Q16_WORLD_16X64_SIZE),
        ("world_64x256", CAROM_F32_WORLD_64X256_SIZE, CAROM_Q16_WORLD_64X256_SIZE),
        ("balls_16x16", CAROM_F32_BALLS_16X16_SIZE, CAROM_Q16_BALLS_16X16_SIZE),
    ] {
        let (begin, end) =
            (format!("| `carom_..._{name}_init` |"), format!("| {} | {} |", thousands(float), thousands(fixed)));
        let found = PAGE.lines().any(|line| line.starts_with(&begin) && line.ends_with(&end));
        assert!(found, "docs/c.md should have a row that begins with\n{begin}\nand ends with\n{end}");
    }
}
