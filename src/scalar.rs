//! Number types: the trait [`Scalar`], and one file for each type that implements it.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::body::Body;
use crate::contact::Contact;
use crate::error::RangeError;
use crate::impulse::{self, Impact};
use crate::math::{Block, BlockImpulse, SymBlock, SymMat3, Vec3};

#[cfg(any(feature = "f32", feature = "f64", feature = "micromath"))]
mod float;
#[cfg(any(feature = "f32", feature = "f64", feature = "micromath"))]
mod float_step;
mod step;

#[cfg(feature = "fixed")]
mod arm32;
#[cfg(feature = "fixed")]
mod contact32;
#[cfg(feature = "f32")]
mod f32;
#[cfg(feature = "f64")]
mod f64;
#[cfg(feature = "fixed")]
mod fixed;
#[cfg(all(feature = "f32", target_arch = "arm", target_abi = "eabihf"))]
mod fpu;
#[cfg(feature = "fixed")]
mod integer;
#[cfg(feature = "fixed")]
mod lever32;
#[cfg(feature = "fixed")]
mod machine;
#[cfg(feature = "micromath")]
mod micromath;
#[cfg(feature = "fixed")]
mod product;
#[cfg(feature = "fixed")]
mod scaled32;
#[cfg(feature = "fixed")]
mod slip32;
#[cfg(feature = "fixed")]
mod step32;
#[cfg(feature = "fixed")]
mod stored32;
#[cfg(feature = "fixed")]
mod wide;

#[cfg(feature = "fixed")]
pub use self::scaled32::Scaled32;
pub use self::step::{Column, StepArithmetic, Velocity, Weights};

