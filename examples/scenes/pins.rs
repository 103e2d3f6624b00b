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
            ("i16f16", 0x7a54_87b8_9f61_b23a),
            ("i12f20", 0x8827_e70b_7d50_9c23),
            ("i8f24", 0x93f0_9812_4421_983d),
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
            ("f32", 0x1def_11af_a095_4a40),
            ("f64", 0x30d0_bb33_7286_73a9),
            ("i16f16", 0xe518_5f5b_8064_b4c1),
            ("i12f20", 0xa834_edc4_145e_d6b7),
            ("i8f24", 0xd662_d2c5_ee3a_557a),
            ("micromath", 0x320b_16a6_f78c_4459),
        ],
    ),
    (
        "marble_maze",
        &[
            ("f32", 0x1c56_8cc2_bbc3_1aa9),
            ("f64", 0x7092_e20f_703a_acaa),
            ("i16f16", 0x5d7a_a961_3493_2851),
            ("i12f20", 0x7ebb_e0e9_b7d3_802e),
            ("i8f24", 0x6462_ea91_64d5_b943),
            ("micromath", 0x3960_ce93_00b6_782c),
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
            ("f32", 0xb97a_06d0_7d66_c50f),
            ("f64", 0x8fe9_df00_4a6b_237e),
            ("i16f16", 0x257e_5d7b_29fc_4cab),
            ("i12f20", 0x2fc2_a156_7e3d_962c),
            ("i8f24", 0xbb92_5200_4a58_3dde),
            ("micromath", 0x7b8d_6921_87e5_39e4),
        ],
    ),
    (
        "stack",
        &[
            ("f32", 0x4776_01df_4e2f_a5a1),
            ("f64", 0x63e4_a72d_97bf_6589),
            ("i16f16", 0x454a_e579_4033_cf54),
            ("i12f20", 0x8caf_568b_1f97_b6be),
            ("i8f24", 0xd1b8_28c5_63b7_2c52),
            ("micromath", 0x3560_15ad_a7cc_705a),
        ],
    ),
    (
        "edge",
        &[
            ("f32", 0xb5b4_3aef_6718_2209),
            ("f64", 0x7cb5_7671_8762_eb0f),
            ("i16f16", 0x84f8_f52e_3ce6_a738),
            ("i12f20", 0x3b52_c548_2569_8aa4),
            ("i8f24", 0xaae9_a21d_2f9f_92d3),
            ("micromath", 0xdff5_4f2f_592c_6854),
        ],
    ),
    (
        "pinball",
        &[
            ("f32", 0x504f_aafc_77d5_c563),
            ("f64", 0x689d_a003_7003_a27c),
            ("i16f16", 0x47e9_8af9_8e59_a533),
            ("i12f20", 0xd9d8_3103_18a8_6e92),
            ("i8f24", 0xd56a_f6cc_4f38_8d89),
            ("micromath", 0x393a_46a4_fcec_d6ba),
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
