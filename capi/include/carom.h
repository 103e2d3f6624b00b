// carom: rigid bodies on microcontrollers, for C and C++. Made by `cargo xtask capi header`: change capi/src, not this file.
//
// NUMBERS. carom_f32_... computes in float. carom_q16_... and carom_q20_... compute in fixed point: numbers are int32_t with 16 or
// 20 bits behind the point (Q16.16: +-32768 in steps of 1.5e-5; Q12.20: +-2048 in steps of 9.5e-7). CAROM_Q16(1.5) and
// CAROM_Q20(1.5) write constants; the compiler evaluates them. Components of directions and orientations are Q2.30 in both:
// CAROM_Q30(1.0). The three may be used side by side; nothing of a type that you do not call is linked.
//
// UNITS. Any consistent ones: metres, kilograms and seconds, say; comments name these as an example. Angles are in radians. Vectors
// are in the world's frame unless said otherwise; a normal points from body A to body B.
//
// ERRORS. Every function answers with a carom_status: CAROM_OK (0), or why it did nothing; carom_status_text says what to do. Where
// it is not CAROM_OK nothing was changed or written.
//
// POINTERS. A pointer may be null only where its comment says so, and is refused otherwise. What is not null leads to an object
// of its type, or to as many as the count beside it says, that nobody else uses during the call: no interrupt, no other
// thread. Pointers that are misaligned, and bodies that overlap, are refused. The library keeps no pointer of yours, and has
// no state of its own.


#ifndef CAROM_H
#define CAROM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** A number in Q16.16, Q12.20 or Q2.30 from a constant: rounded to the nearest, and evaluated by the compiler. Outside the range of
 * the format (+-32768, +-2048, +-2) compilers warn. For numbers that are known only at run time there is carom_..._ratio. */
#define CAROM_Q16(number) CAROM_FIXED_(number, 65536.0)
#define CAROM_Q20(number) CAROM_FIXED_(number, 1048576.0)
#define CAROM_Q30(number) CAROM_FIXED_(number, 1073741824.0)
#define CAROM_FIXED_(number, one) ((int32_t)((number) * (one) + ((number) < 0 ? -0.5 : 0.5)))

