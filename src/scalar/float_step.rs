//! The arithmetic of a step in floating point: plain operations, each rounded once, in the order written.

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

/// Implements `StepArithmetic` for a float: `$half` is 1/2.
macro_rules! float_step {
    ($float:ty, sqrt: $sqrt:expr, zero: $zero:expr, one: $one:expr, half: $half:expr) => {
        use super::float_step::{FloatLevers, FloatStep};
        use super::step::{Column, StepArithmetic, Weights};

        impl StepArithmetic<$float> for FloatStep {
            type Places = ();
            type Rest = ();
            type Ratio = $float;
            type Levers = FloatLevers<$float>;

            const NO_PLACES: () = ();
            const MOST_PLACES: () = ();
            const NO_REST: () = ();
            const NO_RATIO: $float = $zero;
            const EVEN: [$float; 3] = [$one, $zero, $one];

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
            fn round_columns(
                [x, y]: &[Vec3<$float>; 2],
                [reach, turn]: [$float; 2],
                (): (),
                [first, second]: [&mut Column<$float>; 2],
            ) {
                (first.arm, first.turn) = (*y * reach, *y * turn);
                (second.arm, second.turn) = (*x * -reach, *x * -turn);
            }

            #[inline(always)]
            fn ratio(x: $float) -> $float {
                x
            }

            #[inline(always)]
            fn direction(d: &Vec3<$float>) -> Vec3<$float> {
                *d
            }

            #[inline(always)]
            fn lone_speed(d: &Vec3<$float>, v: &Vec3<$float>, w: &Vec3<$float>, column: &Column<$float>) -> $float {
                v.dot(*d) + w.dot(column.arm)
            }

            #[inline(always)]
            fn pair_speed(
                d: &Vec3<$float>,
                v: [&Vec3<$float>; 2],
                w: [&Vec3<$float>; 2],
                columns: [&Column<$float>; 2],
            ) -> $float {
                // The difference first: in a common drift, the speeds are large and their difference small.
                (*v[1] - *v[0]).dot(*d) + (w[0].dot(columns[0].arm) + w[1].dot(columns[1].arm))
            }

            #[inline(always)]
            fn push(
                v: &mut Vec3<$float>,
                w: &mut Vec3<$float>,
                d: &Vec3<$float>,
                column: &Column<$float>,
                impulse: $float,
            ) {
                *v += *d * (column.share * impulse);
                *w += column.turn * impulse;
            }

            #[inline(always)]
            fn pull(
                v: &mut Vec3<$float>,
                w: &mut Vec3<$float>,
                d: &Vec3<$float>,
                column: &Column<$float>,
                impulse: $float,
            ) {
                *v -= *d * (column.share * impulse);
                *w += column.turn * impulse;
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
            fn thrust(v: &mut Vec3<$float>, d: &Vec3<$float>, share: $float, impulse: $float) {
                *v += *d * (share * impulse);
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
