//! Numbers, directions and bodies.

use carom::{Body, MassProperties, Scalar, Vec3};

use super::export;
use super::pointer::{Mirror, check, check_apart, read, write};
use crate::number::{self, Number};
use crate::status::carom_status;
use crate::types::*;

#[cfg(feature = "fixed")]
use fixed::types::{I12F20, I16F16};

macro_rules! bodies {
    ($p:ident, $number:ty, $raw:ty) => {
        pastey::paste! { export! {
            /// `numerator / denominator`, rounded to the format: numbers that are made at run time, the same on every machine.
            fn [<$p _ratio>](numerator: i32, denominator: i32, result: *mut $raw) {
                write(result, <$number as Scalar>::from_ratio(numerator, denominator)?.raw())
            }

            /// The direction of a vector of any length but zero.
            fn [<$p _direction>](vector: *const [<$p _vec3>], result: *mut [<$p _unit_vec3>]) {
                let direction = carom::UnitVec3::normalize(read(vector)?.core())?;
                write(result, direction.into())
            }

            /// Makes a quaternion of any length but zero one of unit length, in place. In fixed point its components are Q2.30: take
            /// them within +-1/2, so that the square of the length is within the format.
            fn [<$p _quat_normalize>](orientation: *mut [<$p _quat>]) {
                let unit = number::normalized::<$number>(read(orientation)?.array())?;
                write(orientation, unit.into())
            }

            /// A body that nothing moves: the ground, a wall. With a velocity set it is driven: it strikes, and is not deflected.
            fn [<$p _body_immovable>](body: *mut [<$p _body>]) {
                Mirror::put(body, Body::<$number>::immovable())
            }

            /// A homogeneous body of that shape and mass (kg), at rest at the origin. A half-space has no mass: CAROM_SHAPE.
            fn [<$p _body_dynamic>](shape: *const [<$p _shape>], mass: $raw, body: *mut [<$p _body>]) {
                let made = read(shape)?.core().body(<$number>::from_raw(mass))?;
                Mirror::put(body, made)
            }

            /// A body of that mass (kg) and that inertia tensor about its centre of mass, in its own frame: xx, xy, xz, yy, yz, zz,
            /// kg m^2. At rest at the origin.
            fn [<$p _body_with_inertia>](mass: $raw, inertia: *const $raw, body: *mut [<$p _body>]) {
                let tensor = number::tensor(read(inertia.cast::<[$raw; 6]>())?);
                let made = MassProperties::<$number>::new(<$number>::from_raw(mass), tensor)?;
                Mirror::put(body, Body::dynamic(made))
            }

            /// Turns the body, and its inertia with it. The orientation is of unit length: see quat_normalize.
            fn [<$p _body_set_orientation>](body: *mut [<$p _body>], orientation: *const [<$p _quat>]) {
                let orientation = number::quat::<$number>(read(orientation)?.array())?;
                Mirror::body_mut(body)?.set_orientation(orientation);
                Ok(())
            }

            /// The orientation of the body.
            fn [<$p _body_orientation>](body: *const [<$p _body>], result: *mut [<$p _quat>]) {
                let body: &Body<$number> = Mirror::body(body)?;
                write(result, body.orientation().into())
            }

            /// A point of the body's frame (m) as seen from its centre of mass in the world's axes: an arm for a contact, or a
            /// direction on the body.
            fn [<$p _body_arm>](body: *const [<$p _body>], local: *const [<$p _vec3>], result: *mut [<$p _vec3>]) {
                let body: &Body<$number> = Mirror::body(body)?;
                let local = number::finite(read(local)?.core())?;
                write(result, body.arm(local).into())
            }

            /// An impulse (N s) at the end of an arm from the centre of mass (m; null: at the centre), both in the world's axes.
            /// `saturated`, which may be null, becomes 1 where a velocity met the end of the format and stayed there, else 0.
            fn [<$p _body_apply_impulse>](
                body: *mut [<$p _body>],
                impulse: *const [<$p _vec3>],
                arm: *const [<$p _vec3>],
                saturated: *mut u32,
            ) {
                let impulse = number::finite(read(impulse)?.core())?;
                let arm = if arm.is_null() { Vec3::ZERO } else { number::finite(read(arm)?.core())? };
                if !saturated.is_null() {
                    check(saturated)?;
                    check_apart(saturated, body)?;
                }
                let body: &mut Body<$number> = Mirror::body_mut(body)?;
                body.check()?;
                let clipped = body.apply_impulse_at(impulse, arm);
                if saturated.is_null() { Ok(()) } else { write(saturated, clipped.into()) }
            }
        } }
    };
}

#[cfg(feature = "f32")]
bodies!(carom_f32, f32, f32);
#[cfg(feature = "fixed")]
bodies!(carom_q16, I16F16, i32);
#[cfg(feature = "fixed")]
bodies!(carom_q20, I12F20, i32);