/** Bytes of working space for a solver_step over so many bodies, manifolds and points. */
#define CAROM_F32_SOLVER_SIZE(bodies, manifolds, points) CAROM_SOLVER_SIZE_(CAROM_F32, bodies, manifolds, points)
#define CAROM_Q16_SOLVER_SIZE(bodies, manifolds, points) CAROM_SOLVER_SIZE_(CAROM_Q16, bodies, manifolds, points)
#define CAROM_Q20_SOLVER_SIZE(bodies, manifolds, points) CAROM_SOLVER_SIZE_(CAROM_Q20, bodies, manifolds, points)
#define CAROM_SOLVER_SIZE_(type, bodies, manifolds, points)                                                        \
    ((bodies) * (size_t)type##_SOLVER_BODY_SIZE + (manifolds) * (size_t)type##_SOLVER_MANIFOLD_SIZE +              \
     (points) * (size_t)type##_SOLVER_POINT_SIZE + 7)

/** No body. */
#ifdef __cplusplus
#define CAROM_NO_BODY (carom_body_handle{0})
#else
#define CAROM_NO_BODY ((carom_body_handle){0})
#endif


// How the memory of a world has to be aligned: what is declared as an array of uint64_t is.
#define CAROM_WORLD_ALIGN 8

// Bytes of a world of 4 bodies, 4 pairs that touch and 12 points.
#define CAROM_F32_WORLD_4X12_SIZE 5248

// Bytes of a world of 16 bodies, 12 pairs that touch and 12 points.
#define CAROM_F32_WORLD_16X12_SIZE 10304

// Bytes of a world of 16 bodies, 32 pairs that touch and 64 points.
#define CAROM_F32_WORLD_16X64_SIZE 25920

// Bytes of a world of 64 bodies, 128 pairs that touch and 256 points.
#define CAROM_F32_WORLD_64X256_SIZE 102848

// Bytes of a world of 4 bodies, 4 pairs that touch and 12 points.
#define CAROM_Q16_WORLD_4X12_SIZE 5440

// Bytes of a world of 16 bodies, 12 pairs that touch and 12 points.
#define CAROM_Q16_WORLD_16X12_SIZE 10752

// Bytes of a world of 16 bodies, 32 pairs that touch and 64 points.
#define CAROM_Q16_WORLD_16X64_SIZE 26752

// Bytes of a world of 64 bodies, 128 pairs that touch and 256 points.
#define CAROM_Q16_WORLD_64X256_SIZE 106176

// Bytes of a world of 4 bodies, 4 pairs that touch and 12 points.
#define CAROM_Q20_WORLD_4X12_SIZE 5440

// Bytes of a world of 16 bodies, 12 pairs that touch and 12 points.
#define CAROM_Q20_WORLD_16X12_SIZE 10752

// Bytes of a world of 16 bodies, 32 pairs that touch and 64 points.
#define CAROM_Q20_WORLD_16X64_SIZE 26752

// Bytes of a world of 64 bodies, 128 pairs that touch and 256 points.
#define CAROM_Q20_WORLD_64X256_SIZE 106176

// Bytes of a world of 16 spheres and half-spaces, 16 pairs that touch and 16 points.
#define CAROM_F32_BALLS_16X16_SIZE 11712

// Bytes of a world of 16 spheres and half-spaces, 16 pairs that touch and 16 points.
#define CAROM_Q16_BALLS_16X16_SIZE 12224

// Bytes of a world of 16 spheres and half-spaces, 16 pairs that touch and 16 points.
#define CAROM_Q20_BALLS_16X16_SIZE 12224

// Bytes of working space that a step takes for each body.
#define CAROM_F32_SOLVER_BODY_SIZE 76

// Bytes of working space that a step takes for each manifold.
#define CAROM_F32_SOLVER_MANIFOLD_SIZE 60

// Bytes of working space that a step takes for each point.
#define CAROM_F32_SOLVER_POINT_SIZE 244

// Bytes of working space that a step takes for each body.
#define CAROM_Q16_SOLVER_BODY_SIZE 80

// Bytes of working space that a step takes for each manifold.
#define CAROM_Q16_SOLVER_MANIFOLD_SIZE 64

// Bytes of working space that a step takes for each point.
#define CAROM_Q16_SOLVER_POINT_SIZE 244

// Bytes of working space that a step takes for each body.
#define CAROM_Q20_SOLVER_BODY_SIZE 80

// Bytes of working space that a step takes for each manifold.
#define CAROM_Q20_SOLVER_MANIFOLD_SIZE 64

// Bytes of working space that a step takes for each point.
#define CAROM_Q20_SOLVER_POINT_SIZE 244

// What a function answers: CAROM_OK, or why it did nothing. Where it is not CAROM_OK nothing was changed or written.
enum carom_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // Done.
  CAROM_OK = 0,
  // A pointer is null that must not be.
  CAROM_NULL = 1,
  // A pointer is not aligned.
  CAROM_MISALIGNED = 2,
  // Two objects that must be two share memory.
  CAROM_OVERLAP = 3,
  // The memory is smaller than what has to go there.
  CAROM_TOO_SMALL = 4,
  // There is no world of this number type in the memory.
  CAROM_NOT_A_WORLD = 5,
  // The body was never made.
  CAROM_NOT_A_BODY = 6,
  // The handle's body is not in this world.
  CAROM_STALE_HANDLE = 7,
  // The world has no place left.
  CAROM_FULL = 8,
  // A number is infinite or NaN.
  CAROM_NOT_FINITE = 9,
  // A number does not fit the format, or a denominator is zero.
  CAROM_RANGE = 10,
  // The vector or quaternion is zero.
  CAROM_ZERO_LENGTH = 11,
  // The vector or quaternion is not of unit length.
  CAROM_NOT_UNIT = 12,
  // A radius, half extent or half length is not positive and finite.
  CAROM_DIMENSION = 13,
  // The mass is not positive and finite.
  CAROM_MASS = 14,
  // The inertia tensor is none.
  CAROM_INERTIA = 15,
  // The coefficient of restitution is not in 0 to 1.
  CAROM_RESTITUTION = 16,
  // The coefficient of friction is negative or not finite.
  CAROM_FRICTION = 17,
  // Not a carom_restitution_law.
  CAROM_LAW = 18,
  // Not a carom_shape_kind, or none that has a mass, or that the world holds.
  CAROM_SHAPE = 19,
  // The step's time cannot be stepped over.
  CAROM_STEP_TIME = 20,
  // A manifold names a body that is not in the array, or one body twice.
  CAROM_INDEX = 21,
  // Too many of something.
  CAROM_COUNT = 22,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum carom_status carom_status;
#else
typedef uint32_t carom_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// What a contact did: the `outcome` of an impact.
enum carom_outcome
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // The bodies do not approach each other at the point: nothing was changed.
  CAROM_SEPARATING = 0,
  // The points do not slide on each other: friction held.
  CAROM_STUCK = 1,
  // The points slide on each other, with friction at its limit, or without friction.
  CAROM_SLID = 2,
  // Neither body can move: nothing was changed.
  CAROM_IMMOVABLE = 3,
  // A number was not finite, or would not be: nothing was changed. Never in fixed point.
  CAROM_OUTCOME_NOT_FINITE = 4,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum carom_outcome carom_outcome;
#else
typedef uint32_t carom_outcome;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// What a contact does in a step: the `phase` of two bodies that touch.
enum carom_phase
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // The bodies did not touch before this step.
  CAROM_BEGAN = 0,
  // They did, and do.
  CAROM_PERSISTS = 1,
  // They do not any more.
  CAROM_ENDED = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum carom_phase carom_phase;
#else
typedef uint32_t carom_phase;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Which law restitution follows where friction acts with it: the `law` of a material.
enum carom_restitution_law
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // v_n' = -e v_n, always. With friction that may raise the energy in rare eccentric impacts.
  CAROM_NEWTON = 0,
  // The same, but where it would raise the energy the rebound is drawn back until it does not.
  CAROM_ENERGY_SAFE = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum carom_restitution_law carom_restitution_law;
#else
typedef uint32_t carom_restitution_law;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// What a body looks like. The numbers of carom_shape_kind.
enum carom_shape_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // A ball: its radius.
  CAROM_SPHERE = 1,
  // A box: its half extents.
  CAROM_CUBOID = 2,
  // A rod with round ends along the local z axis: its radius, and half the length of the segment without the round ends.
  CAROM_CAPSULE = 3,
  // All that lies behind the plane through the body's position: its normal, out of it. It belongs on an immovable body.
  CAROM_HALF_SPACE = 4,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum carom_shape_kind carom_shape_kind;
#else
typedef uint32_t carom_shape_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// A world: made by one of the ..._world_..._init functions in memory of yours, and only to be pointed to.
typedef struct carom_f32_world carom_f32_world;

// A world: made by one of the ..._world_..._init functions in memory of yours, and only to be pointed to.
typedef struct carom_q16_world carom_q16_world;

// A world: made by one of the ..._world_..._init functions in memory of yours, and only to be pointed to.
typedef struct carom_q20_world carom_q20_world;

// A vector: metres, m/s, rad/s, or whatever the units of the scene are.
typedef struct carom_f32_vec3 {
  // Along the first axis.
  float x;
  // Along the second axis.
  float y;
  // Along the third axis.
  float z;
} carom_f32_vec3;

// A direction: a vector whose length is one within 2^-17. In fixed point its components are Q2.30 (CAROM_Q30).
typedef struct carom_f32_unit_vec3 {
  // Along the first axis.
  float x;
  // Along the second axis.
  float y;
  // Along the third axis.
  float z;
} carom_f32_unit_vec3;

// An orientation, from the body's frame to the world's: a quaternion of unit length. In fixed point its components are
// Q2.30 (CAROM_Q30).
typedef struct carom_f32_quat {
  // The scalar part: 1 where nothing is turned.
  float w;
  // Along the first axis.
  float x;
  // Along the second axis.
  float y;
  // Along the third axis.
  float z;
} carom_f32_quat;

// A rigid body: where it is, how it moves, and how hard it is to move. Made by the ..._body_... functions; then its
// first six fields are yours to read and to write. A copy of it is a body like it.
typedef struct carom_f32_body {
  // The centre of mass in the world's frame, m.
  struct carom_f32_vec3 position;
  // The velocity of the centre of mass in the world's frame, m/s.
  struct carom_f32_vec3 linear_velocity;
  // The angular velocity in the world's frame, rad/s.
  struct carom_f32_vec3 angular_velocity;
  // By how much gravity acts on the body: 1 as on others, 0 not at all.
  float gravity_scale;
  // The rate at which the velocity decays, 1/s.
  float linear_damping;
  // The rate at which the angular velocity decays, 1/s.
  float angular_damping;
  // The library's own: mass, inertia, orientation, and what the format cannot hold of the motion.
  uint32_t reserved[23];
} carom_f32_body;

// A shape: its kind, and the dimensions that this kind has; the others are not looked at.
typedef struct carom_f32_shape {
  // A carom_shape_kind.
  uint32_t kind;
  // Of a sphere or a capsule, m.
  float radius;
  // Of a capsule: half the length of its segment, without the round ends, m.
  float half_length;
  // Of a cuboid: half of each edge, m.
  struct carom_f32_vec3 half_extents;
  // Of a half-space: out of it.
  struct carom_f32_unit_vec3 normal;
} carom_f32_shape;

// A vector: metres, m/s, rad/s, or whatever the units of the scene are.
typedef struct carom_q16_vec3 {
  // Along the first axis.
  int32_t x;
  // Along the second axis.
  int32_t y;
  // Along the third axis.
  int32_t z;
} carom_q16_vec3;

// A direction: a vector whose length is one within 2^-17. In fixed point its components are Q2.30 (CAROM_Q30).
typedef struct carom_q16_unit_vec3 {
  // Along the first axis.
  int32_t x;
  // Along the second axis.
  int32_t y;
  // Along the third axis.
  int32_t z;
} carom_q16_unit_vec3;

// An orientation, from the body's frame to the world's: a quaternion of unit length. In fixed point its components are
// Q2.30 (CAROM_Q30).
typedef struct carom_q16_quat {
  // The scalar part: 1 where nothing is turned.
  int32_t w;
  // Along the first axis.
  int32_t x;
  // Along the second axis.
  int32_t y;
  // Along the third axis.
  int32_t z;
} carom_q16_quat;

// A rigid body: where it is, how it moves, and how hard it is to move. Made by the ..._body_... functions; then its
// first six fields are yours to read and to write. A copy of it is a body like it.
typedef struct carom_q16_body {
  // The centre of mass in the world's frame, m.
  struct carom_q16_vec3 position;
  // The velocity of the centre of mass in the world's frame, m/s.
  struct carom_q16_vec3 linear_velocity;
  // The angular velocity in the world's frame, rad/s.
  struct carom_q16_vec3 angular_velocity;
  // By how much gravity acts on the body: 1 as on others, 0 not at all.
  int32_t gravity_scale;
  // The rate at which the velocity decays, 1/s.
  int32_t linear_damping;
  // The rate at which the angular velocity decays, 1/s.
  int32_t angular_damping;
  // The library's own: mass, inertia, orientation, and what the format cannot hold of the motion.
  uint32_t reserved[27];
} carom_q16_body;

// A shape: its kind, and the dimensions that this kind has; the others are not looked at.
typedef struct carom_q16_shape {
  // A carom_shape_kind.
  uint32_t kind;
  // Of a sphere or a capsule, m.
  int32_t radius;
  // Of a capsule: half the length of its segment, without the round ends, m.
  int32_t half_length;
  // Of a cuboid: half of each edge, m.
  struct carom_q16_vec3 half_extents;
  // Of a half-space: out of it.
  struct carom_q16_unit_vec3 normal;
} carom_q16_shape;

// A vector: metres, m/s, rad/s, or whatever the units of the scene are.
typedef struct carom_q20_vec3 {
  // Along the first axis.
  int32_t x;
  // Along the second axis.
  int32_t y;
  // Along the third axis.
  int32_t z;
} carom_q20_vec3;

// A direction: a vector whose length is one within 2^-17. In fixed point its components are Q2.30 (CAROM_Q30).
typedef struct carom_q20_unit_vec3 {
  // Along the first axis.
  int32_t x;
  // Along the second axis.
  int32_t y;
  // Along the third axis.
  int32_t z;
} carom_q20_unit_vec3;

// An orientation, from the body's frame to the world's: a quaternion of unit length. In fixed point its components are
// Q2.30 (CAROM_Q30).
typedef struct carom_q20_quat {
  // The scalar part: 1 where nothing is turned.
  int32_t w;
  // Along the first axis.
  int32_t x;
  // Along the second axis.
  int32_t y;
  // Along the third axis.
  int32_t z;
} carom_q20_quat;

// A rigid body: where it is, how it moves, and how hard it is to move. Made by the ..._body_... functions; then its
// first six fields are yours to read and to write. A copy of it is a body like it.
typedef struct carom_q20_body {
  // The centre of mass in the world's frame, m.
  struct carom_q20_vec3 position;
  // The velocity of the centre of mass in the world's frame, m/s.
  struct carom_q20_vec3 linear_velocity;
  // The angular velocity in the world's frame, rad/s.
  struct carom_q20_vec3 angular_velocity;
  // By how much gravity acts on the body: 1 as on others, 0 not at all.
  int32_t gravity_scale;
  // The rate at which the velocity decays, 1/s.
  int32_t linear_damping;
  // The rate at which the angular velocity decays, 1/s.
  int32_t angular_damping;
  // The library's own: mass, inertia, orientation, and what the format cannot hold of the motion.
  uint32_t reserved[27];
} carom_q20_body;

// A shape: its kind, and the dimensions that this kind has; the others are not looked at.
typedef struct carom_q20_shape {
  // A carom_shape_kind.
  uint32_t kind;
  // Of a sphere or a capsule, m.
  int32_t radius;
  // Of a capsule: half the length of its segment, without the round ends, m.
  int32_t half_length;
  // Of a cuboid: half of each edge, m.
  struct carom_q20_vec3 half_extents;
  // Of a half-space: out of it.
  struct carom_q20_unit_vec3 normal;
} carom_q20_shape;

// Gravity and time: the same for all bodies.
typedef struct carom_f32_settings {
  // The acceleration of free fall, m/s^2.
  struct carom_f32_vec3 gravity;
  // The speed at which bodies that overlap are pushed apart, at most, m/s: about the highest speed of the scene. Zero
  // takes 4.
  float push_out_speed;
  // The length of a step is `seconds_numerator / seconds_denominator` seconds: 1 and 60, say.
  uint16_t seconds_numerator;
  // See there.
  uint16_t seconds_denominator;
  // Sub-steps in a step: 4 suit most scenes.
  uint32_t sub_steps;
} carom_f32_settings;

// Gravity and time: the same for all bodies.
typedef struct carom_q16_settings {
  // The acceleration of free fall, m/s^2.
  struct carom_q16_vec3 gravity;
  // The speed at which bodies that overlap are pushed apart, at most, m/s: about the highest speed of the scene. Zero
  // takes 4.
  int32_t push_out_speed;
  // The length of a step is `seconds_numerator / seconds_denominator` seconds: 1 and 60, say.
  uint16_t seconds_numerator;
  // See there.
  uint16_t seconds_denominator;
  // Sub-steps in a step: 4 suit most scenes.
  uint32_t sub_steps;
} carom_q16_settings;

// Gravity and time: the same for all bodies.
typedef struct carom_q20_settings {
  // The acceleration of free fall, m/s^2.
  struct carom_q20_vec3 gravity;
  // The speed at which bodies that overlap are pushed apart, at most, m/s: about the highest speed of the scene. Zero
  // takes 4.
  int32_t push_out_speed;
  // The length of a step is `seconds_numerator / seconds_denominator` seconds: 1 and 60, say.
  uint16_t seconds_numerator;
  // See there.
  uint16_t seconds_denominator;
  // Sub-steps in a step: 4 suit most scenes.
  uint32_t sub_steps;
} carom_q20_settings;

// A point at which two bodies touch.
typedef struct carom_f32_contact {
  // From body A to body B.
  struct carom_f32_unit_vec3 normal;
  // From the centre of mass of A to the point, in the world's frame, m.
  struct carom_f32_vec3 r_a;
  // From the centre of mass of B to the point, in the world's frame, m.
  struct carom_f32_vec3 r_b;
} carom_f32_contact;

// What a contact did, and with which impulse: on B as given here, on A the opposite.
typedef struct carom_f32_impact {
  // The kind of event.
  carom_outcome outcome;
  // The impulse along the normal, never negative, N s.
  float normal_impulse;
  // The impulse of friction, across the normal, in the world's frame, N s.
  struct carom_f32_vec3 friction_impulse;
  // 1 where a velocity or a reported impulse met the end of the format and stayed there, else 0.
  uint32_t saturated;
} carom_f32_impact;

// How a surface rebounds and rubs. Between two surfaces of a world the geometric means of their coefficients count.
typedef struct carom_f32_material {
  // The coefficient of restitution e, 0 to 1.
  float restitution;
  // The coefficient of friction mu, 0 or more.
  float friction;
  // A carom_restitution_law.
  uint32_t law;
} carom_f32_material;

// A point at which two bodies touch.
typedef struct carom_q16_contact {
  // From body A to body B.
  struct carom_q16_unit_vec3 normal;
  // From the centre of mass of A to the point, in the world's frame, m.
  struct carom_q16_vec3 r_a;
  // From the centre of mass of B to the point, in the world's frame, m.
  struct carom_q16_vec3 r_b;
} carom_q16_contact;

// What a contact did, and with which impulse: on B as given here, on A the opposite.
typedef struct carom_q16_impact {
  // The kind of event.
  carom_outcome outcome;
  // The impulse along the normal, never negative, N s.
  int32_t normal_impulse;
  // The impulse of friction, across the normal, in the world's frame, N s.
  struct carom_q16_vec3 friction_impulse;
  // 1 where a velocity or a reported impulse met the end of the format and stayed there, else 0.
  uint32_t saturated;
} carom_q16_impact;

// How a surface rebounds and rubs. Between two surfaces of a world the geometric means of their coefficients count.
typedef struct carom_q16_material {
  // The coefficient of restitution e, 0 to 1.
  int32_t restitution;
  // The coefficient of friction mu, 0 or more.
  int32_t friction;
  // A carom_restitution_law.
  uint32_t law;
} carom_q16_material;

// A point at which two bodies touch.
typedef struct carom_q20_contact {
  // From body A to body B.
  struct carom_q20_unit_vec3 normal;
  // From the centre of mass of A to the point, in the world's frame, m.
  struct carom_q20_vec3 r_a;
  // From the centre of mass of B to the point, in the world's frame, m.
  struct carom_q20_vec3 r_b;
} carom_q20_contact;

// What a contact did, and with which impulse: on B as given here, on A the opposite.
typedef struct carom_q20_impact {
  // The kind of event.
  carom_outcome outcome;
  // The impulse along the normal, never negative, N s.
  int32_t normal_impulse;
  // The impulse of friction, across the normal, in the world's frame, N s.
  struct carom_q20_vec3 friction_impulse;
  // 1 where a velocity or a reported impulse met the end of the format and stayed there, else 0.
  uint32_t saturated;
} carom_q20_impact;

// How a surface rebounds and rubs. Between two surfaces of a world the geometric means of their coefficients count.
typedef struct carom_q20_material {
  // The coefficient of restitution e, 0 to 1.
  int32_t restitution;
  // The coefficient of friction mu, 0 or more.
  int32_t friction;
  // A carom_restitution_law.
  uint32_t law;
} carom_q20_material;

// A point of a manifold, halfway between the two surfaces.
typedef struct carom_f32_manifold_point {
  // From the centre of mass of A to the point, in the world's frame, m.
  struct carom_f32_vec3 r_a;
  // From the centre of mass of B to the point, in the world's frame, m.
  struct carom_f32_vec3 r_b;
  // The gap between the surfaces along the normal, m: negative where they overlap.
  float separation;
  // What makes the point: the same number in the next step means the same point.
  uint16_t feature;
  // Not looked at.
  uint16_t reserved;
} carom_f32_manifold_point;

// Where two bodies touch, or are about to: a normal and up to four points. Begin with all zeros; keep it from step to step
// as long as the two touch, and give it their new normal and points before each: it carries the impulses over.
typedef struct carom_f32_manifold {
  // The places of the bodies A and B in the array.
  uint16_t a;
  // See there.
  uint16_t b;
  // How many points there are.
  uint32_t point_count;
  // From A to B.
  struct carom_f32_unit_vec3 normal;
  // Of the pair.
  struct carom_f32_material material;
  // The points.
  struct carom_f32_manifold_point points[4];
  // Told by the step: the normal impulse over it, N s.
  float normal_impulse;
  // Told by the step: how fast the surfaces met in it, m/s; zero where they did not.
  float approach_speed;
  // Told by the step: 1 where it solved the manifold, 0 where there are no points or neither body moves.
  uint32_t solved;
  // The library's own.
  uint32_t warm_count;
  // The library's own.
  uint32_t warm[4][6];
} carom_f32_manifold;

// A point of a manifold, halfway between the two surfaces.
typedef struct carom_q16_manifold_point {
  // From the centre of mass of A to the point, in the world's frame, m.
  struct carom_q16_vec3 r_a;
  // From the centre of mass of B to the point, in the world's frame, m.
  struct carom_q16_vec3 r_b;
  // The gap between the surfaces along the normal, m: negative where they overlap.
  int32_t separation;
  // What makes the point: the same number in the next step means the same point.
  uint16_t feature;
  // Not looked at.
  uint16_t reserved;
} carom_q16_manifold_point;

// Where two bodies touch, or are about to: a normal and up to four points. Begin with all zeros; keep it from step to step
// as long as the two touch, and give it their new normal and points before each: it carries the impulses over.
typedef struct carom_q16_manifold {
  // The places of the bodies A and B in the array.
  uint16_t a;
  // See there.
  uint16_t b;
  // How many points there are.
  uint32_t point_count;
  // From A to B.
  struct carom_q16_unit_vec3 normal;
  // Of the pair.
  struct carom_q16_material material;
  // The points.
  struct carom_q16_manifold_point points[4];
  // Told by the step: the normal impulse over it, N s.
  int32_t normal_impulse;
  // Told by the step: how fast the surfaces met in it, m/s; zero where they did not.
  int32_t approach_speed;
  // Told by the step: 1 where it solved the manifold, 0 where there are no points or neither body moves.
  uint32_t solved;
  // The library's own.
  uint32_t warm_count;
  // The library's own.
  uint32_t warm[4][6];
} carom_q16_manifold;

// A point of a manifold, halfway between the two surfaces.
typedef struct carom_q20_manifold_point {
  // From the centre of mass of A to the point, in the world's frame, m.
  struct carom_q20_vec3 r_a;
  // From the centre of mass of B to the point, in the world's frame, m.
  struct carom_q20_vec3 r_b;
  // The gap between the surfaces along the normal, m: negative where they overlap.
  int32_t separation;
  // What makes the point: the same number in the next step means the same point.
  uint16_t feature;
  // Not looked at.
  uint16_t reserved;
} carom_q20_manifold_point;

// Where two bodies touch, or are about to: a normal and up to four points. Begin with all zeros; keep it from step to step
// as long as the two touch, and give it their new normal and points before each: it carries the impulses over.
typedef struct carom_q20_manifold {
  // The places of the bodies A and B in the array.
  uint16_t a;
  // See there.
  uint16_t b;
  // How many points there are.
  uint32_t point_count;
  // From A to B.
  struct carom_q20_unit_vec3 normal;
  // Of the pair.
  struct carom_q20_material material;
  // The points.
  struct carom_q20_manifold_point points[4];
  // Told by the step: the normal impulse over it, N s.
  int32_t normal_impulse;
  // Told by the step: how fast the surfaces met in it, m/s; zero where they did not.
  int32_t approach_speed;
  // Told by the step: 1 where it solved the manifold, 0 where there are no points or neither body moves.
  uint32_t solved;
  // The library's own.
  uint32_t warm_count;
  // The library's own.
  uint32_t warm[4][6];
} carom_q20_manifold;

// A body of a world, for as long as it is there. A handle of a body that was removed is refused; it never means another one,
// until a place has been used 65,536 times. All zeros (CAROM_NO_BODY) is no body.
typedef struct carom_body_handle {
  // To be compared, and for nothing else.
  uint32_t bits;
} carom_body_handle;

// What a step of a world has to say.
typedef struct carom_world_report {
  // The points of contact that were solved.
  uint16_t points;
  // The pairs of surfaces that they belong to, and those of sensors and sleeping bodies.
  uint16_t manifolds;
  // Pairs that were left out for lack of room: those bodies did not see each other in this step. Take a larger world.
  uint16_t dropped;
  // The bodies that sleep.
  uint16_t asleep;
  // The bodies that took no part because a number in them is not finite.
  uint16_t quarantined;
  // 1 where a position or velocity met the end of the format and stayed there, else 0.
  uint16_t saturated;
} carom_world_report;

// Two bodies that touch, or did until this step.
typedef struct carom_f32_touching {
  // The body with the lower place in the world.
  struct carom_body_handle a;
  // The other one.
  struct carom_body_handle b;
  // Whether it is new.
  carom_phase phase;
  // 1 where one of the two is a sensor, else 0.
  uint32_t sensor;
  // The normal impulse in this step, N s.
  float normal_impulse;
  // How fast the surfaces met in this step, m/s; zero where they did not meet in it.
  float approach_speed;
} carom_f32_touching;

// A straight way in the world.
typedef struct carom_f32_ray {
  // Where it begins, m.
  struct carom_f32_vec3 origin;
  // Where it goes.
  struct carom_f32_unit_vec3 direction;
  // How far it goes, m.
  float length;
} carom_f32_ray;

// What a ray meets first.
typedef struct carom_f32_ray_hit {
  // The body; CAROM_NO_BODY where the ray meets nothing, and then the rest is zeros.
  struct carom_body_handle body;
  // From the ray's origin, m; zero where that lies in the body.
  float distance;
  // Out of the body; against the ray where that begins in the body.
  struct carom_f32_unit_vec3 normal;
} carom_f32_ray_hit;

// Two bodies that touch, or did until this step.
typedef struct carom_q16_touching {
  // The body with the lower place in the world.
  struct carom_body_handle a;
  // The other one.
  struct carom_body_handle b;
  // Whether it is new.
  carom_phase phase;
  // 1 where one of the two is a sensor, else 0.
  uint32_t sensor;
  // The normal impulse in this step, N s.
  int32_t normal_impulse;
  // How fast the surfaces met in this step, m/s; zero where they did not meet in it.
  int32_t approach_speed;
} carom_q16_touching;

// A straight way in the world.
typedef struct carom_q16_ray {
  // Where it begins, m.
  struct carom_q16_vec3 origin;
  // Where it goes.
  struct carom_q16_unit_vec3 direction;
  // How far it goes, m.
  int32_t length;
} carom_q16_ray;

// What a ray meets first.
typedef struct carom_q16_ray_hit {
  // The body; CAROM_NO_BODY where the ray meets nothing, and then the rest is zeros.
  struct carom_body_handle body;
  // From the ray's origin, m; zero where that lies in the body.
  int32_t distance;
  // Out of the body; against the ray where that begins in the body.
  struct carom_q16_unit_vec3 normal;
} carom_q16_ray_hit;

// Two bodies that touch, or did until this step.
typedef struct carom_q20_touching {
  // The body with the lower place in the world.
  struct carom_body_handle a;
  // The other one.
  struct carom_body_handle b;
  // Whether it is new.
  carom_phase phase;
  // 1 where one of the two is a sensor, else 0.
  uint32_t sensor;
  // The normal impulse in this step, N s.
  int32_t normal_impulse;
  // How fast the surfaces met in this step, m/s; zero where they did not meet in it.
  int32_t approach_speed;
} carom_q20_touching;

// A straight way in the world.
typedef struct carom_q20_ray {
  // Where it begins, m.
  struct carom_q20_vec3 origin;
  // Where it goes.
  struct carom_q20_unit_vec3 direction;
  // How far it goes, m.
  int32_t length;
} carom_q20_ray;

// What a ray meets first.
typedef struct carom_q20_ray_hit {
  // The body; CAROM_NO_BODY where the ray meets nothing, and then the rest is zeros.
  struct carom_body_handle body;
  // From the ray's origin, m; zero where that lies in the body.
  int32_t distance;
  // Out of the body; against the ray where that begins in the body.
  struct carom_q20_unit_vec3 normal;
} carom_q20_ray_hit;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// What a status means and what to do about it: one sentence, in English, that ends with a zero and lives for ever. Any number may
// be asked for.
const char *carom_status_text(uint32_t status);

// `numerator / denominator`, rounded to the format: numbers that are made at run time, the same on every machine.
carom_status carom_f32_ratio(int32_t numerator,
                             int32_t denominator,
                             float *result);

// The direction of a vector of any length but zero.
carom_status carom_f32_direction(const struct carom_f32_vec3 *vector, struct carom_f32_unit_vec3 *result);

// Makes a quaternion of any length but zero one of unit length, in place. In fixed point its components are Q2.30: take
// them within +-1/2, so that the square of the length is within the format.
carom_status carom_f32_quat_normalize(struct carom_f32_quat *orientation);

// A body that nothing moves: the ground, a wall. With a velocity set it is driven: it strikes, and is not deflected.
carom_status carom_f32_body_immovable(struct carom_f32_body *body);

// A homogeneous body of that shape and mass (kg), at rest at the origin. A half-space has no mass: CAROM_SHAPE.
carom_status carom_f32_body_dynamic(const struct carom_f32_shape *shape,
                                    float mass,
                                    struct carom_f32_body *body);

// A body of that mass (kg) and that inertia tensor about its centre of mass, in its own frame: xx, xy, xz, yy, yz, zz,
// kg m^2. At rest at the origin.
carom_status carom_f32_body_with_inertia(float mass,
                                         const float *inertia,
                                         struct carom_f32_body *body);

// Turns the body, and its inertia with it. The orientation is of unit length: see quat_normalize.
carom_status carom_f32_body_set_orientation(struct carom_f32_body *body,
                                            const struct carom_f32_quat *orientation);

// The orientation of the body.
carom_status carom_f32_body_orientation(const struct carom_f32_body *body, struct carom_f32_quat *result);

// A point of the body's frame (m) as seen from its centre of mass in the world's axes: an arm for a contact, or a
// direction on the body.
carom_status carom_f32_body_arm(const struct carom_f32_body *body,
                                const struct carom_f32_vec3 *local,
                                struct carom_f32_vec3 *result);

// An impulse (N s) at the end of an arm from the centre of mass (m; null: at the centre), both in the world's axes.
// `saturated`, which may be null, becomes 1 where a velocity met the end of the format and stayed there, else 0.
carom_status carom_f32_body_apply_impulse(struct carom_f32_body *body,
                                          const struct carom_f32_vec3 *impulse,
                                          const struct carom_f32_vec3 *arm,
                                          uint32_t *saturated);

// `numerator / denominator`, rounded to the format: numbers that are made at run time, the same on every machine.
carom_status carom_q16_ratio(int32_t numerator,
                             int32_t denominator,
                             int32_t *result);

// The direction of a vector of any length but zero.
carom_status carom_q16_direction(const struct carom_q16_vec3 *vector, struct carom_q16_unit_vec3 *result);

// Makes a quaternion of any length but zero one of unit length, in place. In fixed point its components are Q2.30: take
// them within +-1/2, so that the square of the length is within the format.
carom_status carom_q16_quat_normalize(struct carom_q16_quat *orientation);

// A body that nothing moves: the ground, a wall. With a velocity set it is driven: it strikes, and is not deflected.
carom_status carom_q16_body_immovable(struct carom_q16_body *body);

// A homogeneous body of that shape and mass (kg), at rest at the origin. A half-space has no mass: CAROM_SHAPE.
carom_status carom_q16_body_dynamic(const struct carom_q16_shape *shape,
                                    int32_t mass,
                                    struct carom_q16_body *body);

// A body of that mass (kg) and that inertia tensor about its centre of mass, in its own frame: xx, xy, xz, yy, yz, zz,
// kg m^2. At rest at the origin.
carom_status carom_q16_body_with_inertia(int32_t mass,
                                         const int32_t *inertia,
                                         struct carom_q16_body *body);

// Turns the body, and its inertia with it. The orientation is of unit length: see quat_normalize.
carom_status carom_q16_body_set_orientation(struct carom_q16_body *body,
                                            const struct carom_q16_quat *orientation);

// The orientation of the body.
carom_status carom_q16_body_orientation(const struct carom_q16_body *body, struct carom_q16_quat *result);

// A point of the body's frame (m) as seen from its centre of mass in the world's axes: an arm for a contact, or a
// direction on the body.
carom_status carom_q16_body_arm(const struct carom_q16_body *body,
                                const struct carom_q16_vec3 *local,
                                struct carom_q16_vec3 *result);

// An impulse (N s) at the end of an arm from the centre of mass (m; null: at the centre), both in the world's axes.
// `saturated`, which may be null, becomes 1 where a velocity met the end of the format and stayed there, else 0.
carom_status carom_q16_body_apply_impulse(struct carom_q16_body *body,
                                          const struct carom_q16_vec3 *impulse,
                                          const struct carom_q16_vec3 *arm,
                                          uint32_t *saturated);

// `numerator / denominator`, rounded to the format: numbers that are made at run time, the same on every machine.
carom_status carom_q20_ratio(int32_t numerator,
                             int32_t denominator,
                             int32_t *result);

// The direction of a vector of any length but zero.
carom_status carom_q20_direction(const struct carom_q20_vec3 *vector, struct carom_q20_unit_vec3 *result);

// Makes a quaternion of any length but zero one of unit length, in place. In fixed point its components are Q2.30: take
// them within +-1/2, so that the square of the length is within the format.
carom_status carom_q20_quat_normalize(struct carom_q20_quat *orientation);

// A body that nothing moves: the ground, a wall. With a velocity set it is driven: it strikes, and is not deflected.
carom_status carom_q20_body_immovable(struct carom_q20_body *body);

// A homogeneous body of that shape and mass (kg), at rest at the origin. A half-space has no mass: CAROM_SHAPE.
carom_status carom_q20_body_dynamic(const struct carom_q20_shape *shape,
                                    int32_t mass,
                                    struct carom_q20_body *body);

// A body of that mass (kg) and that inertia tensor about its centre of mass, in its own frame: xx, xy, xz, yy, yz, zz,
// kg m^2. At rest at the origin.
carom_status carom_q20_body_with_inertia(int32_t mass,
                                         const int32_t *inertia,
                                         struct carom_q20_body *body);

// Turns the body, and its inertia with it. The orientation is of unit length: see quat_normalize.
carom_status carom_q20_body_set_orientation(struct carom_q20_body *body,
                                            const struct carom_q20_quat *orientation);

// The orientation of the body.
carom_status carom_q20_body_orientation(const struct carom_q20_body *body, struct carom_q20_quat *result);

// A point of the body's frame (m) as seen from its centre of mass in the world's axes: an arm for a contact, or a
// direction on the body.
carom_status carom_q20_body_arm(const struct carom_q20_body *body,
                                const struct carom_q20_vec3 *local,
                                struct carom_q20_vec3 *result);

// An impulse (N s) at the end of an arm from the centre of mass (m; null: at the centre), both in the world's axes.
// `saturated`, which may be null, becomes 1 where a velocity met the end of the format and stayed there, else 0.
carom_status carom_q20_body_apply_impulse(struct carom_q20_body *body,
                                          const struct carom_q20_vec3 *impulse,
                                          const struct carom_q20_vec3 *arm,
                                          uint32_t *saturated);

// A world of up to 4 bodies, and in a step up to 4 pairs of surfaces that touch
// or are about to, with up to 12 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_F32_WORLD_4X12_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_f32_world_4x12_init(void *memory,
                                       size_t size,
                                       const struct carom_f32_settings *settings,
                                       struct carom_f32_world **world);

