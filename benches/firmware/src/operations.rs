//! The operations that are measured: as a user's firmware calls them, operands and results in memory.
//!
//! Each is a function of its own in each number type, `kernel_OPERATION_SCALAR`, that the optimiser cannot look into from
//! outside. By that name `cargo xtask` links it alone, and follows what it calls.

use crate::harness::Call;
use crate::operands::Operands;
use carom::Scalar;

/// Operations on the same operands, each with its name.
pub type Calls = [(&'static str, Call); 10];

/// A number type with its operations.
pub trait Operations: Scalar {
    /// Everything but the two below.
    fn small(operands: &mut Operands<Self>) -> Calls;

    /// `resolve_collision`
    fn resolve(operands: &mut Operands<Self>) -> Call;

    /// `resolve_collision_with_friction`
    fn friction(operands: &mut Operands<Self>) -> Call;

    /// The bits, for the host to read.
    fn to_word(self) -> u32;
}

/// Implements [`Operations`] for a number type.
macro_rules! operations {
    ($scalar:ty, $name:literal) => {
        const _: () = {
            use carom::impulse::{
                Impact, collision_impulse, effective_mass, resolve_collision, resolve_collision_with_friction,
            };
            use carom::{Body, DirectionError, Quat, Scalar, UnitVec3, Vec3};
            use $crate::harness::{Call, call};
            use $crate::operands::{Given, Operands};
            use $crate::operations::{Calls, Operations};

            type S = $scalar;

            #[unsafe(export_name = concat!("kernel_multiply_", $name))]
            extern "C" fn multiply(out: &mut S, x: &S, y: &S) {
                *out = x.times(*y);
            }

            #[unsafe(export_name = concat!("kernel_divide_", $name))]
            extern "C" fn divide(out: &mut S, x: &S, y: &S) {
                *out = x.over(*y);
            }

            #[unsafe(export_name = concat!("kernel_reciprocal_", $name))]
            extern "C" fn reciprocal(out: &mut S, x: &S) {
                *out = S::ONE.over(*x);
            }

            #[unsafe(export_name = concat!("kernel_sqrt_", $name))]
            extern "C" fn sqrt(out: &mut S, x: &S) {
                *out = Scalar::sqrt(*x);
            }

            #[unsafe(export_name = concat!("kernel_dot_", $name))]
            extern "C" fn dot(out: &mut S, x: &Vec3<S>, y: &Vec3<S>) {
                *out = x.dot(*y);
            }

            #[unsafe(export_name = concat!("kernel_cross_", $name))]
            extern "C" fn cross(out: &mut Vec3<S>, x: &Vec3<S>, y: &Vec3<S>) {
                *out = x.cross(*y);
            }

            #[unsafe(export_name = concat!("kernel_normalize_", $name))]
            extern "C" fn normalize(out: &mut Result<UnitVec3<S>, DirectionError>, v: &Vec3<S>) {
                *out = UnitVec3::normalize(*v);
            }

            #[unsafe(export_name = concat!("kernel_set_orientation_", $name))]
            extern "C" fn set_orientation(body: &mut Body<S>, orientation: &Quat<S>) {
                body.set_orientation(*orientation);
            }

            #[unsafe(export_name = concat!("kernel_effective_mass_", $name))]
            extern "C" fn mass(out: &mut S, a: &Body<S>, b: &Body<S>, given: &Given<S>) {
                *out = effective_mass(a, b, &given.contact, given.contact.normal);
            }

            #[unsafe(export_name = concat!("kernel_collision_impulse_", $name))]
            extern "C" fn impulse(out: &mut S, a: &Body<S>, b: &Body<S>, given: &Given<S>) {
                *out = collision_impulse(a, b, &given.contact, given.material.restitution());
            }

            #[unsafe(export_name = concat!("kernel_resolve_", $name))]
            #[allow(
                improper_ctypes_definitions,
                reason = "micromath states no layout; an impact is returned in memory"
            )]
            extern "C" fn resolve(a: &mut Body<S>, b: &mut Body<S>, given: &Given<S>) -> Impact<S> {
                resolve_collision(a, b, &given.contact, given.material.restitution())
            }

            #[unsafe(export_name = concat!("kernel_friction_", $name))]
            #[allow(
                improper_ctypes_definitions,
                reason = "micromath states no layout; an impact is returned in memory"
            )]
            extern "C" fn friction(a: &mut Body<S>, b: &mut Body<S>, given: &Given<S>) -> Impact<S> {
                resolve_collision_with_friction(a, b, &given.contact, &given.material)
            }

            impl Operations for S {
                fn small(o: &mut Operands<S>) -> Calls {
                    [
                        ("multiply", call!(multiply, o.number, o.x, o.y)),
                        ("divide", call!(divide, o.number, o.x, o.y)),
                        ("reciprocal", call!(reciprocal, o.number, o.x)),
                        ("sqrt", call!(sqrt, o.number, o.x)),
                        ("dot", call!(dot, o.number, o.a.linear_velocity, o.b.angular_velocity)),
                        ("cross", call!(cross, o.vector, o.a.linear_velocity, o.b.angular_velocity)),
                        ("normalize", call!(normalize, o.direction, o.a.linear_velocity)),
                        ("set_orientation", call!(set_orientation, o.turned, o.orientation)),
                        ("effective_mass", call!(mass, o.number, o.a, o.b, o.given)),
                        ("collision_impulse", call!(impulse, o.number, o.a, o.b, o.given)),
                    ]
                }

                fn resolve(o: &mut Operands<S>) -> Call {
                    call!(resolve, o.impact, o.a, o.b, o.given)
                }

                fn friction(o: &mut Operands<S>) -> Call {
                    call!(friction, o.impact, o.a, o.b, o.given)
                }

                fn to_word(self) -> u32 {
                    // Of 32 bits, all of them.
                    self.bits() as u32
                }
            }
        };
    };
}

pub(crate) use operations;
