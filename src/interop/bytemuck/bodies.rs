//! Bodies as bytes, and back.

use core::ptr::from_ref;

use ::bytemuck::{CheckedBitPattern, NoUninit};

use crate::body::Body;
use crate::interop::sound;
use crate::math::{Quat, SymMat3, Vec3};
use crate::scalar::{Scalar, StepArithmetic};

/// The size of a body's fields, one behind the other.
const fn size_of_fields<S: Scalar>() -> usize {
    3 * size_of::<Vec3<S>>()
        + 3 * size_of::<S>()
        + size_of::<S::Scaled>()
        + 2 * size_of::<SymMat3<S::Unit>>()
        + size_of::<S::Exponent>()
        + size_of::<Quat<S>>()
        + size_of::<Vec3<S::Unit>>()
        + 3 * size_of::<S::Remainder>()
        + 7 * size_of::<<S::Step as StepArithmetic<S>>::Rest>()
}

/// A body as words: as many as it has, of the type that has its alignment.
macro_rules! words {
    ($sample:ty as $word:ty) => {
        [$word; {
            assert!(size_of::<Body<$sample>>() == size_of_fields::<$sample>(), "padding");
            assert!(align_of::<Body<$sample>>() == align_of::<$word>());
            size_of::<Body<$sample>>() / size_of::<$word>()
        }]
    };
}

#[cfg(any(feature = "f32", feature = "f64"))]
macro_rules! float_body {
    ($($float:ident as $word:ident)+) => {$(
        // SAFETY: `repr(C)`, without padding: `words!` adds up the fields.
        unsafe impl NoUninit for Body<$float> {}

        // SAFETY: the layout of these words, and all bits are some number.
        unsafe impl CheckedBitPattern for Body<$float> {
            type Bits = words!($float as $word);

            fn is_valid_bit_pattern(bits: &Self::Bits) -> bool {
                // SAFETY: as above.
                is_sound(unsafe { &*from_ref(bits).cast::<Self>() })
            }
        }
    )+};
}

#[cfg(feature = "f32")]
float_body!(f32 as u32);
#[cfg(feature = "f64")]
float_body!(f64 as u64);

#[cfg(feature = "fixed")]
mod fixed_point {
    use fixed::FixedI32;
    use fixed::types::I16F16;
    use fixed::types::extra::{IsLessOrEqual, LeEqU32, True, U30};

    use super::*;
    use crate::scalar::{Scaled, Scaled32};

    // SAFETY: `repr(C)`, without padding: `words!` adds up the fields. All formats differ in a type without size alone.
    unsafe impl<Frac> NoUninit for Body<FixedI32<Frac>> where
        Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static
    {
    }

    // SAFETY: the layout of these words, and all bits are some number.
    unsafe impl<Frac> CheckedBitPattern for Body<FixedI32<Frac>>
    where
        Frac: LeEqU32 + IsLessOrEqual<U30, Output = True> + Send + Sync + 'static,
    {
        type Bits = words!(I16F16 as u32);

        fn is_valid_bit_pattern(bits: &Self::Bits) -> bool {
            // SAFETY: as above.
            let body = unsafe { &*from_ref(bits).cast::<Self>() };
            is_in_form(body.inv_mass) && is_sound(body)
        }
    }

    /// The arithmetic of intermediate numbers relies on 30 bits in each mantissa.
    fn is_in_form(x: Scaled32) -> bool {
        Scaled32::from_parts(x.mantissa(), x.exponent().saturating_sub(30)) == x
    }
}

/// What a constructor and steps could have made.
fn is_sound<S: Scalar>(body: &Body<S>) -> bool {
    let [w, x, y, z] = body.orientation().to_array();
    let mass = body.mass_properties();
    let massive = mass == Body::immovable().mass_properties() || sound::mass(&mass).is_ok();
    if !(massive && Quat::<S>::new(w, x, y, z).is_ok() && body.check().is_ok() && sound::rests_are_finite(body)) {
        return false;
    }
    let mut turned = *body;
    turned.set_orientation(body.orientation());
    turned.inv_inertia_world == body.inv_inertia_world && body.rests.fill == S::Step::NO_REST
}
