//! The broad phase: which bounding boxes overlap, by sweep and prune along one axis.
//!
//! Boxes are kept sorted by where they begin. From one step to the next the order hardly changes, so that an insertion sort
//! passes over it once; then each box is compared with those that begin before it ends. For n boxes of which p pairs overlap
//! along the axis, that is about n + p comparisons and no more memory than n numbers of 16 bits.

use crate::aabb::Aabb;
use crate::math::{Vec3, max, min};
use crate::scalar::Scalar;

/// What takes the pairs that the sweep finds.
pub trait PairSink {
    /// The boxes with these indices overlap; `a < b`. Each pair comes once.
    fn pair(&mut self, a: u16, b: u16);

    /// Two boxes were compared: what a sweep costs, for those who count it.
    #[inline(always)]
    fn compared(&mut self) {}
}

/// Pairs in the caller's memory; counts those for which there is no room.
#[derive(Debug)]
pub struct Pairs<M> {
    memory: M,
    len: usize,
    missed: usize,
}

impl<M: AsMut<[[u16; 2]]> + AsRef<[[u16; 2]]>> Pairs<M> {
    /// None yet.
    pub const fn new(memory: M) -> Self {
        Self { memory, len: 0, missed: 0 }
    }

    /// The pairs found, in the order in which they were.
    pub fn found(&self) -> &[[u16; 2]] {
        self.memory.as_ref().get(..self.len).unwrap_or(&[])
    }

    /// How many there were beyond the memory's length.
    pub const fn missed(&self) -> usize {
        self.missed
    }

    /// Forgets all of it.
    pub fn clear(&mut self) {
        (self.len, self.missed) = (0, 0);
    }
}

impl<M: AsMut<[[u16; 2]]> + AsRef<[[u16; 2]]>> PairSink for Pairs<M> {
    fn pair(&mut self, a: u16, b: u16) {
        match self.memory.as_mut().get_mut(self.len) {
            Some(free) => {
                *free = [a, b];
                self.len = self.len.wrapping_add(1);
            }
            None => self.missed = self.missed.saturating_add(1),
        }
    }
}

/// The axis of the sweep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Axis {
    #[default]
    X,
    Y,
    Z,
}

impl Axis {
    #[inline(always)]
    fn of<S: Copy>(self, v: &Vec3<S>) -> S {
        match self {
            Self::X => along::<S, 0>(v),
            Self::Y => along::<S, 1>(v),
            Self::Z => along::<S, 2>(v),
        }
    }
}

/// The component along an axis that is known at compile time: a choice at every comparison costs more than the comparison.
#[inline(always)]
fn along<S: Copy, const AXIS: u8>(v: &Vec3<S>) -> S {
    match AXIS {
        0 => v.x,
        1 => v.y,
        _ => v.z,
    }
}

/// The order of boxes along an axis, kept from step to step in memory such as `[u16; 16]` or `&mut [u16]`.
///
/// What comes out, and in which order, depends on the boxes and on this state alone.
#[derive(Clone, Debug)]
pub struct SweepAndPrune<M> {
    /// The first `len` are the numbers below `len`, each once.
    order: M,
    len: u32,
    axis: Axis,
    /// Sweeps before the axis is chosen anew.
    left: u8,
}

/// Sweeps along one axis.
const SWEEPS: u8 = 16;

impl<M: AsMut<[u16]>> SweepAndPrune<M> {
    /// For as many boxes as the memory has numbers. More are compared with all others.
    pub const fn new(memory: M) -> Self {
        Self { order: memory, len: 0, axis: Axis::X, left: 0 }
    }

    /// Hands over every pair of boxes that overlap, of up to 65,536 boxes; a box without a shape in it overlaps none where its
    /// minimum is above its maximum. No coordinate may be a NaN.
    pub fn sweep<S: Scalar>(&mut self, boxes: &[Aabb<S>], sink: &mut impl PairSink) {
        self.resize(boxes.len());
        if self.left == 0 {
            self.axis = widest(boxes, self.axis);
            self.left = SWEEPS;
        }
        self.left = self.left.wrapping_sub(1);
        let len = self.len as usize;
        let order = self.order.as_mut().get_mut(..len).unwrap_or_default();
        match self.axis {
            Axis::X => sweep_along::<S, 0>(order, boxes, sink),
            Axis::Y => sweep_along::<S, 1>(order, boxes, sink),
            Axis::Z => sweep_along::<S, 2>(order, boxes, sink),
        }
        // What there is no memory for, with all that come before it.
        let mut index = len;
        while let Some(extra) = boxes.get(index) {
            let mut other = 0;
            for earlier in boxes.get(..index).unwrap_or(&[]) {
                sink.compared();
                if extra.overlaps(earlier) {
                    sink.pair(other, index as u16);
                }
                other = other.wrapping_add(1);
            }
            index = index.wrapping_add(1);
        }
    }

