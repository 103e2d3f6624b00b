//! What all floating-point types share: plain operations, each rounded once, in the order written.

use crate::math::Vec3;

/// A lever in floating point: of c = r x d and u = I^-1 c, what the kernel needs.
#[derive(Clone, Copy, Debug)]
pub struct FloatLever<T> {
    /// u
    pub(super) turn: Vec3<T>,
    /// c . u
    pub(super) inverse_mass: T,
    /// w . c
    pub(super) spin: T,
}

/// An arm in floating point: r, and the rows of W = I^-1 (r x .).
#[derive(Clone, Copy, Debug)]
pub struct FloatArm<T> {
    pub(super) r: Vec3<T>,
    pub(super) turn: [Vec3<T>; 3],
}

/// Implements `Scalar` and `Scaled` for a float: `$sqrt` is its square root, `$int` makes one of an `i32`, `$cut` the other way,
/// `$bits` gives the stored bits, `$power` is two to an exponent that is in the normal range.
macro_rules! float_scalar {
    ($float:ty, rows: $rows:ident, sqrt: $sqrt:expr, int: $int:expr, cut: $cut:expr, bits: $bits:expr, power: $power:expr, max_exponent: $max_exponent:expr,
     zero: $zero:expr, one: $one:expr, largest: $largest:expr, pi: $pi:expr, epsilon: $epsilon:expr, small: $small:expr,
     finite: $finite:expr) => {
        use super::float::{FloatArm, FloatLever};
        $crate::scalar::float_step::float_step!($float, rows: $rows, sqrt: $sqrt, zero: $zero, one: $one, half: $one / ($one + $one));
        use $crate::math::{Block, BlockImpulse, SymBlock, SymMat3, Vec3};

        /// One, or the power of two that brings a vector with squares beyond the range into it.
        #[inline]
        fn moderate(v: [$float; 3]) -> $float {
            let largest = v.iter().fold($zero, |m: $float, &x| {
                let x = if x < $zero { -x } else { x };
                if m < x { x } else { m }
            });
            let tiny: $float = $small;
            if largest < tiny * tiny {
                $one / (tiny * tiny)
            } else if largest < tiny {
                $one / tiny
            } else if largest > $one / tiny {
                tiny * tiny
            } else {
                $one
            }
        }

        impl FloatArm<$float> {
            /// (r x .)^T I^-1 (r x .)
            #[inline(always)]
            fn inverse_mass(&self) -> SymMat3<$float> {
                let Vec3 { x, y, z } = self.r;
                let [wx, wy, wz] = self.turn;
                SymMat3 {
                    xx: wy.x * z - wz.x * y,
                    xy: wy.y * z - wz.y * y,
                    xz: wy.z * z - wz.z * y,
                    yy: wz.y * x - wx.y * z,
                    yz: wz.z * x - wx.z * z,
                    zz: wx.z * y - wy.z * x,
                }
            }
        }

        impl $crate::scalar::Scalar for $float {
            type Unit = Self;
            type Scaled = Self;
            type Exponent = ();
            type Wide = Self;
            type Lever = FloatLever<Self>;
            type Arm = FloatArm<Self>;
            type SubStep = Self;
            type Remainder = Self;
            type Step = FloatStep;

            const ZERO: Self = $zero;
            const NO_REMAINDER: Self = $zero;
            const ONE: Self = $one;
            const LARGEST: Self = $largest;
            const STEP: Self = $zero;
            const SYMMETRIC: bool = true;
            const NO_EXPONENT: () = ();

            #[inline]
            fn from_ratio(numerator: i32, denominator: i32) -> Result<Self, $crate::error::RangeError> {
                if denominator == 0 {
                    return Err($crate::error::RangeError);
                }
                Ok($int(numerator) / $int(denominator))
            }

            #[inline]
            fn sub_step(numerator: i32, denominator: i32) -> Result<Self, $crate::error::RangeError> {
                let h = <Self as $crate::scalar::Scalar>::from_ratio(numerator, denominator)?;
                if ($zero..$one).contains(&h) { Ok(h) } else { Err($crate::error::RangeError) }
            }

            #[inline(always)]
            fn is_finite(self) -> bool {
                $finite(self)
            }

            #[inline(always)]
            fn bits(self) -> u64 {
                $bits(self)
            }

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self + other
            }

            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self - other
            }

            #[inline(always)]
            fn times(self, other: Self) -> Self {
                self * other
            }

            #[inline(always)]
            fn over(self, other: Self) -> Self {
                self / other
            }

            #[inline(always)]
            fn negated(self) -> Self {
                -self
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            #[inline(always)]
            fn dot3(a: [Self; 3], b: [Self; 3]) -> Self {
                a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
            }

            #[inline(always)]
            fn det2(a: Self, b: Self, c: Self, d: Self) -> Self {
                a * d - b * c
            }

            #[inline(always)]
            fn dot3_unit(v: [Self; 3], d: [Self; 3]) -> Self {
                v[0] * d[0] + v[1] * d[1] + v[2] * d[2]
            }

            #[inline(always)]
            fn length3(v: [Self; 3]) -> Self {
                $sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
            }

            #[inline]
            fn normalize3(v: [Self; 3]) -> Option<[Self; 3]> {
                Self::direction3(v).map(|(direction, _)| direction)
            }

            #[inline]
            fn direction3(v: [Self; 3]) -> Option<([Self; 3], Self)> {
                // Only where the squares could leave the range is the vector scaled by a power of two first.
                let scale = moderate(v);
                let v = [v[0] * scale, v[1] * scale, v[2] * scale];
                let length = <Self as $crate::scalar::Scalar>::length3(v);
                if length > $zero && $finite(length) {
                    let back = if scale == $one { length } else { length / scale };
                    Some(([v[0] / length, v[1] / length, v[2] / length], back))
                } else {
                    None
                }
            }

            #[inline(always)]
            fn times_unit(self, d: Self) -> Self {
                self * d
            }

            #[inline(always)]
            fn lowered_by(self, places: u32) -> Self {
                self * $power((places as i32).wrapping_neg())
            }

            #[inline(always)]
            fn times_integer(self, n: i32) -> Self {
                self * $int(n)
            }

            #[inline]
            fn integer_below(self) -> i32 {
                const END: i32 = 1 << 30;
                // A NaN becomes zero below.
                if self < $int(-END) {
                    return -END;
                }
                if self >= $int(END) {
                    return END;
                }
                let cut = $cut(self);
                if $int(cut) > self { cut.wrapping_sub(1) } else { cut }
            }

            #[inline(always)]
            fn fraction(part: Self, whole: Self) -> Self {
                part / whole
            }

            #[inline(always)]
            fn wide_product(a: Self, b: Self) -> Self {
                a * b
            }

            #[inline(always)]
            fn wide_dot3(a: [Self; 3], b: [Self; 3]) -> Self {
                a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
            }

            #[inline(always)]
            fn wide_det2(a: Self, b: Self, c: Self, d: Self) -> Self {
                a * d - b * c
            }

            #[inline(always)]
            fn scaled_dot3(v: [Self; 3], d: [Self; 3]) -> Self {
                v[0] * d[0] + v[1] * d[1] + v[2] * d[2]
            }

            #[inline(always)]
            fn is_against(v: [Self; 3], d: [Self; 3]) -> bool {
                Self::scaled_dot3(v, d) < $zero
            }

            #[inline(always)]
            fn opposite(d: &Vec3<Self>) -> Vec3<Self> {
                -*d
            }

            #[inline(always)]
            fn lever(body: &$crate::body::Body<Self>, r: &Vec3<Self>, d: &Vec3<Self>) -> Self::Lever {
                let cross = r.cross(*d);
                let turn = body.inv_inertia_world.times(cross);
                FloatLever { turn, inverse_mass: cross.dot(turn), spin: body.angular_velocity.dot(cross) }
            }

            #[inline(always)]
            fn parting_speed(v: [&Vec3<Self>; 2], d: [&Vec3<Self>; 2], levers: [&Self::Lever; 2]) -> Self {
                // The difference first: in a common drift, the speeds along the direction are large and their difference small.
                (*v[1] - *v[0]).dot(*d[1]) + (levers[0].spin + levers[1].spin)
            }

            #[inline(always)]
            fn approach_impulse(
                restitution: Self,
                v: [&Vec3<Self>; 2],
                d: [&Vec3<Self>; 2],
                inv_masses: [Self; 2],
                levers: [&Self::Lever; 2],
            ) -> Result<Self, (Self, Self)> {
                let (speed, k) = (Self::parting_speed(v, d, levers), Self::inverse_mass(inv_masses, levers));
                let j = Self::rebound(restitution, speed, k);
                if crate::scalar::Scaled::is_positive(j) { Ok(j) } else { Err((speed, k)) }
            }

            #[inline(always)]
            fn inverse_mass(inv_masses: [Self; 2], levers: [&Self::Lever; 2]) -> Self {
                (inv_masses[0] + inv_masses[1]) + (levers[0].inverse_mass + levers[1].inverse_mass)
            }

            #[inline(always)]
            fn rebound(restitution: Self, speed: Self, k: Self) -> Self {
                -(($one + restitution) * speed) / k
            }

            #[inline(always)]
            fn push(body: &mut $crate::body::Body<Self>, d: &Vec3<Self>, lever: &Self::Lever, j: Self) -> bool {
                body.linear_velocity += *d * (body.inv_mass * j);
                body.angular_velocity += lever.turn * j;
                false
            }

            #[inline(always)]
            fn arm(r: &Vec3<Self>, inv_inertia: &SymMat3<Self>, (): ()) -> Self::Arm {
                let [x, y, z] = inv_inertia.columns();
                FloatArm { r: *r, turn: [x.cross(*r), y.cross(*r), z.cross(*r)] }
            }

            #[inline(always)]
            fn contact_velocity(v: [&Vec3<Self>; 2], w: [&Vec3<Self>; 2], r: [&Vec3<Self>; 2]) -> Block<Self> {
                let turned = w[1].cross(*r[1]) - w[0].cross(*r[0]);
                Block { mantissas: (*v[1] - *v[0]) + turned, exponent: () }
            }

            #[inline(always)]
            fn contact_inverse_mass(inv_masses: [Self; 2], arms: [&Self::Arm; 2]) -> SymBlock<Self> {
                let m = inv_masses[0] + inv_masses[1];
                let (a, b) = (arms[0].inverse_mass(), arms[1].inverse_mass());
                let mantissas = SymMat3 {
                    xx: m + (a.xx + b.xx),
                    xy: a.xy + b.xy,
                    xz: a.xz + b.xz,
                    yy: m + (a.yy + b.yy),
                    yz: a.yz + b.yz,
                    zz: m + (a.zz + b.zz),
                };
                SymBlock { mantissas, exponent: () }
            }

            #[inline(always)]
            fn contact_impulse(
                _: &SymBlock<Self>,
                _: &Block<Self>,
                _: &Vec3<Self>,
                _: [Self; 2],
            ) -> Option<(BlockImpulse<Self>, bool)> {
                None
            }

            #[inline(always)]
            fn from_block(mantissa: Self, (): ()) -> (Self, bool) {
                (mantissa, false)
            }

            #[inline(always)]
            fn kick(
                body: &mut $crate::body::Body<Self>,
                r: &Vec3<Self>,
                _: &Self::Arm,
                j: &Block<Self>,
            ) -> bool {
                // Read once more, not kept: in between there are more numbers than registers.
                core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
                body.linear_velocity += j.mantissas * body.inv_mass;
                body.angular_velocity += body.inv_inertia_world.times(r.cross(j.mantissas));
                false
            }

            #[inline(always)]
            fn to_scaled(self) -> Self {
                self
            }

            #[inline(always)]
            fn from_scaled(x: Self) -> (Self, bool) {
                (x, false)
            }

            #[inline]
            fn advance(self, velocity: Self, h: Self, remainder: &mut Self) -> (Self, bool) {
                // Kahan: what the sum drops of the addend goes into the next one.
                let addend = velocity * h + *remainder;
                let moved = self + addend;
                *remainder = addend - (moved - self);
                (moved, false)
            }
        }

        impl $crate::scalar::Scaled for $float {
            type Unit = Self;
            type Exponent = ();

            const ZERO: Self = $zero;
            const ONE: Self = $one;
            const PI: Self = $pi;
            const EPSILON: Self = $epsilon;

            #[inline]
            fn from_parts(mantissa: i32, exponent: i32) -> Self {
                // Two steps reach every exponent at which the result is neither zero nor infinite.
                let first = exponent.clamp(-$max_exponent, $max_exponent);
                let second = exponent.wrapping_sub(first).clamp(-$max_exponent, $max_exponent);
                $int(mantissa) * $power(first) * $power(second)
            }

            #[inline(always)]
            fn is_finite(self) -> bool {
                $finite(self)
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            #[inline(always)]
            fn is_positive(self) -> bool {
                // From one unit of the last place to the largest number: the bits as an integer, less one.
                $bits(self).wrapping_sub(1) < $bits($one / $zero) - 1
            }

            #[inline(always)]
            fn raised(self, (): ()) -> Self {
                self
            }

            #[inline(always)]
            fn lowered(self, (): ()) -> Self {
                self
            }

            #[inline(always)]
            fn integer_below(self) -> i32 {
                <Self as $crate::scalar::Scalar>::integer_below(self)
            }

            #[inline(always)]
            fn align3(v: [Self; 3]) -> ([Self; 3], ()) {
                (v, ())
            }
        }
    };
}

pub(super) use float_scalar;
