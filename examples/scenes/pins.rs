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
            ("f32", 0xef9c_54dc_0367_a002),
            ("f64", 0x5c5d_c1d6_0929_0924),
            ("i16f16", 0xc5b5_0861_b3b8_cb24),
            ("i12f20", 0x98fa_1795_c84a_97ec),
            ("i8f24", 0x50c0_5d1e_ee8f_518d),
            ("micromath", 0x276c_7623_4032_66e3),
        ],
    ),
    (
        "marble_maze",
        &[
            ("f32", 0x7f86_eb82_69c0_6e29),
            ("f64", 0x0f2b_0d80_213a_3442),
            ("i16f16", 0x18e3_7e32_648f_e02e),
            ("i12f20", 0xa0b3_fb76_e8db_a1ee),
            ("i8f24", 0x4034_2530_497b_f307),
            ("micromath", 0x1ec1_709f_d4d9_e114),
        ],
    ),
    (
        "newtons_cradle",
        &[
            ("f32", 0x8bf1_7a26_2264_5e4a),
            ("f64", 0xb110_67c8_4149_45fd),
            ("i16f16", 0x1f3e_3ad3_2850_5ccf),
            ("i12f20", 0xc68e_0d2f_9f5c_3dbe),
            ("i8f24", 0xc102_7780_5e36_ced4),
            ("micromath", 0xfdab_3068_8bce_9cee),
        ],
    ),
    (
        "billiards",
        &[
            ("f32", 0x2d39_1df8_5568_a48b),
            ("f64", 0x9efb_77aa_59bc_f568),
            ("i16f16", 0xd30e_dd79_5f73_045c),
            ("i12f20", 0x7b99_d81d_8c64_d588),
            ("i8f24", 0xb908_d876_7c66_7dbc),
            ("micromath", 0xf1d9_6fef_e6d6_2c6e),
        ],
    ),
    (
        "stack",
        &[
            ("f32", 0xe272_d0fe_e972_2741),
            ("f64", 0xfbc2_b196_b280_dd29),
            ("i16f16", 0x823b_51d7_3ebf_ee9f),
            ("i12f20", 0xdc16_e53a_4398_f44c),
            ("i8f24", 0x1f22_f3d5_f14e_a62e),
            ("micromath", 0xe932_1ffb_aff2_1fb8),
        ],
    ),
    (
        "edge",
        &[
            ("f32", 0x5eb4_8a88_5b53_a1d3),
            ("f64", 0x26b3_2956_de39_330b),
            ("i16f16", 0x023e_00f8_2fa9_d00e),
            ("i12f20", 0x9ffd_c526_dfba_f612),
            ("i8f24", 0xa40c_77cc_ae1c_90f2),
            ("micromath", 0x304e_4c87_2bca_90f4),
        ],
    ),
    (
        "pinball",
        &[
            ("f32", 0x28c2_cdea_f59d_a55a),
            ("f64", 0x316a_beaa_6bbb_5b0d),
            ("i16f16", 0x837a_7d8c_1f01_ad13),
            ("i12f20", 0x971c_4e86_723f_e257),
            ("i8f24", 0xf7dd_f91b_b671_af4f),
            ("micromath", 0x42f4_ef8e_3652_a0cc),
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
