//! The state hashes that every machine must reach, by number type. A changed one is a changed result: say so in the
//! changelog.

type Pins = [(&'static str, u64); 6];

/// After the ten thousand impacts.
const IMPACTS: Pins = [
    ("f32", 0xe287_4150_53ba_ed5b),
    ("f64", 0x0993_0577_5f32_e903),
    ("i16f16", 0x6d0c_15c7_bb63_cc38),
    ("i12f20", 0xa540_edf4_6a71_1f58),
    ("i8f24", 0xeded_48f1_3242_a4ce),
    ("micromath", 0x9ed9_431f_462c_7537),
];

/// After the billiard break.
const BILLIARD_BREAK: Pins = [
    ("f32", 0x3590_b776_f856_55e4),
    ("f64", 0x4d3c_b06a_933f_5d77),
    ("i16f16", 0xbf4a_bb27_b084_20d9),
    ("i12f20", 0x334b_eb3a_9c3a_82db),
    ("i8f24", 0xe3dd_4b13_4083_22c8),
    ("micromath", 0x7b1a_2dc1_0c4e_206c),
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
