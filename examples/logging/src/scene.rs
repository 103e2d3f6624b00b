//! A box that is thrown onto the ground, and what is to be seen of it: the same in the firmware that logs and in the test that reads.

use carom::impulse::{Impact, resolve_collision_with_friction};
use carom::solver::Settings;
use carom::world::{Touching, WorldReport};
use carom::{
    Body, Contact, Cuboid, HalfSpace, MassProperties, Material, Scalar, Solid, StateHash, UnitVec3, Vec3, World,
};

#[cfg(feature = "fixed")]
pub type Real = fixed::types::I12F20;
#[cfg(not(feature = "fixed"))]
pub type Real = f32;

carom::shapes! { enum Piece<S> { Cuboid, HalfSpace } }

/// What is logged after a step.
pub struct Moment {
    pub body: Body<Real>,
    pub report: WorldReport,
    pub touching: Option<Touching<Real>>,
    pub hash: StateHash,
}

/// Values that are logged once.
pub struct Values {
    pub mass: MassProperties<Real>,
    pub material: Material<Real>,
    pub contact: Contact<Real>,
    pub impact: Impact<Real>,
    pub ground: HalfSpace<Real>,
    pub cuboid: Cuboid<Real>,
}

fn vector(v: [i32; 3]) -> Option<Vec3<Real>> {
    let [x, y, z] = v.map(|x| Real::from_ratio(x, 1000));
    Some(Vec3::new(x.ok()?, y.ok()?, z.ok()?))
}

pub fn values() -> Option<Values> {
    let cuboid = Cuboid::new(vector([100, 150, 200])?).ok()?;
    let mass = cuboid.solid().ok()?.with_mass(Real::from_ratio(12, 10).ok()?).ok()?;
    let material = Material::new(Real::from_ratio(1, 3).ok()?, Real::from_ratio(2, 5).ok()?).ok()?;
    let normal = UnitVec3::normalize(vector([3, -4, 12])?).ok()?;
    let contact = Contact { normal, r_a: vector([20, -30, 41])?, r_b: vector([-7, 5, 1])? };
    let (mut a, mut b) = (
        Body::dynamic(mass),
        Body::dynamic(Solid::sphere(Real::from_ratio(3, 100).ok()?).ok()?.with_mass(Real::ONE).ok()?),
    );
    a.linear_velocity = vector([2000, -1000, 500])?;
    let impact = resolve_collision_with_friction(&mut a, &mut b, &contact, &material);
    Some(Values { mass, material, contact, impact, ground: HalfSpace::new(UnitVec3::Z), cuboid })
}

/// Throws it, and shows every sixth of sixty steps.
pub fn throw(mut show: impl FnMut(&Moment)) -> Option<()> {
    let Values { mass, material, ground, cuboid, .. } = values()?;
    let mut world = World::<Real, Piece<Real>, 2, 2, 8>::new();
    world.insert(Body::immovable(), ground, material).ok()?;
    let mut body = Body::dynamic(mass).at(vector([0, 0, 500])?).moving(vector([900, -350, 0])?);
    body.angular_velocity = vector([1500, 2500, -700])?;
    let thrown = world.insert(body, cuboid, material).ok()?;
    let settings = Settings::new(vector([0, 0, -9810])?, [1, 60], 4).ok()?;
    for step in 1..=60 {
        let report = world.step(&settings);
        if step % 6 == 0 {
            let body = *world.body(thrown).ok()?;
            let mut hash = StateHash::new();
            hash.add_body(&body);
            show(&Moment { body, report, touching: world.contacts().next(), hash });
        }
    }
    Some(())
}
