//! The state hashes that every machine must reach, by scene and number type. A changed one is a changed result: say so in
//! the changelog. `cargo test --release --all-features --test determinism` prints the table as it would have to be.

/// Scenes, and their hashes by number type. A number type whose range a scene leaves is not there.
pub const PINS: &[(&str, &[(&str, u64)])] = &[
    // After the ten thousand impacts.
    (
        "impacts",
        &[
            ("f32", 0xb21e_a2ab_9faa_8c17),
            ("f64", 0x31de_54cb_6812_0d0b),
            ("i16f16", 0x6d0c_15c7_bb63_cc38),
            ("i12f20", 0xfcf9_478f_77c5_95f1),
            ("i8f24", 0xf465_d73d_6de0_aca9),
            ("micromath", 0x9fe5_163e_ff18_1106),
        ],
    ),
    // After the break of the impulse kernel alone.
    (
        "billiard_break",
        &[
            ("f32", 0xc612_7363_645d_6a25),
            ("f64", 0x4ef6_f21c_1790_eed0),
            ("i16f16", 0xbf4a_bb27_b084_20d9),
            ("i12f20", 0x334b_eb3a_9c3a_82db),
            ("i8f24", 0xe3dd_4b13_4083_22c8),
            ("micromath", 0x6b88_4f1a_a57b_85d0),
        ],
    ),
    (
        "dice",
        &[
            ("f32", 0x4c74_0088_e567_0d15),
            ("f64", 0x630b_d8b7_bedd_d0fb),
            ("i16f16", 0x0eaa_1ec9_6375_5ef5),
            ("i12f20", 0x99a0_7799_6886_342c),
            ("i8f24", 0xd68b_f75b_f46d_d7f6),
            ("micromath", 0x45c2_f4dd_19d1_20ee),
        ],
    ),
    (
        "marble_maze",
        &[
            ("f32", 0x62ad_90f9_96c0_136c),
            ("f64", 0x236e_4ed9_2d1d_ae87),
            ("i16f16", 0x8d31_aada_4e54_39d6),
            ("i12f20", 0xe7f8_06ca_b3d2_5ca4),
            ("i8f24", 0xca34_50c4_287f_b2ca),
            ("micromath", 0x04b5_9f1d_6877_fb82),
        ],
    ),
    (
        "newtons_cradle",
        &[
            ("f32", 0xd4b9_ab60_79cf_693b),
            ("f64", 0x061c_bbea_585b_a2e7),
            ("i16f16", 0xe8fb_9310_325e_b199),
            ("i12f20", 0x628d_3c62_ee72_3234),
            ("i8f24", 0xad71_99b8_2f30_03ab),
            ("micromath", 0xf10e_c9ff_8060_1af2),
        ],
    ),
    (
        "billiards",
        &[
            ("f32", 0xce3f_ec55_bc6f_9edc),
            ("f64", 0x27c8_ba94_3b1f_c656),
            ("i16f16", 0x41c0_c36a_1ce3_ce83),
            ("i12f20", 0x79ee_c28b_e101_c8e7),
            ("i8f24", 0x2687_ae50_5995_8697),
            ("micromath", 0x47fb_7179_285d_edbd),
        ],
    ),
    (
        "stack",
        &[
            ("f32", 0x4776_01df_4e2f_a5a1),
            ("f64", 0x63e4_a72d_97bf_6589),
            ("i16f16", 0x5f78_c45f_83c6_4c8d),
            ("i12f20", 0xee10_7834_0cb5_6382),
            ("i8f24", 0x533f_874c_66fa_a5fa),
            ("micromath", 0x3560_15ad_a7cc_705a),
        ],
    ),
    (
        "edge",
        &[
            ("f32", 0xb5b4_3aef_6718_2209),
            ("f64", 0x7cb5_7671_8762_eb0f),
            ("i16f16", 0x84f8_f52e_3ce6_a738),
            ("i12f20", 0xd4db_9733_7eb6_9956),
            ("i8f24", 0xaae9_a21d_2f9f_92d3),
            ("micromath", 0xdff5_4f2f_592c_6854),
        ],
    ),
    (
        "pinball",
        &[
            ("f32", 0xffed_b960_d498_cfc4),
            ("f64", 0xdff6_5ab5_1f79_2335),
            ("i16f16", 0xfb52_353c_cc98_086d),
            ("i12f20", 0x7077_5f64_2bc4_f3db),
            ("i8f24", 0x99e4_ccea_3ceb_df9b),
            ("micromath", 0xdfe7_8b00_1309_87f4),
        ],
    ),
    // Each pair of shapes once, and how they meet.
    (
        "shapes",
        &[
            ("f32", 0x698f_166a_b3c8_de05),
            ("f64", 0x5b98_6ab7_23c8_ab0e),
            ("i16f16", 0x0d71_87c3_a4d1_9516),
            ("i12f20", 0x9f12_8aa3_5587_cd5a),
            ("i8f24", 0x20ee_5d4b_065a_893b),
            ("micromath", 0xabfd_157e_53ab_6c8c),
        ],
    ),
];

/// The hash that the scene must reach in that number type.
pub fn pin(scene: &str, scalar: &str) -> Option<u64> {
    let (_, pins) = PINS.iter().find(|(name, _)| *name == scene)?;
    pins.iter().find(|(name, _)| *name == scalar).map(|(_, hash)| *hash)
}
