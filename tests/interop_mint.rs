//! mint's types against glam, which has conventions and arithmetic of its own: what arrives there turns vectors as it does here.
#![cfg(all(feature = "mint", feature = "f32"))]

use carom::{DirectionError, Mat3, OrientationError, Quat, UnitVec3, Vec3};

/// Quaternions and vectors all over the place, from a counter.
fn cases() -> impl Iterator<Item = (Quat<f32>, Vec3<f32>)> {
    (1..=500u32).map(|n| {
        let part = |k: u32| {
            let mixed = (n * 8 + k).wrapping_mul(0x9e37_79b9);
            let mixed = (mixed ^ mixed >> 15).wrapping_mul(0x85eb_ca6b);
            f32::from((mixed >> 16) as u16) / 32768.0 - 1.0
        };
        let q = Quat::normalize(part(1), part(2), part(3), part(4)).expect("a quaternion that is not zero");
        (q, Vec3::new(part(5), part(6), part(7)))
    })
}

fn near(a: Vec3<f32>, b: glam::Vec3) -> bool {
    (a.x - b.x).abs() < 1e-6 && (a.y - b.y).abs() < 1e-6 && (a.z - b.z).abs() < 1e-6
}

#[test]
fn glam_turns_vectors_as_carom_does() {
    let mut turned = 0;
    for (q, v) in cases() {
        let there = glam::Quat::from(mint::Quaternion::from(q));
        let vector = glam::Vec3::from(mint::Vector3::from(v));
        assert!(near(q.rotate(v), there * vector), "{q:?} {v:?}");
        // A mirrored or transposed rotation would be seen.
        turned += u32::from(!near(q.conjugate().rotate(v), there * vector));

        let matrix = q.to_mat3();
        let columns = glam::Mat3::from(mint::ColumnMatrix3::from(matrix));
        assert!(near(matrix.times(v), columns * vector), "columns of {matrix:?}");
        let rows = mint::RowMatrix3::from(matrix);
        assert_eq!([rows.x.y, rows.y.z, rows.z.x], [columns.y_axis.x, columns.z_axis.y, columns.x_axis.z]);
    }
    assert!(turned > 490, "{turned} of 500 rotations have a direction");
}

#[test]
fn what_goes_out_comes_back() {
    for (q, v) in cases() {
        assert_eq!(Quat::try_from(mint::Quaternion::from(q)), Ok(q));
        assert_eq!(Vec3::from(mint::Vector3::from(v)), v);
        assert_eq!(Vec3::from(mint::Point3::from(v)), v);
        let matrix = q.to_mat3();
        assert_eq!(Mat3::from(mint::RowMatrix3::from(matrix)), matrix);
        assert_eq!(Mat3::from(mint::ColumnMatrix3::from(matrix)), matrix);
        if let Ok(direction) = UnitVec3::normalize(v) {
            assert_eq!(UnitVec3::try_from(mint::Vector3::from(direction)), Ok(direction));
        }
        // From glam, too: its quaternions are of unit length.
        let theirs = glam::Quat::from_xyzw(v.x, v.y, v.z, 0.5).normalize();
        let ours = Quat::<f32>::try_from(mint::Quaternion::from(theirs)).expect("of unit length");
        assert_eq!(ours.to_array(), [theirs.w, theirs.x, theirs.y, theirs.z]);
    }
}

#[test]
fn what_is_not_of_unit_length_is_refused() {
    let quaternion = |s, x| mint::Quaternion { s, v: mint::Vector3 { x, y: 0.0, z: 0.0 } };
    assert_eq!(Quat::<f32>::try_from(quaternion(1.0, 0.01)), Err(OrientationError::NotUnit));
    assert_eq!(Quat::<f32>::try_from(quaternion(0.0, 0.0)), Err(OrientationError::Zero));
    assert_eq!(Quat::<f32>::try_from(quaternion(f32::NAN, 0.0)), Err(OrientationError::NotFinite));
    let direction = |x| UnitVec3::<f32>::try_from(mint::Vector3 { x, y: 0.0, z: 0.0 });
    assert_eq!(direction(0.999), Err(DirectionError::NotUnit));
    assert_eq!(direction(-1.0), Ok(-UnitVec3::X));
}

/// In fixed point directions and quaternions are Q2.30, and mint is generic.
#[cfg(feature = "fixed")]
#[test]
fn fixed_point_goes_as_it_is() {
    use fixed::types::{I2F30, I12F20};
    let v = Vec3::new(I12F20::from_num(1.5), I12F20::from_num(-2), I12F20::DELTA);
    assert_eq!(Vec3::from(mint::Vector3::from(v)), v);
    let q = Quat::<I12F20>::normalize(I2F30::from_num(0.5), I2F30::from_num(-0.25), I2F30::DELTA, I2F30::ONE)
        .expect("a rotation");
    let there: mint::Quaternion<I2F30> = q.into();
    assert_eq!(there.v.x, q.to_array()[1]);
    assert_eq!(Quat::<I12F20>::try_from(there), Ok(q));
    let direction: mint::Vector3<I2F30> = UnitVec3::<I12F20>::Z.into();
    assert_eq!(UnitVec3::<I12F20>::try_from(direction), Ok(UnitVec3::Z));
}
