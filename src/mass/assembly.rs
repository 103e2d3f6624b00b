//! Several solids as one body: its mass, its centre and its principal axes.

use super::{MassProperties, Solid, have_all_digits};
use crate::error::MassError;
use crate::math::{Mat3, Pose, Vec3};
use crate::scalar::{Scalar, Scaled};

/// Off the diagonal of a tensor, what is below this many roundings of its trace is nothing.
const NOISE: i32 = 8;
/// Turns of Jacobi's method, three to a sweep. It converges quadratically: four sweeps find all digits, five are enough.
const TURNS: u32 = 15;

/// A solid with its mass, and where it sits on a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidPart<S: Scalar> {
    /// In any frame of the body, the same for all its parts.
    pub pose: Pose<S>,
    mass: S::Scaled,
    /// Per unit of mass.
    moments: [S::Scaled; 3],
}

impl<S: Scalar> SolidPart<S> {
    /// The solid with a given mass; sizes and errors as of [`Solid::with_mass`].
    ///
    /// # Errors
    /// [`MassError::Mass`].
    pub fn with_mass(solid: &Solid<S>, mass: S, pose: Pose<S>) -> Result<Self, MassError> {
        solid.with_mass(mass)?;
        Ok(Self { pose, mass: mass.to_scaled(), moments: solid.moments() })
    }

    /// The solid with a given density; sizes and errors as of [`Solid::with_density`].
    ///
    /// # Errors
    /// [`MassError::Density`].
    pub fn with_density(solid: &Solid<S>, density: S, pose: Pose<S>) -> Result<Self, MassError> {
        solid.with_density(density)?;
        Ok(Self { pose, mass: density.to_scaled() * solid.measure(), moments: solid.moments() })
    }
}

/// A body of several solids. Where they overlap, both weigh.
///
/// Its frame has the centre of mass as the origin and the principal axes of inertia as its axes: the body's own frame, in which
/// the parts of its shape have to be given ([`Part::seen_from`](crate::Part::seen_from)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assembly<S: Scalar> {
    /// Mass and principal moments.
    pub mass_properties: MassProperties<S>,
    /// The body's frame in that of the parts. Its axes are those of the parts' frame where these are principal axes already.
    pub frame: Pose<S>,
}

impl<S: Scalar> Assembly<S> {
    /// Adds up masses and, by Steiner's theorem, moments of inertia about the common centre; then turns to the principal axes.
    ///
    /// The centre is rounded to the format, and the moments are those about the rounded one.
    ///
    /// # Errors
    /// [`MassError::Mass`] where there is no part, or in floating point where the sums, or the inverse moments, leave the range
    /// of normal numbers. [`MassError::Inertia`] where a pose is not finite.
    pub fn new(parts: &[SolidPart<S>]) -> Result<Self, MassError> {
        if parts.iter().any(|part| !part.pose.is_finite()) {
            return Err(MassError::Inertia);
        }
        let zero = S::Scaled::ZERO;
        let (mut mass, mut moment) = (zero, [zero; 3]);
        for part in parts {
            mass = mass + part.mass;
            moment = plus(moment, scaled(part.pose.position).map(|x| part.mass * x));
        }
        if !mass.is_positive() {
            return Err(MassError::Mass);
        }
        let [x, y, z] = moment.map(|x| S::from_scaled(x / mass).0);
        let centre = Vec3::new(x, y, z);
        let mut tensor = Tensor::ZERO;
        for part in parts {
            tensor.add(part, centre);
        }
        let (moments, rotation) = tensor.principal::<S>();
        let (inv_mass, inverses) = (S::Scaled::ONE / mass, moments.map(|moment| S::Scaled::ONE / moment));
        if !(have_all_digits([mass, inv_mass, mass]) && have_all_digits(moments) && have_all_digits(inverses)) {
            return Err(MassError::Mass);
        }
        let mass_properties = MassProperties::from_inverses(inv_mass, inverses)?;
        Ok(Self { mass_properties, frame: Pose { position: centre, rotation } })
    }
}

type Vector<T> = [T; 3];

fn scaled<S: Scalar>(v: Vec3<S>) -> Vector<S::Scaled> {
    v.to_array().map(S::to_scaled)
}

