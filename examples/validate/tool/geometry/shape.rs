//! Shapes on the host, in f64: what they are, how far they reach in a direction, and the same for the kernel.

use carom::{Capsule, Cuboid, HalfSpace, Pose, Quat, Sphere, UnitVec3, Vec3};

use crate::host::HostScalar;
use crate::tool::vector::{Matrix, Vector, add, dot, norm, rotation, scale};

carom::shapes! {
    /// A shape for the kernel.
    pub enum Solid<S> { Sphere, Cuboid, Capsule, HalfSpace }
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

    /// For the kernel; `None` where the format cannot hold it.
    pub fn for_kernel<S: HostScalar>(&self) -> Option<(Solid<S>, Pose<S>)> {
        let number = |x: f64| S::from_f64(x);
        let vector = |v: Vector| Some(Vec3::new(number(v[0])?, number(v[1])?, number(v[2])?));
        let solid: Solid<S> = match self.shape {
            Shape::Sphere { radius } => Sphere::new(number(radius)?).ok()?.into(),
            Shape::Box { half } => Cuboid::new(vector(half)?).ok()?.into(),
            Shape::Capsule { radius, half } => Capsule::new(number(radius)?, number(half)?).ok()?.into(),
            Shape::Plane => HalfSpace::new(UnitVec3::Z).into(),
        };
        let [w, x, y, z] = self.orientation.map(S::unit);
        let orientation = Quat::new(w, x, y, z).expect("the quaternion is of unit length");
        Some((solid, Pose::new(vector(self.position)?, orientation)))
    }
}

/// How far apart two shapes are along a direction from the first to the second; along the best of all directions, that is
/// their distance.
pub fn separation(shapes: &[Placed; 2], normal: Vector) -> f64 {
    -shapes[1].reach(scale(-1.0, normal)) - shapes[0].reach(normal)
}
