//! `FixedI32<Frac>`: 32-bit fixed point with any number of fraction bits from 0 to 30.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U30, U31};

use super::Scalar;
use super::arm32::{self, Arm32};
use super::contact32::{Contact32, Impulse32};
use super::integer::{inverse_root, leading_zeros, long_quotient, round_shift, round_sqrt, wide_quotient};
use super::lever32::{self, Lever32};
use super::machine::{self, lever, round_product};
use super::product::{dot, product, unsigned_product};
use super::scaled32::Scaled32;
use super::step32::FixedStep;
use super::stored32::{self, clip};
use super::wide::{bits_of, magnitude, units};
use crate::body::Body;
#[cfg(multiply = "short")]
use crate::contact::Contact;
use crate::error::RangeError;
#[cfg(multiply = "short")]
use crate::impulse::Impact;
use crate::math::{Block, BlockImpulse, SymBlock, SymMat3, Vec3};

/// `(p + q + r) / 2^frac` rounded and clipped, for products of 32-bit numbers and `frac <= 30`.
///
/// A sum of three products that leaves 64 bits comes back with a magnitude of at least 2^64 - 3 * 2^62 = 2^62, and a
/// result that fits needs less than 2^61: the wrapped sum is never taken for a good one, and only the cold path has to
/// find the true sign.
#[inline(always)]
fn narrow_sum([p, q, r]: [i64; 3], frac: u32) -> i32 {
    let rounded = round_shift(p.wrapping_add(q).wrapping_add(r), frac);
    if rounded as i32 as i64 == rounded { rounded as i32 } else { end_of_range(p, q, r) }
}

/// The end of the range on the side of `p + q + r`.
#[cold]
#[inline(never)]
fn end_of_range(p: i64, q: i64, r: i64) -> i32 {
    // Halved twice, the sum fits; it is far from zero here.
    if (p >> 2).wrapping_add(q >> 2).wrapping_add(r >> 2) < 0 { i32::MIN } else { i32::MAX }
}

/// `2^46 / sqrt(a)` for `a >= 2^30`, at most 2^31; off by at most 2^-30 in relative terms.
///
/// One more Newton step `y (3 - a y^2)/2` after the two of `inverse_root`.
#[inline(always)]
fn precise_inverse_root(a: u32) -> u32 {
    let y = inverse_root(a);
    // 2^15 sqrt(a), and 2^61 (1 - a y^2): below 2^40 in magnitude, the most where a is next to 2^30.
    let root = (unsigned_product(a, y) >> 31) as u32;
    let rest = (1i64 << 61).wrapping_sub(unsigned_product(root, y) as i64);
    let step = product((rest >> 10) as i32, (y >> 1) as i32) >> 51;
    y.wrapping_add(step as u32)
}

/// The places by which a vector can move left so that its components stay within 29 bits: -2 to 29.
#[inline(always)]
fn headroom(v: [i32; 3]) -> i32 {
    (leading_zeros(magnitude(v)) as i32).wrapping_sub(3)
}

#[inline(always)]
fn move_left(x: i32, places: i32) -> i32 {
    if places >= 0 { x.wrapping_shl(places as u32) } else { round_shift(x as i64, places.unsigned_abs()) as i32 }
}

#[inline(always)]
fn bits3<Frac>(v: [FixedI32<Frac>; 3]) -> [i32; 3] {
    [v[0].to_bits(), v[1].to_bits(), v[2].to_bits()]
}

/// 1 + e in Q2.30, for the nearest e in 0 to 1.
#[inline(always)]
fn rebound_factor<Frac>(restitution: FixedI32<Frac>) -> u32
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True>,
{
    let bits = restitution.to_bits();
    let bits = if bits < 0 { 0 } else { bits };
    let bits = if bits > 1 << Frac::U32 { 1 << Frac::U32 } else { bits };
    (bits as u32).wrapping_add(1 << Frac::U32).wrapping_shl(30 - Frac::U32)
}

