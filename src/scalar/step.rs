//! The arithmetic of a step: what the solver computes with between reading the bodies and storing them.
//!
//! Everything in the solver's inner loops is a **speed**. A row (one direction of one contact point) keeps its impulse as
//! the speed that it changes at the point, lambda K; what that does to a body are prepared columns: a share (1/m)/K of it along
//! the direction, and a turn I^-1 (r x d)/K. So no product has more than 32 x 32 bits, each is rounded once, and units,
//! masses and sizes leave no trace in the numbers.

use core::fmt::Debug;

use super::Scalar;
use crate::math::{SymMat3, Vec3};

/// What a row does to one body, and what it sees of the body's spin, along the body's own direction away from the other.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Column<S: Scalar> {
    /// r x d: what of the spin is speed along the direction.
    pub arm: Vec3<S::Unit>,
    /// I^-1 (r x d)/K: the change of spin for an impulse of one.
    pub turn: Vec3<S::Unit>,
    /// (1/m)/K: the change of velocity along the direction for an impulse of one.
    pub share: S::Unit,
}

/// A linear and an angular velocity, in the units of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Velocity<S: Scalar> {
    /// Of the centre of mass.
    pub v: Vec3<S>,
    /// The spin.
    pub w: Vec3<S>,
}

impl<S: Scalar> Velocity<S> {
    /// At rest.
    pub const ZERO: Self = Self { v: Vec3::ZERO, w: Vec3::ZERO };

    /// The sum.
    #[inline(always)]
    pub fn plus(&self, other: &Self) -> Self {
        Self { v: self.v + other.v, w: self.w + other.w }
    }

    /// The difference.
    #[inline(always)]
    pub fn minus(&self, other: &Self) -> Self {
        Self { v: self.v - other.v, w: self.w - other.w }
    }
}

impl<S: Scalar> Column<S> {
    /// Of a body that does not take part.
    pub const NONE: Self = Self { arm: Vec3::ZERO, turn: Vec3::ZERO, share: <S::Unit as Scalar>::ZERO };
}

/// A contact point's inverse masses K along the normal and across it, as rows need them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights<S: Scalar> {
    /// 1/K along the normal.
    pub inv_normal: S::Scaled,
    /// 1/K across it: for the tangents' 2x2 matrix, the inverse of the larger diagonal element and the other's magnitude, which
    /// no direction exceeds.
    pub inv_tangent: S::Scaled,
    /// The inverse of the tangents' 2x2 matrix in units of that: xx, xy, yy.
    pub block: [<S::Step as StepArithmetic<S>>::Ratio; 3],
    /// The coefficient of friction for impulses in these units.
    pub friction: <S::Step as StepArithmetic<S>>::Ratio,
}

