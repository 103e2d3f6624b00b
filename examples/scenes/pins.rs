//! The state hashes that every machine must reach, by number type. A changed one is a changed result: say so in the
//! changelog.

type Pins = [(&'static str, u64); 6];

/// After the ten thousand impacts.
const IMPACTS: Pins = [
    ("f32", 0xe37c_a8d1_1eb4_6702),
    ("f64", 0x1c85_b128_a306_f80a),
    ("i16f16", 0x2867_c133_24ce_1851),
    ("i12f20", 0x6331_a244_1884_cc6a),
    ("i8f24", 0x7754_6bdd_3858_dac7),
    ("micromath", 0x4480_9f34_ece0_2069),
];

/// After the billiard break.
const BILLIARD_BREAK: Pins = [
    ("f32", 0x03c4_0e55_e108_10e7),
    ("f64", 0x8355_65a9_beca_2366),
    ("i16f16", 0xdb4c_d782_c2bc_6411),
    ("i12f20", 0xfb7a_c278_3893_a799),
    ("i8f24", 0x7d2a_b922_3458_bd44),
    ("micromath", 0x295e_e786_e1bc_fc96),
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
