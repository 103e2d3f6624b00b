//! Mass and inertia: of the usual solids, or as given.

use crate::error::{MassError, SolidError};
use crate::math::{SymMat3, Vec3};
use crate::scalar::{Scalar, Scaled};

mod assembly;

pub use self::assembly::{Assembly, SolidPart};

/// The geometry of a homogeneous solid, as far as its mass depends on it: its volume (of a thin shell: its area) and its
/// principal moments of inertia per unit of mass, about the centre of mass and along the local axes.
///
/// Everything is kept as [`Scalar::Scaled`], and exact to a few parts in 2^30 for the dimensions as stored: a sphere of
/// 655/65536 m in Q16.16 is as exact as one of 1 m (but 655/65536 is 5.5e-4 less than 1/100).
///
/// In floating point, dimensions whose volume or moments leave the range of normal numbers are refused: in f32 a sphere
/// of a radius below 1.5e-13 or above 4.3e12.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid<S: Scalar> {
    measure: S::Scaled,
    moments: [S::Scaled; 3],
}

/// Mass and inertia in the form in which impulses use them: the inverse mass, and the inverse inertia tensor about the
/// centre of mass in the body's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties<S: Scalar> {
    pub(crate) inv_mass: S::Scaled,
    pub(crate) inv_inertia: SymMat3<S::Unit>,
    pub(crate) exponent: S::Exponent,
    /// (I_y - I_z)/I_x, (I_z - I_x)/I_y, (I_x - I_y)/I_z of the principal moments: what turns a free body's spin.
    pub(crate) gyration: Vec3<S::Unit>,
}

fn ratio<S: Scalar>(numerator: i32, denominator: i32) -> S::Scaled {
    S::Scaled::ratio(numerator, denominator)
}

/// Positive, finite, and in a float no subnormal number: those have fewer digits the smaller they are.
fn has_all_digits<T: Scaled>(x: T) -> bool {
    x.is_finite() && x * T::EPSILON > T::ZERO
}

fn have_all_digits<T: Scaled>([x, y, z]: [T; 3]) -> bool {
    has_all_digits(x) && has_all_digits(y) && has_all_digits(z)
}

/// The dimension to name where those of a solid lead out of a float's range.
fn radius_or<T: Scaled>(radius: T, other: SolidError) -> SolidError {
    if has_all_digits(radius * radius * radius) { other } else { SolidError::Radius }
}

/// A dimension that must be positive and finite.
fn positive<S: Scalar>(dimension: S, error: SolidError) -> Result<S::Scaled, SolidError> {
    if dimension.is_finite() && dimension > S::ZERO { Ok(dimension.to_scaled()) } else { Err(error) }
}

impl<S: Scalar> Solid<S> {
    /// A solid sphere: I = 2/5 m r^2.
    ///
    /// # Errors
    /// [`SolidError::Radius`].
    pub fn sphere(radius: S) -> Result<Self, SolidError> {
        let r = positive(radius, SolidError::Radius)?;
        let moment = ratio::<S>(2, 5) * r * r;
        Self::new(ratio::<S>(4, 3) * S::Scaled::PI * r * r * r, [moment; 3], SolidError::Radius)
    }

    /// A thin spherical shell, such as a table-tennis ball: I = 2/3 m r^2. Its density is a mass per area.
    ///
    /// # Errors
    /// [`SolidError::Radius`].
    pub fn spherical_shell(radius: S) -> Result<Self, SolidError> {
        let r = positive(radius, SolidError::Radius)?;
        let moment = ratio::<S>(2, 3) * r * r;
        Self::new(ratio::<S>(4, 1) * S::Scaled::PI * r * r, [moment; 3], SolidError::Radius)
    }

    /// A solid box with the given half edges: I_x = m/3 (h_y^2 + h_z^2), and so on.
    ///
    /// # Errors
    /// [`SolidError::HalfExtent`].
    pub fn cuboid(half_extents: Vec3<S>) -> Result<Self, SolidError> {
        let half = |h| positive::<S>(h, SolidError::HalfExtent);
        let (x, y, z) = (half(half_extents.x)?, half(half_extents.y)?, half(half_extents.z)?);
        let third = ratio::<S>(1, 3);
        let moment = |a: S::Scaled, b: S::Scaled| third * (a * a + b * b);
        let measure = ratio::<S>(8, 1) * x * y * z;
        Self::new(measure, [moment(y, z), moment(x, z), moment(x, y)], SolidError::HalfExtent)
    }

