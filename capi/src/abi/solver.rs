//! A step of the solver over the caller's own bodies and manifolds.

use carom::solver::{Buffers, ManifoldConstraint, Motion, PointConstraint, Step, WarmStart};
use carom::{Body, FeatureId, Manifold, ManifoldPoint, Scalar};
use core::ffi::c_void;
use core::mem::MaybeUninit;
use core::slice;

use super::pointer::{Mirror, check, check_ranges_apart, read, write};
use crate::number::{self, Number};
use crate::status::carom_status::{self, *};
use crate::types::*;

#[cfg(feature = "fixed")]
use fixed::types::{I12F20, I16F16};

/// An array of C's.
///
/// # Safety
/// A pointer that is neither null nor misaligned leads to `count` objects, which outlive `'a` and which nobody else uses.
unsafe fn array<'a, T>(first: *mut T, count: usize) -> Result<&'a mut [T], carom_status> {
    if count == 0 {
        return Ok(&mut []);
    }
    check(first)?;
    // SAFETY: checked, and the caller's word for the rest.
    Ok(unsafe { slice::from_raw_parts_mut(first, count) })
}

/// Where an array is, and how many bytes it has.
fn range<T>(first: *mut T, count: usize) -> (usize, usize) {
    (first.addr(), count.saturating_mul(size_of::<T>()))
}

/// The working space of a step in the caller's memory.
///
/// # Safety
/// `memory` is aligned for words of 32 bits and has room for so many; nobody else uses it during `'a`.
unsafe fn buffers<'a, N: Number>(memory: *mut c_void, [bodies, manifolds, points]: [usize; 3]) -> Buffers<'a, N> {
    const { assert!(align_of::<Motion<N>>() <= 4 && align_of::<ManifoldConstraint<N>>() <= 4) }
    const { assert!(align_of::<PointConstraint<N>>() <= 4) }
    let motions = memory.cast::<Motion<N>>();
    let pairs = motions.wrapping_add(bodies).cast::<ManifoldConstraint<N>>();
    let contacts = pairs.wrapping_add(manifolds).cast::<PointConstraint<N>>();
    // SAFETY: one behind the other in memory that has room for all, each of a size that is a multiple of the alignment.
    unsafe {
        (0..bodies).for_each(|index| motions.add(index).write(Motion::NEW));
        (0..manifolds).for_each(|index| pairs.add(index).write(ManifoldConstraint::NEW));
        (0..points).for_each(|index| contacts.add(index).write(PointConstraint::NEW));
        Buffers {
            motions: slice::from_raw_parts_mut(motions, bodies),
            manifolds: slice::from_raw_parts_mut(pairs, manifolds),
            points: slice::from_raw_parts_mut(contacts, points),
        }
    }
}

/// What an array of C's bodies is cast to an array of the kernel's by.
fn is_mirror<N: Number, M: Mirror<N>>() {}

/// No number of the body is infinite or NaN.
fn check_body<N: Number>(body: &Body<N>) -> Result<(), carom_status> {
    body.check()?;
    let ordinary = [body.gravity_scale, body.linear_damping, body.angular_damping].into_iter().all(N::is_finite);
    let turned = body.orientation().to_array();
    if !(ordinary && turned.into_iter().all(Scalar::is_finite)) {
        return Err(CAROM_NOT_FINITE);
    }
    if turned == [<N::Unit as Scalar>::ZERO; 4] { Err(CAROM_NOT_A_BODY) } else { Ok(()) }
}

