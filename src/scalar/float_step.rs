//! The arithmetic of a step in floating point: plain operations, each rounded once, in the order written.

// Of `f32` the FPU does what is there itself.
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf", not(any(feature = "f64", feature = "micromath")))))]
pub(super) mod rows;

use crate::math::Vec3;

/// The arithmetic of a step for a float.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatStep;

/// r x d and I^-1 (r x d) for three directions.
#[derive(Clone, Copy, Debug)]
pub struct FloatLevers<T> {
    pub(super) arms: [Vec3<T>; 3],
    pub(super) turns: [Vec3<T>; 3],
}

/// How far a contact is along the normal, rho, and rho/I.
#[derive(Clone, Copy, Debug)]
pub struct FloatBall<T> {
    pub(super) reach: T,
    pub(super) turn: T,
}

/// Implements `StepArithmetic` for a float: `$half` is 1/2.
macro_rules! float_step {
    ($float:ty, rows: $rows:ident, sqrt: $sqrt:expr, zero: $zero:expr, one: $one:expr, half: $half:expr) => {
        use super::float_step::{FloatBall, FloatLevers, FloatStep};
        use super::step::{Column, StepArithmetic, Velocity, Weights};

        impl StepArithmetic<$float> for FloatStep {
            type Places = ();
            type Rest = ();
            type Ratio = $float;
            type Levers = FloatLevers<$float>;
            type Ball = FloatBall<$float>;

            const NO_PLACES: () = ();
            const MOST_PLACES: () = ();
            const NO_REST: () = ();
            const NO_RATIO: $float = $zero;

            #[inline(always)]
            fn size(_: $float, (): ()) {}

            #[inline(always)]
            fn more((): (), (): ()) {}

            #[inline(always)]
            fn fit((): (), _: &Vec3<$float>, (): (), _: u32) {}

            #[inline(always)]
            fn lift(x: $float, (): (), (): ()) -> $float {
                x
            }

            #[inline(always)]
            fn lower(x: $float, (): ()) -> ($float, (), bool) {
                (x, (), false)
            }

            #[inline(always)]
            fn changed(x: $float, (): (), change: $float) -> ($float, (), bool) {
                (x + change, (), false)
            }

            #[inline(always)]
            fn gain(acceleration: $float, h: $float, (): ()) -> $float {
                acceleration * h
            }

            #[inline(always)]
            fn gap(separation: $float, inv_h: $float, (): ()) -> $float {
                separation * inv_h
            }

            #[inline(always)]
            fn travel(x: $float, moved: $float, h: $float, (): (), remainder: &mut $float) -> ($float, bool) {
                <$float as $crate::scalar::Scalar>::advance(x, moved, h, remainder)
            }

            #[inline(always)]
            fn half_angle(turned: $float, h: $float, (): ()) -> $float {
                turned * (h * $half)
            }

            #[inline(always)]
            fn levers(r: &Vec3<$float>, d: [&Vec3<$float>; 3], inv_inertia: &SymMat3<$float>, (): ()) -> Self::Levers {
                let arms = [r.cross(*d[0]), r.cross(*d[1]), r.cross(*d[2])];
                let turns = [inv_inertia.times(arms[0]), inv_inertia.times(arms[1]), inv_inertia.times(arms[2])];
                FloatLevers { arms, turns }
            }

            #[inline(always)]
            fn weights(sides: [Option<(&Self::Levers, $float)>; 2], friction: $float) -> Weights<$float> {
                let mut k = [$zero; 4];
                for (FloatLevers { arms: [n, x, y], turns: [turn_n, turn_x, turn_y] }, inv_mass) in
                    sides.into_iter().flatten()
                {
                    k[0] += (inv_mass + n.dot(*turn_n));
                    k[1] += (inv_mass + x.dot(*turn_x));
                    k[2] += x.dot(*turn_y);
                    k[3] += (inv_mass + y.dot(*turn_y));
                }
                let [normal, xx, xy, yy] = k;
                let larger = if xx < yy { yy } else { xx };
                let tangent = larger + if xy < $zero { -xy } else { xy };
                let determinant = xx * yy - xy * xy;
                let least = tangent * tangent * <$float as $crate::scalar::Scaled>::EPSILON;
                // Without a second direction in which anything gives way, each is taken alone.
                let block = if determinant > least {
                    let factor = tangent / determinant;
                    [yy * factor, -(xy * factor), xx * factor]
                } else {
                    [$half + $half, $zero, $half + $half]
                };
                let one = $half + $half;
                let inv_normal = one / normal;
                Weights { inv_normal, inv_tangent: one / tangent, block, friction: friction * tangent * inv_normal }
            }

            #[inline(always)]
            fn columns(
                levers: &Self::Levers,
                inv_mass: $float,
                weights: &Weights<$float>,
                (): (),
                _: bool,
                [normal, first, second]: [&mut Column<$float>; 3],
            ) {
                let column = |arm: Vec3<$float>, turn: Vec3<$float>, inv_k: $float| Column::<$float> {
                    arm,
                    turn: turn * inv_k,
                    share: inv_mass * inv_k,
                };
                let ([n, x, y], [turn_n, turn_x, turn_y]) = (levers.arms, levers.turns);
                *normal = column(n, turn_n, weights.inv_normal);
                *first = column(x, turn_x, weights.inv_tangent);
                *second = column(y, turn_y, weights.inv_tangent);
            }

            #[inline(always)]
            fn is_along(r: &Vec3<$float>, d: &Vec3<$float>) -> bool {
                let arm = r.cross(*d);
                let part = <$float as $crate::scalar::Scaled>::EPSILON;
                arm.dot(arm) <= r.dot(*r) * (part * part)
            }

            #[inline(always)]
            fn ball(r: &Vec3<$float>, d: &Vec3<$float>, inv_inertia: $float, (): ()) -> Self::Ball {
                let reach = r.dot(*d);
                FloatBall { reach, turn: reach * inv_inertia }
            }

            #[inline(always)]
            fn ball_weights(sides: [Option<(&Self::Ball, $float)>; 2], friction: $float) -> Weights<$float> {
                let (mut normal, mut tangent) = ($zero, $zero);
                for (&FloatBall { reach, turn }, inv_mass) in sides.into_iter().flatten() {
                    normal += inv_mass;
                    tangent += inv_mass + reach * turn;
                }
                let (inv_normal, inv_tangent) = ($one / normal, $one / tangent);
                let block = [$one, $zero, $one];
                Weights { inv_normal, inv_tangent, block, friction: friction * tangent * inv_normal }
            }

            #[inline(always)]
            fn ball_columns(
                ball: &Self::Ball,
                inv_mass: $float,
                weights: &Weights<$float>,
                (): (),
                [x, y]: &[Vec3<$float>; 2],
                [normal, first, second]: [&mut Column<$float>; 3],
            ) {
                let (reach, turn, share) =
                    (ball.reach, ball.turn * weights.inv_tangent, inv_mass * weights.inv_tangent);
                normal.share = inv_mass * weights.inv_normal;
                *first = Column { arm: *y * reach, turn: *y * turn, share };
                *second = Column { arm: *x * -reach, turn: *x * -turn, share };
            }

            #[inline(always)]
            fn direction(d: &Vec3<$float>) -> Vec3<$float> {
                *d
            }

            #[inline(always)]
            fn lone_speed(d: &Vec3<$float>, body: &Velocity<$float>, column: &Column<$float>) -> $float {
                $rows::lone_speed(d, body, column)
            }

            #[inline(always)]
            fn pair_speed(d: &Vec3<$float>, bodies: [&Velocity<$float>; 2], columns: &[Column<$float>; 2]) -> $float {
                $rows::pair_speed(d, bodies, columns)
            }

            #[inline(always)]
            fn push(body: &mut Velocity<$float>, d: &Vec3<$float>, column: &Column<$float>, impulse: $float) {
                $rows::push(body, d, column, impulse)
            }

            #[inline(always)]
            fn push_pair(
                bodies: [&mut Velocity<$float>; 2],
                d: &Vec3<$float>,
                columns: &[Column<$float>; 2],
                impulse: $float,
            ) {
                $rows::push_pair(bodies, d, columns, impulse)
            }

            #[inline]
            fn turned([w, x, y, z]: [$float; 4], u: Vec3<$float>) -> [$float; 4] {
                // tan a = a + a^3/3 + ...
                let third: $float = <$float as $crate::scalar::Scaled>::ratio(1, 3);
                let u = u + u * (u.dot(u) * third);
                let turned = [
                    w - (u.x * x + u.y * y + u.z * z),
                    x + (u.x * w + (u.y * z - u.z * y)),
                    y + (u.y * w + (u.z * x - u.x * z)),
                    z + (u.z * w + (u.x * y - u.y * x)),
                ];
                let [a, b, c, d] = turned;
                let length = $sqrt((a * a + b * b) + (c * c + d * d));
                [a / length, b / length, c / length, d / length]
            }

            #[inline(always)]
            fn central_speed(d: &Vec3<$float>, v: [&Vec3<$float>; 2]) -> $float {
                $rows::central_speed(d, v)
            }

            #[inline(always)]
            fn thrust(v: &mut Vec3<$float>, d: &Vec3<$float>, share: $float, impulse: $float) {
                $rows::thrust(v, d, share, impulse)
            }

            #[inline(always)]
            fn is_central(levers: &Self::Levers, r: &Vec3<$float>) -> bool {
                let [arm, ..] = &levers.arms;
                let part = <$float as $crate::scalar::Scaled>::EPSILON;
                arm.dot(*arm) <= r.dot(*r) * (part * part)
            }

            #[inline]
            fn bearing(r: &Vec3<$float>) -> [i8; 3] {
                let Vec3 { x, y, z } = r.magnitudes();
                let larger = if x < y { y } else { x };
                let largest = if larger < z { z } else { larger };
                let unit = <$float as $crate::scalar::Scaled>::ratio(63, 1) / largest;
                let part = |x: $float| <$float as $crate::scalar::Scalar>::integer_below(x * unit) as i8;
                if largest > $zero { [part(r.x), part(r.y), part(r.z)] } else { [0; 3] }
            }

            #[inline(always)]
            fn along(v: &Vec3<$float>, d: &Vec3<$float>) -> $float {
                v.dot(*d)
            }

            #[inline(always)]
            fn impulse(x: $float, (): (), share: $float, inv_mass: $float) -> $float {
                if inv_mass > $zero { x * (share / inv_mass) } else { $zero }
            }

            #[inline(always)]
            fn moved(x: $float, (): (), (): ()) -> $float {
                x
            }

            #[inline(always)]
            fn half(x: $float) -> $float {
                x * $half
            }

            #[inline(always)]
            fn times(x: $float, factor: $float) -> $float {
                x * factor
            }

            #[inline(always)]
            fn by_ratio(x: $float, factor: $float) -> $float {
                x * factor
            }

            #[inline(always)]
            fn by_block(v: [$float; 2], [xx, xy, yy]: [$float; 3]) -> [$float; 2] {
                [xx * v[0] + xy * v[1], xy * v[0] + yy * v[1]]
            }

            #[inline(always)]
            fn is_within(v: [$float; 2], length: $float) -> bool {
                v[0] * v[0] + v[1] * v[1] <= length * length
            }

            #[inline(always)]
            fn shortened(v: [$float; 2], length: $float) -> [$float; 2] {
                let factor = length / $sqrt(v[0] * v[0] + v[1] * v[1]);
                [v[0] * factor, v[1] * factor]
            }

            #[inline(always)]
            fn speed_after(speed: $float, change: $float, fall: $float) -> $float {
                let square = speed * speed + (change + change) * fall;
                if square > $zero { $sqrt(square) } else { $zero }
            }
        }
    };
}

pub(super) use float_step;
