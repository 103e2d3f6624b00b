//! Bodies as bytes come back bit for bit and go on; what no constructor makes is refused, and nothing that is taken in harms.
#![cfg(all(feature = "bytemuck", any(feature = "f32", feature = "f64", feature = "fixed")))]

#[macro_use]
#[path = "support/each_number.rs"]
mod each_number;
#[cfg(feature = "arbitrary")]
#[path = "support/random.rs"]
mod random;

#[cfg(feature = "arbitrary")]
use arbitrary::{Arbitrary, Unstructured};
use bytemuck::checked::{try_cast_slice, try_pod_read_unaligned};
use bytemuck::{CheckedBitPattern, NoUninit, Pod, bytes_of, cast_slice};
use carom::solver::Settings;
use carom::{Body, BodyHandle, Cuboid, HalfSpace, Material, Quat, Scalar, Solid, UnitVec3, Vec3, World};

#[cfg(feature = "arbitrary")]
each_number!(what_safe_code_makes_comes_back);
each_number!(bodies_go_on, directions_are_checked, damage_is_refused_or_harmless, impossible_bodies_are_refused);

carom::shapes! { enum Piece<S> { Cuboid, HalfSpace } }

type Room<S> = World<S, Piece<S>, 4, 12, 32>;

fn ratio<S: Scalar>(numerator: i32, denominator: i32) -> S {
    S::from_ratio(numerator, denominator).expect("a number within the format")
}

fn vector<S: Scalar>(x: i32, y: i32, z: i32) -> Vec3<S> {
    Vec3::new(ratio(x, 1000), ratio(y, 1000), ratio(z, 1000))
}

fn tilted<S: Scalar>() -> Quat<S> {
    let part = |n| <S::Unit as Scalar>::from_ratio(n, 1000).expect("a component");
    Quat::normalize(part(700), part(-300), part(100), part(450)).expect("a rotation")
}

/// A box that tumbles and slides, and the ground.
fn scene<S: Scalar>() -> (Room<S>, Settings<S>, BodyHandle) {
    let mut world = Room::new();
    let wood = Material::new(ratio(3, 10), ratio(4, 10)).expect("a material");
    world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), wood).expect("room");
    let half = vector(100, 150, 200);
    let mass = Solid::cuboid(half).expect("a solid").with_mass(ratio(12, 10)).expect("a mass");
    let mut body = Body::dynamic(mass).at(vector(0, 0, 600)).moving(vector(900, -350, 0));
    body.set_orientation(tilted());
    body.angular_velocity = vector(1500, 2500, -700);
    let body = world.insert(body, Cuboid::new(half).expect("a shape"), wood).expect("room");
    (world, Settings::new(vector(0, 0, -9810), [1, 60], 4).expect("settings"), body)
}

/// Each body of a run comes back with every bit, and the one that came back goes on as the one that was kept.
fn bodies_go_on<S: Scalar>(name: &str)
where
    Body<S>: NoUninit + CheckedBitPattern,
{
    let (mut world, settings, handle) = scene::<S>();
    for _ in 0..90 {
        world.step(&settings);
        let bodies: Vec<Body<S>> = world.bodies().map(|(_, body)| *body).collect();
        let bytes: &[u8] = cast_slice(&bodies);
        let back: &[Body<S>] = try_cast_slice(bytes).unwrap_or_else(|error| panic!("{name}: {error:?}"));
        assert_eq!(back, bodies);
    }
    let mut copy = world.clone();
    let kept = *world.body(handle).expect("the box");
    let back = try_pod_read_unaligned::<Body<S>>(bytes_of(&kept)).expect("a body");
    *copy.body_mut(handle).expect("the box") = back;
    world.body_mut(handle).expect("the box");
    for _ in 0..60 {
        world.step(&settings);
        copy.step(&settings);
        assert_eq!(copy.hash(), world.hash(), "{name}");
    }
}

fn directions_are_checked<S: Scalar>(_: &str)
where
    S::Unit: Pod,
{
    let direction = UnitVec3::<S>::normalize(vector(3, -100, 77)).expect("a direction");
    assert_eq!(try_pod_read_unaligned::<UnitVec3<S>>(bytes_of(&direction)), Ok(direction));
    assert_eq!(try_pod_read_unaligned::<Quat<S>>(bytes_of(&tilted::<S>())), Ok(tilted::<S>()));
    assert!(try_pod_read_unaligned::<UnitVec3<S>>(&vec![0; size_of::<UnitVec3<S>>()]).is_err());
    assert!(try_pod_read_unaligned::<Quat<S>>(&vec![0; size_of::<Quat<S>>()]).is_err());
}

