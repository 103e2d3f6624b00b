//! The state hashes that every machine must reach, by number type. A changed one is a changed result: say so in the
//! changelog.

type Pins = [(&'static str, u64); 6];

/// After the ten thousand impacts.
const IMPACTS: Pins = [
    ("f32", 0x4a15_33f6_9736_6185),
    ("f64", 0xd551_7569_c85f_af22),
    ("i16f16", 0x8bba_bcc4_d3fa_8c29),
    ("i12f20", 0xce6e_00f1_e49d_5e58),
    ("i8f24", 0x3bfa_0ada_4a68_0aee),
    ("micromath", 0x2e75_ad8a_b54d_6d21),
];

/// After the billiard break.
const BILLIARD_BREAK: Pins = [
    ("f32", 0xde52_d5d3_dc89_653c),
    ("f64", 0xb54b_138a_8326_5839),
    ("i16f16", 0xbf4a_bb27_b084_20d9),
    ("i12f20", 0x334b_eb3a_9c3a_82db),
    ("i8f24", 0xe3dd_4b13_4083_22c8),
    ("micromath", 0x64f5_7e56_20da_be36),
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
