//! A closed set of shapes as one type.

/// Makes one type of the shapes that a world holds: an enum with a variant for each, which is a [`Shape`](crate::Shape) and
/// meets every other of its kind. Only the pairs of these shapes are linked.
///
/// ```
/// # #[cfg(feature = "f32")] {
/// use carom::{Cuboid, HalfSpace, Sphere, UnitVec3};
///
/// carom::shapes! {
///     /// What lies on the table.
///     pub enum Piece<S> { Sphere, Cuboid, HalfSpace }
/// }
///
/// let table: Piece<f32> = HalfSpace::new(UnitVec3::Z).into();
/// let ball: Piece<f32> = Sphere::new(0.5)?.into();
/// # }
/// # Ok::<(), carom::ShapeError>(())
/// ```
///
/// A variant named otherwise than its type, or of a type with parameters, gives the type:
/// `pub enum Piece<'a, S> { Ball(Sphere<S>), Track(HeightField<'a, S>) }`.
#[macro_export]
macro_rules! shapes {
    // Each variant with its type, one after the other.
    (@name $head:tt [$($named:tt)*]) => { $crate::shapes!(@make $head $($named)*); };
    (@name $head:tt $named:tt , $($rest:tt)*) => { $crate::shapes!(@name $head $named $($rest)*); };
    (@name { $($head:tt)* } [$($named:tt)*] $(#[$meta:meta])* $variant:ident ($shape:ty) $($rest:tt)*) => {
        $crate::shapes!(@name { $($head)* } [$($named)* { [$(#[$meta])*] $variant ($shape) }] $($rest)*);
    };
    (@name { $metas:tt $vis:tt $name:ident $lives:tt $s:ident } [$($named:tt)*] $(#[$meta:meta])* $variant:ident $($rest:tt)*) => {
        $crate::shapes!(@name { $metas $vis $name $lives $s }
            [$($named)* { [$(#[$meta])*] $variant ($crate::$variant<$s>) }] $($rest)*);
    };
    (@make { [$($meta:tt)*] [$vis:vis] $name:ident [$($life:lifetime)*] $s:ident }
        $({ [$($variant_meta:tt)*] $variant:ident ($shape:ty) })+
    ) => {
        $($meta)*
        #[derive(Clone, Copy, Debug, PartialEq)]
        $vis enum $name<$($life,)* $s: $crate::Scalar> {
            $($($variant_meta)* #[allow(missing_docs)] $variant($shape),)+
        }

        $crate::shapes!(@from [$($life)*] $name $s $({ $variant $shape })+);
        $crate::shapes!(@members [$($life)*] $name $s $({ $variant $shape })+);

        impl<$($life,)* $s: $crate::Scalar> $crate::Shape<$s> for $name<$($life,)* $s> {
            fn aabb(&self, pose: &$crate::Pose<$s>) -> $crate::Aabb<$s> {
                match self { $(Self::$variant(shape) => $crate::Shape::<$s>::aabb(shape, pose),)+ }
            }

            fn inner_radius(&self) -> $s {
                match self { $(Self::$variant(shape) => $crate::Shape::<$s>::inner_radius(shape),)+ }
            }

            fn outer_radius(&self) -> $s {
                match self { $(Self::$variant(shape) => $crate::Shape::<$s>::outer_radius(shape),)+ }
            }

            fn cast_ray(&self, pose: &$crate::Pose<$s>, ray: &$crate::Ray<$s>) -> Option<$crate::RayHit<$s>> {
                match self { $(Self::$variant(shape) => $crate::Shape::<$s>::cast_ray(shape, pose, ray),)+ }
            }

            fn closest_point(
                &self,
                pose: &$crate::Pose<$s>,
                point: $crate::Vec3<$s>,
            ) -> Option<$crate::SurfacePoint<$s>> {
                match self { $(Self::$variant(shape) => $crate::Shape::<$s>::closest_point(shape, pose, point),)+ }
            }

            fn outline<Sink: $crate::OutlineSink<$s>>(&self, pose: &$crate::Pose<$s>, sink: &mut Sink) {
                match self { $(Self::$variant(shape) => $crate::Shape::<$s>::outline(shape, pose, sink),)+ }
            }
        }

        impl<$($life,)* $s: $crate::Scalar> $name<$($life,)* $s> {
            fn meet<First, Sink: $crate::ManifoldSink<$s>>(
                &self,
                pose: &$crate::Pose<$s>,
                (first, first_pose): (&First, &$crate::Pose<$s>),
                margin: $s,
                sink: &mut Sink,
            ) where
                $(First: $crate::Collide<$s, $shape>),+
            {
                match self { $(Self::$variant(shape) => first.collide(first_pose, shape, pose, margin, sink),)+ }
            }

            fn closest_of<First>(
                &self,
                pose: &$crate::Pose<$s>,
                (first, first_pose): (&First, &$crate::Pose<$s>),
            ) -> Option<$crate::Closest<$s>>
            where
                $(First: $crate::Collide<$s, $shape>),+
            {
                match self { $(Self::$variant(shape) => first.closest(first_pose, shape, pose),)+ }
            }

            fn is_met<First>(
                &self,
                pose: &$crate::Pose<$s>,
                (first, first_pose): (&First, &$crate::Pose<$s>),
            ) -> bool
            where
                $(First: $crate::Collide<$s, $shape>),+
            {
                match self { $(Self::$variant(shape) => first.overlaps(first_pose, shape, pose),)+ }
            }
        }

        impl<$($life,)* $s: $crate::Scalar> $crate::Collide<$s, $name<$($life,)* $s>> for $name<$($life,)* $s> {
            fn collide<Sink: $crate::ManifoldSink<$s>>(
                &self,
                pose: &$crate::Pose<$s>,
                other: &Self,
                other_pose: &$crate::Pose<$s>,
                margin: $s,
                sink: &mut Sink,
            ) {
                match self { $(Self::$variant(shape) => other.meet(other_pose, (shape, pose), margin, sink),)+ }
            }

            fn closest(
                &self,
                pose: &$crate::Pose<$s>,
                other: &Self,
                other_pose: &$crate::Pose<$s>,
            ) -> Option<$crate::Closest<$s>> {
                match self { $(Self::$variant(shape) => other.closest_of(other_pose, (shape, pose)),)+ }
            }

            fn overlaps(&self, pose: &$crate::Pose<$s>, other: &Self, other_pose: &$crate::Pose<$s>) -> bool {
                match self { $(Self::$variant(shape) => other.is_met(other_pose, (shape, pose)),)+ }
            }
        }
    };
    (@members [$($life:lifetime)*] $name:ident $s:ident $({ $variant:ident $shape:ty })+) => {
        impl<$($life,)* $s: $crate::Scalar, Other: $crate::Member> $crate::Collide<$s, Other> for $name<$($life,)* $s>
        where
            $($shape: $crate::Collide<$s, Other>),+
        {
            fn collide<Sink: $crate::ManifoldSink<$s>>(
                &self,
                pose: &$crate::Pose<$s>,
                other: &Other,
                other_pose: &$crate::Pose<$s>,
                margin: $s,
                sink: &mut Sink,
            ) {
                match self { $(Self::$variant(shape) => shape.collide(pose, other, other_pose, margin, sink),)+ }
            }

            fn closest(
                &self,
                pose: &$crate::Pose<$s>,
                other: &Other,
                other_pose: &$crate::Pose<$s>,
            ) -> Option<$crate::Closest<$s>> {
                match self { $(Self::$variant(shape) => shape.closest(pose, other, other_pose),)+ }
            }

            fn overlaps(&self, pose: &$crate::Pose<$s>, other: &Other, other_pose: &$crate::Pose<$s>) -> bool {
                match self { $(Self::$variant(shape) => shape.overlaps(pose, other, other_pose),)+ }
            }
        }
    };
    (@from $lives:tt $name:ident $s:ident $({ $variant:ident $shape:ty })+) => {
        $($crate::shapes!(@from_one $lives $name $s $variant $shape);)+
    };
    (@from_one [$($life:lifetime)*] $name:ident $s:ident $variant:ident $shape:ty) => {
        impl<$($life,)* $s: $crate::Scalar> From<$shape> for $name<$($life,)* $s> {
            #[inline]
            fn from(shape: $shape) -> Self {
                Self::$variant(shape)
            }
        }
    };
    ($(#[$meta:meta])* $vis:vis enum $name:ident<$($life:lifetime,)* $s:ident> { $($variants:tt)+ }) => {
        $crate::shapes!(@name { [$(#[$meta])*] [$vis] $name [$($life)*] $s } [] $($variants)+);
    };
}