/// Speeds of a step are kept in `S` itself, in fixed point with as many more [`Places`](Self::Places) as the fastest body of
/// the step leaves room for; spins with as many as makes them speeds at the distance of the body's size.
pub trait StepArithmetic<S: Scalar>: Copy + Debug + PartialEq + Send + Sync + 'static {
    /// Binary places by which numbers are moved left.
    type Places: Copy + Default + Debug + PartialEq + Send + Sync + 'static;
    /// What the stored velocity lacks.
    type Rest: Copy + Default + Debug + PartialEq + Send + Sync + 'static;
    /// A factor that may be above two.
    type Ratio: Copy + Default + Debug + PartialEq + Send + Sync + 'static;
    /// r x d and I^-1 (r x d) of any magnitude, in three directions.
    type Levers: Copy + Debug + Send + Sync + 'static;
    /// How far a contact is along the normal, rho, and rho/I.
    type Ball: Copy + Debug + Send + Sync + 'static;

    /// None.
    const NO_PLACES: Self::Places;
    /// As many as there can be.
    const MOST_PLACES: Self::Places;
    /// Nothing.
    const NO_REST: Self::Rest;
    /// Zero.
    const NO_RATIO: Self::Ratio;

    /// The places of a body's spin beyond those of speeds: a size of the body from its mass and inertia.
    fn size(inv_mass: S::Scaled, exponent: S::Exponent) -> Self::Places;
    /// The sum.
    fn more(places: Self::Places, size: Self::Places) -> Self::Places;
    /// The fewer of `places` and those by which `v` can move left, `size` moved already, with `head` bits to spare.
    fn fit(places: Self::Places, v: &Vec3<S>, size: Self::Places, head: u32) -> Self::Places;

    /// A stored number with its rest in the step's units.
    fn lift(x: S, rest: Self::Rest, places: Self::Places) -> S;
    /// Back again, and whether the end of the range was met.
    fn lower(x: S, places: Self::Places) -> (S, Self::Rest, bool);
    /// A stored number with its rest after a change of any size: rounded once, to the last place of the rest; and whether the end
    /// of the range was met.
    fn changed(x: S, rest: Self::Rest, change: S::Scaled) -> (S, Self::Rest, bool);
    /// An acceleration over a sub-step.
    fn gain(acceleration: S, h: S::SubStep, places: Self::Places) -> S;
    /// A gap as the speed that closes it in a sub-step.
    fn gap(separation: S, inv_h: S::Scaled, places: Self::Places) -> S;
    /// A position after the sum of its speeds over sub-steps, with what the format cannot hold in `remainder`; and whether the
    /// end of the range was met.
    fn travel(x: S, moved: S, h: S::SubStep, places: Self::Places, remainder: &mut S::Remainder) -> (S, bool);
    /// Half the angle that a sum of spins over sub-steps turns by, at the end of the range beyond it.
    fn half_angle(turned: S, h: S::SubStep, places: Self::Places) -> S::Unit;

    /// r x d and I^-1 (r x d) for three directions.
    fn levers(
        r: &Vec3<S>,
        d: [&Vec3<S::Unit>; 3],
        inv_inertia: &SymMat3<S::Unit>,
        exponent: S::Exponent,
    ) -> Self::Levers;
    /// What the levers and inverse masses of the bodies, one or two, come to along a normal and two tangents.
    fn weights(sides: [Option<(&Self::Levers, S::Scaled)>; 2], friction: S) -> Weights<S>;
    /// Writes the columns of a body with that inverse mass and size, for the normal and the tangents; of the normal only the
    /// share where it is `central`.
    fn columns(
        levers: &Self::Levers,
        inv_mass: S::Scaled,
        weights: &Weights<S>,
        size: Self::Places,
        central: bool,
        columns: [&mut Column<S>; 3],
    );

    /// Whether `r` is along the direction: what is across it is no more than rounding makes of an arm along it.
    fn is_along(r: &Vec3<S>, d: &Vec3<S::Unit>) -> bool;
    /// The levers of a body whose inertia is the same about every axis, `inv_inertia 2^exponent`, at a contact along the direction.
    fn ball(r: &Vec3<S>, d: &Vec3<S::Unit>, inv_inertia: S::Unit, exponent: S::Exponent) -> Self::Ball;
    /// What [`weights`](Self::weights) gives, for balls.
    fn ball_weights(sides: [Option<(&Self::Ball, S::Scaled)>; 2], friction: S) -> Weights<S>;
    /// What [`columns`](Self::columns) writes where it is central, for a ball, and two tangents that form a right-handed frame with
    /// the normal.
    fn ball_columns(
        ball: &Self::Ball,
        inv_mass: S::Scaled,
        weights: &Weights<S>,
        size: Self::Places,
        tangents: &[Vec3<S::Unit>; 2],
        columns: [&mut Column<S>; 3],
    );

    /// A direction as rows have it.
    fn direction(d: &Vec3<S::Unit>) -> Vec3<S::Unit>;
    /// The speed of a body's point along the direction: v . d + w . arm.
    fn lone_speed(d: &Vec3<S::Unit>, body: &Velocity<S>, column: &Column<S>) -> S;
    /// The speed of the second body's point relative to the first's.
    fn pair_speed(d: &Vec3<S::Unit>, bodies: [&Velocity<S>; 2], columns: &[Column<S>; 2]) -> S;
    /// Adds an impulse along the direction.
    fn push(body: &mut Velocity<S>, d: &Vec3<S::Unit>, column: &Column<S>, impulse: S);
    /// Adds it to the second body, and to the first one along the opposite direction, to which its column belongs.
    fn push_pair(bodies: [&mut Velocity<S>; 2], d: &Vec3<S::Unit>, columns: &[Column<S>; 2], impulse: S);
    /// The orientation after a rotation about the world's axis along `u` by twice its length, in radians: to the fifth power
    /// of the angle, and of unit length again.
    fn turned(orientation: [S::Unit; 4], u: Vec3<S::Unit>) -> [S::Unit; 4];

    /// The speed of the second body's centre of mass relative to the first's.
    fn central_speed(d: &Vec3<S::Unit>, v: [&Vec3<S>; 2]) -> S;
    /// Adds an impulse through the centre of mass.
    fn thrust(v: &mut Vec3<S>, d: &Vec3<S::Unit>, share: S::Unit, impulse: S);
    /// Whether the lever along the normal is nothing but what rounding makes of an arm along it.
    fn is_central(levers: &Self::Levers, r: &Vec3<S>) -> bool;
    /// The direction of an arm, to about a degree: to recognise it.
    fn bearing(r: &Vec3<S>) -> [i8; 3];
    /// The component of a vector along a direction.
    fn along(v: &Vec3<S>, d: &Vec3<S::Unit>) -> S;
    /// An impulse in N s: of a row with that share of a body with that inverse mass.
    fn impulse(x: S, places: Self::Places, share: S::Unit, inv_mass: S::Scaled) -> S::Scaled;

    /// A number that was lifted by other places.
    fn moved(x: S, from: Self::Places, to: Self::Places) -> S;
    /// Half of it.
    fn half(x: S) -> S;
    /// A speed times a factor within two.
    fn times(x: S, factor: S::Unit) -> S;
    /// A speed times a factor.
    fn by_ratio(x: S, factor: Self::Ratio) -> S;
    /// A symmetric 2x2 matrix (xx, xy, yy) times a vector.
    fn by_block(v: [S; 2], block: [Self::Ratio; 3]) -> [S; 2];
    /// Whether the vector is no longer than `length >= 0`.
    fn is_within(v: [S; 2], length: S) -> bool;
    /// The vector, which is longer, cut to `length >= 0`.
    fn shortened(v: [S; 2], length: S) -> [S; 2];
    /// The root of `speed^2 + 2 change fall`; zero where that is negative.
    fn speed_after(speed: S, change: S, fall: S) -> S;
}
