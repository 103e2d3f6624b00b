//! What goes out through serde comes back bit for bit, in a binary format and in text; what no constructor makes is refused.
#![cfg(all(feature = "serde", any(feature = "f32", feature = "f64", feature = "fixed")))]

#[macro_use]
#[path = "support/each_number.rs"]
mod each_number;

use std::fmt::Debug;

use carom::impulse::{Impact, resolve_collision_with_friction};
use carom::solver::Settings;
use carom::world::{Filter, Touching, WorldReport};
use carom::{
    Body, BodyHandle, Capsule, Contact, Cuboid, HalfSpace, MassProperties, Material, Pose, Quat, RestitutionLaw,
    Scalar, Scaled, Solid, Sphere, StepArithmetic, SymMat3, UnitVec3, Vec3, World,
};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

each_number!(values_come_back, bodies_go_on, wild_masses_come_back, invalid_values_are_refused, sets_of_shapes);

/// A number type whose family can be written.
trait Written:
    Scalar<Unit: Both, Scaled: Both, Exponent: Both, Remainder: Both, Step: StepArithmetic<Self, Rest: Both>> + Both
{
}
impl<S> Written for S where
    S: Scalar<Unit: Both, Scaled: Both, Exponent: Both, Remainder: Both, Step: StepArithmetic<S, Rest: Both>> + Both
{
}
trait Both: Serialize + DeserializeOwned {}
impl<T: Serialize + DeserializeOwned> Both for T {}

/// Through postcard and JSON and back: each must give the same value, and Debug the same text, which tells zeros apart.
fn comes_back<T: Both + PartialEq + Debug>(value: &T) {
    let bytes = postcard::to_stdvec(value).expect("bytes");
    let text = serde_json::to_string(value).expect("text");
    let from_bytes: T = postcard::from_bytes(&bytes).expect("a value");
    let from_text: T = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error} in {text}"));
    for back in [from_bytes, from_text] {
        assert_eq!(back, *value);
        assert_eq!(format!("{back:?}"), format!("{value:?}"));
    }
}

fn refused<T: DeserializeOwned + Debug>(text: &str, why: &str) {
    let error = serde_json::from_str::<T>(text).expect_err(text).to_string();
    assert!(error.contains(why), "`{error}` does not speak of `{why}`: {text}");
}

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

fn values_come_back<S: Written>(_: &str) {
    comes_back(&vector::<S>(1, -2, 3141));
    comes_back(&tilted::<S>());
    comes_back(&tilted::<S>().to_mat3());
    comes_back(&Pose::<S>::new(vector(1, -2, 3), tilted()));
    let direction = UnitVec3::normalize(vector::<S>(3, -100, 77)).expect("a direction");
    comes_back(&direction);
    comes_back(&Contact { normal: direction, r_a: vector(20, 0, -1), r_b: vector(-7, 8, 9) });
    comes_back(&Material::<S>::new(ratio(1, 3), ratio(2, 7)).expect("a material").with_law(RestitutionLaw::EnergySafe));
    comes_back(&Sphere::<S>::new(ratio(1, 30)).expect("a shape"));
    comes_back(&Cuboid::<S>::new(vector(10, 20, 33)).expect("a shape"));
    comes_back(&Capsule::<S>::new(ratio(1, 30), ratio(1, 7)).expect("a shape"));
    comes_back(&HalfSpace::<S>::new(direction));
    comes_back(&Solid::<S>::cuboid(vector(10, 20, 33)).expect("a solid"));
    comes_back(&Filter { groups: 6, meets: 9 });

    let solid = Solid::<S>::sphere(ratio(28, 1000)).expect("a solid").with_mass(ratio(17, 100)).expect("a mass");
    let (mut a, mut b) = (Body::dynamic(solid).moving(vector(2000, 300, 0)), Body::dynamic(solid));
    let contact = Contact { normal: UnitVec3::X, r_a: vector(28, 0, 0), r_b: vector(-28, 0, 0) };
    let surface = Material::new(ratio(9, 10), ratio(1, 10)).expect("a material");
    let impact: Impact<S> = resolve_collision_with_friction(&mut a, &mut b, &contact, &surface);
    assert!(impact.normal_impulse > S::ZERO);
    comes_back(&impact);
}

