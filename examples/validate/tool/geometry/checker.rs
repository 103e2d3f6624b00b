//! Asks the kernel for the distance of pair after pair, and keeps what is to be said about them.

use carom::{Collide, Manifold, Pose, UnitVec3, Vec3};

use super::shape::{Placed, Solid, separation};
use crate::host::HostScalar;
use crate::tool::checker::{Failure, Sample};
use crate::tool::errors::{Errors, Quantity};
use crate::tool::vector::{Vector, norm, scale, sub};

/// Two shapes and what is known of them.
#[derive(Clone, Debug)]
pub struct Pair {
    pub id: String,
    pub shapes: [Placed; 2],
    pub distance: f64,
    pub normal: Vector,
}

/// What the kernel made of a pair.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    pub distance: f64,
    pub normal: Vector,
    /// The least separation of the points of contact, where there are any.
    pub contact: Option<f64>,
}

/// What is asked for a pair: in the kernel's own format and units.
pub type Kernel<S> = fn([(Solid<'_, S>, Pose<S>); 2]) -> Option<Found>;

/// The kernel as it is.
pub fn kernel<S: HostScalar>([(a, pose_a), (b, pose_b)]: [(Solid<'_, S>, Pose<S>); 2]) -> Option<Found> {
    let closest = a.closest(&pose_a, &b, &pose_b)?;
    let mut manifold = Manifold::empty(UnitVec3::Z);
    a.collide(&pose_a, &b, &pose_b, S::ZERO, &mut manifold);
    let separations = manifold.points().iter().map(|point| point.separation.to_f64());
    let Vec3 { x, y, z } = closest.normal.get();
    Some(Found {
        distance: closest.separation.to_f64(),
        normal: [x, y, z].map(S::unit_to_f64),
        contact: separations.reduce(f64::min),
    })
}

/// All about the pairs so far, in one number type.
pub struct Checker<S: HostScalar> {
    kernel: Kernel<S>,
    /// Which of the two shapes are computed as others that are equal to them.
    disguised: [bool; 2],
    /// The rows are made that much smaller, and computed in units of that length.
    shrink: f64,
    unit: f64,
    pub rows: usize,
    pub samples: Vec<Sample>,
    pub not_representable: usize,
    /// Rows with more than one right normal, of which the kernel chose another than the file.
    pub tied: Vec<String>,
    pub failures: Vec<Failure>,
}

/// Normals farther apart than this are not the same one with an error.
const ANOTHER: f64 = 1e-3;
/// A normal along which the shapes are apart by the distance, to within this, is as right as the file's: the distance is the
/// largest separation along any direction. In units of the spacing of numbers near one, or where that is more, of 1e-6.
const AS_GOOD: f64 = 4.0;

impl<S: HostScalar> Checker<S> {
    pub fn new(kernel: Kernel<S>, disguised: [bool; 2], shrink: f64, unit: f64) -> Self {
        Self {
            kernel,
            disguised,
            shrink,
            unit,
            rows: 0,
            samples: vec![],
            not_representable: 0,
            tied: vec![],
            failures: vec![],
        }
    }

    /// What the kernel makes of the pair, in the size of the file; `None` where the format cannot hold it.
    pub fn check(&mut self, pair: &Pair) -> Option<Found> {
        self.rows += 1;
        let scale_to = self.shrink / self.unit;
        let shapes = pair.shapes.map(|placed| placed.scaled(scale_to));
        let disguises = [0, 1].map(|k| if self.disguised[k] { shapes[k].disguise::<S>(4.0 * scale_to) } else { None });
        let [a, b] = [0, 1].map(|k| shapes[k].for_kernel(disguises[k].as_ref()));
        let unfit = (0..2).any(|k| self.disguised[k] && disguises[k].is_none());
        let (Some(a), Some(b), false) = (a, b, unfit) else {
            self.not_representable += 1;
            return None;
        };
        let Some(found) = (self.kernel)([a, b]) else {
            self.failures.push(Failure { id: pair.id.clone(), reason: "no distance" });
            return None;
        };
        let found =
            Found { distance: found.distance / scale_to, contact: found.contact.map(|x| x / scale_to), ..found };
        if !found.distance.is_finite() || (norm(found.normal) - 1.0).abs() > 1e-5 {
            self.failures
                .push(Failure { id: pair.id.clone(), reason: "the normal is not of unit length, or not finite" });
            return Some(found);
        }
        self.judge(pair, &found, S::spacing(1.0) / scale_to);
        Some(found)
    }

    fn judge(&mut self, pair: &Pair, found: &Found, spacing: f64) {
        let mut errors = Errors::none();
        errors.set(Quantity::Distance, (found.distance - pair.distance).abs());
        let away = norm(sub(found.normal, pair.normal));
        let as_good = f64::max(AS_GOOD * spacing, 1e-6);
        let n = scale(1.0 / norm(found.normal), found.normal);
        let is_right = |n| separation(&pair.shapes, n) >= pair.distance - as_good;
        if away > ANOTHER && is_right(n) && is_right(pair.normal) {
            self.tied.push(format!("{} ({:.1e})", pair.id, away));
        } else {
            errors.set(Quantity::Normal, away);
        }
        if let Some(contact) = found.contact {
            errors.set(Quantity::Contact, (contact - pair.distance).abs());
        }
        let [a, b] = &pair.shapes;
        let category = format!("{}-{}", a.shape.name(), b.shape.name());
        self.samples.push(Sample { id: pair.id.clone(), category, suits_q16: true, errors });
    }
}
