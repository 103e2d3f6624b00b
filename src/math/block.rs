//! Blocks: several numbers under one power of two. In floating point the numbers themselves.

use super::{SymMat3, Vec3};
use crate::scalar::{Scalar, Scaled};

/// A vector of any magnitude: in fixed point mantissas of Q2.30 under one exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block<S: Scalar> {
    /// The components, to be multiplied by the power of two.
    pub mantissas: Vec3<S::Unit>,
    /// The power of two.
    pub exponent: S::Exponent,
}

/// A symmetric 3x3 matrix of any magnitude, the same way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymBlock<S: Scalar> {
    /// The six numbers, to be multiplied by the power of two.
    pub mantissas: SymMat3<S::Unit>,
    /// The power of two.
    pub exponent: S::Exponent,
}

/// An impulse of any magnitude in a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlockImpulse<S: Scalar> {
    /// Along the normal, under a power of two of its own: strong friction can leave it a small part of the whole.
    pub normal: S::Unit,
    /// The power of two of the part along the normal.
    pub normal_exponent: S::Exponent,
    /// Across the normal.
    pub across: Vec3<S::Unit>,
    /// The sum of both.
    pub whole: Vec3<S::Unit>,
    /// The power of two of the vectors.
    pub exponent: S::Exponent,
}

impl<S: Scalar> Block<S> {
    /// Three numbers as a block, with mantissas within 1/2 in fixed point.
    #[inline(always)]
    pub(crate) fn align(v: [S::Scaled; 3]) -> Self {
        let (mantissas, exponent) = S::Scaled::align3(v);
        Self { mantissas: Vec3::from_array(mantissas), exponent }
    }

    /// The three numbers.
    #[inline(always)]
    pub(crate) fn to_scaled(self) -> [S::Scaled; 3] {
        let Vec3 { x, y, z } = self.mantissas;
        [scaled::<S>(x, self.exponent), scaled::<S>(y, self.exponent), scaled::<S>(z, self.exponent)]
    }

    /// The component along a unit vector: the exact sum, rounded once (one of rounded terms could have the other sign).
    #[inline(always)]
    pub(crate) fn along(&self, d: &Vec3<S::Unit>) -> S::Scaled {
        S::Unit::scaled_dot3(self.mantissas.to_array(), d.to_array()).raised(self.exponent)
    }

    /// The opposite vector.
    #[inline(always)]
    pub(crate) fn opposite(&self) -> Self {
        Self { mantissas: S::opposite(&self.mantissas), exponent: self.exponent }
    }
}

impl<S: Scalar> BlockImpulse<S> {
    /// An impulse under one power of two, in fixed point with mantissas of the whole within 1/2.
    #[inline(always)]
    pub(crate) fn align(normal: S::Scaled, across: [S::Scaled; 3], whole: [S::Scaled; 3]) -> Self {
        let Block { mantissas, exponent } = Block::<S>::align(whole);
        let [x, y, z] = across;
        let across = Vec3::new(x.lowered(exponent), y.lowered(exponent), z.lowered(exponent));
        let along = Block::<S>::align([normal, S::Scaled::ZERO, S::Scaled::ZERO]);
        Self { normal: along.mantissas.x, normal_exponent: along.exponent, across, whole: mantissas, exponent }
    }

    /// Along the normal, across it, and the whole.
    #[inline(always)]
    pub(crate) fn to_scaled(self) -> (S::Scaled, [S::Scaled; 3], [S::Scaled; 3]) {
        let vector = |mantissas: Vec3<S::Unit>| Block::<S> { mantissas, exponent: self.exponent }.to_scaled();
        (scaled::<S>(self.normal, self.normal_exponent), vector(self.across), vector(self.whole))
    }
}

impl<S: Scalar> SymBlock<S> {
    /// The six numbers: xx, xy, xz, yy, yz, zz.
    #[inline(always)]
    pub(crate) fn to_scaled(self) -> [S::Scaled; 6] {
        let SymMat3 { xx, xy, xz, yy, yz, zz } = self.mantissas;
        let e = self.exponent;
        [
            scaled::<S>(xx, e),
            scaled::<S>(xy, e),
            scaled::<S>(xz, e),
            scaled::<S>(yy, e),
            scaled::<S>(yz, e),
            scaled::<S>(zz, e),
        ]
    }
}

#[inline(always)]
fn scaled<S: Scalar>(mantissa: S::Unit, exponent: S::Exponent) -> S::Scaled {
    mantissa.to_scaled().raised(exponent)
}