fn plus<T: Scaled>([a, b, c]: Vector<T>, [x, y, z]: Vector<T>) -> Vector<T> {
    [a + x, b + y, c + z]
}

fn magnitude<T: Scaled>(x: T) -> T {
    x.max(-x)
}

/// A symmetric tensor: its diagonal, and yz, zx, xy.
#[derive(Clone, Copy)]
struct Tensor<T> {
    diagonal: Vector<T>,
    off: Vector<T>,
}

impl<T: Scaled> Tensor<T> {
    const ZERO: Self = Self { diagonal: [T::ZERO; 3], off: [T::ZERO; 3] };

    /// Adds a solid's R diag(I) R^T + m (d^2 1 - d d^T), for the way d from the centre to it.
    fn add<S: Scalar<Scaled = T>>(&mut self, part: &SolidPart<S>, centre: Vec3<S>) {
        let m = part.mass;
        let [x, y, z] = scaled(part.pose.position - centre);
        self.diagonal = plus(self.diagonal, [m * (y * y + z * z), m * (z * z + x * x), m * (x * x + y * y)]);
        self.off = plus(self.off, [-(m * y * z), -(m * z * x), -(m * x * y)]);
        let [x, y, z] = part.pose.rotation.rows.map(|row| row.to_array().map(S::Unit::to_scaled));
        let [i, j, k] = part.moments.map(|moment| m * moment);
        let entry = |a: Vector<T>, b: Vector<T>| i * a[0] * b[0] + j * a[1] * b[1] + k * a[2] * b[2];
        self.diagonal = plus(self.diagonal, [entry(x, x), entry(y, y), entry(z, z)]);
        self.off = plus(self.off, [entry(y, z), entry(z, x), entry(x, y)]);
    }

    /// The second axis first.
    fn cycled(&self) -> Self {
        let ([x, y, z], [a, b, c]) = (self.diagonal, self.off);
        Self { diagonal: [y, z, x], off: [b, c, a] }
    }

    /// The principal moments, and the rotation from the principal axes: by Jacobi's method, which turns about the third axis to
    /// make xy zero, then about the next.
    fn principal<S: Scalar<Scaled = T>>(mut self) -> (Vector<T>, Mat3<S::Unit>) {
        let [x, y, z] = self.diagonal;
        let nothing = T::from_parts(NOISE, 0) * T::EPSILON * (x + y + z);
        let (one, nil) = (T::ONE, T::ZERO);
        let mut axes = [[one, nil, nil], [nil, one, nil], [nil, nil, one]];
        let mut turned = false;
        for _ in 0..TURNS {
            let ([x, y, z], [yz, zx, xy]) = (self.diagonal, self.off);
            if magnitude(xy) > nothing {
                turned = true;
                let slope = (y - x) / (T::from_parts(2, 0) * xy);
                let tangent = T::ONE / (magnitude(slope) + (slope * slope + T::ONE).sqrt());
                let t = if slope < T::ZERO { -tangent } else { tangent };
                let c = T::ONE / (t * t + T::ONE).sqrt();
                let s = t * c;
                self.diagonal = [x - t * xy, y + t * xy, z];
                self.off = [s * zx + c * yz, c * zx - s * yz, T::ZERO];
                let [i, j, k] = axes;
                axes = [plus(i.map(|x| c * x), j.map(|x| -(s * x))), plus(i.map(|x| s * x), j.map(|x| c * x)), k];
            }
            self = self.cycled();
            let [i, j, k] = axes;
            axes = [j, k, i];
        }
        let rotation = if turned { rotation::<S>(axes) } else { Mat3::IDENTITY };
        (self.diagonal, rotation)
    }
}

/// The rotation to which those axes are the columns, of unit length and across each other to the last places.
fn rotation<S: Scalar>([i, j, _]: [Vector<S::Scaled>; 3]) -> Mat3<S::Unit> {
    let unit = |v: Vector<S::Scaled>| {
        let v = v.map(|x| S::Unit::from_scaled(x).0);
        Vec3::from_array(S::Unit::normalize3(v).unwrap_or(v))
    };
    let (x, y) = (unit(i), unit(j));
    Mat3 { rows: [x, y, x.cross(y)] }.transposed()
}
