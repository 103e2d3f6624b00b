//! The distance of two polytopes: apart, they are closest at two edges, or at a corner of one over a face of the other.

use super::super::noise;
use super::super::polytope::{Edge, Polytope};
use super::super::segment::{Segment, between};
use super::{Axis, Placed, Relative, separating_axis};
use crate::math::{UnitVec3, Vec3, abs};
use crate::scalar::Scalar;
use crate::shape::Closest;

pub fn closest<S: Scalar, A: Polytope<S>, B: Polytope<S>>(
    (a, pose_a): Placed<'_, S, A>,
    (b, pose_b): Placed<'_, S, B>,
) -> Closest<S> {
    let relative = Relative::new(pose_a, pose_b);
    let found = match separating_axis(a, b, &relative, S::ZERO, S::ZERO) {
        Some((axis, separation)) => overlapping(a, b, &relative, axis, separation),
        None => apart(a, b, &relative),
    };
    let (normal, r_a) = (pose_a.rotation.times(found.normal), pose_a.rotate(found.from_a));
    Closest {
        normal: UnitVec3::from_unit(normal),
        separation: found.separation,
        r_a,
        r_b: r_a + Vec3::of_length(found.separation, normal) - relative.d,
    }
}

/// In A's frame: the normal, the separation, and the point of A.
#[derive(Clone, Copy)]
struct Found<S: Scalar> {
    normal: Vec3<S::Unit>,
    separation: S,
    from_a: Vec3<S>,
}

impl<S: Scalar> Found<S> {
    /// Seen from the other polytope.
    fn reversed(self, relative: &Relative<S>) -> Self {
        let from_b = self.from_a + Vec3::of_length(self.separation, self.normal);
        Self {
            normal: S::opposite(&relative.rotation.times(self.normal)),
            separation: self.separation,
            from_a: relative.in_a + from_b.through(relative.rotation.rows),
        }
    }
}

fn lowest_corner<S: Scalar>(polytope: &impl Polytope<S>, direction: Vec3<S::Unit>) -> Vec3<S> {
    let (mut best, mut lowest, mut index) = (Vec3::ZERO, S::LARGEST, 0);
    while let Some(corner) = polytope.corner(index) {
        let along = corner.along(direction);
        if along < lowest {
            (best, lowest) = (corner, along);
        }
        index = index.wrapping_add(1);
    }
    best
}

fn overlapping<S: Scalar>(
    a: &impl Polytope<S>,
    b: &impl Polytope<S>,
    relative: &Relative<S>,
    axis: Axis<S>,
    separation: S,
) -> Found<S> {
    let of_face = |plane: Vec3<S::Unit>, corner: Vec3<S>, relative: &Relative<S>| {
        let from_b = relative.in_a + corner.through(relative.rotation.rows);
        Found { normal: plane, separation, from_a: from_b - Vec3::of_length(separation, plane) }
    };
    let found = match axis {
        Axis::FaceOfA(face) => a
            .face(face)
            .map(|plane| of_face(plane.normal, lowest_corner(b, relative.back.times(plane.normal)), relative)),
        Axis::FaceOfB(face) => b.face(face).map(|plane| {
            let corner = lowest_corner(a, relative.rotation.times(plane.normal));
            of_face(plane.normal, corner, &relative.reversed()).reversed(relative)
        }),
        Axis::Edges(i, j, normal) => a.edge(i).zip(b.edge(j)).map(|(of_a, of_b)| {
            let (of_a, of_b) = (of_a.segment(), relative.edge(&of_b).segment());
            let [s, _] = of_a.closest(&of_b);
            Found { normal, separation, from_a: of_a.at(s) }
        }),
    };
    found.unwrap_or(Found { normal: UnitVec3::<S>::Z.get(), separation, from_a: Vec3::ZERO })
}

fn apart<S: Scalar>(a: &impl Polytope<S>, b: &impl Polytope<S>, relative: &Relative<S>) -> Found<S> {
    let nowhere = Found { normal: UnitVec3::<S>::Z.get(), separation: S::LARGEST, from_a: Vec3::ZERO };
    let mut over_faces = corners_over_faces(a, b, relative, nowhere);
    let reversed = relative.reversed();
    let of_b = corners_over_faces(b, a, &reversed, nowhere);
    if of_b.separation < over_faces.separation {
        over_faces = of_b.reversed(relative);
    }
    // Two edges between their ends, one of them at an end, both.
    let [mut crossing, mut passing, mut corners] = [nowhere; 3];
    let mut j = 0;
    while let Some(of_b) = b.edge(j) {
        let of_b = relative.edge(&of_b).segment();
        let mut i = 0;
        while let Some(of_a) = a.edge(i) {
            if let Some((found, ends)) = of_edges(&of_a, &of_b) {
                let best = match ends {
                    0 => &mut crossing,
                    1 => &mut passing,
                    _ => &mut corners,
                };
                if found.separation < best.separation {
                    *best = found;
                }
            }
            i = i.wrapping_add(1);
        }
        j = j.wrapping_add(1);
    }
    // Near the ends of an edge several are equally far to all digits, and what lies between its ends is right.
    let mut best = corners;
    for &other in &[passing, crossing, over_faces] {
        if other.separation <= best.separation.plus(noise(best.separation)) {
            best = other;
        }
    }
    best
}

/// The corners of B that are over a face of A.
#[inline(never)]
fn corners_over_faces<S: Scalar>(
    a: &impl Polytope<S>,
    b: &impl Polytope<S>,
    relative: &Relative<S>,
    nowhere: Found<S>,
) -> Found<S> {
    let (mut best, mut index) = (nowhere, 0);
    while let Some(corner) = b.corner(index) {
        let corner = relative.in_a + corner.through(relative.rotation.rows);
        let (face, height) = a.highest_above(corner);
        if let Some(plane) = a.face(face).filter(|_| height < best.separation) {
            // The nearest point of a convex polytope lies in this face, if it is in a face at all.
            if a.is_over(face, &plane, corner) {
                let from_a = corner - Vec3::of_length(height, plane.normal);
                best = Found { normal: plane.normal, separation: height, from_a };
            }
        }
        index = index.wrapping_add(1);
    }
    best
}

/// Where two edges are closest, and of how many of them that is an end.
#[inline(never)]
fn of_edges<S: Scalar>(of_a: &Edge<S>, of_b: &Segment<S>) -> Option<(Found<S>, u8)> {
    let of_a = of_a.segment();
    let [s, t] = of_a.closest(of_b);
    let (normal, separation) = between(&of_a, of_b, [s, t])?;
    let ends = u8::from(abs(s) >= of_a.half).wrapping_add(u8::from(abs(t) >= of_b.half));
    Some((Found { normal, separation, from_a: of_a.at(s) }, ends))
}