    /// A solid ellipsoid with the given semi-axes: I_x = m/5 (b^2 + c^2), and so on.
    ///
    /// # Errors
    /// [`SolidError::SemiAxis`].
    pub fn ellipsoid(semi_axes: Vec3<S>) -> Result<Self, SolidError> {
        let axis = |h| positive::<S>(h, SolidError::SemiAxis);
        let (x, y, z) = (axis(semi_axes.x)?, axis(semi_axes.y)?, axis(semi_axes.z)?);
        let fifth = ratio::<S>(1, 5);
        let moment = |a: S::Scaled, b: S::Scaled| fifth * (a * a + b * b);
        let measure = ratio::<S>(4, 3) * S::Scaled::PI * x * y * z;
        Self::new(measure, [moment(y, z), moment(x, z), moment(x, y)], SolidError::SemiAxis)
    }

    /// A solid cylinder along the local z axis: I_z = m/2 r^2, I_x = I_y = m (r^2/4 + h^2/3) with the half length h.
    ///
    /// # Errors
    /// [`SolidError::Radius`], [`SolidError::HalfLength`].
    pub fn cylinder(radius: S, half_length: S) -> Result<Self, SolidError> {
        let r = positive(radius, SolidError::Radius)?;
        let h = positive(half_length, SolidError::HalfLength)?;
        let across = ratio::<S>(1, 4) * r * r + ratio::<S>(1, 3) * h * h;
        let measure = ratio::<S>(2, 1) * S::Scaled::PI * r * r * h;
        Self::new(measure, [across, across, ratio::<S>(1, 2) * r * r], radius_or(r, SolidError::HalfLength))
    }

    /// A thin tube without ends along the local z axis: I_z = m r^2, I_x = I_y = m (r^2/2 + h^2/3) with the half length
    /// h. Its density is a mass per area.
    ///
    /// # Errors
    /// [`SolidError::Radius`], [`SolidError::HalfLength`].
    pub fn tube(radius: S, half_length: S) -> Result<Self, SolidError> {
        let r = positive(radius, SolidError::Radius)?;
        let h = positive(half_length, SolidError::HalfLength)?;
        let across = ratio::<S>(1, 2) * r * r + ratio::<S>(1, 3) * h * h;
        let measure = ratio::<S>(4, 1) * S::Scaled::PI * r * h;
        Self::new(measure, [across, across, r * r], radius_or(r, SolidError::HalfLength))
    }

    /// A solid cone along the local z axis, about its centre of mass, which is a quarter of the height above the base:
    /// I_z = 3/10 m r^2, I_x = I_y = m (3/20 r^2 + 3/80 h^2).
    ///
    /// # Errors
    /// [`SolidError::Radius`], [`SolidError::Height`].
    pub fn cone(radius: S, height: S) -> Result<Self, SolidError> {
        let r = positive(radius, SolidError::Radius)?;
        let h = positive(height, SolidError::Height)?;
        let across = ratio::<S>(3, 20) * r * r + ratio::<S>(3, 80) * h * h;
        let measure = ratio::<S>(1, 3) * S::Scaled::PI * r * r * h;
        Self::new(measure, [across, across, ratio::<S>(3, 10) * r * r], radius_or(r, SolidError::Height))
    }

    /// A solid capsule: a cylinder of the given half length along the local z axis, with half a sphere on each end.
    ///
    /// With the cylinder's share c and the spheres' share s of the mass: I_z = c r^2/2 + 2 s r^2/5 and
    /// I_x = I_y = c (r^2/4 + h^2/3) + s (2 r^2/5 + h^2 + 3 h r/4), the last by Steiner's theorem about each hemisphere's
    /// own centre of mass, 3 r/8 from its plane.
    ///
    /// # Errors
    /// [`SolidError::Radius`], [`SolidError::HalfLength`].
    pub fn capsule(radius: S, half_length: S) -> Result<Self, SolidError> {
        let r = positive(radius, SolidError::Radius)?;
        if half_length == S::ZERO {
            return Self::sphere(radius);
        }
        let h = positive(half_length, SolidError::HalfLength)?;
        // Volumes over 2 pi r^2: h of the cylinder, 2 r/3 of the spheres.
        let spheres = ratio::<S>(2, 3) * r;
        let total = h + spheres;
        let (c, s) = (h / total, spheres / total);
        let along = (c * ratio::<S>(1, 2) + s * ratio::<S>(2, 5)) * r * r;
        let across = c * (ratio::<S>(1, 4) * r * r + ratio::<S>(1, 3) * h * h)
            + s * (ratio::<S>(2, 5) * r * r + h * h + ratio::<S>(3, 4) * h * r);
        let measure = ratio::<S>(2, 1) * S::Scaled::PI * r * r * total;
        Self::new(measure, [across, across, along], radius_or(r, SolidError::HalfLength))
    }

