//! A cuboid and a half-space: the corners that are lowest.

use super::{Placed, above, point};
use crate::manifold::Manifold;
use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;
use crate::shape::{Closest, Cuboid, HalfSpace};

/// Half an edge in the world's axes, turned so that it leads down, and how far: not negative.
#[derive(Clone, Copy)]
struct HalfEdge<S> {
    down: Vec3<S>,
    drop: S,
    /// What the lower and the upper end add to a corner's number: a bit for the positive side of the axis.
    bits: [u16; 2],
}

impl<S: Scalar> HalfEdge<S> {
    #[inline(always)]
    fn new(half: S, axis: Vec3<S::Unit>, up: Vec3<S::Unit>, bit: u16) -> Self {
        let edge = Vec3::of_length(half, axis);
        let rise = half.times_unit(axis.dot(up));
        if rise < S::ZERO {
            Self { down: edge, drop: rise.negated(), bits: [bit, 0] }
        } else {
            Self { down: -edge, drop: rise, bits: [0, bit] }
        }
    }

    #[inline(always)]
    fn all((cuboid, pose): Placed<'_, S, Cuboid<S>>, up: Vec3<S::Unit>) -> [Self; 3] {
        let half = cuboid.half_extents();
        let [x, y, z] = pose.rotation.columns();
        [Self::new(half.x, x, up, 1), Self::new(half.y, y, up, 2), Self::new(half.z, z, up, 4)]
    }

    /// From the middle of the edge to its lower end.
    #[inline(always)]
    fn lower(&self, corner: Corner<S>) -> Corner<S> {
        let [bit, _] = self.bits;
        Corner { r: corner.r + self.down, height: corner.height.minus(self.drop), number: corner.number | bit }
    }

    /// From the middle of the edge to its upper end.
    #[inline(always)]
    fn upper(&self, corner: Corner<S>) -> Corner<S> {
        let [_, bit] = self.bits;
        Corner { r: corner.r - self.down, height: corner.height.plus(self.drop), number: corner.number | bit }
    }
}

/// A point of the cuboid, as far as its corner's number is known.
#[derive(Clone, Copy)]
struct Corner<S> {
    r: Vec3<S>,
    height: S,
    number: u16,
}

/// Of the four lowest corners, those within `margin`: the lowest one, and what is reached from it along the two edges that
/// rise least.
pub(super) fn manifold<S: Scalar>(
    cuboid: Placed<'_, S, Cuboid<S>>,
    plane: Placed<'_, S, HalfSpace<S>>,
    margin: S,
    out: &mut Manifold<S>,
) {
    let (up, height, d) = above(cuboid.1, plane);
    let [mut i, mut j, mut k] = HalfEdge::all(cuboid, up);
    if height.minus(i.drop).minus(j.drop).minus(k.drop) > margin {
        return;
    }
    // The steepest last: its upper end is left out.
    if i.drop > k.drop {
        (i, k) = (k, i);
    }
    if j.drop > k.drop {
        (j, k) = (k, j);
    }
    let down = S::opposite(&up);
    out.begin(down);
    let face = k.lower(Corner { r: Vec3::ZERO, height, number: 0 });
    let (low, high) = (i.lower(face), i.upper(face));
    for corner in &[j.lower(low), j.lower(high), j.upper(high), j.upper(low)] {
        if corner.height <= margin {
            let r = corner.r + Vec3::of_length(corner.height.lowered_by(1), down);
            out.push(point(r, d, corner.height, corner.number));
        }
    }
}

pub(super) fn closest<S: Scalar>(cuboid: Placed<'_, S, Cuboid<S>>, plane: Placed<'_, S, HalfSpace<S>>) -> Closest<S> {
    let (up, height, d) = above(cuboid.1, plane);
    let [i, j, k] = HalfEdge::all(cuboid, up);
    let corner = i.lower(j.lower(k.lower(Corner { r: Vec3::ZERO, height, number: 0 })));
    let down = S::opposite(&up);
    let r_b = corner.r + Vec3::of_length(corner.height, down) - d;
    Closest { normal: UnitVec3::from_unit(down), separation: corner.height, r_a: corner.r, r_b }
}