// A world of up to 16 bodies, and in a step up to 12 pairs of surfaces that touch
// or are about to, with up to 12 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_F32_WORLD_16X12_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_f32_world_16x12_init(void *memory,
                                        size_t size,
                                        const struct carom_f32_settings *settings,
                                        struct carom_f32_world **world);

// A world of up to 16 bodies, and in a step up to 32 pairs of surfaces that touch
// or are about to, with up to 64 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_F32_WORLD_16X64_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_f32_world_16x64_init(void *memory,
                                        size_t size,
                                        const struct carom_f32_settings *settings,
                                        struct carom_f32_world **world);

// A world of up to 64 bodies, and in a step up to 128 pairs of surfaces that touch
// or are about to, with up to 256 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_F32_WORLD_64X256_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_f32_world_64x256_init(void *memory,
                                         size_t size,
                                         const struct carom_f32_settings *settings,
                                         struct carom_f32_world **world);

// A world of up to 4 bodies, and in a step up to 4 pairs of surfaces that touch
// or are about to, with up to 12 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_Q16_WORLD_4X12_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_q16_world_4x12_init(void *memory,
                                       size_t size,
                                       const struct carom_q16_settings *settings,
                                       struct carom_q16_world **world);

// A world of up to 16 bodies, and in a step up to 12 pairs of surfaces that touch
// or are about to, with up to 12 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_Q16_WORLD_16X12_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_q16_world_16x12_init(void *memory,
                                        size_t size,
                                        const struct carom_q16_settings *settings,
                                        struct carom_q16_world **world);