    pub(crate) fn new(measure: S::Scaled, moments: [S::Scaled; 3], error: SolidError) -> Result<Self, SolidError> {
        let fits = has_all_digits(measure) && have_all_digits(moments);
        if fits { Ok(Self { measure, moments }) } else { Err(error) }
    }

    /// The volume; of a thin shell, the area.
    pub fn measure(&self) -> S::Scaled {
        self.measure
    }

    /// The principal moments of inertia per unit of mass, along the local x, y and z axes.
    pub fn moments(&self) -> [S::Scaled; 3] {
        self.moments
    }

    /// The solid with a given mass.
    ///
    /// # Errors
    /// [`MassError::Mass`] where it is not positive and finite, or in floating point where a moment of inertia, or the
    /// inverse of one, leaves the range of normal numbers.
    pub fn with_mass(&self, mass: S) -> Result<MassProperties<S>, MassError> {
        if !(mass.is_finite() && mass > S::ZERO) {
            return Err(MassError::Mass);
        }
        self.scaled_mass(mass.to_scaled(), MassError::Mass)
    }

    /// The solid with a given density: a mass per volume, of a thin shell a mass per area.
    ///
    /// # Errors
    /// [`MassError::Density`] where it is not positive and finite, or in floating point where the mass, a moment of
    /// inertia, or the inverse of one, leaves the range of normal numbers.
    pub fn with_density(&self, density: S) -> Result<MassProperties<S>, MassError> {
        if !(density.is_finite() && density > S::ZERO) {
            return Err(MassError::Density);
        }
        self.scaled_mass(density.to_scaled() * self.measure, MassError::Density)
    }

    fn scaled_mass(&self, mass: S::Scaled, error: MassError) -> Result<MassProperties<S>, MassError> {
        let [x, y, z] = self.moments;
        let moments = [mass * x, mass * y, mass * z];
        let (inv_mass, inverses) = (S::Scaled::ONE / mass, moments.map(|moment| S::Scaled::ONE / moment));
        let fits = has_all_digits(mass) && has_all_digits(inv_mass);
        if !(fits && have_all_digits(moments) && have_all_digits(inverses)) {
            return Err(error);
        }
        MassProperties::from_inverses(inv_mass, inverses)
    }
}

impl<S: Scalar> MassProperties<S> {
    /// From a mass (kg) and a full inertia tensor (kg m^2) about the centre of mass, in the body's frame.
    ///
    /// The tensor is inverted here, once: each entry of I^-1 I is within 4 c^2 u of the unit matrix's, for a ratio c of
    /// the largest principal moment to the smallest and a precision u of 2^-29 in fixed point, 2^-23 in f32 and 2^-52 in
    /// f64, whatever the size of the tensor.
    ///
    /// With products of inertia (entries off the diagonal) contacts are exact, but the solver leaves the gyroscopic torque out:
    /// a body that flies freely keeps its angular velocity, not its angular momentum. Give the body its principal axes as its
    /// frame, and [`from_inverses`](Self::from_inverses) or a diagonal tensor, where that matters.
    ///
    /// # Errors
    /// [`MassError`]: the mass is not positive and finite, the tensor not finite and positive definite, or a principal
    /// moment exceeds the sum of the other two by more than one part in 2^12.
    pub fn new(mass: S, inertia: SymMat3<S>) -> Result<Self, MassError> {
        if !(mass.is_finite() && mass > S::ZERO) {
            return Err(MassError::Mass);
        }
        let SymMat3 { xx, xy, xz, yy, yz, zz } = inertia;
        // Of unit size: the determinant is of the third power, and soon beyond a float.
        let size = power_near(xx.to_scaled().max(yy.to_scaled()).max(zz.to_scaled()));
        let tensor = [xx, xy, xz, yy, yz, zz].map(|x| x.to_scaled() / size);
        let inverse = inverse(tensor).ok_or(MassError::Inertia)?;
        if !obeys_triangle_inequality(tensor) {
            return Err(MassError::Triangle);
        }
        Self::from_inverse_tensor(S::Scaled::ONE / mass.to_scaled(), inverse.map(|x| x / size))
    }

