//! Shapes on the host, in f64: what they are, how far they reach in a direction, and the same for the kernel.

use carom::{Capsule, ConvexHull, Cuboid, HalfSpace, HeightField, Pose, Quat, Sphere, UnitVec3, Vec3};

use crate::host::HostScalar;
use crate::tool::vector::{Matrix, Vector, add, dot, norm, rotation, scale};

carom::shapes! {
    /// A shape for the kernel.
    pub enum Solid<'a, S> { Sphere, Cuboid, Capsule, HalfSpace, Hull(&'a ConvexHull<S, 8>), HeightField(HeightField<'a, S>) }
}

/// What shapes that are references refer to: a box as the hull of its eight corners, a half-space as a flat height field.
pub enum Disguise<S: HostScalar> {
    None,
    Hull(ConvexHull<S, 8>),
    Field { heights: [S; 81], spacing: S },
}

/// A shape around the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    Sphere {
        radius: f64,
    },
    Box {
        half: Vector,
    },
    /// Along the third axis.
    Capsule {
        radius: f64,
        half: f64,
    },
    /// What is below the plane through the origin across the third axis.
    Plane,
}

/// A shape where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    pub shape: Shape,
    pub position: Vector,
    pub orientation: [f64; 4],
}

impl Shape {
    pub fn name(&self) -> &'static str {
        match self {
            Self::Sphere { .. } => "sphere",
            Self::Box { .. } => "box",
            Self::Capsule { .. } => "capsule",
            Self::Plane => "plane",
        }
    }

    pub fn sizes(&self) -> Vec<f64> {
        match *self {
            Self::Sphere { radius } => vec![radius],
            Self::Box { half } => half.to_vec(),
            Self::Capsule { radius, half } => vec![radius, half],
            Self::Plane => vec![],
        }
    }

    fn scaled(&self, factor: f64) -> Self {
        match *self {
            Self::Sphere { radius } => Self::Sphere { radius: factor * radius },
            Self::Box { half } => Self::Box { half: scale(factor, half) },
            Self::Capsule { radius, half } => Self::Capsule { radius: factor * radius, half: factor * half },
            Self::Plane => Self::Plane,
        }
    }
}

impl Placed {
    pub fn scaled(&self, factor: f64) -> Self {
        Self { shape: self.shape.scaled(factor), position: scale(factor, self.position), ..*self }
    }

    fn axes(&self) -> Matrix {
        let r = rotation(self.orientation);
        [0, 1, 2].map(|k| [r[0][k], r[1][k], r[2][k]])
    }

    /// How far it reaches in a direction: without end where a plane is not across it.
    pub fn reach(&self, n: Vector) -> f64 {
        let [x, y, z] = self.axes();
        let beyond = match self.shape {
            Shape::Sphere { radius } => radius * norm(n),
            Shape::Box { half } => half[0] * dot(x, n).abs() + half[1] * dot(y, n).abs() + half[2] * dot(z, n).abs(),
            Shape::Capsule { radius, half } => radius * norm(n) + half * dot(z, n).abs(),
            Shape::Plane if norm(add(n, scale(-dot(n, z), z))) < 1e-3 && dot(n, z) > 0.0 => 0.0,
            Shape::Plane => f64::INFINITY,
        };
        dot(self.position, n) + beyond
    }

    /// The same as another shape; `None` where the format cannot hold it.
    ///
    /// A field reaches `far` to each side.
    pub fn disguise<S: HostScalar>(&self, far: f64) -> Option<Disguise<S>> {
        let half = match self.shape {
            Shape::Box { half } => half,
            Shape::Plane => return Some(Disguise::Field { heights: [S::ZERO; 81], spacing: S::from_f64(far / 4.0)? }),
            _ => return Some(Disguise::None),
        };
        let mut corners = [Vec3::ZERO; 8];
        for (index, corner) in corners.iter_mut().enumerate() {
            let signs = [0, 1, 2].map(|axis| if index >> axis & 1 == 1 { -1.0 } else { 1.0 });
            *corner = vector([0, 1, 2].map(|axis| signs[axis] * half[axis]))?;
        }
        Some(Disguise::Hull(ConvexHull::new(&corners).ok()?))
    }

    /// For the kernel, in a disguise if there is one for the shape; `None` where the format cannot hold it.
    pub fn for_kernel<'a, S: HostScalar>(&self, disguise: Option<&'a Disguise<S>>) -> Option<(Solid<'a, S>, Pose<S>)> {
        let number = |x: f64| S::from_f64(x);
        let solid: Solid<'a, S> = match (self.shape, disguise) {
            (Shape::Box { .. }, Some(Disguise::Hull(hull))) => hull.into(),
            (Shape::Plane, Some(Disguise::Field { heights, spacing })) => {
                HeightField::new(heights, 9, 9, *spacing).ok()?.into()
            }
            (Shape::Sphere { radius }, _) => Sphere::new(number(radius)?).ok()?.into(),
            (Shape::Box { half }, _) => Cuboid::new(vector(half)?).ok()?.into(),
            (Shape::Capsule { radius, half }, _) => Capsule::new(number(radius)?, number(half)?).ok()?.into(),
            (Shape::Plane, _) => HalfSpace::new(UnitVec3::Z).into(),
        };
        let [w, x, y, z] = self.orientation.map(S::unit);
        let orientation = Quat::new(w, x, y, z).expect("the quaternion is of unit length");
        Some((solid, Pose::new(vector(self.position)?, orientation)))
    }
}

fn vector<S: HostScalar>(v: Vector) -> Option<Vec3<S>> {
    Some(Vec3::new(S::from_f64(v[0])?, S::from_f64(v[1])?, S::from_f64(v[2])?))
}

/// How far apart two shapes are along a direction from the first to the second; along the best of all directions, that is
/// their distance.
pub fn separation(shapes: &[Placed; 2], normal: Vector) -> f64 {
    -shapes[1].reach(scale(-1.0, normal)) - shapes[0].reach(normal)
}
