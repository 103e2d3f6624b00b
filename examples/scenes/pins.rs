//! The state hashes that every machine must reach, by number type. A changed one is a changed result: say so in the
//! changelog.

type Pins = [(&'static str, u64); 6];

/// After the ten thousand impacts.
const IMPACTS: Pins = [
    ("f32", 0xf2bc_0c91_ec97_2289),
    ("f64", 0xc6e4_c7b9_4dfc_e9f7),
    ("i16f16", 0x7428_853f_0998_1e59),
    ("i12f20", 0xdd1a_f39f_eeb8_2fa1),
    ("i8f24", 0xf0ee_f313_4b10_41e9),
    ("micromath", 0xc21c_672c_d462_d5b7),
];

/// After the billiard break.
const BILLIARD_BREAK: Pins = [
    ("f32", 0x0d57_4d42_6784_95b8),
    ("f64", 0x2d6f_58b0_978f_b21a),
    ("i16f16", 0x99fd_44bf_db45_5903),
    ("i12f20", 0xfb7a_c278_3893_a799),
    ("i8f24", 0x7d2a_b922_3458_bd44),
    ("micromath", 0x66ff_9180_f048_731c),
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