    /// From the inverse mass and the inverse principal moments, for values that the format itself would not hold: a body
    /// of 1e-5 kg m^2, say, in Q16.16. Zero inverse moments lock the rotation about their axis.
    ///
    /// # Errors
    /// [`MassError`]: the inverse mass is not positive and finite, or an inverse moment negative or not finite.
    pub fn from_inverses(inv_mass: S::Scaled, inv_moments: [S::Scaled; 3]) -> Result<Self, MassError> {
        let [x, y, z] = inv_moments;
        let zero = S::Scaled::ZERO;
        if !(x >= zero && y >= zero && z >= zero) {
            return Err(MassError::Inertia);
        }
        Self::from_inverse_tensor(inv_mass, [x, zero, zero, y, zero, z])
    }

    fn from_inverse_tensor(inv_mass: S::Scaled, tensor: [S::Scaled; 6]) -> Result<Self, MassError> {
        if !(inv_mass.is_finite() && inv_mass > S::Scaled::ZERO) {
            return Err(MassError::Mass);
        }
        if tensor.iter().any(|x| !x.is_finite()) {
            return Err(MassError::Inertia);
        }
        let [xx, xy, xz, yy, yz, zz] = tensor;
        // A common power of two for all six: that of the trace, which bounds the tensor's norm in every frame.
        let trace = xx + yy + zz;
        let block = |x, y| {
            let ([x, y, _], exponent) = S::Scaled::align3([x, y, trace]);
            (x, y, exponent)
        };
        let ((xx, yy, exponent), (zz, xy, _), (xz, yz, _)) = (block(xx, yy), block(zz, xy), block(xz, yz));
        Ok(Self {
            inv_mass,
            inv_inertia: SymMat3 { xx, xy, xz, yy, yz, zz },
            exponent,
            gyration: gyration::<S>(tensor),
        })
    }

    /// The same mass with the rotation locked: infinite inertia about every axis.
    #[must_use]
    pub fn with_locked_rotation(self) -> Self {
        Self { inv_inertia: SymMat3::ZERO, gyration: Vec3::ZERO, ..self }
    }
}

/// (I_y - I_z)/I_x and so on, from the inverse moments; zero where the axes of the body are not principal ones, or an axis is
/// locked.
pub(crate) fn gyration<S: Scalar>([x, xy, xz, y, yz, z]: [S::Scaled; 6]) -> Vec3<S::Unit> {
    let zero = S::Scaled::ZERO;
    let principal = xy == zero && xz == zero && yz == zero;
    if !principal || x == zero || y == zero || z == zero {
        return Vec3::ZERO;
    }
    let ratio = |a: S::Scaled, b: S::Scaled, c: S::Scaled| S::Unit::from_scaled((c - b) / b * (a / c)).0;
    Vec3::new(ratio(x, y, z), ratio(y, z, x), ratio(z, x, y))
}

/// A power of two within a factor of two of a positive number.
fn power_near<T: Scaled>(x: T) -> T {
    let mut power = T::ONE;
    let mut exponent = 512;
    while exponent > 0 {
        let larger = power * T::from_parts(1, exponent);
        let smaller = power * T::from_parts(1, -exponent);
        if larger <= x {
            power = larger;
        } else if smaller >= x {
            power = smaller;
        }
        exponent /= 2;
    }
    power
}

/// The six numbers xx, xy, xz, yy, yz, zz of the inverse, by cofactors; `None` unless positive definite.
fn inverse<T: Scaled>([xx, xy, xz, yy, yz, zz]: [T; 6]) -> Option<[T; 6]> {
    let cofactors = [
        yy * zz - yz * yz,
        xz * yz - xy * zz,
        xy * yz - xz * yy,
        xx * zz - xz * xz,
        xy * xz - xx * yz,
        xx * yy - xy * xy,
    ];
    let determinant = xx * cofactors[0] + xy * cofactors[1] + xz * cofactors[2];
    // Sylvester: the leading minors. NaN fails every comparison.
    let definite = xx > T::ZERO && cofactors[5] > T::ZERO && determinant > T::ZERO && determinant.is_finite();
    definite.then(|| cofactors.map(|c| c / determinant))
}

/// No principal moment exceeds the sum of the other two: tr(I)/2 - I has no negative eigenvalue, which is the second
/// moment of mass along each direction. Allows one part in 2^12, for laminae and for rounded input.
fn obeys_triangle_inequality<T: Scaled>([xx, xy, xz, yy, yz, zz]: [T; 6]) -> bool {
    let half_trace = T::ratio(1, 2) * (xx + yy + zz);
    let tolerance = half_trace * T::from_parts(1, -12);
    let (a, d, f) = (half_trace - xx + tolerance, half_trace - yy + tolerance, half_trace - zz + tolerance);
    let (b, c, e) = (-xy, -xz, -yz);
    let determinant = a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d);
    a > T::ZERO && a * d - b * b >= T::ZERO && determinant >= T::ZERO
}
