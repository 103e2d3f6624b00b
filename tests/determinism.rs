//! The pinned states, on the host: boards are held against the same numbers by their examples.

#[path = "../examples/scenes/mod.rs"]
mod scenes;

#[cfg(any(feature = "f32", feature = "fixed", feature = "f64", feature = "micromath"))]
mod pinned {
    use super::scenes::impacts::{IMPACTS, Scene};
    use super::scenes::pins;
    use super::scenes::shapes::meet_all;
    use super::scenes::table::{STEPS, Table};
    use carom::Scalar;

    fn scenes<S: Scalar>(name: &str) {
        let mut scene = Scene::<S>::new().expect("a scene");
        for _ in 0..IMPACTS {
            scene.step().expect("an impact");
        }
        assert!(scene.stuck > 1000 && scene.slid > 3000 && scene.apart > 4000, "{name}: little happened");
        assert_eq!(scene.saturated, 0, "{name}");
        assert_eq!(pins::impacts(name), Some(scene.hash()), "{name}: {:#018x}", scene.hash());

        let mut table = Table::<S>::new().expect("a table");
        for _ in 0..STEPS {
            table.step();
        }
        assert!(table.ball_impacts > 30 && table.cushion_impacts > 15, "{name}: little happened");
        assert_eq!(pins::billiard_break(name), Some(table.hash()), "{name}: {:#018x}", table.hash());

        let mut met = 0;
        let hash = meet_all::<S>(&mut |meeting| met += u32::from(meeting.points > 0)).expect("a scene");
        assert_eq!(met, 10, "{name}: each pair meets");
        assert_eq!(pins::shapes(name), Some(hash), "{name}: {hash:#018x}");
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

    macro_rules! pinned {
        ($($feature:literal $name:ident $number:ty;)+) => {$(
            #[cfg(feature = $feature)]
            #[test]
            fn $name() {
                scenes::<$number>(stringify!($name));
            }
        )+};
    }

    pinned! {
        "f32" f32 f32;
        "f64" f64 f64;
        "micromath" micromath micromath::F32;
        "fixed" i16f16 fixed::types::I16F16;
        "fixed" i12f20 fixed::types::I12F20;
        "fixed" i8f24 fixed::types::I8F24;
    }
}
