//! What each number type has of its own.

use core::mem::MaybeUninit;

use super::common::{carom_body_handle, carom_outcome, carom_phase};

macro_rules! structs {
    ($p:ident, $raw:ty, body: $private:literal) => {
        pastey::paste! {
            /// A vector: metres, m/s, rad/s, or whatever the units of the scene are.
            #[repr(C)]
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            pub struct [<$p _vec3>] {
                /// Along the first axis.
                pub x: $raw,
                /// Along the second axis.
                pub y: $raw,
                /// Along the third axis.
                pub z: $raw,
            }

            /// A direction: a vector whose length is one within 2^-17. In fixed point its components are Q2.30 (CAROM_Q30).
            #[repr(C)]
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            pub struct [<$p _unit_vec3>] {
                /// Along the first axis.
                pub x: $raw,
                /// Along the second axis.
                pub y: $raw,
                /// Along the third axis.
                pub z: $raw,
            }

            /// An orientation, from the body's frame to the world's: a quaternion of unit length. In fixed point its components are
            /// Q2.30 (CAROM_Q30).
            #[repr(C)]
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            pub struct [<$p _quat>] {
                /// The scalar part: 1 where nothing is turned.
                pub w: $raw,
                /// Along the first axis.
                pub x: $raw,
                /// Along the second axis.
                pub y: $raw,
                /// Along the third axis.
                pub z: $raw,
            }

            /// A rigid body: where it is, how it moves, and how hard it is to move. Made by the ..._body_... functions; then its
            /// first six fields are yours to read and to write. A copy of it is a body like it.
            #[repr(C)]
            #[derive(Clone, Copy, Debug)]
            pub struct [<$p _body>] {
                /// The centre of mass in the world's frame, m.
                pub position: [<$p _vec3>],
                /// The velocity of the centre of mass in the world's frame, m/s.
                pub linear_velocity: [<$p _vec3>],
                /// The angular velocity in the world's frame, rad/s.
                pub angular_velocity: [<$p _vec3>],
                /// By how much gravity acts on the body: 1 as on others, 0 not at all.
                pub gravity_scale: $raw,
                /// The rate at which the velocity decays, 1/s.
                pub linear_damping: $raw,
                /// The rate at which the angular velocity decays, 1/s.
                pub angular_damping: $raw,
                /// The library's own: mass, inertia, orientation, and what the format cannot hold of the motion.
                pub reserved: [MaybeUninit<u32>; $private],
            }

            /// A point at which two bodies touch.
            #[repr(C)]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct [<$p _contact>] {
                /// From body A to body B.
                pub normal: [<$p _unit_vec3>],
                /// From the centre of mass of A to the point, in the world's frame, m.
                pub r_a: [<$p _vec3>],
                /// From the centre of mass of B to the point, in the world's frame, m.
                pub r_b: [<$p _vec3>],
            }

            /// How a surface rebounds and rubs. Between two surfaces of a world the geometric means of their coefficients count.
            #[repr(C)]
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            pub struct [<$p _material>] {
                /// The coefficient of restitution e, 0 to 1.
                pub restitution: $raw,
                /// The coefficient of friction mu, 0 or more.
                pub friction: $raw,
                /// A carom_restitution_law.
                pub law: u32,
            }

            /// What a contact did, and with which impulse: on B as given here, on A the opposite.
            #[repr(C)]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct [<$p _impact>] {
                /// The kind of event.
                pub outcome: carom_outcome,
                /// The impulse along the normal, never negative, N s.
                pub normal_impulse: $raw,
                /// The impulse of friction, across the normal, in the world's frame, N s.
                pub friction_impulse: [<$p _vec3>],
                /// 1 where a velocity or a reported impulse met the end of the format and stayed there, else 0.
                pub saturated: u32,
            }

            /// Gravity and time: the same for all bodies.
            #[repr(C)]
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            pub struct [<$p _settings>] {
                /// The acceleration of free fall, m/s^2.
                pub gravity: [<$p _vec3>],
                /// The speed at which bodies that overlap are pushed apart, at most, m/s: about the highest speed of the scene. Zero
                /// takes 4.
                pub push_out_speed: $raw,
                /// The length of a step is `seconds_numerator / seconds_denominator` seconds: 1 and 60, say.
                pub seconds_numerator: u16,
                /// See there.
                pub seconds_denominator: u16,
                /// Sub-steps in a step: 4 suit most scenes.
                pub sub_steps: u32,
            }

            /// A shape: its kind, and the dimensions that this kind has; the others are not looked at.
            #[repr(C)]
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            pub struct [<$p _shape>] {
                /// A carom_shape_kind.
                pub kind: u32,
                /// Of a sphere or a capsule, m.
                pub radius: $raw,
                /// Of a capsule: half the length of its segment, without the round ends, m.
                pub half_length: $raw,
                /// Of a cuboid: half of each edge, m.
                pub half_extents: [<$p _vec3>],
                /// Of a half-space: out of it.
                pub normal: [<$p _unit_vec3>],
            }

            /// Two bodies that touch, or did until this step.
            #[repr(C)]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct [<$p _touching>] {
                /// The body with the lower place in the world.
                pub a: carom_body_handle,
                /// The other one.
                pub b: carom_body_handle,
                /// Whether it is new.
                pub phase: carom_phase,
                /// 1 where one of the two is a sensor, else 0.
                pub sensor: u32,
                /// The normal impulse in this step, N s.
                pub normal_impulse: $raw,
                /// How fast the surfaces met in this step, m/s; zero where they did not meet in it.
                pub approach_speed: $raw,
            }

            /// A straight way in the world.
            #[repr(C)]
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            pub struct [<$p _ray>] {
                /// Where it begins, m.
                pub origin: [<$p _vec3>],
                /// Where it goes.
                pub direction: [<$p _unit_vec3>],
                /// How far it goes, m.
                pub length: $raw,
            }

            /// What a ray meets first.
            #[repr(C)]
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            pub struct [<$p _ray_hit>] {
                /// The body; CAROM_NO_BODY where the ray meets nothing, and then the rest is zeros.
                pub body: carom_body_handle,
                /// From the ray's origin, m; zero where that lies in the body.
                pub distance: $raw,
                /// Out of the body; against the ray where that begins in the body.
                pub normal: [<$p _unit_vec3>],
            }
        }
    };
}

#[cfg(feature = "f32")]
structs!(carom_f32, f32, body: 23);
#[cfg(feature = "fixed")]
structs!(carom_q16, i32, body: 27);
#[cfg(feature = "fixed")]
structs!(carom_q20, i32, body: 27);
