//! What every function answers.

use carom::solver::SettingsError;
use carom::{
    BodyError, ContactError, DirectionError, HandleError, InsertError, MassError, MaterialError, OrientationError,
    RangeError, ShapeError, SolidError,
};
use core::ffi::CStr;

macro_rules! statuses {
    ($($(#[$meta:meta])* $name:ident = $number:literal, $text:literal;)+) => {
        /// What a function answers: CAROM_OK, or why it did nothing. Where it is not CAROM_OK nothing was changed or written.
        #[repr(u32)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum carom_status {
            $($(#[$meta])* $name = $number),+
        }

        impl carom_status {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$name),+];
        }

        pub(crate) fn text_of(status: u32) -> &'static CStr {
            match status {
                $($number => $text,)+
                _ => c"not a carom_status",
            }
        }
    };
}

statuses! {
    /// Done.
    CAROM_OK = 0, c"done";
    /// A pointer is null that must not be.
    CAROM_NULL = 1, c"a pointer is null: only arguments documented as optional may be";
    /// A pointer is not aligned.
    CAROM_MISALIGNED = 2, c"a pointer is not aligned: declare the memory as an array of uint64_t, or with its own type";
    /// Two objects that must be two share memory.
    CAROM_OVERLAP = 3, c"two arguments share memory: the bodies of a contact must be two, results apart from what is read";
    /// The memory is smaller than what has to go there.
    CAROM_TOO_SMALL = 4, c"the memory is too small: take the ..._SIZE of the same carom.h that the library was built with";
    /// There is no world of this number type in the memory.
    CAROM_NOT_A_WORLD = 5, c"there is no world of this number type there: begin with ..._world_..._init";
    /// The body was never made.
    CAROM_NOT_A_BODY = 6, c"the body was never made: begin with ..._body_immovable or ..._body_dynamic, not with zeros";
    /// The handle's body is not in this world.
    CAROM_STALE_HANDLE = 7, c"no body of this world has that handle: it was removed, or never inserted";
    /// The world has no place left.
    CAROM_FULL = 8, c"the world is full: remove a body, or take a larger world";
    /// A number is infinite or NaN.
    CAROM_NOT_FINITE = 9, c"a number is infinite or NaN";
    /// A number does not fit the format, or a denominator is zero.
    CAROM_RANGE = 10, c"the number is outside the range of the format, or its denominator is zero";
    /// The vector or quaternion is zero.
    CAROM_ZERO_LENGTH = 11, c"the vector or quaternion is zero and has no direction";
    /// The vector or quaternion is not of unit length.
    CAROM_NOT_UNIT = 12, c"the direction or orientation is not of unit length: make it with ..._direction or ..._quat_normalize";
    /// A radius, half extent or half length is not positive and finite.
    CAROM_DIMENSION = 13, c"a radius, half extent or half length is not positive, or too small or large for a mass";
    /// The mass is not positive and finite.
    CAROM_MASS = 14, c"the mass must be positive and finite; what nothing moves is made by ..._body_immovable";
    /// The inertia tensor is none.
    CAROM_INERTIA = 15, c"the inertia tensor must be positive definite, no principal moment above the sum of the others";
    /// The coefficient of restitution is not in 0 to 1.
    CAROM_RESTITUTION = 16, c"the restitution must lie in 0 to 1";
    /// The coefficient of friction is negative or not finite.
    CAROM_FRICTION = 17, c"the friction must be finite and not negative";
    /// Not a carom_restitution_law.
    CAROM_LAW = 18, c"the material's law is no carom_restitution_law: CAROM_NEWTON is 0";
    /// Not a carom_shape_kind, or none that has a mass, or that the world holds.
    CAROM_SHAPE = 19, c"the kind is no carom_shape_kind; or a half-space, which has no mass; or not for a world of balls";
    /// The step's time cannot be stepped over.
    CAROM_STEP_TIME = 20, c"take a sub-step or more, each longer than zero and below one second, the step below two";
    /// A manifold names a body that is not in the array, or one body twice.
    CAROM_INDEX = 21, c"a manifold names a body beyond the array, or the same body twice";
    /// Too many of something.
    CAROM_COUNT = 22, c"too many: a manifold has up to 4 points, a step up to 65535 bodies and manifolds and 32767 points";
}

/// The answer to C.
impl From<Result<(), carom_status>> for carom_status {
    fn from(result: Result<(), carom_status>) -> Self {
        result.err().unwrap_or(Self::CAROM_OK)
    }
}

macro_rules! from {
    ($($error:ty: $($variant:pat => $status:ident),+;)+) => {$(
        impl From<$error> for carom_status {
            fn from(error: $error) -> Self {
                match error { $($variant => Self::$status),+ }
            }
        }
    )+};
}

// Errors may get more variants, which are then told by the last code of their kind.
from! {
    RangeError: _ => CAROM_RANGE;
    SettingsError: _ => CAROM_STEP_TIME;
    BodyError: _ => CAROM_NOT_FINITE;
    ContactError: _ => CAROM_NOT_FINITE;
    HandleError: _ => CAROM_STALE_HANDLE;
    InsertError: InsertError::NotFinite => CAROM_NOT_FINITE, _ => CAROM_FULL;
    DirectionError: DirectionError::NotFinite => CAROM_NOT_FINITE, DirectionError::Zero => CAROM_ZERO_LENGTH, _ => CAROM_NOT_UNIT;
    OrientationError: OrientationError::NotFinite => CAROM_NOT_FINITE, OrientationError::Zero => CAROM_ZERO_LENGTH, _ => CAROM_NOT_UNIT;
    ShapeError: _ => CAROM_DIMENSION;
    SolidError: _ => CAROM_DIMENSION;
    MaterialError: MaterialError::Restitution => CAROM_RESTITUTION, _ => CAROM_FRICTION;
    MassError: MassError::Mass | MassError::Density => CAROM_MASS, _ => CAROM_INERTIA;
}
