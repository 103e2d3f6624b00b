//! From and to mint's types, which libraries of mathematics exchange.

use ::mint::{ColumnMatrix3, IntoMint, Point3, Quaternion, RowMatrix3, Vector3};

use crate::error::{DirectionError, OrientationError};
use crate::math::{Mat3, Quat, UnitVec3, Vec3};
use crate::scalar::Scalar;

macro_rules! triple {
    ($($mint:ident)+) => {$(
        impl<S> From<$mint<S>> for Vec3<S> {
            fn from($mint { x, y, z }: $mint<S>) -> Self {
                Self { x, y, z }
            }
        }

        impl<S> From<Vec3<S>> for $mint<S> {
            fn from(Vec3 { x, y, z }: Vec3<S>) -> Self {
                Self { x, y, z }
            }
        }
    )+};
}

triple!(Vector3 Point3);

impl<S> IntoMint for Vec3<S> {
    type MintType = Vector3<S>;
}

impl<S: Scalar> From<UnitVec3<S>> for Vector3<S::Unit> {
    fn from(direction: UnitVec3<S>) -> Self {
        direction.get().into()
    }
}

impl<S: Scalar> IntoMint for UnitVec3<S> {
    type MintType = Vector3<S::Unit>;
}

/// As [`UnitVec3::new`]: the components are taken as they are.
impl<S: Scalar> TryFrom<Vector3<S::Unit>> for UnitVec3<S> {
    type Error = DirectionError;

    fn try_from(components: Vector3<S::Unit>) -> Result<Self, DirectionError> {
        Self::new(components.into())
    }
}

impl<S: Scalar> From<Quat<S>> for Quaternion<S::Unit> {
    fn from(rotation: Quat<S>) -> Self {
        let [s, x, y, z] = rotation.to_array();
        Self { s, v: Vector3 { x, y, z } }
    }
}

impl<S: Scalar> IntoMint for Quat<S> {
    type MintType = Quaternion<S::Unit>;
}

/// As [`Quat::new`]: the components are taken as they are.
impl<S: Scalar> TryFrom<Quaternion<S::Unit>> for Quat<S> {
    type Error = OrientationError;

    fn try_from(Quaternion { s, v }: Quaternion<S::Unit>) -> Result<Self, OrientationError> {
        Self::new(s, v.x, v.y, v.z)
    }
}

impl<S> From<RowMatrix3<S>> for Mat3<S> {
    fn from(RowMatrix3 { x, y, z }: RowMatrix3<S>) -> Self {
        Self { rows: [x.into(), y.into(), z.into()] }
    }
}

impl<S> From<Mat3<S>> for RowMatrix3<S> {
    fn from(matrix: Mat3<S>) -> Self {
        let [x, y, z] = matrix.rows.map(Into::into);
        Self { x, y, z }
    }
}

impl<S: Scalar> From<ColumnMatrix3<S>> for Mat3<S> {
    fn from(ColumnMatrix3 { x, y, z }: ColumnMatrix3<S>) -> Self {
        Self { rows: [x.into(), y.into(), z.into()] }.transposed()
    }
}

impl<S: Scalar> From<Mat3<S>> for ColumnMatrix3<S> {
    fn from(matrix: Mat3<S>) -> Self {
        let [x, y, z] = matrix.columns().map(Into::into);
        Self { x, y, z }
    }
}

impl<S> IntoMint for Mat3<S> {
    type MintType = RowMatrix3<S>;
}
