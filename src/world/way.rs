//! The way that fast bodies go: where along it they meet others. Conservative advancement (Mirtich 1996, section 2.3.2) along
//! straight ways; what turning may add counts as touching.
//!
//! Speculative contacts alone, with the normals that shapes have at the start of a step, would let a fast body bounce off the
//! plane of a face beside that face.

use crate::manifold::Manifold;
use crate::math::{Pose, Vec3, max, min};
use crate::scalar::Scalar;

/// Looks on the way, at most. A ball and another convex shape mostly take two or three.
pub(super) const LOOKS: u8 = 16;
/// Strides on the way, at most, as a power of two.
const STRIDES: u32 = 3;

/// How the second body of a pair goes as the first one sees it, and how far along that the shapes are looked at.
pub(super) struct Way<S: Scalar> {
    /// Both displacements in the step.
    way: [Vec3<S>; 2],
    relative: Vec3<S>,
    /// Nearer surfaces touch.
    near: S,
    /// No farther at a time, where manifolds do not tell how near all of the surfaces are: of polytopes they are cut to what
    /// lies over a face, and of height fields they have what is right below.
    stride: S::Unit,
    exact: bool,
    /// The part of the step after which they are looked at.
    at: S::Unit,
    /// Nothing is made of manifolds but what follows.
    seeking: bool,
    touches: bool,
    /// How fast what touches closes, as the way of a step.
    closing: S,
    /// The part of the step in which no surface can come to touch another.
    free: Option<S::Unit>,
}

impl<S: Scalar> Way<S> {
    /// For surfaces that touch where they are `near`, of shapes of that size. `exact`: one is a ball.
    pub fn new(velocities: [Vec3<S>; 2], dt: S::Unit, [near, size]: [S; 2], exact: bool) -> Self {
        let [a, b] = velocities.map(|v| part(v, dt));
        let relative = b - a;
        let length = relative.taxicab();
        let stride = if size < length { S::fraction(size, length) } else { S::Unit::ONE };
        Self {
            way: [a, b],
            relative,
            near: near.plus(S::STEP),
            stride: max(stride, S::Unit::ONE.lowered_by(STRIDES)),
            exact,
            at: S::Unit::ZERO,
            seeking: true,
            touches: false,
            closing: S::ZERO,
            free: None,
        }
    }

    /// The poses that far along.
    pub fn poses(&self, [a, b]: [&Pose<S>; 2]) -> [Pose<S>; 2] {
        let ahead = |pose: &Pose<S>, way| Pose { position: pose.position + part(way, self.at), ..*pose };
        [ahead(a, self.way[0]), ahead(b, self.way[1])]
    }

    /// Before a look.
    pub fn look(&mut self) {
        (self.touches, self.closing, self.free) = (false, S::ZERO, None);
    }

    /// After it: as far on as nothing can touch. Where they touch, or never will, there is nothing to look for any more.
    pub fn go_on(&mut self) -> Found {
        if self.touches {
            return Found::Touch;
        }
        self.at = match self.free {
            Some(free) if self.exact => self.at.plus(free),
            None if self.exact => return Found::Nothing,
            free => self.at.plus(free.map_or(self.stride, |free| min(free, self.stride))),
        };
        if self.at >= S::Unit::ONE { Found::Nothing } else { Found::Way }
    }

    /// Contacts are made from now on: here, or at the start of the step.
    pub fn stop(&mut self, here: bool) {
        self.seeking = false;
        if !here {
            self.at = S::Unit::ZERO;
        }
    }

    /// How far along it is, as a part of the step.
    pub fn at(&self) -> S::Unit {
        self.at
    }

    /// How far what touches here would go into each other.
    pub fn blow(&self) -> S {
        self.closing.times_unit(S::Unit::ONE.minus(self.at))
    }

    /// Notes a manifold, and turns one that is made ahead into one at the start of the step. False: there is no contact.
    pub fn take(&mut self, manifold: &mut Manifold<S>, part: u32) -> bool {
        let closing = self.relative.along(manifold.normal.get()).negated();
        let mut separation = S::LARGEST;
        for point in manifold.points() {
            separation = min(separation, point.separation);
        }
        let (touches, closes) = (separation <= self.near, closing > S::ZERO);
        if self.seeking {
            self.exact &= part == 0;
            if touches && (closes || self.at == S::Unit::ZERO) {
                self.touches = true;
                self.closing = max(self.closing, closing);
            } else if separation > S::ZERO && separation < closing {
                let free = S::fraction(separation, closing);
                self.free = Some(self.free.map_or(free, |least| min(least, free)));
            }
            return false;
        }
        if self.at == S::Unit::ZERO {
            return true;
        }
        if closes {
            let back = closing.times_unit(self.at);
            for point in manifold.points_mut() {
                point.separation = point.separation.plus(back);
            }
        }
        closes || touches
    }
}

/// What is found where shapes are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Found {
    /// They touch, or have since the start.
    Touch,
    /// They may touch farther along.
    Way,
    /// They do not touch in this step.
    Nothing,
}

fn part<S: Scalar>(v: Vec3<S>, part: S::Unit) -> Vec3<S> {
    Vec3::new(v.x.times_unit(part), v.y.times_unit(part), v.z.times_unit(part))
}