// A world of up to 16 bodies, and in a step up to 32 pairs of surfaces that touch
// or are about to, with up to 64 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_Q16_WORLD_16X64_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_q16_world_16x64_init(void *memory,
                                        size_t size,
                                        const struct carom_q16_settings *settings,
                                        struct carom_q16_world **world);

// A world of up to 64 bodies, and in a step up to 128 pairs of surfaces that touch
// or are about to, with up to 256 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_Q16_WORLD_64X256_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_q16_world_64x256_init(void *memory,
                                         size_t size,
                                         const struct carom_q16_settings *settings,
                                         struct carom_q16_world **world);

// A world of up to 4 bodies, and in a step up to 4 pairs of surfaces that touch
// or are about to, with up to 12 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_Q20_WORLD_4X12_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_q20_world_4x12_init(void *memory,
                                       size_t size,
                                       const struct carom_q20_settings *settings,
                                       struct carom_q20_world **world);

// A world of up to 16 bodies, and in a step up to 12 pairs of surfaces that touch
// or are about to, with up to 12 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_Q20_WORLD_16X12_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_q20_world_16x12_init(void *memory,
                                        size_t size,
                                        const struct carom_q20_settings *settings,
                                        struct carom_q20_world **world);

// A world of up to 16 bodies, and in a step up to 32 pairs of surfaces that touch
// or are about to, with up to 64 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_Q20_WORLD_16X64_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_q20_world_16x64_init(void *memory,
                                        size_t size,
                                        const struct carom_q20_settings *settings,
                                        struct carom_q20_world **world);

