//! Numbers, bodies and surfaces from integers. Lengths are decimetres, which suits every format down to I8F24's +-128: the
//! acceleration of free fall is 98.1. Each scene counts masses in units of its own.

use carom::solver::Settings;
use carom::world::WorldReport;
use carom::{Body, Collide, Cuboid, Material, Scalar, Sphere, Vec3, World};

/// The acceleration of free fall, in thousandths of dm/s^2.
pub const GRAVITY: i32 = 98_100;

/// `n` thousandths.
pub fn milli<S: Scalar>(n: i32) -> Option<S> {
    S::from_ratio(n, 1000).ok()
}

/// A vector of thousandths.
pub fn vector<S: Scalar>([x, y, z]: [i32; 3]) -> Option<Vec3<S>> {
    Some(Vec3::new(milli(x)?, milli(y)?, milli(z)?))
}

/// Restitution and friction in thousandths.
pub fn material<S: Scalar>(restitution: i32, friction: i32) -> Option<Material<S>> {
    Material::new(milli(restitution)?, milli(friction)?).ok()
}

/// Steps of `1 / rate` s under gravity along -z.
pub fn settings<S: Scalar>(rate: u16, sub_steps: u8) -> Option<Settings<S>> {
    Settings::new(vector([0, 0, -GRAVITY])?, [1, rate], sub_steps).ok()
}

/// A solid ball of mass one, its radius in millionths.
pub fn ball<S: Scalar>(radius: i32) -> Option<(Body<S>, Sphere<S>)> {
    let shape = Sphere::new(S::from_ratio(radius, 1_000_000).ok()?).ok()?;
    Some((Body::dynamic(shape.solid().ok()?.with_mass(S::ONE).ok()?), shape))
}

/// A solid cube of mass one, half its edge in thousandths.
pub fn cube<S: Scalar>(half: i32) -> Option<(Body<S>, Cuboid<S>)> {
    let shape = Cuboid::new(vector([half; 3])?).ok()?;
    Some((Body::dynamic(shape.solid().ok()?.with_mass(S::ONE).ok()?), shape))
}

/// `x` from decimetres to micrometres, for printing: below 1.28 dm in every format.
pub fn hundredfold<S: Scalar>(x: S) -> S {
    x.times_integer(100)
}

/// The square of a vector's length.
pub fn square<S: Scalar>(v: Vec3<S>) -> S::Scaled {
    let [x, y, z] = v.to_array().map(S::to_scaled);
    x * x + y * y + z * z
}

/// `part / whole` in thousandths.
pub fn per_mille<S: Scalar>(part: S::Scaled, whole: S::Scaled) -> S {
    S::from_scaled(part / whole).0
}

/// A step of a world, in a function of its own: the checks of the linked firmware follow calls from here.
#[inline(never)]
pub fn kernel_step<S, Sh, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>(
    world: &mut World<S, Sh, BODIES, MANIFOLDS, POINTS>,
    settings: &Settings<S>,
) -> WorldReport
where
    S: Scalar,
    Sh: Collide<S, Sh>,
{
    world.step(settings)
}
