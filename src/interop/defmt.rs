//! Logs: how public values look to whoever reads them. The texts stay in the ELF file; numbers go over as they are.

use defmt::{Format, Formatter, write};

use crate::aabb::Aabb;
use crate::body::Body;
use crate::contact::{Contact, Material};
use crate::error::RangeError;
use crate::hash::StateHash;
use crate::impulse::Impact;
use crate::manifold::{Manifold, ManifoldPoint};
use crate::mass::{MassProperties, Solid};
use crate::math::{Mat3, Pose, Quat, SymMat3, UnitVec3, Vec3};
use crate::query::{Ray, RayHit, SurfacePoint};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Closest, Cuboid, HalfSpace, Sphere};
use crate::solver::{SettingsError, StepReport};
use crate::world::Touching;

/// As the bits of an `f64`: exact, and put together without one floating-point operation. Beyond the range of `f64`: zero or an
/// infinity.
#[cfg(feature = "fixed")]
impl Format for crate::Scaled32 {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=f64}", f64::from_bits(double(self.mantissa(), self.exponent())));
    }
}

/// The bits of `mantissa * 2^(exponent - 30)`, for a mantissa of 30 bits or zero.
#[cfg(feature = "fixed")]
const fn double(mantissa: i32, exponent: i32) -> u64 {
    const INFINITE: u64 = 0x7ff;
    let sign = (mantissa as u64) & 1 << 63;
    // The leading bit of the mantissa is not written.
    let fraction = (mantissa.unsigned_abs() & !(1 << 29)) as u64;
    match exponent.saturating_add(1022) {
        ..=0 => sign,
        biased if mantissa != 0 && biased as u64 >= INFINITE => sign | INFINITE << 52,
        biased if mantissa != 0 => sign | (biased as u64) << 52 | fraction << 23,
        _ => 0,
    }
}

/// xx, xy, xz, yy, yz, zz of a symmetric matrix.
struct Tensor<T>([T; 6]);

impl<T: Format> Format for Tensor<T> {
    fn format(&self, f: Formatter<'_>) {
        let Self([xx, xy, xz, yy, yz, zz]) = self;
        write!(f, "[xx {}, xy {}, xz {}, yy {}, yz {}, zz {}]", xx, xy, xz, yy, yz, zz);
    }
}

macro_rules! format {
    ($($type:ident: |$value:ident, $f:ident| $write:expr;)+) => {$(
        impl<S: Scalar> Format for $type<S>
        where
            S::Scaled: Format,
        {
            fn format(&self, $f: Formatter<'_>) {
                let $value = self;
                $write
            }
        }
    )+};
}