// A world of up to 64 bodies, and in a step up to 128 pairs of surfaces that touch
// or are about to, with up to 256 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_Q20_WORLD_64X256_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_q20_world_64x256_init(void *memory,
                                         size_t size,
                                         const struct carom_q20_settings *settings,
                                         struct carom_q20_world **world);

// A world of up to 16 spheres and half-spaces, and in a step up to 16 pairs of surfaces that touch
// or are about to, with up to 16 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_F32_BALLS_16X16_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_f32_balls_16x16_init(void *memory,
                                        size_t size,
                                        const struct carom_f32_settings *settings,
                                        struct carom_f32_world **world);

// A world of up to 16 spheres and half-spaces, and in a step up to 16 pairs of surfaces that touch
// or are about to, with up to 16 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_Q16_BALLS_16X16_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_q16_balls_16x16_init(void *memory,
                                        size_t size,
                                        const struct carom_q16_settings *settings,
                                        struct carom_q16_world **world);

// A world of up to 16 spheres and half-spaces, and in a step up to 16 pairs of surfaces that touch
// or are about to, with up to 16 points in all.
//
// `memory` is an array of uint64_t of `size` bytes, CAROM_Q20_BALLS_16X16_SIZE at least.
// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
// it brings the state back.
carom_status carom_q20_balls_16x16_init(void *memory,
                                        size_t size,
                                        const struct carom_q20_settings *settings,
                                        struct carom_q20_world **world);

