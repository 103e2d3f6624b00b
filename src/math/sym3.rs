//! The symmetric 3x3 matrix: an inertia tensor or its inverse, six numbers.

use super::{Mat3, Vec3};
use crate::scalar::Scalar;

/// A symmetric 3x3 matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct SymMat3<S> {
    /// Row 1, column 1.
    pub xx: S,
    /// Rows and columns 1 and 2.
    pub xy: S,
    /// Rows and columns 1 and 3.
    pub xz: S,
    /// Row 2, column 2.
    pub yy: S,
    /// Rows and columns 2 and 3.
    pub yz: S,
    /// Row 3, column 3.
    pub zz: S,
}

impl<S: Scalar> SymMat3<S> {
    /// The zero matrix.
    pub const ZERO: Self = Self::diagonal(S::ZERO, S::ZERO, S::ZERO);

    /// A matrix with nothing off its diagonal: a tensor in its principal axes.
    #[inline(always)]
    pub const fn diagonal(xx: S, yy: S, zz: S) -> Self {
        Self { xx, xy: S::ZERO, xz: S::ZERO, yy, yz: S::ZERO, zz }
    }

    /// The matrix times a column vector. In fixed point each component is rounded once, in floating point each product
    /// and each sum.
    #[inline(always)]
    #[must_use]
    pub fn times(&self, v: Vec3<S>) -> Vec3<S> {
        let [x, y, z] = self.columns();
        Vec3::new(x.dot(v), y.dot(v), z.dot(v))
    }

    /// The same tensor in another frame: R A R^T for the rotation R from the old frame to the new one.
    ///
    /// A multiple of the unit matrix comes back unchanged, bit for bit.
    #[must_use]
    pub fn rotated(&self, rotation: &Mat3<S>) -> Self {
        let off_diagonal = self.xy != S::ZERO || self.xz != S::ZERO || self.yz != S::ZERO;
        if !off_diagonal && self.xx == self.yy && self.yy == self.zz {
            return *self;
        }
        let [r0, r1, r2] = rotation.rows;
        // A is symmetric, so that A r is the row r^T A.
        let (a0, a1, a2) = (self.times(r0), self.times(r1), self.times(r2));
        Self { xx: a0.dot(r0), xy: a0.dot(r1), xz: a0.dot(r2), yy: a1.dot(r1), yz: a1.dot(r2), zz: a2.dot(r2) }
    }

    #[inline(always)]
    pub(crate) fn columns(&self) -> [Vec3<S>; 3] {
        [
            Vec3::new(self.xx, self.xy, self.xz),
            Vec3::new(self.xy, self.yy, self.yz),
            Vec3::new(self.xz, self.yz, self.zz),
        ]
    }
}