format! {
    Vec3: |v, f| write!(f, "({}, {}, {})", v.x.to_scaled(), v.y.to_scaled(), v.z.to_scaled());
    UnitVec3: |d, f| write!(f, "{}", d.get());
    Quat: |q, f| {
        let [w, x, y, z] = q.to_array().map(|c| c.to_scaled());
        write!(f, "({}; {}, {}, {})", w, x, y, z);
    };
    Mat3: |m, f| write!(f, "[{}, {}, {}]", m.rows[0], m.rows[1], m.rows[2]);
    SymMat3: |m, f| write!(f, "{}", Tensor([m.xx, m.xy, m.xz, m.yy, m.yz, m.zz].map(S::to_scaled)));
    Pose: |pose, f| write!(f, "Pose {{ position: {}, rotation: {} }}", pose.position, pose.rotation);
    Aabb: |bounds, f| write!(f, "Aabb {{ min: {}, max: {} }}", bounds.min, bounds.max);
    Solid: |solid, f| {
        let [x, y, z] = solid.moments();
        write!(f, "Solid {{ measure: {}, moments: ({}, {}, {}) }}", solid.measure(), x, y, z);
    };
    MassProperties: |mass, f| {
        let inv_inertia = Tensor(Body::dynamic(*mass).inv_inertia_local());
        write!(f, "MassProperties {{ inv_mass: {}, inv_inertia: {} }}", mass.inv_mass, inv_inertia);
    };
    Body: |body, f| {
        write!(
            f,
            "Body {{ position: {}, orientation: {}, linear_velocity: {}, angular_velocity: {}, inv_mass: {} }}",
            body.position,
            body.orientation(),
            body.linear_velocity,
            body.angular_velocity,
            body.inv_mass()
        );
    };
    Contact: |contact, f| {
        write!(f, "Contact {{ normal: {}, r_a: {}, r_b: {} }}", contact.normal, contact.r_a, contact.r_b);
    };
    Material: |material, f| {
        let (restitution, friction) = (material.restitution().to_scaled(), material.friction().to_scaled());
        write!(f, "Material {{ restitution: {}, friction: {}, law: {} }}", restitution, friction, material.law);
    };
    Impact: |impact, f| {
        write!(
            f,
            "Impact {{ outcome: {}, normal_impulse: {}, friction_impulse: {}, saturated: {} }}",
            impact.outcome,
            impact.normal_impulse.to_scaled(),
            impact.friction_impulse,
            impact.saturated
        );
    };
    ManifoldPoint: |point, f| {
        write!(
            f,
            "ManifoldPoint {{ r_a: {}, r_b: {}, separation: {}, feature: {} }}",
            point.r_a,
            point.r_b,
            point.separation.to_scaled(),
            point.feature.0
        );
    };
    Manifold: |manifold, f| write!(f, "Manifold {{ normal: {}, points: {} }}", manifold.normal, manifold.points());
    Touching: |touching, f| {
        write!(
            f,
            "Touching {{ bodies: {}, part: {}, phase: {}, sensor: {}, normal_impulse: {}, approach_speed: {} }}",
            touching.bodies,
            touching.part,
            touching.phase,
            touching.sensor,
            touching.normal_impulse,
            touching.approach_speed.to_scaled()
        );
    };
    Sphere: |sphere, f| write!(f, "Sphere {{ radius: {} }}", sphere.radius().to_scaled());
    Cuboid: |cuboid, f| write!(f, "Cuboid {{ half_extents: {} }}", cuboid.half_extents());
    Capsule: |capsule, f| {
        let (radius, half_length) = (capsule.radius().to_scaled(), capsule.half_length().to_scaled());
        write!(f, "Capsule {{ radius: {}, half_length: {} }}", radius, half_length);
    };
    HalfSpace: |ground, f| write!(f, "HalfSpace {{ normal: {} }}", ground.normal());
    Ray: |ray, f| {
        write!(f, "Ray {{ origin: {}, direction: {}, length: {} }}", ray.origin, ray.direction, ray.length.to_scaled());
    };
    RayHit: |hit, f| write!(f, "RayHit {{ distance: {}, normal: {} }}", hit.distance.to_scaled(), hit.normal);
    SurfacePoint: |at, f| {
        let separation = at.separation.to_scaled();
        write!(f, "SurfacePoint {{ point: {}, normal: {}, separation: {} }}", at.point, at.normal, separation);
    };
    Closest: |near, f| {
        write!(
            f,
            "Closest {{ normal: {}, separation: {}, r_a: {}, r_b: {} }}",
            near.normal,
            near.separation.to_scaled(),
            near.r_a,
            near.r_b
        );
    };
}

impl Format for StateHash {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=u64:016x}", self.get());
    }
}

impl Format for StepReport {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "StepReport {{ saturated: {}, not_finite: {} }}", self.saturated, self.not_finite);
    }
}

impl Format for RangeError {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "the ratio is outside the range of the number format");
    }
}

impl Format for SettingsError {
    fn format(&self, f: Formatter<'_>) {
        write!(
            f,
            "settings: take a sub-step or more, each longer than zero and below one second, the step below two, and a finite gravity"
        );
    }
}