/// Every bit of a body turned over, one at a time: what is refused and what is taken in differ by field, and a world steps on with
/// whatever is taken in.
fn damage_is_refused_or_harmless<S: Scalar>(name: &str)
where
    Body<S>: NoUninit + CheckedBitPattern,
{
    let (mut world, settings, handle) = scene::<S>();
    for _ in 0..20 {
        world.step(&settings);
    }
    let body = *world.body(handle).expect("the box");
    let mut bytes = bytes_of(&body).to_vec();
    let (mut refused, mut taken) = (0, 0);
    for bit in 0..bytes.len() * 8 {
        bytes[bit / 8] ^= 1 << (bit % 8);
        match try_pod_read_unaligned::<Body<S>>(&bytes) {
            Err(_) => refused += 1,
            Ok(damaged) => {
                taken += 1;
                assert!(damaged.check().is_ok(), "{name}: bit {bit}");
                let mut turned = damaged;
                turned.set_orientation(damaged.orientation());
                assert_eq!(turned, damaged, "{name}: bit {bit}: the tensor is another than the orientation's");
                let mut world = world.clone();
                *world.body_mut(handle).expect("the box") = damaged;
                world.step(&settings);
            }
        }
        bytes[bit / 8] ^= 1 << (bit % 8);
    }
    // Of the tensor in the world's frame no bit is free.
    let tensor = 6 * 8 * size_of::<S::Unit>();
    assert!(refused >= tensor, "{name}: {refused} refused");
    assert!(taken > 9 * 20, "{name}: {taken} taken in");
}

/// What no call makes, word by word; a body is its fields one behind the other.
fn impossible_bodies_are_refused<S: Scalar>(name: &str)
where
    Body<S>: NoUninit + CheckedBitPattern,
{
    let (_, _, handle) = scene::<S>();
    let body = *scene::<S>().0.body(handle).expect("the box");
    let bytes = bytes_of(&body);
    let (word, unit) = (size_of::<S>(), size_of::<S::Unit>());
    let inv_mass = 12 * word;
    let local = inv_mass + size_of::<S::Scaled>() + 6 * unit + size_of::<S::Exponent>();
    let orientation = local + 6 * unit;
    let carried = orientation + 7 * unit;
    let refused = |what: &str, at: usize, change: &[u8]| {
        let mut damaged = bytes.to_vec();
        damaged[at..at + change.len()].copy_from_slice(change);
        let taken = try_pod_read_unaligned::<Body<S>>(&damaged);
        assert!(taken.is_err(), "{name}: {what} is taken in: {taken:?}");
    };
    assert!(try_pod_read_unaligned::<Body<S>>(bytes) == Ok(body));
    refused("no orientation", orientation, &vec![0; 4 * unit]);
    let mut ground = bytes_of(&Body::<S>::immovable()).to_vec();
    assert!(try_pod_read_unaligned::<Body<S>>(&ground) == Ok(Body::immovable()));
    ground[orientation..orientation + 4 * unit].fill(0);
    assert!(
        try_pod_read_unaligned::<Body<S>>(&ground).is_err(),
        "{name}: the ground without an orientation is taken in"
    );
    refused("ratios of moments that are not the tensor's", orientation + 4 * unit, &vec![0x55; 3 * unit]);
    refused("a moment below zero", local, &[bytes[local..local + unit - 1].to_vec(), vec![0xff]].concat());
    if S::STEP == S::ZERO {
        // Of floats the sign is the last bit.
        let last = inv_mass + word - 1;
        refused("a mass below zero", last, &[bytes[last] | 0x80]);
        for (what, at) in [("place", 0), ("mass", inv_mass), ("damping", 11 * word), ("part of a place", carried)] {
            refused(&format!("a {what} that is no number"), at, &vec![0xff; word]);
        }
    } else {
        let parts = |mantissa: i32, exponent: i32| [mantissa.to_ne_bytes(), exponent.to_ne_bytes()].concat();
        refused("a mantissa of few bits", inv_mass, &parts(1, 0));
        refused("a mantissa of many bits", inv_mass, &parts(i32::MAX, 0));
        refused("a mass below zero", inv_mass, &parts(-(1 << 29), 0));
        refused("an exponent beyond all use", inv_mass, &parts(1 << 29, i32::MAX));
        refused("an exponent of the tensor beyond all use", local - 4, &i32::MAX.to_ne_bytes());
        refused("something where nothing is", bytes.len() - 2, &[1, 0]);
    }
}

/// Whatever safe code could make comes back with every bit, unless a number in it is none: in floating point also where moments of
/// inertia are too far apart for their ratios.
#[cfg(feature = "arbitrary")]
fn what_safe_code_makes_comes_back<S: Scalar + for<'a> Arbitrary<'a>>(name: &str)
where
    S::Unit: for<'a> Arbitrary<'a>,
    Body<S>: NoUninit + CheckedBitPattern,
{
    let mut random = random::Random::new(8);
    let (mut taken, mut refused) = (0, 0);
    for _ in 0..4000 {
        let seed: Vec<u8> =
            (0..256).map(|_| if random.below(5) == 0 { random.below(4) } else { random.below(256) } as u8).collect();
        let Ok(body) = Body::<S>::arbitrary(&mut Unstructured::new(&seed)) else { continue };
        match try_pod_read_unaligned::<Body<S>>(bytes_of(&body)) {
            Ok(back) => {
                assert_eq!(bytes_of(&back), bytes_of(&body), "{name}");
                taken += 1;
            }
            Err(_) => {
                let text = format!("{body:?}");
                assert!(
                    text.contains("NaN") || text.contains("inf,") || text.contains("inf }"),
                    "{name}: refused: {text}"
                );
                refused += 1;
            }
        }
    }
    assert!(taken > 500, "{name}: {taken} taken in");
    assert!((refused > 0) == (S::STEP == S::ZERO), "{name}: {refused} refused");
}