// The mass that the contact opposes to an impulse along its normal, kg: zero where neither body can move.
carom_status carom_f32_effective_mass(const struct carom_f32_body *a,
                                      const struct carom_f32_body *b,
                                      const struct carom_f32_contact *contact,
                                      float *result);

// The velocity of B's point relative to A's, m/s.
carom_status carom_f32_relative_velocity(const struct carom_f32_body *a,
                                         const struct carom_f32_body *b,
                                         const struct carom_f32_contact *contact,
                                         struct carom_f32_vec3 *result);

// The impulse along the normal (N s) that makes v_n' = -e v_n, for approaching bodies and for separating ones alike, where
// it is negative. Nothing is changed.
carom_status carom_f32_collision_impulse(const struct carom_f32_body *a,
                                         const struct carom_f32_body *b,
                                         const struct carom_f32_contact *contact,
                                         float e,
                                         float *result);

// Rebound without friction: where the bodies approach, changes both so that v_n' = -e v_n. `impact` may be null.
carom_status carom_f32_resolve_collision(struct carom_f32_body *a,
                                         struct carom_f32_body *b,
                                         const struct carom_f32_contact *contact,
                                         float e,
                                         struct carom_f32_impact *impact);

// Rebound with Coulomb friction: the three components of the impulse are found together, in the cone |J_t| <= mu J_n.
// `impact` may be null.
carom_status carom_f32_resolve_collision_with_friction(struct carom_f32_body *a,
                                                       struct carom_f32_body *b,
                                                       const struct carom_f32_contact *contact,
                                                       const struct carom_f32_material *material,
                                                       struct carom_f32_impact *impact);

// The mass that the contact opposes to an impulse along its normal, kg: zero where neither body can move.
carom_status carom_q16_effective_mass(const struct carom_q16_body *a,
                                      const struct carom_q16_body *b,
                                      const struct carom_q16_contact *contact,
                                      int32_t *result);

// The velocity of B's point relative to A's, m/s.
carom_status carom_q16_relative_velocity(const struct carom_q16_body *a,
                                         const struct carom_q16_body *b,
                                         const struct carom_q16_contact *contact,
                                         struct carom_q16_vec3 *result);

// The impulse along the normal (N s) that makes v_n' = -e v_n, for approaching bodies and for separating ones alike, where
// it is negative. Nothing is changed.
carom_status carom_q16_collision_impulse(const struct carom_q16_body *a,
                                         const struct carom_q16_body *b,
                                         const struct carom_q16_contact *contact,
                                         int32_t e,
                                         int32_t *result);

// Rebound without friction: where the bodies approach, changes both so that v_n' = -e v_n. `impact` may be null.
carom_status carom_q16_resolve_collision(struct carom_q16_body *a,
                                         struct carom_q16_body *b,
                                         const struct carom_q16_contact *contact,
                                         int32_t e,
                                         struct carom_q16_impact *impact);

