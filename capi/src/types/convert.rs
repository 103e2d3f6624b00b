//! To the kernel's types, checked, and back.

#[cfg(feature = "fixed")]
use fixed::types::{I12F20, I16F16};

use carom::impulse::Impact;
use carom::solver::Settings;
use carom::world::Touching;
use carom::{Contact, Material, Ray, RestitutionLaw};

use super::common::{carom_body_handle, carom_restitution_law};
use super::structs::*;
use crate::number::{self, Number};
use crate::shape::Raw;
use crate::status::carom_status;

macro_rules! convert {
    ($p:ident, $number:ty, $raw:ty) => { pastey::paste! {
        impl [<$p _vec3>] {
            pub(crate) fn core(self) -> carom::Vec3<$number> {
                number::vec3([self.x, self.y, self.z])
            }
        }

        impl From<carom::Vec3<$number>> for [<$p _vec3>] {
            fn from(v: carom::Vec3<$number>) -> Self {
                let [x, y, z] = number::raw_vec3(v);
                Self { x, y, z }
            }
        }

        impl [<$p _unit_vec3>] {
            pub(crate) fn core(self) -> Result<carom::UnitVec3<$number>, carom_status> {
                number::unit_vec3([self.x, self.y, self.z])
            }
        }

        impl From<carom::UnitVec3<$number>> for [<$p _unit_vec3>] {
            fn from(d: carom::UnitVec3<$number>) -> Self {
                let [x, y, z] = number::raw_unit_vec3(d);
                Self { x, y, z }
            }
        }

        impl [<$p _quat>] {
            pub(crate) fn array(self) -> [$raw; 4] {
                [self.w, self.x, self.y, self.z]
            }
        }

        impl From<carom::Quat<$number>> for [<$p _quat>] {
            fn from(q: carom::Quat<$number>) -> Self {
                let [w, x, y, z] = number::raw_quat(q);
                Self { w, x, y, z }
            }
        }

        impl [<$p _contact>] {
            pub(crate) fn core(&self) -> Result<Contact<$number>, carom_status> {
                Ok(Contact::new(self.normal.core()?, self.r_a.core(), self.r_b.core())?)
            }
        }

        impl [<$p _material>] {
            pub(crate) fn core(&self) -> Result<Material<$number>, carom_status> {
                let law = match self.law {
                    law if law == carom_restitution_law::CAROM_NEWTON as u32 => RestitutionLaw::Newton,
                    law if law == carom_restitution_law::CAROM_ENERGY_SAFE as u32 => RestitutionLaw::EnergySafe,
                    _ => return Err(carom_status::CAROM_LAW),
                };
                let [restitution, friction] = [self.restitution, self.friction].map(<$number>::from_raw);
                Ok(Material::new(restitution, friction)?.with_law(law))
            }
        }

        impl From<Impact<$number>> for [<$p _impact>] {
            fn from(impact: Impact<$number>) -> Self {
                Self {
                    outcome: impact.outcome.into(),
                    normal_impulse: impact.normal_impulse.raw(),
                    friction_impulse: impact.friction_impulse.into(),
                    saturated: impact.saturated.into(),
                }
            }
        }

        impl [<$p _settings>] {
            pub(crate) fn core(&self) -> Result<Settings<$number>, carom_status> {
                let sub_steps = u8::try_from(self.sub_steps).map_err(|_| carom_status::CAROM_STEP_TIME)?;
                let gravity = number::finite(self.gravity.core())?;
                let settings = Settings::new(gravity, [self.seconds_numerator, self.seconds_denominator], sub_steps)?;
                let speed = <$number>::from_raw(self.push_out_speed);
                let zero = <$number as carom::Scalar>::ZERO;
                if !(carom::Scalar::is_finite(speed) && speed >= zero) {
                    return Err(carom_status::CAROM_RANGE);
                }
                Ok(if speed > zero { settings.with_push_out_speed(speed) } else { settings })
            }
        }

        impl [<$p _shape>] {
            pub(crate) fn core(&self) -> Raw<$number> {
                Raw {
                    kind: self.kind,
                    radius: <$number>::from_raw(self.radius),
                    half_length: <$number>::from_raw(self.half_length),
                    half_extents: self.half_extents.core(),
                    normal: [self.normal.x, self.normal.y, self.normal.z],
                }
            }
        }

        impl From<&Touching<$number>> for [<$p _touching>] {
            fn from(touching: &Touching<$number>) -> Self {
                let [a, b] = touching.bodies.map(carom_body_handle::from);
                let (impulse, _) = <$number as carom::Scalar>::from_scaled(touching.normal_impulse);
                Self {
                    a,
                    b,
                    phase: touching.phase.into(),
                    sensor: touching.sensor.into(),
                    normal_impulse: impulse.raw(),
                    approach_speed: touching.approach_speed.raw(),
                }
            }
        }

        impl [<$p _ray>] {
            pub(crate) fn core(&self) -> Result<Ray<$number>, carom_status> {
                let length = <$number>::from_raw(self.length);
                if !(carom::Scalar::is_finite(length) && length >= <$number as carom::Scalar>::ZERO) {
                    return Err(carom_status::CAROM_RANGE);
                }
                Ok(Ray { origin: number::finite(self.origin.core())?, direction: self.direction.core()?, length })
            }
        }
    } };
}

#[cfg(feature = "f32")]
convert!(carom_f32, f32, f32);
#[cfg(feature = "fixed")]
convert!(carom_q16, I16F16, i32);
#[cfg(feature = "fixed")]
convert!(carom_q20, I12F20, i32);
