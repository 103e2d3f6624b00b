//! The arithmetic of a step in floating point: plain operations, each rounded once, in the order written.

use crate::math::Vec3;

/// The arithmetic of a step for a float.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatStep;

/// r x d and I^-1 (r x d).
#[derive(Clone, Copy, Debug)]
pub struct StepLever<T> {
    pub(super) arm: Vec3<T>,
    pub(super) turn: Vec3<T>,
}

/// Implements `StepArithmetic` for a float: `$half` is 1/2.
macro_rules! float_step {
    ($float:ty, sqrt: $sqrt:expr, zero: $zero:expr, half: $half:expr) => {
        use super::float_step::{FloatStep, StepLever};
        use super::step::{Column, StepArithmetic};

        impl StepArithmetic<$float> for FloatStep {
            type Places = ();
            type Rest = ();
            type Ratio = $float;
            type Lever = StepLever<$float>;

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
            fn lever(r: &Vec3<$float>, d: &Vec3<$float>, inv_inertia: &SymMat3<$float>, (): ()) -> Self::Lever {
                let arm = r.cross(*d);
                StepLever { arm, turn: inv_inertia.times(arm) }
            }

            #[inline(always)]
            fn coupling(d: &Self::Lever, other: &Self::Lever) -> $float {
                d.arm.dot(other.turn)
            }

            #[inline(always)]
            fn column(lever: &Self::Lever, inv_mass: $float, inv_k: $float, (): ()) -> Column<$float> {
                Column { arm: lever.arm, turn: lever.turn * inv_k, share: inv_mass * inv_k }
            }

            #[inline(always)]
            fn opposite_column(lever: &Self::Lever, inv_mass: $float, inv_k: $float, (): ()) -> Column<$float> {
                let column: Column<$float> = Self::column(lever, inv_mass, inv_k, ());
                Column { arm: -column.arm, turn: -column.turn, share: -column.share }
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
            fn ratio(x: $float) -> $float {
                x
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
