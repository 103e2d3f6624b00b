//! The pinned states, on the host: boards are held against the same numbers by their examples.

#[path = "../examples/scenes/mod.rs"]
mod scenes;

#[cfg(any(feature = "f32", feature = "fixed", feature = "f64", feature = "micromath"))]
mod pinned {
    use super::scenes::impacts::{IMPACTS, Scene};
    use super::scenes::pins::PINS;
    use super::scenes::shapes::meet_all;
    use super::scenes::table::{STEPS, Table};
    use super::scenes::{billiards, cradle, dice, edge, maze, pinball, stack};
    use carom::Scalar;
    use std::fmt::Write;

    fn impacts<S: Scalar>() -> Option<u64> {
        let mut scene = Scene::<S>::new()?;
        for _ in 0..IMPACTS {
            scene.step()?;
        }
        assert!(scene.stuck > 1000 && scene.slid > 3000 && scene.apart > 4000, "little happened");
        assert_eq!(scene.saturated, 0);
        Some(scene.hash())
    }

    fn billiard_break<S: Scalar>() -> Option<u64> {
        let mut table = Table::<S>::new()?;
        for _ in 0..STEPS {
            table.step();
        }
        assert!(table.ball_impacts > 30 && table.cushion_impacts > 15, "little happened");
        Some(table.hash())
    }

    fn shapes<S: Scalar>() -> Option<u64> {
        let mut met = 0;
        let hash = meet_all::<S>(&mut |meeting| met += u32::from(meeting.points > 0))?;
        assert_eq!(met, 10, "each pair meets");
        Some(hash)
    }

    /// What a scene comes to in a number type.
    fn hash<S: Scalar>(scene: &str) -> Option<u64> {
        match scene {
            "impacts" => impacts::<S>(),
            "billiard_break" => billiard_break::<S>(),
            "dice" => dice::hash::<S>(),
            "marble_maze" => maze::hash::<S>(),
            "newtons_cradle" => cradle::hash::<S>(),
            "billiards" => billiards::hash::<S>(),
            "stack" => stack::hash::<S>(),
            "edge" => edge::hash::<S>(),
            "shapes" => shapes::<S>(),
            "pinball" => pinball::hash::<S>(),
            _ => None,
        }
    }

    type Run = fn(&str) -> Option<u64>;

    /// The number types of this build.
    const SCALARS: &[(&str, Run)] = &[
        #[cfg(feature = "f32")]
        ("f32", hash::<f32>),
        #[cfg(feature = "f64")]
        ("f64", hash::<f64>),
        #[cfg(feature = "fixed")]
        ("i16f16", hash::<fixed::types::I16F16>),
        #[cfg(feature = "fixed")]
        ("i12f20", hash::<fixed::types::I12F20>),
        #[cfg(feature = "fixed")]
        ("i8f24", hash::<fixed::types::I8F24>),
        #[cfg(feature = "micromath")]
        ("micromath", hash::<micromath::F32>),
    ];

    /// All at once: where some differ, the failure holds the entries as they would have to be.
    #[test]
    fn every_scene_reaches_its_pinned_state() {
        let (mut held, mut wrong) = (0, String::new());
        for (scene, pins) in PINS {
            let mut lines = String::new();
            let mut moved = false;
            for (scalar, pinned) in *pins {
                let run = SCALARS.iter().find(|(name, _)| name == scalar);
                let found = run.map_or(*pinned, |(_, run)| run(scene).unwrap_or(0));
                held += usize::from(run.is_some());
                moved |= found != *pinned;
                let digits = format!("{found:016x}");
                let [a, b, c, d] = [0, 4, 8, 12].map(|i| &digits[i..i + 4]);
                let _ = writeln!(lines, "            (\"{scalar}\", 0x{a}_{b}_{c}_{d}),");
            }
            if moved {
                let _ = write!(wrong, "    (\n        \"{scene}\",\n        &[\n{lines}        ],\n    ),\n");
            }
        }
        assert!(wrong.is_empty(), "these states have moved; examples/scenes/pins.rs would read\n\n{wrong}");
        assert_eq!(held, PINS.len() * SCALARS.len(), "every scene in every number type");
    }

    /// One unit of the last place in one ball is another state.
    #[cfg(feature = "fixed")]
    #[test]
    fn the_hash_sees_one_bit() {
        use carom::StateHash;
        use fixed::types::I16F16;
        let table = Table::<I16F16>::new().expect("a table");
        let mut hash = StateHash::new();
        let mut other = StateHash::new();
        for (index, body) in table.bodies().enumerate() {
            hash.add_body(body);
            let mut body = *body;
            if index == 3 {
                body.angular_velocity.z = I16F16::DELTA;
            }
            other.add_body(&body);
        }
        assert_ne!(hash.get(), other.get());
        assert_eq!(hash.get(), table.hash());
    }
}
