//! What a step is made of, counted stage by stage: the same bodies, stepped by the public pieces that the world is made of.
//!
//! - broad: poses and boxes of what moves, and the sweep
//! - narrow: the manifolds of the pairs that it finds
//! - prepare: [`Step::begin`], and [`Step::add`] for each manifold
//! - integrate: [`Step::finish`] without contacts
//! - solve: what [`Step::finish`] takes more with them
//! - keep: the impulses to start the next step from, and what is told of the contacts

use crate::harness::{Call, counter};
use crate::measure::Bodies;
use crate::room::{MOST, Piece, settings, surface};
use carom::solver::{Buffers, ManifoldConstraint, Motion, PointConstraint, Settings, Step, Touch, WarmStart};
use carom::{Aabb, HalfSpace, Manifold, ManifoldSink, Material, Pairs, Pose, Scalar, SweepAndPrune, UnitVec3};

/// Room for the pairs of boxes.
const PAIRS: usize = 3 * MOST;

/// The part of a size within which surfaces count as near, as a power of two: the world's.
pub const NEAR: u32 = 8;

/// A manifold, between whom, and its impulses of the step before.
#[derive(Clone, Copy)]
struct Contact<S: Scalar> {
    pair: [u16; 2],
    manifold: Manifold<S>,
    warm: [WarmStart<S>; 4],
    touch: Touch<S>,
}

impl<S: Scalar> Contact<S> {
    fn warm(&self) -> &[WarmStart<S>] {
        &self.warm[..self.manifold.points().len()]
    }
}

/// The contacts found so far.
struct Contacts<S: Scalar> {
    all: [Contact<S>; MOST + 1],
    len: usize,
}

impl<S: Scalar> ManifoldSink<S> for Contacts<S> {
    fn place(&mut self) -> &mut Manifold<S> {
        &mut self.all[self.len].manifold
    }

    fn take(&mut self, _: u32) {
        // The last place stays free for another manifold.
        self.len = (self.len + 1).min(MOST);
    }
}

/// What a world is made of.
pub struct Pieces<S: Scalar, Sh, const POINTS: usize> {
    bodies: Bodies<S>,
    shapes: [Sh; MOST + 1],
    len: usize,
    poses: [Pose<S>; MOST + 1],
    boxes: [Aabb<S>; MOST + 1],
    sweep: SweepAndPrune<[u16; MOST + 1]>,
    pairs: Pairs<[[u16; 2]; PAIRS]>,
    contacts: Contacts<S>,
    motions: [Motion<S>; MOST + 1],
    manifolds: [ManifoldConstraint<S>; MOST],
    points: [PointConstraint<S>; POINTS],
    settings: Settings<S>,
    material: Material<S>,
}

impl<S: Scalar, Sh: Piece<S>, const POINTS: usize> Pieces<S, Sh, POINTS> {
    /// Takes up the first `len` of the bodies, the plane first; everything is zero before.
    pub fn take(&mut self, bodies: &Bodies<S>, len: usize) -> Option<()> {
        let (plane, piece) = (Sh::from(HalfSpace::new(UnitVec3::Z)), Sh::new()?.1);
        self.bodies = *bodies;
        self.shapes = [piece; MOST + 1];
        self.shapes[0] = plane;
        self.len = len;
        self.poses = [Pose::IDENTITY; MOST + 1];
        self.boxes[0] = plane.aabb(&Pose::IDENTITY);
        self.settings = settings(4)?;
        self.material = surface()?;
        Some(())
    }

    fn begin(&mut self) -> (Step<'_, S>, &mut Contacts<S>, &Material<S>) {
        let Self { bodies, len, motions, manifolds, points, settings, contacts, material, .. } = self;
        (Step::begin(&mut bodies[..*len], Buffers { motions, manifolds, points }, settings), contacts, material)
    }

