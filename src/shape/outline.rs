//! What shapes look like, told to whoever draws them.

use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;

/// What takes the outlines of shapes, in the world's frame: something that draws, or measures.
pub trait OutlineSink<S: Scalar> {
    /// A flat convex face of something solid: its corners, up to [`MAX_FACE_CORNERS`](crate::MAX_FACE_CORNERS), counter-clockwise
    /// seen from outside.
    fn face(&mut self, corners: &[Vec3<S>]);

    /// A line on a surface.
    fn segment(&mut self, ends: [Vec3<S>; 2]);

    /// All within a radius of a segment: a ball, where both ends are the same point.
    fn rod(&mut self, ends: [Vec3<S>; 2], radius: S);

    /// All behind a plane through that point, whose normal points out of it.
    fn plane(&mut self, point: Vec3<S>, normal: UnitVec3<S>);
}
