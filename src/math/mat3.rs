//! The 3x3 matrix, as the rotation of a quaternion.

use super::Vec3;
use crate::scalar::Scalar;

/// A 3x3 matrix by rows.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct Mat3<S> {
    /// First, second and third row.
    pub rows: [Vec3<S>; 3],
}

impl<S: Scalar> Mat3<S> {
    /// The identity: no rotation.
    pub const IDENTITY: Self = Self {
        rows: [
            Vec3::new(S::ONE, S::ZERO, S::ZERO),
            Vec3::new(S::ZERO, S::ONE, S::ZERO),
            Vec3::new(S::ZERO, S::ZERO, S::ONE),
        ],
    };

    /// The matrix times a column vector. In fixed point each component is rounded once, in floating point each product
    /// and each sum.
    #[inline]
    #[must_use]
    pub fn times(&self, v: Vec3<S>) -> Vec3<S> {
        let [x, y, z] = self.rows;
        Vec3::new(x.dot(v), y.dot(v), z.dot(v))
    }

    /// First, second and third column: the rows of the transposed matrix.
    #[inline(always)]
    pub const fn columns(&self) -> [Vec3<S>; 3] {
        let [a, b, c] = self.rows;
        [Vec3::new(a.x, b.x, c.x), Vec3::new(a.y, b.y, c.y), Vec3::new(a.z, b.z, c.z)]
    }

    /// The transposed matrix: of a rotation, the way back.
    #[inline(always)]
    #[must_use]
    pub const fn transposed(&self) -> Self {
        Self { rows: self.columns() }
    }

    /// The product of two matrices: of rotations, `other` first.
    #[inline]
    #[must_use]
    pub fn times_mat3(&self, other: &Self) -> Self {
        let [x, y, z] = self.rows;
        let other = other.transposed();
        Self { rows: [other.times(x), other.times(y), other.times(z)] }
    }
}
