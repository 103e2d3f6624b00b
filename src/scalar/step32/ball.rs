//! Columns of balls, whose levers need neither cross products nor a tensor.

use fixed::FixedI32;
use fixed::types::I2F30;
use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U30};

use super::columns::{ARM, EVEN, TURN, aligned, fitted, friction_ratio, inverted, share, unit_vector};
use super::round::round;
use crate::math::Vec3;
use crate::scalar::Scalar;
use crate::scalar::product::{dot, product};
use crate::scalar::scaled32::Scaled32;
use crate::scalar::step::{Column, Weights};
use crate::scalar::wide::{bits, bits_of, high, max, narrow};

/// How far a contact is along the normal, rho, and rho/I: mantissas of Q2.30.
#[derive(Clone, Copy, Debug)]
pub struct Ball32 {
    reach: i32,
    reach_exponent: i32,
    turn: i32,
    turn_exponent: i32,
}

impl Ball32 {
    /// Of a contact at `r`, `inv_inertia 2^exponent` being the inverse inertia.
    #[inline(always)]
    pub fn new<Frac: LeEqU32>(
        r: &Vec3<FixedI32<Frac>>,
        normal: &Vec3<I2F30>,
        inv_inertia: I2F30,
        exponent: i32,
    ) -> Self {
        let reach = Scaled32::cut(dot(bits_of(r), bits(normal)), 30i32.wrapping_add(Frac::I32).wrapping_neg());
        let turn = narrow::<29>(product(reach.mantissa(), inv_inertia.to_bits()));
        let turn_exponent = reach.exponent().wrapping_add(exponent).wrapping_sub(1);
        Self { reach: reach.mantissa(), reach_exponent: reach.exponent(), turn, turn_exponent }
    }

    /// rho^2/I, and its exponent.
    #[inline(always)]
    fn inverse_mass(&self) -> (i32, i32) {
        let product = high(product(self.reach, self.turn));
        (product, self.reach_exponent.wrapping_add(self.turn_exponent).wrapping_add(2))
    }

    /// The columns of a body with that inverse mass and size, for the normal and a right-handed frame's two tangents.
    #[inline(never)]
    pub fn columns<F: LeEqU32>(
        &self,
        inv_mass: Scaled32,
        weights: &Weights<FixedI32<F>>,
        size: i32,
        [x, y]: &[Vec3<I2F30>; 2],
        [normal, first, second]: [&mut Column<FixedI32<F>>; 3],
    ) where
        FixedI32<F>: Scalar<Unit = I2F30, Scaled = Scaled32>,
    {
        let k = weights.inv_tangent;
        let arm =
            fitted::<{ ARM + 1 }>(self.reach, size.wrapping_sub(self.reach_exponent).wrapping_add(30 - ARM as i32));
        let down = (60 - TURN as i32).wrapping_sub(self.turn_exponent).wrapping_sub(k.exponent()).wrapping_sub(size);
        let turn = fitted::<30>(round::<30>(product(self.turn, k.mantissa())), down.wrapping_sub(30));
        let along = |d: [i32; 3], length| {
            let part = |d| round::<30>(product(d, length));
            unit_vector([part(d[0]), part(d[1]), part(d[2])])
        };
        let minus = [arm.wrapping_neg(), turn.wrapping_neg()];
        normal.share = share(inv_mass, weights.inv_normal);
        let share = share(inv_mass, k);
        *first = Column { arm: along(bits(y), arm), turn: along(bits(y), turn), share };
        *second = Column { arm: along(bits(x), minus[0]), turn: along(bits(x), minus[1]), share };
    }
}

/// The inverses of K along the normal and across it.
#[inline(never)]
pub fn weights<Frac>(sides: [Option<(&Ball32, Scaled32)>; 2], friction: FixedI32<Frac>) -> Weights<FixedI32<Frac>>
where
    Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
{
    let mut top = Scaled32::LOWEST;
    for (ball, inv_mass) in sides.iter().flatten() {
        let (_, exponent) = ball.inverse_mass();
        top = max(top, max(inv_mass.exponent(), exponent));
    }
    // Four terms below 2^30.
    let top = top.wrapping_add(2);
    let (mut normal, mut across) = (0i32, 0i32);
    for (ball, inv_mass) in sides.iter().flatten() {
        let (spin, exponent) = ball.inverse_mass();
        normal = normal.wrapping_add(aligned(inv_mass.mantissa(), top.wrapping_sub(inv_mass.exponent())));
        across = across.wrapping_add(aligned(spin, top.wrapping_sub(exponent)));
    }
    let tangent = normal.wrapping_add(across);
    let unit = 30i32.wrapping_sub(top);
    let (inv_normal, inv_tangent) = (inverted(normal, unit), inverted(tangent, unit));
    let friction = friction_ratio(friction, tangent, inv_normal, unit);
    Weights { inv_normal, inv_tangent, block: EVEN, friction }
}
