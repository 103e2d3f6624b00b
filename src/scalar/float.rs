//! What all floating-point types share: plain operations, each rounded once, in the order written.

/// Implements `Scalar` and `Scaled` for a float: `$sqrt` is its square root, `$int` makes one of an `i32`, `$bits` gives
/// the stored bits, `$power` is two to an exponent that is in the normal range.
macro_rules! float_scalar {
    ($float:ty, sqrt: $sqrt:expr, int: $int:expr, bits: $bits:expr, power: $power:expr, max_exponent: $max_exponent:expr,
     zero: $zero:expr, one: $one:expr, pi: $pi:expr, epsilon: $epsilon:expr, small: $small:expr, finite: $finite:expr) => {
        impl $crate::scalar::Scalar for $float {
            type Unit = Self;
            type Scaled = Self;
            type Exponent = ();
            type SubStep = Self;
            type Remainder = Self;

            const ZERO: Self = $zero;
            const ONE: Self = $one;
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
                // Only where the squares could leave the range is the vector scaled by a power of two first.
                let largest = v.iter().fold($zero, |m: Self, &x| {
                    let x = if x < $zero { -x } else { x };
                    if m < x { x } else { m }
                });
                let tiny: Self = $small;
                let scale = if largest < tiny * tiny {
                    $one / (tiny * tiny)
                } else if largest < tiny {
                    $one / tiny
                } else if largest > $one / tiny {
                    tiny * tiny
                } else {
                    $one
                };
                let v = [v[0] * scale, v[1] * scale, v[2] * scale];
                let length = <Self as $crate::scalar::Scalar>::length3(v);
                if length > $zero && $finite(length) {
                    Some([v[0] / length, v[1] / length, v[2] / length])
                } else {
                    None
                }
            }

            #[inline(always)]
            fn align3(v: [Self; 3]) -> ([Self; 3], ()) {
                (v, ())
            }

            #[inline(always)]
            fn scaled_dot3(v: [Self; 3], d: [Self; 3]) -> Self {
                v[0] * d[0] + v[1] * d[1] + v[2] * d[2]
            }

            #[inline(always)]
            fn relative_dot3(a: [Self; 3], b: [Self; 3], d: [Self; 3]) -> Self {
                (b[0] - a[0]) * d[0] + (b[1] - a[1]) * d[1] + (b[2] - a[2]) * d[2]
            }

            #[inline(always)]
            fn add_scaled3(x: [Self; 3], d: [Self; 3], k: Self) -> ([Self; 3], bool) {
                ([x[0] + d[0] * k, x[1] + d[1] * k, x[2] + d[2] * k], false)
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
            fn raised(self, (): ()) -> Self {
                self
            }

            #[inline(always)]
            fn align3(v: [Self; 3]) -> ([Self; 3], ()) {
                (v, ())
            }
        }
    };
}

pub(super) use float_scalar;
