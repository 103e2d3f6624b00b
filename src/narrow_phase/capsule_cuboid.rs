//! A capsule and a box: a point, or two where the capsule lies along a face.

use super::point_cuboid::nearest_face;
use super::segment::{Segment, cut};
use super::segment_cuboid::nearest;
use super::{Placed, cycled, point, uncycled};
use crate::manifold::Manifold;
use crate::math::{UnitVec3, Vec3, abs};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Closest, Cuboid};

/// A normal whose cosine with a face's lacks less than this power of two of one, 1.3 degrees, is taken for the face's.
const ALONG_FACE: u32 = 12;
/// A capsule whose axis leans less than this power of two out of a face, 3.6 degrees, lies along it.
const LYING: u32 = 4;

/// In the box's frame: the direction from the box to the core of the capsule, how far away that is (negative where the core
/// pierces the box), and the point of the core.
fn core<S: Scalar>(core: &Segment<S>, half: Vec3<S>) -> (Vec3<S::Unit>, S, Vec3<S>) {
    let near = nearest(core, half);
    if let Some((normal, height)) = near.direction(core.axis) {
        return (normal, height, near.point);
    }
    let (normal, height) = least_translation(core, half);
    // The end that is deepest in that direction.
    let rises = core.axis.dot(normal) > S::Unit::ZERO;
    (normal, height, core.at(if rises { core.half.negated() } else { core.half }))
}

/// Out of the box by the shortest way: across one of its faces, or across an edge and the core.
fn least_translation<S: Scalar>(core: &Segment<S>, half: Vec3<S>) -> (Vec3<S::Unit>, S) {
    let (c, u) = (core.middle, core.axis);
    let reach = Vec3::of_length(core.half, u.magnitudes());
    let (mut normal, mut best) = nearest_face(c, half + reach);
    let nil = S::Unit::ZERO;
    let crosses = [[nil, u.z.negated(), u.y], [u.z, nil, u.x.negated()], [u.y.negated(), u.x, nil]];
    for &across in &crosses {
        if S::Unit::dot3(across, across) <= S::Unit::ONE.lowered_by(20) {
            continue;
        }
        let Some((d, _)) = S::Unit::direction3(across) else { continue };
        let d = Vec3::from_array(d);
        let along = c.along(d);
        let height = abs(along).minus(half.along(d.magnitudes()));
        if height > best {
            (normal, best) = (if along < S::ZERO { S::opposite(&d) } else { d }, height);
        }
    }
    (normal, best)
}

/// The core in the box's frame, and the way from the capsule's origin to the box's.
#[inline(always)]
fn relative<S: Scalar>(
    (capsule, pose): Placed<'_, S, Capsule<S>>,
    (_, cuboid_pose): Placed<'_, S, Cuboid<S>>,
) -> (Segment<S>, Vec3<S>) {
    let d = cuboid_pose.position - pose.position;
    let [_, _, axis] = pose.rotation.columns();
    let axis = cuboid_pose.rotation.transposed().times(axis);
    (Segment { middle: -cuboid_pose.unrotate(d), axis, half: capsule.half_length() }, d)
}

pub(super) fn manifold<S: Scalar>(
    capsule: Placed<'_, S, Capsule<S>>,
    cuboid: Placed<'_, S, Cuboid<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    let (segment, d) = relative(capsule, cuboid);
    let (radius, half, pose) = (capsule.0.radius(), cuboid.0.half_extents(), cuboid.1);
    let (normal, height, place) = core(&segment, half);
    let separation = height.minus(radius);
    if separation > margin {
        return;
    }
    if abs(segment.axis.dot(normal)) <= S::Unit::ONE.lowered_by(LYING) {
        if let Some(face) = Face::along(normal) {
            lying(&segment, face, (capsule, cuboid), margin, out);
        }
    }
    if out.is_empty() {
        let down = S::opposite(&pose.rotation.times(normal));
        let r = pose.rotate(place) + d + Vec3::of_length(radius.plus(separation.lowered_by(1)), down);
        out.begin(down);
        out.push(point(r, d, separation, 0));
    }
}