// Rebound with Coulomb friction: the three components of the impulse are found together, in the cone |J_t| <= mu J_n.
// `impact` may be null.
carom_status carom_q16_resolve_collision_with_friction(struct carom_q16_body *a,
                                                       struct carom_q16_body *b,
                                                       const struct carom_q16_contact *contact,
                                                       const struct carom_q16_material *material,
                                                       struct carom_q16_impact *impact);

// The mass that the contact opposes to an impulse along its normal, kg: zero where neither body can move.
carom_status carom_q20_effective_mass(const struct carom_q20_body *a,
                                      const struct carom_q20_body *b,
                                      const struct carom_q20_contact *contact,
                                      int32_t *result);

// The velocity of B's point relative to A's, m/s.
carom_status carom_q20_relative_velocity(const struct carom_q20_body *a,
                                         const struct carom_q20_body *b,
                                         const struct carom_q20_contact *contact,
                                         struct carom_q20_vec3 *result);

// The impulse along the normal (N s) that makes v_n' = -e v_n, for approaching bodies and for separating ones alike, where
// it is negative. Nothing is changed.
carom_status carom_q20_collision_impulse(const struct carom_q20_body *a,
                                         const struct carom_q20_body *b,
                                         const struct carom_q20_contact *contact,
                                         int32_t e,
                                         int32_t *result);

// Rebound without friction: where the bodies approach, changes both so that v_n' = -e v_n. `impact` may be null.
carom_status carom_q20_resolve_collision(struct carom_q20_body *a,
                                         struct carom_q20_body *b,
                                         const struct carom_q20_contact *contact,
                                         int32_t e,
                                         struct carom_q20_impact *impact);

// Rebound with Coulomb friction: the three components of the impulse are found together, in the cone |J_t| <= mu J_n.
// `impact` may be null.
carom_status carom_q20_resolve_collision_with_friction(struct carom_q20_body *a,
                                                       struct carom_q20_body *b,
                                                       const struct carom_q20_contact *contact,
                                                       const struct carom_q20_material *material,
                                                       struct carom_q20_impact *impact);

// Moves bodies on by one step: gravity, and the contacts that the manifolds describe.
//
// `workspace` is aligned as an array of uint64_t is and has `size` bytes, SOLVER_SIZE(bodies, manifolds, points) of this
// number type at least; what is in it does not matter, before or after. `saturated`, which may be null, becomes 1 where
// a position or velocity met the end of the format and stayed there, else 0.
carom_status carom_f32_solver_step(const struct carom_f32_settings *settings,
                                   struct carom_f32_body *bodies,
                                   size_t body_count,
                                   struct carom_f32_manifold *manifolds,
                                   size_t manifold_count,
                                   void *workspace,
                                   size_t size,
                                   uint32_t *saturated);

// Moves bodies on by one step: gravity, and the contacts that the manifolds describe.
//
// `workspace` is aligned as an array of uint64_t is and has `size` bytes, SOLVER_SIZE(bodies, manifolds, points) of this
// number type at least; what is in it does not matter, before or after. `saturated`, which may be null, becomes 1 where
// a position or velocity met the end of the format and stayed there, else 0.
carom_status carom_q16_solver_step(const struct carom_q16_settings *settings,
                                   struct carom_q16_body *bodies,
                                   size_t body_count,
                                   struct carom_q16_manifold *manifolds,
                                   size_t manifold_count,
                                   void *workspace,
                                   size_t size,
                                   uint32_t *saturated);

// Moves bodies on by one step: gravity, and the contacts that the manifolds describe.
//
// `workspace` is aligned as an array of uint64_t is and has `size` bytes, SOLVER_SIZE(bodies, manifolds, points) of this
// number type at least; what is in it does not matter, before or after. `saturated`, which may be null, becomes 1 where
// a position or velocity met the end of the format and stayed there, else 0.
carom_status carom_q20_solver_step(const struct carom_q20_settings *settings,
                                   struct carom_q20_body *bodies,
                                   size_t body_count,
                                   struct carom_q20_manifold *manifolds,
                                   size_t manifold_count,
                                   void *workspace,
                                   size_t size,
                                   uint32_t *saturated);

// Puts a body with that shape and material into the world, at the place and with the velocity that it has.
carom_status carom_f32_world_insert(struct carom_f32_world *world,
                                    const struct carom_f32_body *body,
                                    const struct carom_f32_shape *shape,
                                    const struct carom_f32_material *material,
                                    struct carom_body_handle *handle);

// Takes a body out, and writes it to `body`, which may be null. What it touched wakes up.
carom_status carom_f32_world_remove(struct carom_f32_world *world,
                                    struct carom_body_handle handle,
                                    struct carom_f32_body *body);

// Takes everything out. Handles given so far mean nothing afterwards.
carom_status carom_f32_world_clear(struct carom_f32_world *world);

// Writes the body as it is now to `body`.
carom_status carom_f32_world_get_body(struct carom_f32_world *world,
                                      struct carom_body_handle handle,
                                      struct carom_f32_body *body);

// Makes the body what `body` is: moved, pushed or changed. It wakes up, with all that it touches.
carom_status carom_f32_world_set_body(struct carom_f32_world *world,
                                      struct carom_body_handle handle,
                                      const struct carom_f32_body *body);

// Gives the body another shape.
carom_status carom_f32_world_set_shape(struct carom_f32_world *world,
                                       struct carom_body_handle handle,
                                       const struct carom_f32_shape *shape);

// Gives the body another material.
carom_status carom_f32_world_set_material(struct carom_f32_world *world,
                                          struct carom_body_handle handle,
                                          const struct carom_f32_material *material);

// Makes a sensor of the body, or a body of the sensor: a sensor notices what overlaps it, and stops nothing.
carom_status carom_f32_world_set_sensor(struct carom_f32_world *world,
                                        struct carom_body_handle handle,
                                        bool sensor);

// Says which bodies it meets: two meet where the groups of each are among those that the other meets. At first a body
// is in group 1 and meets all (0xffff).
carom_status carom_f32_world_set_filter(struct carom_f32_world *world,
                                        struct carom_body_handle handle,
                                        uint16_t groups,
                                        uint16_t meets);

// Whether the body sleeps.
carom_status carom_f32_world_is_asleep(struct carom_f32_world *world,
                                       struct carom_body_handle handle,
                                       bool *asleep);

// Whether bodies that have been still for half a second fall asleep. They do unless told otherwise.
carom_status carom_f32_world_set_sleeping(struct carom_f32_world *world, bool on);

// Another gravity from the next step on, m/s^2.
carom_status carom_f32_world_set_gravity(struct carom_f32_world *world, const struct carom_f32_vec3 *gravity);

// Other settings from the next step on: length of a step, sub-steps, gravity.
carom_status carom_f32_world_set_settings(struct carom_f32_world *world,
                                          const struct carom_f32_settings *settings);

// Moves everything on by one step. `report` may be null.
carom_status carom_f32_world_step(struct carom_f32_world *world, struct carom_world_report *report);

// Everything that touches after the last step, then what does not any more: up to `capacity` of it to `touching`
// (which may be null where that is zero), and to `count` how many there are, more than `capacity` perhaps.
carom_status carom_f32_world_contacts(struct carom_f32_world *world,
                                      struct carom_f32_touching *touching,
                                      size_t capacity,
                                      size_t *count);

// The contacts whose surfaces met in the last step: who hit whom, how fast and how hard. As for contacts.
carom_status carom_f32_world_impacts(struct carom_f32_world *world,
                                     struct carom_f32_touching *touching,
                                     size_t capacity,
                                     size_t *count);

// The first body that a ray meets, of those in a group of `meets` (0xffff: all). Sensors are looked through.
carom_status carom_f32_world_cast_ray(struct carom_f32_world *world,
                                      const struct carom_f32_ray *ray,
                                      uint16_t meets,
                                      struct carom_f32_ray_hit *hit);

