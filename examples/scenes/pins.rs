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
            ("f32", 0xbc6e_b404_a395_0006),
            ("f64", 0xc04c_d481_4f81_640d),
            ("i16f16", 0x6994_4d35_0f03_860b),
            ("i12f20", 0xa85d_3add_67f3_dd13),
            ("i8f24", 0xf655_3173_c638_a9d7),
            ("micromath", 0x02f8_4675_8a7f_12e5),
        ],
    ),
    (
        "marble_maze",
        &[
            ("f32", 0x8290_7b93_0d40_9e19),
            ("f64", 0x9564_75b4_e657_0a3a),
            ("i16f16", 0x8ebf_8d01_5f4f_579d),
            ("i12f20", 0x3099_95ee_c3d8_c7f3),
            ("i8f24", 0x003d_1871_05eb_443c),
            ("micromath", 0x7a58_2f6e_eb62_066c),
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
            ("f32", 0xc7ca_9e6c_3cc2_d28a),
            ("f64", 0x44a5_1d2b_7779_9c05),
            ("i16f16", 0x0c5c_390c_679d_6beb),
            ("i12f20", 0x2034_6904_44a4_5ab7),
            ("i8f24", 0xad47_ed47_a531_1cfd),
            ("micromath", 0xd607_5c42_b66f_6fc1),
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
            ("f32", 0x8d54_f53f_9bc7_e525),
            ("f64", 0xb7b6_879f_ebd8_5a90),
            ("i16f16", 0x0642_2dc7_2e85_deee),
            ("i12f20", 0x8181_311c_7bc3_f0b7),
            ("i8f24", 0x175e_cda4_7a26_7a21),
            ("micromath", 0x1c61_811d_e90f_a8b8),
        ],
    ),
    (
        "pinball",
        &[
            ("f32", 0x5262_d38f_b52c_ea42),
            ("f64", 0xeeb5_c7c3_cda8_c017),
            ("i16f16", 0x78b6_97d2_ec46_394f),
            ("i12f20", 0x0df9_ed04_7390_a137),
            ("i8f24", 0x6f65_d6f7_acfb_e015),
            ("micromath", 0x3e2c_a8dd_9ef7_07f8),
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
