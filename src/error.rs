//! What constructors refuse: one small enum per operation, whose variants name the parameter.

use core::error::Error;
use core::fmt::{Display, Formatter, Result};

macro_rules! errors {
    ($($(#[$meta:meta])* $name:ident { $($(#[$variant_meta:meta])* $variant:ident => $text:literal),+ $(,)? })+) => {$(
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$variant_meta])* #[doc = concat!("\n\n`", $text, "`")] $variant),+
        }

        impl Display for $name {
            fn fmt(&self, f: &mut Formatter<'_>) -> Result {
                f.write_str(match self { $(Self::$variant => $text),+ })
            }
        }

        impl Error for $name {}

        #[cfg(feature = "defmt")]
        impl defmt::Format for $name {
            fn format(&self, f: defmt::Formatter<'_>) {
                match self { $(Self::$variant => defmt::write!(f, $text)),+ }
            }
        }
    )+};
}

/// A ratio that the format cannot hold, or a denominator of zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RangeError;

impl Display for RangeError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str("the ratio is outside the range of the number format")
    }
}

impl Error for RangeError {}

errors! {
    /// A handle that cannot be followed.
    HandleError {
        /// The body was removed.
        Stale => "body: it was removed from the world, and the handle is of no use any more",
    }

    /// A body that a world cannot take.
    InsertError {
        /// There is no place left.
        Full => "world: it is full; give it a larger number of BODIES, or remove one",
        /// A number in the body is infinite or NaN.
        NotFinite => "body: a number in it is not finite; Body::check names it",
    }

    /// A direction that cannot be a [`UnitVec3`](crate::UnitVec3).
    DirectionError {
        /// A component is infinite or NaN.
        NotFinite => "direction: a component is not finite",
        /// All components are zero.
        Zero => "direction: the vector is zero",
        /// The length is not one.
        NotUnit => "direction: the vector is not of unit length; use `UnitVec3::normalize`",
    }

    /// A quaternion that is not a rotation.
    OrientationError {
        /// A component is infinite or NaN.
        NotFinite => "orientation: a component is not finite",
        /// All components are zero.
        Zero => "orientation: the quaternion is zero",
        /// The length is not one.
        NotUnit => "orientation: the quaternion is not of unit length; use `Quat::normalize`",
    }

    /// A dimension of a solid that is not positive and finite, or with which, in floating point, the volume or a moment
    /// of inertia leaves the range of normal numbers.
    SolidError {
        /// Of a sphere, capsule, cylinder, cone or tube.
        Radius => "solid: the radius, and the volume and moments with it, must be positive and finite",
        /// Of a cuboid.
        HalfExtent => "solid: each half extent, and the volume and moments with it, must be positive and finite",
        /// Of a capsule (where zero is a sphere), cylinder or tube.
        HalfLength => "solid: the half length must be finite and not negative, of a cylinder or tube positive",
        /// Of a cone.
        Height => "solid: the height, and the volume and moments with it, must be positive and finite",
        /// Of an ellipsoid.
        SemiAxis => "solid: each semi-axis, and the volume and moments with it, must be positive and finite",
    }

    /// A dimension that no shape has.
    ShapeError {
        /// Of a sphere or a capsule: not positive and finite.
        Radius => "shape: the radius must be positive and finite",
        /// Of a cuboid: not positive and finite.
        HalfExtent => "shape: each half extent must be positive and finite",
        /// Of a capsule: not positive and finite. Without length it is a sphere.
        HalfLength => "shape: the half length must be positive and finite; without length it is a sphere",
    }

    /// Heights that make no field.
    HeightFieldError {
        /// Fewer than two columns or rows.
        TooFew => "height field: it takes two columns and two rows at least",
        /// Not a height for each column of each row.
        Count => "height field: there must be a height for each column of each row",
        /// More than 16,383 columns or rows.
        TooMany => "height field: more than 16,383 columns or rows",
        /// Zero, negative or not finite, or with it the field leaves the range of the format.
        Spacing => "height field: the spacing must be positive and finite, and the field fit the format",
        /// Infinite or NaN.
        Height => "height field: a height is not finite",
    }

    /// Parts that make no compound.
    CompoundError {
        /// There is no part.
        Empty => "compound: it takes one part at least",
        /// More than 255 parts.
        TooMany => "compound: more than 255 parts",
        /// A part's pose has an infinity or NaN in it.
        Pose => "compound: a part's pose is not finite",
    }

    /// Points that make no convex hull.
    HullError {
        /// Fewer than four corners.
        TooFew => "hull: it takes four corners at least",
        /// More than the hull has room for, or than 32.
        TooMany => "hull: more points than there is room for, or than 32",
        /// A coordinate is infinite or NaN.
        NotFinite => "hull: a coordinate is not finite",
        /// All points lie in a plane.
        Flat => "hull: all points lie in a plane",
        /// A face with more than 12 corners.
        FaceCorners => "hull: a face has more than 12 corners",
        /// In fixed point: less than 2048 units of the last place across.
        TooSmall => "hull: it is less than 2048 units of the last place across; take smaller units of length",
        /// Points nearly coincide or nearly lie in a plane, so that the faces do not close.
        Unclear => "hull: points nearly coincide or nearly lie in a plane, and the faces do not close",
    }

    /// A mass or inertia that no body has.
    MassError {
        /// Zero, negative or not finite, or so with the moments of inertia that go with it. A body that cannot move is
        /// `Body::immovable`.
        Mass => "mass: must be positive and finite, and the moments with it; an immovable body is `Body::immovable`",
        /// Zero, negative or not finite, or so with the mass and the moments of inertia that go with it.
        Density => "density: must be positive and finite, and the mass and moments with it",
        /// Not symmetric positive definite, or not finite.
        Inertia => "inertia: the tensor must be finite and positive definite",
        /// A principal moment exceeds the sum of the other two.
        Triangle => "inertia: a principal moment exceeds the sum of the other two",
    }

    /// A property of a surface pair that the contact law does not know.
    MaterialError {
        /// Outside 0 to 1.
        Restitution => "restitution: must lie in 0 to 1",
        /// Negative or not finite.
        Friction => "friction: must be finite and not negative",
    }

    /// A contact with an arm that is not finite.
    ContactError {
        /// From the centre of mass of body A.
        ArmA => "contact: the arm r_a is not finite",
        /// From the centre of mass of body B.
        ArmB => "contact: the arm r_b is not finite",
    }

    /// A state that is not finite.
    BodyError {
        /// The position.
        Position => "body: the position is not finite",
        /// The linear velocity.
        LinearVelocity => "body: the linear velocity is not finite",
        /// The angular velocity.
        AngularVelocity => "body: the angular velocity is not finite",
        /// The orientation.
        Orientation => "body: the orientation is not finite",
        /// The gravity scale.
        GravityScale => "body: the gravity scale is not finite",
        /// A damping.
        Damping => "body: the linear or the angular damping is not finite",
    }
}

#[cfg(feature = "embedded-graphics")]
errors! {
    /// A view that cannot be drawn.
    ViewError {
        /// The width or height of the display is zero or above 3840 pixels.
        Size => "size: a width or height is zero or above 3840 pixels",
        /// Eye and target are the same point, or one is not finite.
        Direction => "camera: it looks nowhere; eye and target are the same point, or not finite",
        /// The upward direction is that of the sight.
        Up => "camera: up is the direction in which it looks",
        /// What is seen has no width.
        HalfWidth => "lens: the half width is not positive and finite",
    }
}
