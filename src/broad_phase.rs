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

    /// So many boxes were compared: what a sweep costs, for those who count it.
    #[inline(always)]
    fn compared(&mut self, _count: usize) {}
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
        let mut place = Place { first: 0, second: 1, compared: self.order(boxes) };
        while let Some((a, b)) = self.next(boxes, &mut place) {
            sink.pair(a, b);
        }
        sink.compared(place.compared);
    }

    /// Puts the order right, and returns how many comparisons that took.
    #[inline(never)]
    fn order<S: Scalar>(&mut self, boxes: &[Aabb<S>]) -> usize {
        self.resize(boxes.len());
        if self.left == 0 {
            self.axis = widest(boxes, self.axis);
            self.left = SWEEPS;
        }
        self.left = self.left.wrapping_sub(1);
        let order = self.order.as_mut().get_mut(..self.len as usize).unwrap_or_default();
        sort(order, boxes, self.axis)
    }

    /// The next pair, in code that all sinks share.
    #[inline(never)]
    fn next<S: Scalar>(&mut self, boxes: &[Aabb<S>], place: &mut Place) -> Option<(u16, u16)> {
        let order = self.order.as_mut().get(..self.len as usize).unwrap_or_default();
        let pair = match self.axis {
            Axis::X => place.next_along::<S, 0>(order, boxes),
            Axis::Y => place.next_along::<S, 1>(order, boxes),
            Axis::Z => place.next_along::<S, 2>(order, boxes),
        };
        if pair.is_none() { place.next_extra(boxes) } else { pair }
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

/// How far a sweep has come.
struct Place {
    /// The place in the order of the box at hand, and of the one that it is compared with next. Beyond the order the number of
    /// a box, and of the one before it.
    first: usize,
    second: usize,
    compared: usize,
}

impl Place {
    /// The next pair of the boxes in that order along the axis.
    #[inline(always)]
    fn next_along<S: Scalar, const AXIS: u8>(&mut self, order: &[u16], boxes: &[Aabb<S>]) -> Option<(u16, u16)> {
        while let Some(&first) = order.get(self.first) {
            if let Some(a) = boxes.get(usize::from(first)) {
                let end = along::<S, AXIS>(&a.max);
                while let Some(&second) = order.get(self.second) {
                    self.second = self.second.wrapping_add(1);
                    let Some(b) = boxes.get(usize::from(second)) else { continue };
                    self.compared = self.compared.wrapping_add(1);
                    if along::<S, AXIS>(&b.min) > end {
                        break;
                    }
                    if a.overlaps(b) {
                        return Some((first.min(second), first.max(second)));
                    }
                }
            }
            self.first = self.first.wrapping_add(1);
            self.second = self.first.wrapping_add(1);
        }
        None
    }

    /// What there is no memory for, with all that come before it.
    #[inline(never)]
    fn next_extra<S: Scalar>(&mut self, boxes: &[Aabb<S>]) -> Option<(u16, u16)> {
        if self.second > self.first {
            self.second = 0;
        }
        while let Some(extra) = boxes.get(self.first) {
            while self.second < self.first {
                let earlier = self.second;
                self.second = earlier.wrapping_add(1);
                self.compared = self.compared.wrapping_add(1);
                if boxes.get(earlier).is_some_and(|earlier| extra.overlaps(earlier)) {
                    return Some((earlier as u16, self.first as u16));
                }
            }
            self.first = self.first.wrapping_add(1);
            self.second = 0;
        }
        None
    }
}

/// Insertion sort by where the boxes begin, and where they begin together by their numbers: one order, wherever it came from.
/// The number of comparisons.
fn sort<S: Scalar>(order: &mut [u16], boxes: &[Aabb<S>], axis: Axis) -> usize {
    let begin = |number: u16| boxes.get(usize::from(number)).map_or(S::LARGEST, |of| axis.of(&of.min));
    let (Some(&first), mut place, mut compared) = (order.first(), 0usize, 0usize) else { return 0 };
    let mut last = (begin(first), first);
    while let Some(&number) = order.get(place.wrapping_add(1)) {
        place = place.wrapping_add(1);
        let key = (begin(number), number);
        compared = compared.wrapping_add(1);
        if !is_before(key, last) {
            last = key;
            continue;
        }
        // The boxes that begin later go one place on.
        let mut free = place;
        while let Some([before, after]) = order.get_mut(free.wrapping_sub(1)..=free) {
            compared = compared.wrapping_add(1);
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
    compared
}

#[inline(always)]
fn is_before<S: Scalar>((a, first): (S, u16), (b, second): (S, u16)) -> bool {
    a < b || (a == b && first < second)
}