/// A number type of the kernel, with the family of formats that goes with it.
///
/// | | stores | `f32` | `FixedI32<Frac>` |
/// |---|---|---|---|
/// | `Self` | positions, velocities, masses, impulses | `f32` | `Frac` fraction bits, 0 to 30 |
/// | [`Unit`](Self::Unit) | components of unit vectors, quaternions, rotations | `f32` | Q2.30 |
/// | [`Scaled`](Self::Scaled) | what lies between reading a body and writing it | `f32` | 30 bits and an exponent |
/// | [`SubStep`](Self::SubStep) | the length of a sub-step, below one second | `f32` | Q0.31 |
/// | [`Remainder`](Self::Remainder) | what a position could not hold of its motion | `f32` | 16 bits |
///
/// Sums of products are formed in 64 bits in fixed point and rounded **once**, to the nearest, ties away from zero: a
/// change of sign of the operands changes the sign of the result and nothing else. In floating point each operation
/// rounds, in the order written. Results beyond the format's range take its largest value; nothing wraps or panics.
/// Three-component operands are arrays in the order x, y, z.
#[diagnostic::on_unimplemented(
    message = "carom does not compute with `{Self}` as it is built here",
    note = "number types are features of carom: `f32` (default), `fixed`, `f64`, `micromath`; name yours in Cargo.toml"
)]
pub trait Scalar: Copy + Default + Debug + PartialEq + PartialOrd + Send + Sync + 'static {
    /// Components of unit vectors: magnitudes up to one, and a little more in between.
    type Unit: Scalar<Unit = Self::Unit, Scaled = Self::Scaled, Exponent = Self::Exponent>;
    /// Intermediate results of any magnitude.
    type Scaled: Scaled<Unit = Self::Unit, Exponent = Self::Exponent>;
    /// The power of two that a block of [`Unit`](Self::Unit) numbers shares; of size zero in floating point.
    type Exponent: Copy + Default + Debug + PartialEq + Send + Sync + 'static;
    /// Sums of products that are compared and not rounded: 64 bits in fixed point.
    type Wide: Copy + Debug + PartialEq + PartialOrd + Send + Sync + 'static;
    /// How an impulse along a direction turns a body; see [`lever`](Self::lever).
    type Lever: Copy + Debug + Send + Sync + 'static;
    /// How impulses at the end of an arm turn a body; see [`arm`](Self::arm).
    type Arm: Copy + Debug + Send + Sync + 'static;
    /// Length of a sub-step in seconds.
    type SubStep: Copy + Default + Debug + PartialEq + Send + Sync + 'static;
    /// What [`advance`](Self::advance) carries from one sub-step to the next.
    type Remainder: Copy + Default + Debug + PartialEq + Send + Sync + 'static;

    /// The arithmetic of a step.
    type Step: StepArithmetic<Self>;

    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// What [`advance`](Self::advance) carries at the start.
    const NO_REMAINDER: Self::Remainder;
    /// The largest number of the format.
    const LARGEST: Self;
    /// The spacing of the format's numbers; zero in floating point, where it depends on the number.
    const STEP: Self;
    /// Whether [`contact_impulse`](Self::contact_impulse) and what goes into it round alike for a number and its opposite.
    const SYMMETRIC: bool;
    /// Two to the zeroth.
    const NO_EXPONENT: Self::Exponent;

    /// `numerator / denominator`, rounded to the nearest: constants without float literals.
    ///
    /// In f32 and micromath this holds for operands up to 2^24; larger ones are rounded to 24 bits first, and the
    /// quotient is off by up to two and a half units of its last place.
    ///
    /// # Errors
    /// [`RangeError`] where the denominator is zero or the quotient beyond the format.
    fn from_ratio(numerator: i32, denominator: i32) -> Result<Self, RangeError>;

    /// `numerator / denominator` seconds as the length of a sub-step, rounded as by [`from_ratio`](Self::from_ratio).
    ///
    /// # Errors
    /// [`RangeError`] where the quotient is outside `[0, 1)` once it is rounded: in f32 from about 1 - 2^-23 on.
    fn sub_step(numerator: i32, denominator: i32) -> Result<Self::SubStep, RangeError>;

    /// Neither an infinity nor a NaN; always true in fixed point.
    fn is_finite(self) -> bool;

    /// The stored bits, zero-extended: what state hashes are made of.
    fn bits(self) -> u64;

    /// `self + other`.
    #[must_use]
    fn plus(self, other: Self) -> Self;

    /// `self - other`.
    #[must_use]
    fn minus(self, other: Self) -> Self;

    /// `self * other`.
    #[must_use]
    fn times(self, other: Self) -> Self;

    /// `self / other`. By zero: an infinity or NaN in floating point; in fixed point the end of the range with the sign
    /// of `self`, and 0/0 is 0.
    #[must_use]
    fn over(self, other: Self) -> Self;

    /// `-self`.
    #[must_use]
    fn negated(self) -> Self;

    /// The square root, correctly rounded (`micromath::F32`: within 1e-5 of it, relative). Of a negative number: NaN,
    /// in fixed point zero.
    #[must_use]
    fn sqrt(self) -> Self;

    /// `a0 b0 + a1 b1 + a2 b2`.
    #[must_use]
    fn dot3(a: [Self; 3], b: [Self; 3]) -> Self;

    /// `a d - b c`: a component of a cross product.
    #[must_use]
    fn det2(a: Self, b: Self, c: Self, d: Self) -> Self;

    /// `v0 d0 + v1 d1 + v2 d2` with a row of a rotation or a unit vector.
    #[must_use]
    fn dot3_unit(v: [Self; 3], d: [Self::Unit; 3]) -> Self;

    /// The length of a vector.
    #[must_use]
    fn length3(v: [Self; 3]) -> Self;

    /// The vector divided by its length; `None` where that is zero or not finite.
    ///
    /// In fixed point the direction is as good as the given components allow, however short the vector: each component
    /// is within 2 units of 2^-30 of the exact quotient. In f32 vectors shorter than 1e-19 or longer than 1e19 are
    /// scaled first.
    fn normalize3(v: [Self; 3]) -> Option<[Self::Unit; 3]>;

    /// The direction of a vector and its length, by one inverse root: what [`normalize3`](Self::normalize3) and
    /// [`length3`](Self::length3) give, cheaper. `None` where the length is zero or not finite.
    ///
    /// In fixed point each component is within 2 units of 2^-30 of the exact quotient, and the length within one unit of the
    /// last place of the exact one, or 2^-29 of it where that is more.
    fn direction3(v: [Self; 3]) -> Option<([Self::Unit; 3], Self)>;

    /// `self d` for a component of a direction.
    #[must_use]
    fn times_unit(self, d: Self::Unit) -> Self;

    /// `self / 2^places`, for `places` up to 30; in fixed point rounded, ties away from zero.
    #[must_use]
    fn lowered_by(self, places: u32) -> Self;

    /// `self n`.
    #[must_use]
    fn times_integer(self, n: i32) -> Self;

    /// The largest integer that is not above the number, within +-2^30.
    fn integer_below(self) -> i32;

    /// `part / whole`, for `0 <= part <= whole` and `whole > 0`.
    fn fraction(part: Self, whole: Self) -> Self::Unit;

    /// `a b`, to compare with others.
    fn wide_product(a: Self, b: Self) -> Self::Wide;

    /// `a0 b0 + a1 b1 + a2 b2`, to compare with others: squares of lengths, beyond what the format itself could hold.
    fn wide_dot3(a: [Self; 3], b: [Self; 3]) -> Self::Wide;

    /// `a d - b c`, to compare with others: areas.
    fn wide_det2(a: Self, b: Self, c: Self, d: Self) -> Self::Wide;

    /// `v0 d0 + v1 d1 + v2 d2`, exact before it is rounded to [`Scaled`](Self::Scaled).
    /// `d` is of length at most two.
    fn scaled_dot3(v: [Self; 3], d: [Self::Unit; 3]) -> Self::Scaled;

    /// Whether `v0 d0 + v1 d1 + v2 d2` is below zero: the sign of [`scaled_dot3`](Self::scaled_dot3).
    fn is_against(v: [Self; 3], d: [Self::Unit; 3]) -> bool;

    /// `-d` for a unit vector.
    fn opposite(d: &Vec3<Self::Unit>) -> Vec3<Self::Unit>;

    /// What an impulse along the unit direction `d` does at the end of the arm `r`: c = r x d and u = I^-1 c for the body's tensor
    /// I^-1; and w . c for its angular velocity w.
    fn lever(body: &Body<Self>, r: &Vec3<Self>, d: &Vec3<Self::Unit>) -> Self::Lever;

    /// The speed at which two points part: `v . d + w . c`, added up for both bodies, each with its own direction away from
    /// the other.
    fn parting_speed(v: [&Vec3<Self>; 2], d: [&Vec3<Self::Unit>; 2], levers: [&Self::Lever; 2]) -> Self::Scaled;

    /// [`rebound`](Self::rebound) at once for points that approach each other; for others, or where that
    /// [is no impulse](Scaled::is_positive), the speed and the denominator of (10).
    ///
    /// # Errors
    /// The speed at which the points part, and the denominator of (10).
    fn approach_impulse(
        restitution: Self,
        v: [&Vec3<Self>; 2],
        d: [&Vec3<Self::Unit>; 2],
        inv_masses: [Self::Scaled; 2],
        levers: [&Self::Lever; 2],
    ) -> Result<Self::Scaled, (Self::Scaled, Self::Scaled)>;

    /// The denominator of (10): `1/m + c . u`, added up for both bodies.
    fn inverse_mass(inv_masses: [Self::Scaled; 2], levers: [&Self::Lever; 2]) -> Self::Scaled;

    /// `-(1 + e) speed / k` for `e` in 0 to 1 and `k >= 0`. For `k = 0`: not finite, in fixed point zero.
    fn rebound(restitution: Self, speed: Self::Scaled, k: Self::Scaled) -> Self::Scaled;

    /// `v + j m d` and `w + j u` for the body's inverse mass m and a lever's u, rounded once a component, and whether a component
    /// met the end of the range. `d` is within +-1.
    fn push(body: &mut Body<Self>, d: &Vec3<Self::Unit>, lever: &Self::Lever, j: Self::Scaled) -> bool;

    /// [`resolve_collision`](crate::impulse::resolve_collision), by a core's own instructions where there are such.
    #[inline(always)]
    fn strike(a: &mut Body<Self>, b: &mut Body<Self>, contact: &Contact<Self>, restitution: Self) -> Impact<Self> {
        impulse::strike(a, b, contact, restitution)
    }

    /// What impulses in any direction do at the end of the arm `r`: W = I^-1 (r x .), for a tensor I^-1 with the power of two
    /// of its block.
    fn arm(r: &Vec3<Self>, inv_inertia: &SymMat3<Self::Unit>, exponent: Self::Exponent) -> Self::Arm;

    /// The velocity of the second body's point relative to the first's: `v + w x r` of the second less that of the first.
    fn contact_velocity(v: [&Vec3<Self>; 2], w: [&Vec3<Self>; 2], r: [&Vec3<Self>; 2]) -> Block<Self>;

    /// K of a contact in the world's frame: 1/m + (r x .)^T W, added up for both bodies.
    fn contact_inverse_mass(inv_masses: [Self::Scaled; 2], arms: [&Self::Arm; 2]) -> SymBlock<Self>;

    /// The impulse with friction in the number type's own arithmetic, and whether the points stick: for approaching points, the
    /// unit `normal`, and the coefficients of restitution and friction. `None` where [`Scaled`](Self::Scaled) has to be used: in
    /// floating point always, in fixed point where the contact is not well conditioned.
    fn contact_impulse(
        inverse_mass: &SymBlock<Self>,
        velocity: &Block<Self>,
        normal: &Vec3<Self::Unit>,
        surface: [Self; 2],
    ) -> Option<(BlockImpulse<Self>, bool)>;

    /// The number `mantissa * 2^exponent`, rounded to the format, and whether the end of the range was met.
    fn from_block(mantissa: Self::Unit, exponent: Self::Exponent) -> (Self, bool);

    /// `v + m j` and `w + I^-1 (r x j)`, which is W j, for the body's inverse mass m: rounded once a component, and whether a
    /// component met the end of the range.
    fn kick(body: &mut Body<Self>, r: &Vec3<Self>, arm: &Self::Arm, j: &Block<Self>) -> bool;

    /// The same number as a [`Scaled`](Self::Scaled), rounded to its 30 bits.
    fn to_scaled(self) -> Self::Scaled;

    /// The nearest number of the format, and whether the end of the range was met.
    fn from_scaled(x: Self::Scaled) -> (Self, bool);

    /// `self + velocity * h`, with what the format cannot hold carried in `remainder`, so that the slowest motion
    /// arrives in the end: 1 mm/s over 1/240 s is a quarter of a unit of Q16.16, and would never leave without it.
    /// Also whether the end of the range was met.
    fn advance(self, velocity: Self, h: Self::SubStep, remainder: &mut Self::Remainder) -> (Self, bool);
}

