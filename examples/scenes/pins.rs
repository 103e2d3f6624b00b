//! The state hashes that every machine must reach, by number type. A changed one is a changed result: say so in the
//! changelog.

type Pins = [(&'static str, u64); 6];

/// After the ten thousand impacts.
const IMPACTS: Pins = [
    ("f32", 0xb21e_a2ab_9faa_8c17),
    ("f64", 0x31de_54cb_6812_0d0b),
    ("i16f16", 0x6d0c_15c7_bb63_cc38),
    ("i12f20", 0xfcf9_478f_77c5_95f1),
    ("i8f24", 0xf465_d73d_6de0_aca9),
    ("micromath", 0x9fe5_163e_ff18_1106),
];

/// After the billiard break.
const BILLIARD_BREAK: Pins = [
    ("f32", 0xc612_7363_645d_6a25),
    ("f64", 0x4ef6_f21c_1790_eed0),
    ("i16f16", 0xbf4a_bb27_b084_20d9),
    ("i12f20", 0x334b_eb3a_9c3a_82db),
    ("i8f24", 0xe3dd_4b13_4083_22c8),
    ("micromath", 0x6b88_4f1a_a57b_85d0),
];

/// Of the pairs of shapes.
const SHAPES: Pins = [
    ("f32", 0x698f_166a_b3c8_de05),
    ("f64", 0x5b98_6ab7_23c8_ab0e),
    ("i16f16", 0x0d71_87c3_a4d1_9516),
    ("i12f20", 0x9f12_8aa3_5587_cd5a),
    ("i8f24", 0x20ee_5d4b_065a_893b),
    ("micromath", 0xabfd_157e_53ab_6c8c),
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

/// The hash of the pairs of shapes.
pub fn shapes(scalar: &str) -> Option<u64> {
    pin(&SHAPES, scalar)
}
