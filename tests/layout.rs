//! What firmware relies on without calling it: sizes, statics, threads.

use carom::{Body, Contact, Material, Scalar};

#[allow(dead_code)]
fn is_shareable<T: Send + Sync + Copy + 'static>() {}

#[allow(dead_code)]
fn shareable<S: Scalar>() {
    is_shareable::<Body<S>>();
    is_shareable::<Contact<S>>();
    is_shareable::<Material<S>>();
}

#[cfg(feature = "f32")]
mod f32 {
    use super::*;
    use carom::{UnitVec3, Vec3};

    static GROUND: Body<f32> = Body::immovable();
    static UP: Contact<f32> = Contact { normal: UnitVec3::Y, r_a: Vec3::ZERO, r_b: Vec3::new(0.0, -1.0, 0.0) };

    #[test]
    fn sizes_and_statics() {
        assert_eq!(size_of::<Body<f32>>(), 140);
        assert_eq!(size_of::<Contact<f32>>(), 36);
        assert!(GROUND.is_immovable() && UP.r_b.y == -1.0);
    }
}

#[cfg(feature = "fixed")]
mod fixed_point {
    use super::*;
    use carom::Quat;
    use fixed::types::I16F16;

    static GROUND: Body<I16F16> = Body::immovable();
    static TURN: Quat<I16F16> = Quat::IDENTITY;
    const DEAD: Material<I16F16> = Material::DEAD;

    #[test]
    fn sizes_and_statics() {
        assert_eq!(size_of::<Body<I16F16>>(), 156);
        assert_eq!(size_of::<Contact<I16F16>>(), 36);
        assert!(GROUND.is_immovable() && GROUND.orientation() == TURN && DEAD.friction() == I16F16::ZERO);
    }
}
