//! What scenes must come to: one bound a line, in every number type unless it says otherwise.
#![allow(dead_code)]

/// The last apex of a ball with e = 1 before 10 s, against the first.
pub const APEX: f64 = 1e-3;
/// Apexes of the e-series, beside what looking once a step misses of an apex.
pub const SERIES: f64 = 0.01;
/// The speed of a ball that slid and rolls: 5.000.
pub const ROLLING: f64 = 1e-3;
/// Velocities of the rows of sliding_to_rolling, in parts of the speed at the start.
pub const SLIDING_ROW: f64 = 1e-4;
/// Stopping distance, with the integrator's offset.
pub const STOPPING: f64 = 0.01;
/// Degrees between the push and where the box comes to rest.
pub const HEADING: f64 = 0.1;
/// Accelerations on slopes.
pub const SLOPE: f64 = 0.01;
/// The same at the threshold, where a thousandth of the weight is left: gravity itself is rounded.
pub const SLOPE_AT_THRESHOLD: f64 = 0.03;
/// Metres in five seconds inside the cone, and in the last of them.
pub const CREEP: [f64; 2] = [3e-4, 1e-4];
/// Speeds at rest, beside 20 units of the last place: 3e-4 m/s in I16F16.
pub const NOISE: f64 = 1e-5;
/// Angle and time of a box that spins down.
pub const SPIN_DOWN: f64 = 0.01;
/// Free tops: |L|, energy, and degrees after 5 s.
pub const TOP: [f64; 3] = [1e-3, 1e-2, 1.0];
/// The height of the highest of eight spheres.
pub const EIGHT_SPHERES: f64 = 7.49;
/// By how much of a box a pile sinks in ten seconds.
pub const SINKS: f64 = 0.1;
/// The time a box past its edge takes to fall, in f64's; at a hundredth of a degree.
pub const EDGE: [f64; 2] = [1.1, 1.5];
/// The way of a slow ball in ten seconds.
pub const SLOW: f64 = 0.01;
/// Peak angles of a rocking block against f64's.
pub const ROCKING: f64 = 0.05;
/// What is left of the error after some sweeps, in parts of what a row-wise solver leaves.
pub const NETWORK: f64 = 1.05;
/// By how much of a box a box of a pile moves aside meanwhile.
pub const ASIDE: f64 = 0.1;
/// Impulses and approach speeds that a step tells.
pub const IMPULSE: f64 = 0.01;
/// The most energy of a box that bounces under the safe law, in parts of what it had.
pub const SAFE: f64 = 1.1;
/// Errors of a bouncing ball's energy, squared, in parts of exact bounces' seen through symplectic Euler; and in steps of 0.1 s.
pub const BOUNCING: f64 = 1.1;
pub const BOUNCING_COARSE: f64 = 1.15;
