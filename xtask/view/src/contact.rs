//! Where bodies touch. A trace says who pushed whom and how hard; the places follow from the poses, by carom's own geometry
//! in double precision.

use crate::trace::{Frame, Shape, Trace};
use carom::{Capsule, Collide, Cuboid, HalfSpace, Manifold, Pose, Quat, Sphere, UnitVec3, Vec3};

carom::shapes! { enum Piece<S> { Sphere, Cuboid, Capsule, HalfSpace } }

/// A pair that pushed, in the scene's units.
#[derive(Clone, Debug)]
pub struct Push {
    pub points: Vec<[f64; 3]>,
    /// The direction of the push on the one that gives way.
    pub direction: [f64; 3],
    pub impulse: f64,
    /// They met in this step.
    pub struck: bool,
}

fn vec3([x, y, z]: [f64; 3]) -> Vec3<f64> {
    Vec3::new(x, y, z)
}

/// The shape, for geometry. `None`: its numbers are no shape's.
fn piece(shape: &Shape) -> Option<Piece<f64>> {
    Some(match *shape {
        Shape::HalfSpace { normal } => HalfSpace::new(UnitVec3::normalize(vec3(normal)).ok()?).into(),
        Shape::Sphere { radius } => Sphere::new(radius).ok()?.into(),
        Shape::Cuboid { half } => Cuboid::new(vec3(half)).ok()?.into(),
        Shape::Capsule { radius, half_length } => Capsule::new(radius, half_length).ok()?.into(),
    })
}

fn pose(frame: &Frame, body: usize) -> Option<Pose<f64>> {
    let motion = frame.motions.get(body)?;
    let [w, x, y, z] = motion.orientation;
    Some(Pose::new(vec3(motion.position), Quat::normalize(w, x, y, z).ok()?))
}

/// What pushed in the step that led to frame `index`.
pub fn pushes(trace: &Trace, index: usize) -> Vec<Push> {
    let frame = &trace.frames[index];
    let before = &trace.frames[index.saturating_sub(1)];
    let touches = frame.touches.iter().filter(|touch| !touch.sensor && touch.impulse > 0.0);
    touches
        .filter_map(|touch| {
            // In a blow they have met and parted within the step: the nearer pose shows best where.
            let [first, second] = [before, frame].map(|frame| meet(trace, frame, touch.bodies));
            let (_, points, normal) = match (first?, second?) {
                (first, second) if first.0.abs() < second.0.abs() => first,
                (_, second) => second,
            };
            let onto_first = trace.bodies[touch.bodies[1]].is_fixed();
            let direction = if onto_first { normal.map(|part| -part) } else { normal };
            Some(Push { points, direction, impulse: touch.impulse, struck: touch.approach > 0.0 })
        })
        .collect()
}

/// The separation, the points, and the normal from the first to the second.
fn meet(trace: &Trace, frame: &Frame, [a, b]: [usize; 2]) -> Option<(f64, Vec<[f64; 3]>, [f64; 3])> {
    let (subject_a, subject_b) = (&trace.bodies[a], &trace.bodies[b]);
    let (shape_a, shape_b) = (piece(&subject_a.shape)?, piece(&subject_b.shape)?);
    let (pose_a, pose_b) = (pose(frame, a)?, pose(frame, b)?);
    let closest = shape_a.closest(&pose_a, &shape_b, &pose_b)?;
    // Points as near as a hundredth of the size bear as well.
    let margin = closest.separation.max(0.0) + 0.01 * subject_a.size().min(subject_b.size());
    let mut manifold = Manifold::empty(UnitVec3::Z);
    shape_a.collide(&pose_a, &shape_b, &pose_b, margin, &mut manifold);
    let middle = |r_a, r_b| ((pose_a.position + r_a + pose_b.position + r_b) * 0.5).to_array();
    let near = manifold.points().iter().filter(|point| point.separation <= margin);
    let mut points: Vec<_> = near.map(|point| middle(point.r_a, point.r_b)).collect();
    if points.is_empty() {
        points.push(middle(closest.r_a, closest.r_b));
    }
    Some((closest.separation, points, closest.normal.get().to_array()))
}