/// `|n| 2^frac / |d|` with its sign, clipped.
#[inline]
fn divide(n: i32, d: i32, frac: u32) -> (i32, bool) {
    let negative = (n ^ d) < 0;
    let magnitude = if d == 0 { None } else { wide_quotient(n.unsigned_abs(), d.unsigned_abs(), frac) };
    match magnitude {
        _ if n == 0 => (0, d == 0),
        Some(q) => ((q as i32).wrapping_mul(if negative { -1 } else { 1 }), false),
        // By zero the sign of the dividend decides; `d >= 0` there.
        None => (if negative { i32::MIN } else { i32::MAX }, true),
    }
}

/// `x / length` in Q2.30, for a length of twice the places of `x` and no less than it.
#[inline(always)]
fn component(x: i32, length: u32) -> I2F30 {
    let bits = wide_quotient(x.unsigned_abs(), length, 31).unwrap_or(1 << 30) as i32;
    I2F30::from_bits(if x < 0 { bits.wrapping_neg() } else { bits })
}

impl<Frac> Scalar for FixedI32<Frac>
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
    type Unit = I2F30;
    type Scaled = Scaled32;
    type Exponent = i32;
    type Wide = i64;
    type Lever = Lever32;
    type Arm = Arm32;
    type SubStep = FixedI32<U31>;
    type Remainder = u16;
    type Step = FixedStep;

    const ZERO: Self = Self::from_bits(0);
    const ONE: Self = Self::from_bits(1 << Frac::U32);
    const NO_REMAINDER: u16 = 0;
    const LARGEST: Self = Self::from_bits(i32::MAX);
    const STEP: Self = Self::from_bits(1);
    const SYMMETRIC: bool = false;
    const NO_EXPONENT: i32 = Scaled32::LOWEST;

    #[inline]
    fn from_ratio(numerator: i32, denominator: i32) -> Result<Self, RangeError> {
        let (bits, clipped) = divide(numerator, denominator, Frac::U32);
        // The lowest number is one unit farther from zero than `divide` goes: up to 2^31 + 1/2 units round to it.
        let (n, d) = (numerator.unsigned_abs() as u64, denominator.unsigned_abs() as u64);
        let is_lowest = bits == i32::MIN && n.wrapping_shl(Frac::U32.wrapping_add(1)) < d.wrapping_mul((1 << 32) + 1);
        if clipped && !is_lowest { Err(RangeError) } else { Ok(Self::from_bits(bits)) }
    }

    #[inline]
    fn sub_step(numerator: i32, denominator: i32) -> Result<Self::SubStep, RangeError> {
        match divide(numerator, denominator, 31) {
            (bits @ 0.., false) => Ok(FixedI32::from_bits(bits)),
            _ => Err(RangeError),
        }
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        true
    }

    #[inline(always)]
    fn bits(self) -> u64 {
        self.to_bits() as u32 as u64
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self::from_bits(self.to_bits().saturating_add(other.to_bits()))
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        Self::from_bits(self.to_bits().saturating_sub(other.to_bits()))
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self::from_bits(round_product::<Frac>(product(self.to_bits(), other.to_bits())))
    }

    #[inline]
    fn over(self, other: Self) -> Self {
        Self::from_bits(divide(self.to_bits(), other.to_bits(), Frac::U32).0)
    }

    #[inline(always)]
    fn negated(self) -> Self {
        Self::from_bits(0i32.saturating_sub(self.to_bits()))
    }

    #[inline]
    fn sqrt(self) -> Self {
        let bits = self.to_bits();
        if bits <= 0 {
            return Self::ZERO;
        }
        Self::from_bits(clip(round_sqrt((bits as u64).wrapping_shl(Frac::U32)) as i64).0)
    }

    #[inline(always)]
    fn dot3(a: [Self; 3], b: [Self; 3]) -> Self {
        let (a, b) = (bits3(a), bits3(b));
        Self::from_bits(narrow_sum([product(a[0], b[0]), product(a[1], b[1]), product(a[2], b[2])], Frac::U32))
    }

    #[inline(always)]
    fn det2(a: Self, b: Self, c: Self, d: Self) -> Self {
        let difference = product(a.to_bits(), d.to_bits()).wrapping_sub(product(b.to_bits(), c.to_bits()));
        Self::from_bits(round_product::<Frac>(difference))
    }

    #[inline(always)]
    fn dot3_unit(v: [Self; 3], d: [I2F30; 3]) -> Self {
        let (v, d) = (bits3(v), bits3(d));
        Self::from_bits(narrow_sum([product(v[0], d[0]), product(v[1], d[1]), product(v[2], d[2])], 30))
    }

    #[inline]
    fn length3(v: [Self; 3]) -> Self {
        // At most 3 * 2^62: it fits unsigned, and its root has twice as few fraction bits.
        let v = bits3(v);
        Self::from_bits(clip(round_sqrt(dot(v, v) as u64) as i64).0)
    }

    #[inline]
    fn normalize3(v: [Self; 3]) -> Option<[I2F30; 3]> {
        let v = bits3(v);
        if v == [0; 3] {
            return None;
        }
        // The largest component has 30 bits, the length 30 to 31, and the squares times four still fit.
        let places = headroom(v).wrapping_add(1);
        let v = [move_left(v[0], places), move_left(v[1], places), move_left(v[2], places)];
        // The root of the squares times four: the length to half a unit of its 31st bit.
        let length = round_sqrt((dot(v, v) as u64).wrapping_shl(2));
        Some([component(v[0], length), component(v[1], length), component(v[2], length)])
    }

    #[inline(never)]
    fn direction3(v: [Self; 3]) -> Option<([I2F30; 3], Self)> {
        let bits = bits3(v);
        if bits[0] | bits[1] | bits[2] == 0 {
            return None;
        }
        // The largest component has 30 bits, the sum of the squares 59 to 62. By magnitudes, so that the opposite vector has the
        // opposite direction to the last bit.
        let largest = bits[0].unsigned_abs() | bits[1].unsigned_abs() | bits[2].unsigned_abs();
        let places = (leading_zeros(largest) as i32).wrapping_sub(2);
        let m = [move_left(bits[0], places), move_left(bits[1], places), move_left(bits[2], places)];
        let square = dot(m, m) as u64;
        // Moved left by an even number of places, the square is a 2^32 with a >= 2^30, and its root sqrt(a) 2^16.
        let even = leading_zeros((square >> 32) as u32 | 1) & 30;
        let inverse = precise_inverse_root((square.wrapping_shl(even) >> 32) as u32);
        let down = 32u32.wrapping_sub(even >> 1);
        let half = 1u64.wrapping_shl(down.wrapping_sub(1));
        let component = |x: i32| {
            let rounded = unsigned_product(x.unsigned_abs(), inverse).wrapping_add(half).wrapping_shr(down) as i32;
            I2F30::from_bits(if x < 0 { rounded.wrapping_neg() } else { rounded })
        };
        let d = [component(m[0]), component(m[1]), component(m[2])];
        Some((d, Self::dot3_unit(v, d)))
    }

    #[inline(always)]
    fn times_unit(self, d: I2F30) -> Self {
        Self::from_bits(round_product::<U30>(product(self.to_bits(), d.to_bits())))
    }

    #[inline(always)]
    fn lowered_by(self, places: u32) -> Self {
        Self::from_bits(round_shift(self.to_bits() as i64, places & 31) as i32)
    }

    #[inline(always)]
    fn times_integer(self, n: i32) -> Self {
        Self::from_bits(clip(product(self.to_bits(), n)).0)
    }

    #[inline(always)]
    fn integer_below(self) -> i32 {
        self.to_bits().wrapping_shr(Frac::U32)
    }

    #[inline]
    fn fraction(part: Self, whole: Self) -> I2F30 {
        let (part, whole) = (part.to_bits().unsigned_abs(), whole.to_bits().unsigned_abs());
        if part >= whole {
            return I2F30::from_bits(1 << 30);
        }
        // Both moved left until the divisor fills 32 bits: to one unit of the last place, and rounded by what is left.
        let places = leading_zeros(whole);
        let (part, whole) = (part.wrapping_shl(places), whole.wrapping_shl(places));
        let quotient = long_quotient(part, whole);
        let rest = (u64::from(part) << 30).wrapping_sub(unsigned_product(quotient, whole)) as i64;
        let (twice, whole) = (rest.wrapping_mul(2), i64::from(whole));
        let correction = i32::from(twice >= whole).wrapping_sub(i32::from(twice < whole.wrapping_neg()));
        I2F30::from_bits((quotient as i32).wrapping_add(correction))
    }

    #[inline(always)]
    fn wide_product(a: Self, b: Self) -> i64 {
        product(a.to_bits(), b.to_bits())
    }

    #[inline(always)]
    fn wide_dot3(a: [Self; 3], b: [Self; 3]) -> i64 {
        let (a, b) = (bits3(a), bits3(b));
        product(a[0], b[0]).saturating_add(product(a[1], b[1])).saturating_add(product(a[2], b[2]))
    }

    #[inline(always)]
    fn wide_det2(a: Self, b: Self, c: Self, d: Self) -> i64 {
        product(a.to_bits(), d.to_bits()).saturating_sub(product(b.to_bits(), c.to_bits()))
    }

    #[inline(always)]
    fn scaled_dot3(v: [Self; 3], d: [I2F30; 3]) -> Scaled32 {
        // |v| < 2^31.8 and |d| <= 2^31 in units of the last place: below 2^62.8.
        Scaled32::new(dot(bits3(v), bits3(d)), -30i32.wrapping_add(Frac::I32))
    }

    #[inline(always)]
    fn is_against(v: [Self; 3], d: [I2F30; 3]) -> bool {
        dot(bits3(v), bits3(d)) < 0
    }

    #[inline(always)]
    fn opposite(d: &Vec3<I2F30>) -> Vec3<I2F30> {
        Vec3::new(d.x.wrapping_neg(), d.y.wrapping_neg(), d.z.wrapping_neg())
    }

    #[inline(always)]
    fn lever(body: &Body<Self>, r: &Vec3<Self>, d: &Vec3<I2F30>) -> Lever32 {
        lever(body, r, d)
    }

    #[inline(always)]
    fn parting_speed(v: [&Vec3<Self>; 2], d: [&Vec3<I2F30>; 2], levers: [&Lever32; 2]) -> Scaled32 {
        lever32::parting_speed([bits_of(v[0]), bits_of(v[1])], d, levers, Frac::I32)
    }

    #[inline(always)]
    fn approach_impulse(
        restitution: Self,
        v: [&Vec3<Self>; 2],
        d: [&Vec3<I2F30>; 2],
        inv_masses: [Scaled32; 2],
        levers: [&Lever32; 2],
    ) -> Result<Scaled32, (Scaled32, Scaled32)> {
        let v = [bits_of(v[0]), bits_of(v[1])];
        lever32::approach_impulse(rebound_factor(restitution), v, d, inv_masses, levers, Frac::I32)
    }

    #[inline(always)]
    fn inverse_mass(inv_masses: [Scaled32; 2], levers: [&Lever32; 2]) -> Scaled32 {
        lever32::inverse_mass(inv_masses, levers, Frac::I32)
    }

    #[inline(always)]
    fn rebound(restitution: Self, speed: Scaled32, k: Scaled32) -> Scaled32 {
        Scaled32::quotient_of_product(-speed, rebound_factor(restitution), k)
    }

    #[inline(always)]
    fn push(body: &mut Body<Self>, d: &Vec3<I2F30>, lever: &Lever32, j: Scaled32) -> bool {
        machine::push(body, d, lever, j)
    }

    #[cfg(multiply = "short")]
    #[inline(always)]
    fn strike(a: &mut Body<Self>, b: &mut Body<Self>, contact: &Contact<Self>, restitution: Self) -> Impact<Self> {
        machine::strike(a, b, contact, restitution)
    }

    #[inline(always)]
    fn arm(r: &Vec3<Self>, inv_inertia: &SymMat3<I2F30>, exponent: i32) -> Arm32 {
        machine::arm(r, inv_inertia, exponent)
    }

    #[inline(always)]
    fn contact_velocity(v: [&Vec3<Self>; 2], w: [&Vec3<Self>; 2], r: [&Vec3<Self>; 2]) -> Block<Self> {
        let (mantissas, exponent) = match arm32::velocity(v, w, r, Frac::I32) {
            Some((u, exponent)) => (units(u), exponent.wrapping_add(30)),
            None => {
                let (u, exponent) = arm32::far_velocity(v, w, r);
                (Vec3::from_array(u), exponent)
            }
        };
        Block { mantissas, exponent }
    }

    #[inline(always)]
    fn contact_inverse_mass(inv_masses: [Scaled32; 2], arms: [&Arm32; 2]) -> SymBlock<Self> {
        let ([xx, xy, xz, yy, yz, zz], exponent) = arm32::inverse_mass(inv_masses, arms);
        let mantissas = SymMat3 {
            xx: I2F30::from_bits(xx),
            xy: I2F30::from_bits(xy),
            xz: I2F30::from_bits(xz),
            yy: I2F30::from_bits(yy),
            yz: I2F30::from_bits(yz),
            zz: I2F30::from_bits(zz),
        };
        SymBlock { mantissas, exponent: exponent.wrapping_add(30) }
    }

    #[inline(always)]
    fn contact_impulse(
        inverse_mass: &SymBlock<Self>,
        velocity: &Block<Self>,
        normal: &Vec3<I2F30>,
        [restitution, friction]: [Self; 2],
    ) -> Option<(BlockImpulse<Self>, bool)> {
        let up = 30 - Frac::U32;
        let friction = friction.to_bits();
        if friction >> Frac::U32 >= 2 {
            return None;
        }
        let SymMat3 { xx, xy, xz, yy, yz, zz } = inverse_mass.mantissas;
        let contact = Contact32 {
            inverse_mass: [xx.to_bits(), xy.to_bits(), xz.to_bits(), yy.to_bits(), yz.to_bits(), zz.to_bits()],
            inverse_mass_exponent: inverse_mass.exponent,
            velocity: bits_of(&velocity.mantissas),
            velocity_exponent: velocity.exponent,
            normal: bits_of(normal),
            restitution: restitution.to_bits() << up,
            friction: friction << up,
        };
        let Impulse32 { normal, across, whole, exponent, stuck } = contact.solve()?;
        let exponent = exponent.wrapping_add(30);
        let impulse = BlockImpulse {
            normal: I2F30::from_bits(normal),
            normal_exponent: exponent,
            across: units(across),
            whole: units(whole),
            exponent,
        };
        Some((impulse, stuck))
    }

    #[inline(always)]
    fn from_block(mantissa: I2F30, exponent: i32) -> (Self, bool) {
        stored32::from_block(mantissa, exponent)
    }

    #[inline(always)]
    fn kick(body: &mut Body<Self>, _: &Vec3<Self>, arm: &Arm32, j: &Block<Self>) -> bool {
        machine::kick(body, arm, &j.mantissas, j.exponent)
    }

    #[inline(always)]
    fn to_scaled(self) -> Scaled32 {
        Scaled32::new(self.to_bits() as i64, Frac::I32.wrapping_neg())
    }

    #[inline(always)]
    fn from_scaled(x: Scaled32) -> (Self, bool) {
        stored32::from_scaled(x)
    }

    #[inline]
    fn advance(self, velocity: Self, h: Self::SubStep, remainder: &mut u16) -> (Self, bool) {
        // Position and remainder as one number with 16 more places; the product has 31, of which 15 are rounded away.
        let place = (self.to_bits() as i64).wrapping_shl(16) | *remainder as i64;
        let moved = place.wrapping_add(round_shift(product(velocity.to_bits(), h.to_bits()), 15));
        *remainder = moved as u16;
        let (bits, clipped) = clip(moved >> 16);
        (Self::from_bits(bits), clipped)
    }
}
