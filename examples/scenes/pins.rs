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
            ("f32", 0xe456_8c97_1d76_222f),
            ("f64", 0x0ee4_69dc_a7e0_4c50),
            ("i16f16", 0x2281_c0a9_d775_c7aa),
            ("i12f20", 0xdabc_d621_918f_9840),
            ("i8f24", 0x6023_6cde_5dcc_2ae3),
            ("micromath", 0xdea0_187d_84fd_e862),
        ],
    ),
    (
        "marble_maze",
        &[
            ("f32", 0xd13f_0dd3_d6d4_eb71),
            ("f64", 0x575e_228a_58ad_d5fc),
            ("i16f16", 0x0410_b08c_c0e8_cd20),
            ("i12f20", 0x5364_f10c_35c5_f242),
            ("i8f24", 0xdb45_d057_e169_13c2),
            ("micromath", 0x95a4_bc01_72e1_fbea),
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
            ("f32", 0x1b12_8def_34a5_c6ea),
            ("f64", 0x9dd0_97f9_62ee_f32f),
            ("i16f16", 0x80fb_761e_6b97_df0e),
            ("i12f20", 0x4e46_268b_91ea_6608),
            ("i8f24", 0xbfd1_79d2_f8d4_5f27),
            ("micromath", 0x066e_f51b_63b4_94c3),
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
            ("f32", 0x19c9_cf72_2c9b_adbb),
            ("f64", 0x193a_94b5_1312_b202),
            ("i16f16", 0x8a50_b7c8_84d1_bec4),
            ("i12f20", 0xea3b_b58c_fb53_8d35),
            ("i8f24", 0xb41b_cf67_230c_4be4),
            ("micromath", 0x7155_e715_4218_a63f),
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