/// The ends of the part of the capsule that lies over a face.
fn lying<S: Scalar>(
    segment: &Segment<S>,
    face: Face,
    (capsule, cuboid): (Placed<'_, S, Capsule<S>>, Placed<'_, S, Cuboid<S>>),
    margin: S,
    out: &mut Manifold<S>,
) {
    let (radius, half, pose) = (capsule.0.radius(), cuboid.0.half_extents(), cuboid.1);
    let Some([low, high]) = face.below(segment, half).filter(|[low, high]| low < high) else { return };
    let d = pose.position - capsule.1.position;
    let down = S::opposite(&pose.rotation.times(face.normal::<S>()));
    out.begin(down);
    for &(feature, s) in &[(1, low), (2, high)] {
        let end = segment.at(s);
        let separation = face.height(end, half).minus(radius);
        if separation <= margin {
            let r = pose.rotate(end) + d + Vec3::of_length(radius.plus(separation.lowered_by(1)), down);
            out.push(point(r, d, separation, feature));
        }
    }
}

pub(super) fn closest<S: Scalar>(capsule: Placed<'_, S, Capsule<S>>, cuboid: Placed<'_, S, Cuboid<S>>) -> Closest<S> {
    let (segment, d) = relative(capsule, cuboid);
    let (normal, height, place) = core(&segment, cuboid.0.half_extents());
    let down = S::opposite(&cuboid.1.rotation.times(normal));
    let from_a = cuboid.1.rotate(place) + d;
    Closest {
        normal: UnitVec3::from_unit(down),
        separation: height.minus(capsule.0.radius()),
        r_a: from_a + Vec3::of_length(capsule.0.radius(), down),
        r_b: from_a - d + Vec3::of_length(height, down),
    }
}

/// A face of a box: its axis, and on which side.
#[derive(Clone, Copy)]
struct Face {
    axis: u8,
    negative: bool,
}

impl Face {
    /// The face whose normal that direction is, or nearly.
    fn along<U: Scalar>(normal: Vec3<U>) -> Option<Self> {
        let least = U::ONE.minus(U::ONE.lowered_by(ALONG_FACE));
        let is_along = |x: U, axis: u8| if abs(x) >= least { Some(Self { axis, negative: x < U::ZERO }) } else { None };
        is_along(normal.x, 0).or_else(|| is_along(normal.y, 1)).or_else(|| is_along(normal.z, 2))
    }

    /// The components of a vector, with the one along the face's axis first.
    #[inline(always)]
    fn first<T: Copy>(self, v: Vec3<T>) -> Vec3<T> {
        cycled(v, self.axis)
    }

    fn normal<S: Scalar>(self) -> Vec3<S::Unit> {
        let one = if self.negative { S::Unit::ONE.negated() } else { S::Unit::ONE };
        let nil = S::Unit::ZERO;
        uncycled(Vec3::new(one, nil, nil), self.axis)
    }

    fn height<S: Scalar>(self, p: Vec3<S>, half: Vec3<S>) -> S {
        let x = self.first(p).x;
        (if self.negative { x.negated() } else { x }).minus(self.first(half).x)
    }

    /// The part of a segment that lies above or below the face.
    fn below<S: Scalar>(self, segment: &Segment<S>, half: Vec3<S>) -> Option<[S; 2]> {
        let (c, u, h) = (self.first(segment.middle), self.first(segment.axis), self.first(half));
        let mut range = [segment.half.negated(), segment.half];
        for &(c, u, h) in &[(c.y, u.y, h.y), (c.z, u.z, h.z)] {
            range = cut(range, h.minus(c), u)?;
            range = cut(range, h.plus(c), u.negated())?;
        }
        Some(range)
    }
}
