//! The state hashes that every machine must reach, by number type. A changed one is a changed result: say so in the
//! changelog.

type Pins = [(&'static str, u64); 6];

/// After the ten thousand impacts.
const IMPACTS: Pins = [
    ("f32", 0xa192_45ba_9e5c_7dca),
    ("f64", 0xa7c7_bf5c_672a_597b),
    ("i16f16", 0xbd64_a6a0_8dde_0f42),
    ("i12f20", 0xc659_9559_8578_eab7),
    ("i8f24", 0xf771_63c2_18d2_add6),
    ("micromath", 0x7f1d_ebe9_c59e_6fdf),
];

/// After the billiard break.
const BILLIARD_BREAK: Pins = [
    ("f32", 0xd5e0_9d6b_f346_196a),
    ("f64", 0xe148_a0e7_f1bd_bd0e),
    ("i16f16", 0xdbcf_89bc_73e9_5d27),
    ("i12f20", 0xe947_6dce_2897_1d87),
    ("i8f24", 0xb378_c1d1_4271_ea0e),
    ("micromath", 0x40f4_2111_6790_6998),
];

fn pin(pins: &Pins, scalar: &str) -> Option<u64> {
    pins.iter().find(|(name, _)| *name == scalar).map(|(_, hash)| *hash)
}

/// The hash after the ten thousand impacts.
pub fn impacts(scalar: &str) -> Option<u64> {
    pin(&IMPACTS, scalar)
}

/// The hash after the billiard break.
pub fn billiard_break(scalar: &str) -> Option<u64> {
    pin(&BILLIARD_BREAK, scalar)
}