// One number for the state of all bodies: equal on all machines after the same steps.
carom_status carom_f32_world_hash(struct carom_f32_world *world, uint64_t *hash);

// Puts a body with that shape and material into the world, at the place and with the velocity that it has.
carom_status carom_q16_world_insert(struct carom_q16_world *world,
                                    const struct carom_q16_body *body,
                                    const struct carom_q16_shape *shape,
                                    const struct carom_q16_material *material,
                                    struct carom_body_handle *handle);

// Takes a body out, and writes it to `body`, which may be null. What it touched wakes up.
carom_status carom_q16_world_remove(struct carom_q16_world *world,
                                    struct carom_body_handle handle,
                                    struct carom_q16_body *body);

// Takes everything out. Handles given so far mean nothing afterwards.
carom_status carom_q16_world_clear(struct carom_q16_world *world);

// Writes the body as it is now to `body`.
carom_status carom_q16_world_get_body(struct carom_q16_world *world,
                                      struct carom_body_handle handle,
                                      struct carom_q16_body *body);

// Makes the body what `body` is: moved, pushed or changed. It wakes up, with all that it touches.
carom_status carom_q16_world_set_body(struct carom_q16_world *world,
                                      struct carom_body_handle handle,
                                      const struct carom_q16_body *body);

// Gives the body another shape.
carom_status carom_q16_world_set_shape(struct carom_q16_world *world,
                                       struct carom_body_handle handle,
                                       const struct carom_q16_shape *shape);

// Gives the body another material.
carom_status carom_q16_world_set_material(struct carom_q16_world *world,
                                          struct carom_body_handle handle,
                                          const struct carom_q16_material *material);

// Makes a sensor of the body, or a body of the sensor: a sensor notices what overlaps it, and stops nothing.
carom_status carom_q16_world_set_sensor(struct carom_q16_world *world,
                                        struct carom_body_handle handle,
                                        bool sensor);

// Says which bodies it meets: two meet where the groups of each are among those that the other meets. At first a body
// is in group 1 and meets all (0xffff).
carom_status carom_q16_world_set_filter(struct carom_q16_world *world,
                                        struct carom_body_handle handle,
                                        uint16_t groups,
                                        uint16_t meets);

// Whether the body sleeps.
carom_status carom_q16_world_is_asleep(struct carom_q16_world *world,
                                       struct carom_body_handle handle,
                                       bool *asleep);

// Whether bodies that have been still for half a second fall asleep. They do unless told otherwise.
carom_status carom_q16_world_set_sleeping(struct carom_q16_world *world, bool on);

// Another gravity from the next step on, m/s^2.
carom_status carom_q16_world_set_gravity(struct carom_q16_world *world, const struct carom_q16_vec3 *gravity);

// Other settings from the next step on: length of a step, sub-steps, gravity.
carom_status carom_q16_world_set_settings(struct carom_q16_world *world,
                                          const struct carom_q16_settings *settings);

// Moves everything on by one step. `report` may be null.
carom_status carom_q16_world_step(struct carom_q16_world *world, struct carom_world_report *report);

// Everything that touches after the last step, then what does not any more: up to `capacity` of it to `touching`
// (which may be null where that is zero), and to `count` how many there are, more than `capacity` perhaps.
carom_status carom_q16_world_contacts(struct carom_q16_world *world,
                                      struct carom_q16_touching *touching,
                                      size_t capacity,
                                      size_t *count);

// The contacts whose surfaces met in the last step: who hit whom, how fast and how hard. As for contacts.
carom_status carom_q16_world_impacts(struct carom_q16_world *world,
                                     struct carom_q16_touching *touching,
                                     size_t capacity,
                                     size_t *count);

// The first body that a ray meets, of those in a group of `meets` (0xffff: all). Sensors are looked through.
carom_status carom_q16_world_cast_ray(struct carom_q16_world *world,
                                      const struct carom_q16_ray *ray,
                                      uint16_t meets,
                                      struct carom_q16_ray_hit *hit);

// One number for the state of all bodies: equal on all machines after the same steps.
carom_status carom_q16_world_hash(struct carom_q16_world *world, uint64_t *hash);

// Puts a body with that shape and material into the world, at the place and with the velocity that it has.
carom_status carom_q20_world_insert(struct carom_q20_world *world,
                                    const struct carom_q20_body *body,
                                    const struct carom_q20_shape *shape,
                                    const struct carom_q20_material *material,
                                    struct carom_body_handle *handle);

// Takes a body out, and writes it to `body`, which may be null. What it touched wakes up.
carom_status carom_q20_world_remove(struct carom_q20_world *world,
                                    struct carom_body_handle handle,
                                    struct carom_q20_body *body);

// Takes everything out. Handles given so far mean nothing afterwards.
carom_status carom_q20_world_clear(struct carom_q20_world *world);

// Writes the body as it is now to `body`.
carom_status carom_q20_world_get_body(struct carom_q20_world *world,
                                      struct carom_body_handle handle,
                                      struct carom_q20_body *body);

// Makes the body what `body` is: moved, pushed or changed. It wakes up, with all that it touches.
carom_status carom_q20_world_set_body(struct carom_q20_world *world,
                                      struct carom_body_handle handle,
                                      const struct carom_q20_body *body);

// Gives the body another shape.
carom_status carom_q20_world_set_shape(struct carom_q20_world *world,
                                       struct carom_body_handle handle,
                                       const struct carom_q20_shape *shape);

// Gives the body another material.
carom_status carom_q20_world_set_material(struct carom_q20_world *world,
                                          struct carom_body_handle handle,
                                          const struct carom_q20_material *material);

// Makes a sensor of the body, or a body of the sensor: a sensor notices what overlaps it, and stops nothing.
carom_status carom_q20_world_set_sensor(struct carom_q20_world *world,
                                        struct carom_body_handle handle,
                                        bool sensor);

// Says which bodies it meets: two meet where the groups of each are among those that the other meets. At first a body
// is in group 1 and meets all (0xffff).
carom_status carom_q20_world_set_filter(struct carom_q20_world *world,
                                        struct carom_body_handle handle,
                                        uint16_t groups,
                                        uint16_t meets);

// Whether the body sleeps.
carom_status carom_q20_world_is_asleep(struct carom_q20_world *world,
                                       struct carom_body_handle handle,
                                       bool *asleep);

// Whether bodies that have been still for half a second fall asleep. They do unless told otherwise.
carom_status carom_q20_world_set_sleeping(struct carom_q20_world *world, bool on);

// Another gravity from the next step on, m/s^2.
carom_status carom_q20_world_set_gravity(struct carom_q20_world *world, const struct carom_q20_vec3 *gravity);

// Other settings from the next step on: length of a step, sub-steps, gravity.
carom_status carom_q20_world_set_settings(struct carom_q20_world *world,
                                          const struct carom_q20_settings *settings);

// Moves everything on by one step. `report` may be null.
carom_status carom_q20_world_step(struct carom_q20_world *world, struct carom_world_report *report);

// Everything that touches after the last step, then what does not any more: up to `capacity` of it to `touching`
// (which may be null where that is zero), and to `count` how many there are, more than `capacity` perhaps.
carom_status carom_q20_world_contacts(struct carom_q20_world *world,
                                      struct carom_q20_touching *touching,
                                      size_t capacity,
                                      size_t *count);

// The contacts whose surfaces met in the last step: who hit whom, how fast and how hard. As for contacts.
carom_status carom_q20_world_impacts(struct carom_q20_world *world,
                                     struct carom_q20_touching *touching,
                                     size_t capacity,
                                     size_t *count);

// The first body that a ray meets, of those in a group of `meets` (0xffff: all). Sensors are looked through.
carom_status carom_q20_world_cast_ray(struct carom_q20_world *world,
                                      const struct carom_q20_ray *ray,
                                      uint16_t meets,
                                      struct carom_q20_ray_hit *hit);

// One number for the state of all bodies: equal on all machines after the same steps.
carom_status carom_q20_world_hash(struct carom_q20_world *world, uint64_t *hash);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* CAROM_H */