    fn prepared(&mut self) -> (Step<'_, S>, &mut Contacts<S>) {
        let (mut step, contacts, material) = self.begin();
        for contact in &contacts.all[..contacts.len] {
            step.add(contact.pair, &contact.manifold, material, contact.warm());
        }
        (step, contacts)
    }
}

extern "C" fn broad<S: Scalar, Sh: Piece<S>, const POINTS: usize>(pieces: &mut Pieces<S, Sh, POINTS>) {
    let Pieces { bodies, shapes, len, poses, boxes, sweep, pairs, .. } = pieces;
    let parts = bodies[..*len].iter().zip(&*shapes).zip(poses).zip(&mut *boxes);
    for (((body, shape), pose), bounds) in parts.skip(1) {
        *pose = Pose::new(body.position, body.orientation());
        *bounds = shape.aabb(pose).expanded(shape.inner_radius().lowered_by(NEAR));
    }
    pairs.clear();
    sweep.sweep(&boxes[..*len], pairs);
}

extern "C" fn narrow<S: Scalar, Sh: Piece<S>, const POINTS: usize>(pieces: &mut Pieces<S, Sh, POINTS>) {
    let Pieces { shapes, poses, pairs, contacts, .. } = pieces;
    contacts.len = 0;
    for pair in pairs.found() {
        let [a, b] = pair.map(usize::from);
        contacts.all[contacts.len].pair = *pair;
        // The pieces are all of one size, and the plane of none.
        let margin = shapes[b].inner_radius().lowered_by(NEAR);
        shapes[a].collide(&poses[a], &shapes[b], &poses[b], margin, contacts);
    }
}

extern "C" fn begin<S: Scalar, Sh: Piece<S>, const POINTS: usize>(pieces: &mut Pieces<S, Sh, POINTS>) {
    pieces.begin();
}

extern "C" fn prepare<S: Scalar, Sh: Piece<S>, const POINTS: usize>(pieces: &mut Pieces<S, Sh, POINTS>) {
    pieces.prepared();
}

extern "C" fn fall<S: Scalar, Sh: Piece<S>, const POINTS: usize>(pieces: &mut Pieces<S, Sh, POINTS>) {
    pieces.begin().0.finish();
}

extern "C" fn solve<S: Scalar, Sh: Piece<S>, const POINTS: usize>(pieces: &mut Pieces<S, Sh, POINTS>) {
    pieces.prepared().0.finish();
}

extern "C" fn keep<S: Scalar, Sh: Piece<S>, const POINTS: usize>(pieces: &mut Pieces<S, Sh, POINTS>) {
    let (step, contacts) = pieces.prepared();
    let (mut constraints, _) = step.finish();
    constraints.impulses(|index, warm| contacts.all[index].warm[..warm.len()].copy_from_slice(warm));
    constraints.touches(|index, touch| contacts.all[index].touch = *touch);
}

/// Instructions: broad, narrow, prepare, solve, integrate, keep. Moves the bodies on by a few steps, so that the last one starts from
/// what the first one did.
pub fn measure<S: Scalar, Sh: Piece<S>, const POINTS: usize>(pieces: &mut Pieces<S, Sh, POINTS>) -> Option<[u32; 6]> {
    let count = |pieces: &mut Pieces<S, Sh, POINTS>, stage: extern "C" fn(&mut Pieces<S, Sh, POINTS>)| {
        counter::instructions(&Call::new(stage as *const (), [(&raw mut *pieces).cast()]))
    };
    // The order of the sweep settles.
    count(pieces, broad)?;
    let [broad, narrow] = [count(pieces, broad)?, count(pieces, narrow)?];
    // Impulses to start from.
    count(pieces, keep)?;
    let [begin, prepare] = [count(pieces, begin)?, count(pieces, prepare)?];
    let [keep, solve] = [count(pieces, keep)?, count(pieces, solve)?];
    let integrate = count(pieces, fall)? - begin;
    Some([broad, narrow, prepare, (solve - prepare).saturating_sub(integrate), integrate, keep.saturating_sub(solve)])
}
