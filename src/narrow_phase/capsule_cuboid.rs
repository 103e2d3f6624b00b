//! A capsule and a box: a point, or two where the capsule lies along a face.

use super::point_cuboid::nearest_face;
use super::polytope::Plane;
use super::rod::{ALONG_FACE, Core, Rod};
use super::segment::{Segment, cut};
use super::segment_cuboid::nearest;
use super::{Placed, cycled, uncycled};
use crate::manifold::Manifold;
use crate::math::{Vec3, abs};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Closest, Cuboid};

fn core<S: Scalar>(core: &Segment<S>, half: Vec3<S>) -> Core<S> {
    let near = nearest(core, half);
    if let Some((normal, height)) = near.direction(core.axis) {
        return Core { normal, height, place: near.point };
    }
    let (normal, height) = least_translation(core, half);
    // The end that is deepest in that direction.
    let rises = core.axis.dot(normal) > S::Unit::ZERO;
    Core { normal, height, place: core.at(if rises { core.half.negated() } else { core.half }) }
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

pub(super) fn manifold<S: Scalar>(
    capsule: Placed<'_, S, Capsule<S>>,
    (cuboid, pose): Placed<'_, S, Cuboid<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    let (rod, half) = (Rod::new(capsule, pose), cuboid.half_extents());
    let over_face = |normal| {
        let face = Face::along(normal)?;
        let [low, high] = face.below(&rod.segment, half)?;
        if low < high { Some((face.plane(half), [low, high])) } else { None }
    };
    rod.manifold(core(&rod.segment, half), over_face, margin, out);
}

pub(super) fn closest<S: Scalar>(
    capsule: Placed<'_, S, Capsule<S>>,
    (cuboid, pose): Placed<'_, S, Cuboid<S>>,
) -> Closest<S> {
    let rod = Rod::new(capsule, pose);
    rod.closest(core(&rod.segment, cuboid.half_extents()))
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

    fn plane<S: Scalar>(self, half: Vec3<S>) -> Plane<S> {
        let one = if self.negative { S::Unit::ONE.negated() } else { S::Unit::ONE };
        let nil = S::Unit::ZERO;
        Plane { normal: uncycled(Vec3::new(one, nil, nil), self.axis), offset: self.first(half).x }
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
