//! The convex hull of some points.

use heapless::Vec;

use crate::aabb::Aabb;
use crate::error::HullError;
use crate::math::{Pose, Vec3, max, min};
use crate::query::{self, Ray, RayHit, SurfacePoint};
use crate::scalar::Scalar;
use crate::shape::{OutlineSink, Shape};

mod build;

/// The most corners that a face of a hull may have.
pub const MAX_FACE_CORNERS: usize = 12;
/// The most corners that a hull may have, whatever there is room for: they are counted in the bits of a number.
pub const MAX_CORNERS: usize = 32;

/// A convex polytope of up to `N` corners, 4 to [`MAX_CORNERS`]: a die, a wedge, a gem.
///
/// It is made once, in memory of its own, and a shape is a reference to it, `&ConvexHull<S, N>`: many bodies share one. By
/// Euler's formula N corners make at most 2 N faces and 3 N edges; with all of them it takes about 110 N bytes.
///
/// The origin of its frame is that of the points: for a body, the centre of mass.
#[derive(Clone, Debug, PartialEq)]
pub struct ConvexHull<S: Scalar, const N: usize> {
    corners: [Vec3<S>; N],
    faces: [[Face<S>; 2]; N],
    edges: [[Edge<S>; 3]; N],
    /// The corners of all faces, one after the other, counter-clockwise seen from outside.
    rings: [[u8; 6]; N],
    corner_count: u8,
    face_count: u8,
    edge_count: u8,
    /// Of a ball around the origin in the hull, and of one that holds the hull.
    radii: [S; 2],
}

/// A face by its plane and its ring of corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Face<S: Scalar> {
    /// Out of the hull.
    pub normal: Vec3<S::Unit>,
    /// How far the plane is from the origin along the normal.
    pub offset: S,
    first: u8,
    len: u8,
}

/// An edge between two corners, and the faces on its left and on its right, seen from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Edge<S: Scalar> {
    pub direction: Vec3<S::Unit>,
    pub ends: [u8; 2],
    pub sides: [u8; 2],
}

impl<S: Scalar, const N: usize> ConvexHull<S, N> {
    /// The hull of these points, m. Those that are no corner of it are left out. Takes time that grows with the fourth power of
    /// their number.
    ///
    /// Points are taken to lie in one face where they do to within a 2048th of the hull's size.
    ///
    /// # Errors
    /// [`HullError`] says what is wrong with the points.
    pub fn new(points: &[Vec3<S>]) -> Result<Self, HullError> {
        build::hull(points)
    }

    /// The corners, m.
    pub fn corners(&self) -> &[Vec3<S>] {
        self.corners.get(..usize::from(self.corner_count)).unwrap_or(&[])
    }

    #[inline(always)]
    pub(crate) fn faces(&self) -> &[Face<S>] {
        self.faces.as_flattened().get(..usize::from(self.face_count)).unwrap_or(&[])
    }

    #[inline(always)]
    pub(crate) fn edges(&self) -> &[Edge<S>] {
        self.edges.as_flattened().get(..usize::from(self.edge_count)).unwrap_or(&[])
    }

    /// The numbers of a face's corners.
    #[inline(always)]
    pub(crate) fn ring(&self, face: &Face<S>) -> &[u8] {
        let first = usize::from(face.first);
        self.rings.as_flattened().get(first..first.wrapping_add(usize::from(face.len))).unwrap_or(&[])
    }
}

impl<S: Scalar, const N: usize> Shape<S> for &ConvexHull<S, N> {
    fn aabb(&self, pose: &Pose<S>) -> Aabb<S> {
        let far = Vec3::new(S::LARGEST, S::LARGEST, S::LARGEST);
        let (mut low, mut high) = (far, -far);
        for &corner in self.corners() {
            let r = pose.rotate(corner);
            low = Vec3::new(min(low.x, r.x), min(low.y, r.y), min(low.z, r.z));
            high = Vec3::new(max(high.x, r.x), max(high.y, r.y), max(high.z, r.z));
        }
        Aabb { min: pose.position + low, max: pose.position + high }
    }

    /// Of a ball around the origin of the frame; zero where that is outside.
    #[inline(always)]
    fn inner_radius(&self) -> S {
        self.radii[0]
    }

    #[inline(always)]
    fn outer_radius(&self) -> S {
        self.radii[1]
    }

    #[inline]
    fn cast_ray(&self, pose: &Pose<S>, ray: &Ray<S>) -> Option<RayHit<S>> {
        query::cast(*self, pose, ray)
    }

    #[inline]
    fn closest_point(&self, pose: &Pose<S>, point: Vec3<S>) -> Option<SurfacePoint<S>> {
        query::closest_point(self, pose, point)
    }

    fn outline<K: OutlineSink<S>>(&self, pose: &Pose<S>, sink: &mut K) {
        for face in self.faces() {
            let corners = self.ring(face).iter().filter_map(|number| self.corners.get(usize::from(*number)));
            let mut ring = Vec::<Vec3<S>, MAX_FACE_CORNERS>::new();
            for &corner in corners {
                // There is room for as many as a face may have.
                let _ = ring.push(pose.to_world(corner));
            }
            sink.face(&ring);
        }
    }
}