macro_rules! solver {
    ($p:ident, $P:ident, $number:ty, $raw:ty: $body:literal, $manifold:literal, $point:literal) => { pastey::paste! {
        /// Bytes of working space that a step takes for each body.
        pub const [<$P _SOLVER_BODY_SIZE>]: usize = $body;
        /// Bytes of working space that a step takes for each manifold.
        pub const [<$P _SOLVER_MANIFOLD_SIZE>]: usize = $manifold;
        /// Bytes of working space that a step takes for each point.
        pub const [<$P _SOLVER_POINT_SIZE>]: usize = $point;

        /// A point of a manifold, halfway between the two surfaces.
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct [<$p _manifold_point>] {
            /// From the centre of mass of A to the point, in the world's frame, m.
            pub r_a: [<$p _vec3>],
            /// From the centre of mass of B to the point, in the world's frame, m.
            pub r_b: [<$p _vec3>],
            /// The gap between the surfaces along the normal, m: negative where they overlap.
            pub separation: $raw,
            /// What makes the point: the same number in the next step means the same point.
            pub feature: u16,
            /// Not looked at.
            pub reserved: u16,
        }

        /// Where two bodies touch, or are about to: a normal and up to four points. Begin with all zeros; keep it from step to step
        /// as long as the two touch, and give it their new normal and points before each: it carries the impulses over.
        #[repr(C)]
        #[derive(Clone, Copy, Debug)]
        pub struct [<$p _manifold>] {
            /// The places of the bodies A and B in the array.
            pub a: u16,
            /// See there.
            pub b: u16,
            /// How many points there are.
            pub point_count: u32,
            /// From A to B.
            pub normal: [<$p _unit_vec3>],
            /// Of the pair.
            pub material: [<$p _material>],
            /// The points.
            pub points: [[<$p _manifold_point>]; 4],
            /// Told by the step: the normal impulse over it, N s.
            pub normal_impulse: $raw,
            /// Told by the step: how fast the surfaces met in it, m/s; zero where they did not.
            pub approach_speed: $raw,
            /// Told by the step: 1 where it solved the manifold, 0 where there are no points or neither body moves.
            pub solved: u32,
            /// The library's own.
            pub warm_count: u32,
            /// The library's own.
            pub warm: [[MaybeUninit<u32>; 6]; 4],
        }

        impl [<$p _manifold>] {
            fn core(&self) -> Result<Manifold<$number>, carom_status> {
                let mut manifold = Manifold::empty(self.normal.core()?);
                let points = self.points.get(..self.point_count as usize).ok_or(CAROM_COUNT)?;
                for point in points {
                    let (r_a, r_b) = (number::finite(point.r_a.core())?, number::finite(point.r_b.core())?);
                    let separation = <$number>::from_raw(point.separation);
                    if !Scalar::is_finite(separation) {
                        return Err(CAROM_NOT_FINITE);
                    }
                    manifold.push(ManifoldPoint { r_a, r_b, separation, feature: FeatureId(point.feature) });
                }
                Ok(manifold)
            }

            /// Nothing is wrong with it, among so many bodies.
            fn check(&self, bodies: usize) -> Result<(), carom_status> {
                if usize::from(self.a.max(self.b)) >= bodies || self.a == self.b {
                    return Err(CAROM_INDEX);
                }
                if self.warm_count > 4 {
                    return Err(CAROM_COUNT);
                }
                self.material.core()?;
                self.core()?;
                Ok(())
            }

            fn warm(&mut self) -> &mut [WarmStart<$number>; 4] {
                const { assert!(size_of::<WarmStart<$number>>() <= size_of::<[u32; 6]>()) }
                const { assert!(align_of::<WarmStart<$number>>() <= align_of::<u32>()) }
                // SAFETY: room for four; integers and floats, for which zeros and what the library wrote are good.
                unsafe { &mut *self.warm.as_mut_ptr().cast() }
            }
        }

        /// Moves bodies on by one step: gravity, and the contacts that the manifolds describe.
        ///
        /// `workspace` is aligned as an array of uint64_t is and has `size` bytes, SOLVER_SIZE(bodies, manifolds, points) of this
        /// number type at least; what is in it does not matter, before or after. `saturated`, which may be null, becomes 1 where
        /// a position or velocity met the end of the format and stayed there, else 0.
        #[unsafe(no_mangle)]
        #[allow(clippy::too_many_arguments)]
        pub unsafe extern "C" fn [<$p _solver_step>](
            settings: *const [<$p _settings>],
            bodies: *mut [<$p _body>],
            body_count: usize,
            manifolds: *mut [<$p _manifold>],
            manifold_count: usize,
            workspace: *mut c_void,
            size: usize,
            saturated: *mut u32,
        ) -> carom_status {
            // SAFETY: the header's contract.
            let result = unsafe {
                [<$p _solve>](settings, (bodies, body_count), (manifolds, manifold_count), (workspace, size), saturated)
            };
            carom_status::from(result)
        }

        unsafe fn [<$p _solve>](
            settings: *const [<$p _settings>],
            (first_body, body_count): (*mut [<$p _body>], usize),
            (first_manifold, manifold_count): (*mut [<$p _manifold>], usize),
            (workspace, size): (*mut c_void, usize),
            saturated: *mut u32,
        ) -> Result<(), carom_status> {
            if body_count > usize::from(u16::MAX) || manifold_count > usize::from(u16::MAX) {
                return Err(CAROM_COUNT);
            }
            if !saturated.is_null() {
                check(saturated)?;
            }
            let (place_of_bodies, place_of_manifolds) =
                (range(first_body, body_count), range(first_manifold, manifold_count));
            check_ranges_apart(place_of_bodies, place_of_manifolds)?;
            check_ranges_apart(place_of_bodies, (workspace.addr(), size))?;
            check_ranges_apart(place_of_manifolds, (workspace.addr(), size))?;
            // SAFETY: the header's contract; the three do not overlap. Bodies are mirrored: see `Mirror`.
            let (settings, bodies, manifolds) = unsafe {
                is_mirror::<$number, [<$p _body>]>();
                (read(settings)?.core()?, array(first_body.cast::<Body<$number>>(), body_count)?, array(first_manifold, manifold_count)?)
            };
            bodies.iter().try_for_each(check_body)?;
            manifolds.iter().try_for_each(|manifold| manifold.check(body_count))?;
            let points = manifolds.iter().fold(0usize, |sum, manifold| sum.saturating_add(manifold.point_count as usize));
            if points >= 1 << 15 {
                return Err(CAROM_COUNT);
            }
            const { assert!(size_of::<Motion<$number>>() <= $body && size_of::<ManifoldConstraint<$number>>() <= $manifold) }
            const { assert!(size_of::<PointConstraint<$number>>() <= $point) }
            let needed = (body_count.saturating_mul($body))
                .saturating_add(manifold_count.saturating_mul($manifold))
                .saturating_add(points.saturating_mul($point));
            check(workspace.cast::<u64>())?;
            if size < needed {
                return Err(CAROM_TOO_SMALL);
            }
            // SAFETY: as large as that takes.
            let buffers = unsafe { buffers::<$number>(workspace, [body_count, manifold_count, points]) };

            let mut step = Step::begin(bodies, buffers, &settings);
            for manifold in manifolds.iter_mut() {
                let places = [manifold.a, manifold.b];
                let moves = |place: u16| step.bodies().get(usize::from(place)).is_some_and(|body| !body.is_immovable());
                manifold.solved = u32::from(manifold.point_count > 0 && (moves(manifold.a) || moves(manifold.b)));
                (manifold.normal_impulse, manifold.approach_speed) = Default::default();
                if manifold.solved == 0 {
                    manifold.warm_count = 0;
                    continue;
                }
                let (shape, material) = (manifold.core()?, manifold.material.core()?);
                let count = manifold.warm_count as usize;
                let warm = manifold.warm().get(..count).unwrap_or(&[]);
                // There is room for all.
                let _ = step.add(places, &shape, &material, warm);
            }
            let (mut constraints, report) = step.finish();
            let mut solved = manifolds.iter_mut().filter(|manifold| manifold.solved != 0);
            constraints.touches(|_, touch| {
                let Some(manifold) = solved.next() else { return };
                manifold.normal_impulse = <$number as Scalar>::from_scaled(touch.impulse).0.raw();
                manifold.approach_speed = touch.approach.raw();
            });
            let mut solved = manifolds.iter_mut().filter(|manifold| manifold.solved != 0);
            constraints.impulses(|_, impulses| {
                let Some(manifold) = solved.next() else { return };
                manifold.warm_count = impulses.len() as u32;
                manifold.warm().iter_mut().zip(impulses).for_each(|(kept, impulse)| *kept = *impulse);
            });
            // SAFETY: the header's contract.
            if saturated.is_null() { Ok(()) } else { unsafe { write(saturated, report.saturated.into()) } }
        }

        #[cfg(test)]
        mod [<$p _sizes>] {
            use super::*;

            #[test]
            fn sizes() {
                let needed = [size_of::<Motion<$number>>(), size_of::<ManifoldConstraint<$number>>(), size_of::<PointConstraint<$number>>()];
                assert_eq!([$body, $manifold, $point], needed, "write these in solver! of {}", stringify!($p));
            }
        }
    } };
}

#[cfg(feature = "f32")]
solver!(carom_f32, CAROM_F32, f32, f32: 76, 60, 244);
#[cfg(feature = "fixed")]
solver!(carom_q16, CAROM_Q16, I16F16, i32: 80, 64, 244);
#[cfg(feature = "fixed")]
solver!(carom_q20, CAROM_Q20, I12F20, i32: 80, 64, 244);