carom::shapes! {
    #[derive(Serialize, Deserialize)]
    #[serde(bound(serialize = "S: Serialize, S::Unit: Serialize", deserialize = "S: Deserialize<'de>, S::Unit: Deserialize<'de>"))]
    enum Piece<S> { Sphere, Cuboid, Capsule, HalfSpace }
}

fn sets_of_shapes<S: Written>(_: &str) {
    comes_back(&Piece::<S>::from(Cuboid::new(vector(10, 20, 33)).expect("a shape")));
    comes_back(&Piece::<S>::from(HalfSpace::new(UnitVec3::Z)));
    refused::<Piece<S>>(r#"{"Sphere": {"half_extents": 1}}"#, "radius");
}

type Room<S> = World<S, Piece<S>, 4, 12, 32>;

/// A box that tumbles and slides, and the ground. Its body carries what the format cannot hold.
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

/// Every body of a run comes back, and the one that came back goes on with the same bits: nothing that matters was left out.
fn bodies_go_on<S: Written>(_: &str) {
    let (mut world, settings, handle) = scene::<S>();
    let (mut carried, mut met) = (0, 0);
    for _ in 0..90 {
        let report = world.step(&settings);
        let body = *world.body(handle).expect("the box");
        comes_back(&body);
        carried += u32::from(format!("{:?}", body) != format!("{:?}", without_rests(&body)));
        comes_back(&report);
        for touching in world.contacts() {
            met += 1;
            comes_back(&touching);
            comes_back(&touching.bodies);
        }
    }
    assert!(met > 20, "{met} contacts");
    assert!(carried > 80, "{carried} bodies carried something beyond their format");
    let in_flight: Body<S> = *world.body(handle).expect("the box");
    let back: Body<S> = postcard::from_bytes(&postcard::to_stdvec(&in_flight).expect("bytes")).expect("a body");
    let mut copy = world.clone();
    *copy.body_mut(handle).expect("the box") = back;
    world.body_mut(handle).expect("the box");
    for _ in 0..60 {
        let _: [WorldReport; 2] = [world.step(&settings), copy.step(&settings)];
        assert_eq!(copy.hash(), world.hash());
        assert_eq!(copy.contacts().collect::<Vec<Touching<S>>>(), world.contacts().collect::<Vec<_>>());
    }
    comes_back(&Body::<S>::immovable());
    comes_back(&Body::<S>::immovable().moving(vector(1, 2, 3)));
}

/// The body as far as its public face shows it.
fn without_rests<S: Written>(body: &Body<S>) -> Body<S> {
    let mut value = serde_json::to_value(body).expect("text");
    let none = serde_json::to_value(Body::<S>::immovable()).expect("text");
    value["rests"] = none["rests"].clone();
    serde_json::from_value(value).expect("a body")
}

/// From needles to slabs, over masses and sizes: tensors whose rounded inverse is far from what they were made from.
fn wild_masses_come_back<S: Written>(_: &str) {
    let power = |exponent| S::Scaled::from_parts(1, exponent);
    let (mut count, mut tensors) = (0, 0);
    for (i, a) in (-14..=14).step_by(2).enumerate() {
        for b in (-14..=14).step_by(4) {
            for mass in [-20, 0, 20] {
                let odd = S::Scaled::ratio(1000 + i as i32, 1001);
                let moments = [power(a) * odd, power(b), power((a + b) / 2) * odd * odd];
                let properties = MassProperties::<S>::from_inverses(power(mass) * odd, moments).expect("a mass");
                comes_back(&properties);
                comes_back(&properties.with_locked_rotation());
                comes_back(&Body::dynamic(properties));
                count += 1;
            }
        }
    }
    for n in 1..40 {
        let tensor = SymMat3 {
            xx: ratio(30, 10),
            xy: ratio(n, 50),
            xz: ratio(-n, 70),
            yy: ratio(35, 10),
            yz: ratio(n, 90),
            zz: ratio(40, 10),
        };
        if let Ok(properties) = MassProperties::<S>::new(ratio(13, 10), tensor) {
            comes_back(&properties);
            tensors += 1;
        }
    }
    assert!(count == 360 && tensors > 30, "{count} of principal moments, {tensors} full ones");
}

fn invalid_values_are_refused<S: Written>(_: &str) {
    // A number as this type writes it.
    fn text<T: Serialize>(x: &T) -> String {
        serde_json::to_string(x).expect("text")
    }
    let unit = |n| text(&<S::Unit as Scalar>::from_ratio(n, 100).expect("a component"));
    let number = |n| text(&ratio::<S>(n, 100));
    let direction = |x, y, z| format!(r#"{{"x":{},"y":{},"z":{}}}"#, unit(x), unit(y), unit(z));
    refused::<UnitVec3<S>>(&direction(60, 60, 0), "unit length");
    refused::<UnitVec3<S>>(&direction(0, 0, 0), "zero");
    assert_eq!(serde_json::from_str::<UnitVec3<S>>(&direction(0, -100, 0)).expect("a direction"), -UnitVec3::Y);
    refused::<HalfSpace<S>>(&format!(r#"{{"normal":{}}}"#, direction(10, 0, 0)), "unit length");
    let quat = |w, x| format!(r#"{{"w":{},"x":{},"y":{},"z":{}}}"#, unit(w), unit(x), unit(0), unit(0));
    refused::<Quat<S>>(&quat(100, 100), "unit length");
    refused::<Quat<S>>(&quat(0, 0), "zero");
    refused::<Sphere<S>>(&format!(r#"{{"radius":{}}}"#, number(-1)), "radius");
    refused::<Capsule<S>>(&format!(r#"{{"radius":{},"half_length":{}}}"#, number(1), number(0)), "half length");
    let extents = format!(r#"{{"half_extents":{{"x":{},"y":{},"z":{}}}}}"#, number(1), number(1), number(-1));
    refused::<Cuboid<S>>(&extents, "half extent");
    let material = |e, mu| format!(r#"{{"restitution":{},"friction":{},"law":"Newton"}}"#, number(e), number(mu));
    refused::<Material<S>>(&material(101, 0), "restitution");
    refused::<Material<S>>(&material(50, -1), "friction");

    // A body with one field spoiled at a time.
    let mass = Solid::<S>::cuboid(vector(100, 150, 200)).expect("a solid").with_mass(ratio(12, 10)).expect("a mass");
    let good = serde_json::to_value(Body::dynamic(mass).at(vector(1, 2, 3))).expect("text");
    let spoiled = |path: &str, value: serde_json::Value| {
        let mut body = good.clone();
        *body.pointer_mut(path).unwrap_or_else(|| panic!("there is no {path} in {good}")) = value;
        body.to_string()
    };
    let unit_value =
        |n| serde_json::to_value(<S::Unit as Scalar>::from_ratio(n, 100).expect("a component")).expect("text");
    let scaled = |n| serde_json::to_value(S::Scaled::ratio(n, 100)).expect("text");
    assert!(serde_json::from_value::<Body<S>>(good.clone()).is_ok());
    refused::<Body<S>>(&spoiled("/orientation/w", unit_value(50)), "unit length");
    refused::<Body<S>>(&spoiled("/mass/inv_mass", scaled(-100)), "mass");
    refused::<Body<S>>(&spoiled("/mass/inv_mass", scaled(0)), "mass");
    refused::<Body<S>>(&spoiled("/mass/inv_inertia/yy", unit_value(-40)), "inertia");
    refused::<Body<S>>(&spoiled("/mass/inv_inertia/xy", unit_value(190)), "inertia");
    refused::<Body<S>>(&spoiled("/mass/gyration/z", unit_value(73)), "inertia");
    if S::STEP > S::ZERO {
        for exponent in [i32::MAX, i32::MIN, 1 << 25, -1 << 24] {
            refused::<Body<S>>(&spoiled("/mass/exponent", exponent.into()), "inertia");
        }
    } else {
        // Text has no infinity, but a number beyond the format is one; bytes have it outright.
        for path in ["/position/x", "/gravity_scale", "/rests/position/1"] {
            let json = spoiled(path, serde_json::json!(1e300));
            assert!(serde_json::from_str::<Body<S>>(&json).is_err() || size_of::<S>() == 8, "{json}");
        }
        let zero = ratio::<S>(0, 1);
        for bad in [zero.over(zero), ratio::<S>(1, 1).over(zero)] {
            let mut body = Body::<S>::dynamic(mass);
            body.angular_velocity.y = bad;
            let bytes = postcard::to_stdvec(&body).expect("bytes");
            assert!(postcard::from_bytes::<Body<S>>(&bytes).is_err());
            let bytes = postcard::to_stdvec(&Sphere::<S>::new(S::ONE).map(|_| bad).expect("a radius")).expect("bytes");
            assert!(postcard::from_bytes::<Sphere<S>>(&bytes).is_err());
        }
    }
}