    /// Makes the order one of the numbers below `count`, or of as many as there is memory for, and keeps what it can of it.
    fn resize(&mut self, count: usize) {
        let order = self.order.as_mut();
        let count = count.min(order.len()).min(1 << 16);
        let len = self.len as usize;
        if count == len {
            return;
        }
        self.left = 0;
        if count < len {
            let mut kept = 0;
            for index in 0..len {
                let Some(&number) = order.get(index) else { continue };
                if usize::from(number) < count {
                    if let Some(place) = order.get_mut(kept) {
                        *place = number;
                    }
                    kept = kept.wrapping_add(1);
                }
            }
        }
        let mut number = self.len as u16;
        for place in order.get_mut(len..count).unwrap_or_default() {
            *place = number;
            number = number.wrapping_add(1);
        }
        self.len = count as u32;
    }
}

/// The axis along which the boxes are spread farthest, if that is twice as far as along the present one: a change of axis means
/// sorting anew. What has no end counts with neither.
fn widest<S: Scalar>(boxes: &[Aabb<S>], present: Axis) -> Axis {
    let far = S::LARGEST;
    let (mut low, mut high) = (Vec3::new(far, far, far), Vec3::new(far.negated(), far.negated(), far.negated()));
    for Aabb { min: begin, max: end } in boxes {
        if begin.x > far.negated() && end.x < far {
            low = Vec3::new(min(low.x, begin.x), min(low.y, begin.y), min(low.z, begin.z));
            high = Vec3::new(max(high.x, begin.x), max(high.y, begin.y), max(high.z, begin.z));
        }
    }
    let spread = high - low;
    let mut best = present;
    let mut bar = present.of(&spread).plus(present.of(&spread));
    for &axis in &[Axis::X, Axis::Y, Axis::Z] {
        if axis.of(&spread) > bar {
            (best, bar) = (axis, axis.of(&spread));
        }
    }
    best
}

/// The pairs of the boxes in that order along the axis, which is put right first.
fn sweep_along<S: Scalar, const AXIS: u8>(order: &mut [u16], boxes: &[Aabb<S>], sink: &mut impl PairSink) {
    sort::<S, AXIS>(order, boxes, sink);
    let mut rest: &[u16] = order;
    while let [first, later @ ..] = rest {
        rest = later;
        let Some(a) = boxes.get(usize::from(*first)) else { continue };
        let end = along::<S, AXIS>(&a.max);
        for second in later {
            let Some(b) = boxes.get(usize::from(*second)) else { continue };
            sink.compared();
            if along::<S, AXIS>(&b.min) > end {
                break;
            }
            if a.overlaps(b) {
                sink.pair(*first.min(second), *first.max(second));
            }
        }
    }
}

/// Insertion sort by where the boxes begin, and where they begin together by their numbers: one order, wherever it came from.
fn sort<S: Scalar, const AXIS: u8>(order: &mut [u16], boxes: &[Aabb<S>], sink: &mut impl PairSink) {
    let begin = |number: u16| boxes.get(usize::from(number)).map_or(S::LARGEST, |of| along::<S, AXIS>(&of.min));
    let (Some(&first), mut place) = (order.first(), 0usize) else { return };
    let mut last = (begin(first), first);
    while let Some(&number) = order.get(place.wrapping_add(1)) {
        place = place.wrapping_add(1);
        let key = (begin(number), number);
        sink.compared();
        if !is_before(key, last) {
            last = key;
            continue;
        }
        // The boxes that begin later go one place on.
        let mut free = place;
        while let Some([before, after]) = order.get_mut(free.wrapping_sub(1)..=free) {
            sink.compared();
            if !is_before(key, (begin(*before), *before)) {
                break;
            }
            (*after, *before) = (*before, number);
            free = free.wrapping_sub(1);
            if free == 0 {
                break;
            }
        }
    }
}

#[inline(always)]
fn is_before<S: Scalar>((a, first): (S, u16), (b, second): (S, u16)) -> bool {
    a < b || (a == b && first < second)
}