/// A bound on the turns of the search for the direction in which points slide, in
/// [`resolve_collision_with_friction`](crate::impulse::resolve_collision_with_friction).
///
/// Newton's method takes 3 to 6 of them, more where friction nearly holds; where it leaves the bracket, bisection takes its
/// place. What the last turn leaves
/// unresolved turns the friction by its share; the cone and Newton's law of restitution hold all the same, but where friction
/// presses the bodies together so hard that the normal impulse is taken from the tangential rows: there v_n' has its share, too.
pub const MAX_SLIP_ITERATIONS: usize = 24;

/// Intermediate results of the kernel: a small floating-point arithmetic of its own in fixed point
/// (`Scaled32`), the float itself otherwise. Operators round to the nearest and never panic.
pub trait Scaled:
    Copy
    + Default
    + Debug
    + PartialEq
    + PartialOrd
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Mantissas of a block.
    type Unit: Copy;
    /// The power of two of a block.
    type Exponent: Copy;

    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// The ratio of a circle's circumference to its diameter.
    const PI: Self;
    /// The spacing of numbers just above one.
    const EPSILON: Self;

    /// `mantissa * 2^exponent`, rounded: any value, whatever the format of the scalar.
    fn from_parts(mantissa: i32, exponent: i32) -> Self;

    /// Neither an infinity nor a NaN; in fixed point: not the quotient by zero.
    fn is_finite(self) -> bool;

    /// Above zero and finite.
    fn is_positive(self) -> bool;

    /// The square root; of a negative number NaN, in fixed point zero.
    #[must_use]
    fn sqrt(self) -> Self;

    /// `self * 2^exponent` for the exponent of a block.
    #[must_use]
    fn raised(self, exponent: Self::Exponent) -> Self;

    /// The mantissa in a block with that exponent, rounded.
    #[must_use]
    fn lowered(self, exponent: Self::Exponent) -> Self::Unit;

    /// The largest integer that is not above the number, within +-2^30.
    fn integer_below(self) -> i32;

    /// Three numbers as a block with components within +-1/2 (in floating point: themselves).
    fn align3(v: [Self; 3]) -> ([Self::Unit; 3], Self::Exponent);

    /// `numerator / denominator` for small integers.
    #[must_use]
    fn ratio(numerator: i32, denominator: i32) -> Self {
        Self::from_parts(numerator, 0) / Self::from_parts(denominator, 0)
    }

    /// The larger of two.
    #[must_use]
    fn max(self, other: Self) -> Self {
        if self < other { other } else { self }
    }
}
