//! The 3x3 matrix, as the rotation of a quaternion.

use super::Vec3;
use crate::scalar::Scalar;

/// A 3x3 matrix by rows.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Mat3<S> {
    /// First, second and third row.
    pub rows: [Vec3<S>; 3],
}

impl<S: Scalar> Mat3<S> {
    /// The matrix times a column vector. In fixed point each component is rounded once, in floating point each product
    /// and each sum.
    #[inline]
    #[must_use]
    pub fn times(&self, v: Vec3<S>) -> Vec3<S> {
        let [x, y, z] = self.rows;
        Vec3::new(x.dot(v), y.dot(v), z.dot(v))
    }
}
