//! What spheres and capsules share: two points, each with a radius around it.

use crate::manifold::{FeatureId, Manifold, ManifoldPoint};
use crate::math::{UnitVec3, Vec3};
use crate::scalar::Scalar;
use crate::shape::Closest;

/// Two points that are closest to each other, of a core of each shape.
pub(super) struct Cores<S> {
    /// From A's origin to B's.
    pub d: Vec3<S>,
    /// From A's origin to its point.
    pub from_a: Vec3<S>,
    /// From A's point to B's.
    pub gap: Vec3<S>,
    /// The radius around each.
    pub radii: [S; 2],
}

impl<S: Scalar> Cores<S> {
    /// The one point of contact, for round surfaces nearer than `margin`. Which are not is found without a root.
    #[inline(always)]
    pub fn manifold(&self, margin: S, out: &mut Manifold<S>) {
        let [a, b] = self.radii;
        let reach = a.plus(b).plus(margin);
        let gap = self.gap.to_array();
        if S::wide_dot3(gap, gap) > S::wide_product(reach, reach) {
            return;
        }
        let (normal, length) = self.direction();
        let separation = length.minus(a).minus(b);
        // Each arm by its own radius, so that the other order gives the same two.
        let half = separation.lowered_by(1);
        out.begin(normal);
        out.push(ManifoldPoint {
            r_a: self.from_a + Vec3::of_length(a.plus(half), normal),
            r_b: self.b_point() - Vec3::of_length(b.plus(half), normal),
            separation,
            feature: FeatureId(0),
        });
    }

    #[inline(always)]
    pub fn closest(&self) -> Closest<S> {
        let [a, b] = self.radii;
        let (normal, length) = self.direction();
        Closest {
            normal: UnitVec3::from_unit(normal),
            separation: length.minus(a).minus(b),
            r_a: self.from_a + Vec3::of_length(a, normal),
            r_b: self.b_point() - Vec3::of_length(b, normal),
        }
    }

    /// From B's origin to its point.
    #[inline(always)]
    fn b_point(&self) -> Vec3<S> {
        (self.from_a + self.gap) - self.d
    }

    /// Of points in the same place the third axis: any direction parts them.
    #[inline(always)]
    fn direction(&self) -> (Vec3<S::Unit>, S) {
        match S::direction3(self.gap.to_array()) {
            Some((normal, length)) => (Vec3::from_array(normal), length),
            None => (UnitVec3::<S>::Z.get(), S::ZERO),
        }
    }
}
