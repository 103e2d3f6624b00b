//! Values that a fuzzer makes: each is one that the constructors would give, and a world takes them all without a panic.
#![cfg(all(feature = "arbitrary", any(feature = "f32", feature = "f64", feature = "fixed")))]

#[macro_use]
#[path = "support/each_number.rs"]
mod each_number;
#[path = "support/random.rs"]
mod random;

use arbitrary::{Arbitrary, Unstructured};
use carom::solver::Settings;
use carom::{
    Body, Capsule, Contact, Cuboid, HalfSpace, InsertError, Material, Pose, Quat, Scalar, Scaled, Solid, Sphere,
    UnitVec3, Vec3, World,
};
use random::Random;

each_number!(values_are_valid, worlds_take_them);

carom::shapes! { enum Piece<S> { Sphere, Cuboid, Capsule, HalfSpace } }

/// Bytes for a value, a fifth of them small numbers: those that fit each other.
fn bytes(random: &mut Random) -> Vec<u8> {
    (0..256).map(|_| if random.below(5) == 0 { random.below(4) as u8 } else { random.below(256) as u8 }).collect()
}

fn is_unit<T: Scaled>(components: &[T]) -> bool {
    let square = components.iter().fold(T::ZERO, |sum, &x| sum + x * x);
    let off = square - T::ONE;
    off.max(-off) < T::from_parts(1, -15)
}

fn values_are_valid<S: Scalar + for<'a> Arbitrary<'a>>(name: &str)
where
    S::Unit: for<'a> Arbitrary<'a>,
{
    let mut random = Random::new(6);
    let (mut made, mut wild) = ([0u32; 8], 0);
    for _ in 0..4000 {
        let bytes = bytes(&mut random);
        let mut u = Unstructured::new(&bytes);
        let scaled = |x: S::Unit| x.to_scaled();
        if let Ok(direction) = UnitVec3::<S>::arbitrary(&mut u) {
            assert!(is_unit(&direction.get().to_array().map(scaled)), "{name}: {direction:?}");
            made[0] += 1;
        }
        if let Ok(rotation) = Quat::<S>::arbitrary(&mut u) {
            assert!(is_unit(&rotation.to_array().map(scaled)), "{name}: {rotation:?}");
            made[1] += 1;
        }
        if let Ok(material) = Material::<S>::arbitrary(&mut u) {
            assert!(Material::new(material.restitution(), material.friction()).is_ok(), "{name}: {material:?}");
            made[2] += 1;
        }
        if let Ok(cuboid) = Cuboid::<S>::arbitrary(&mut u) {
            assert_eq!(Cuboid::new(cuboid.half_extents()), Ok(cuboid));
            made[3] += 1;
        }
        if let Ok(solid) = Solid::<S>::arbitrary(&mut u) {
            assert!(
                solid.measure().is_positive() && solid.moments().iter().all(|x| x.is_positive()),
                "{name}: {solid:?}"
            );
            made[4] += 1;
        }
        if let Ok(body) = Body::<S>::arbitrary(&mut Unstructured::new(&bytes)) {
            assert!(body.is_immovable() || body.inv_mass().is_positive(), "{name}: {body:?}");
            assert!(body.inv_inertia_world().iter().all(|x| x.is_finite()), "{name}: {body:?}");
            wild += u32::from(body.check().is_err());
            made[5] += 1;
        }
        made[6] += u32::from(Pose::<S>::arbitrary(&mut u).is_ok());
        made[7] += u32::from(Contact::<S>::arbitrary(&mut u).is_ok());
    }
    for (kind, count) in [(0, 3000), (1, 3000), (2, 3000), (3, 2000), (4, 800), (5, 1000), (6, 1000), (7, 1000)] {
        assert!(made[kind] > count, "{name}: of kind {kind} only {}: {made:?}", made[kind]);
    }
    assert!(wild > 0 || S::STEP > S::ZERO, "{name}: no body is wild");
}

fn worlds_take_them<S: Scalar + for<'a> Arbitrary<'a>>(name: &str)
where
    S::Unit: for<'a> Arbitrary<'a>,
{
    let mut random = Random::new(7);
    let settings = Settings::new(Vec3::new(S::ZERO, S::ZERO, S::ONE.negated()), [1, 60], 2).expect("settings");
    let (mut taken, mut refused, mut steps) = (0, 0, 0);
    for _ in 0..300 {
        let mut world = World::<S, Piece<S>, 6, 12, 24>::new();
        for _ in 0..6 {
            let bytes = bytes(&mut random);
            let mut u = Unstructured::new(&bytes);
            let (Ok(body), Ok(material)) = (u.arbitrary::<Body<S>>(), u.arbitrary::<Material<S>>()) else { continue };
            let shape: Result<Piece<S>, _> = match random.below(4) {
                0 => u.arbitrary::<Sphere<S>>().map(Into::into),
                1 => u.arbitrary::<Cuboid<S>>().map(Into::into),
                2 => u.arbitrary::<Capsule<S>>().map(Into::into),
                _ => u.arbitrary::<HalfSpace<S>>().map(Into::into),
            };
            let Ok(shape) = shape else { continue };
            match world.insert(body, shape, material) {
                Ok(_) => taken += 1,
                Err(InsertError::NotFinite) => refused += 1,
                Err(error) => panic!("{name}: {error}"),
            }
        }
        for _ in 0..5 {
            world.step(&settings);
            steps += 1;
        }
    }
    assert!(taken > 300 && steps == 1500, "{name}: {taken} bodies taken, {refused} refused");
    assert!((refused > 0) == (S::STEP == S::ZERO), "{name}: {refused} refused");
}
