//! What bodies look like in a trace.

use carom::{Capsule, Cuboid, HalfSpace, Scalar, Sphere};

use super::word;
use crate::board::BinaryWriter;
use crate::scenes;

/// How a body is to be drawn.
#[derive(Clone, Copy)]
#[repr(u8)]
pub enum Look {
    Plain = 0,
    /// With pips: the face along x is the one, y the two, z the three; opposite faces add up to seven.
    Die = 1,
    /// Something that notices and stops nothing.
    Sensor = 2,
}

/// A shape that a trace can hold.
pub trait Traced<S: Scalar> {
    /// Writes its kind, then its sizes.
    fn write(&self, file: &mut BinaryWriter);
}

impl<S: Scalar> Traced<S> for HalfSpace<S> {
    fn write(&self, file: &mut BinaryWriter) {
        file.bytes(b"H");
        self.normal().get().to_array().into_iter().for_each(|part| word(file, part));
    }
}

impl<S: Scalar> Traced<S> for Sphere<S> {
    fn write(&self, file: &mut BinaryWriter) {
        file.bytes(b"S");
        word(file, self.radius());
    }
}

impl<S: Scalar> Traced<S> for Cuboid<S> {
    fn write(&self, file: &mut BinaryWriter) {
        file.bytes(b"B");
        self.half_extents().to_array().into_iter().for_each(|part| word(file, part));
    }
}

impl<S: Scalar> Traced<S> for Capsule<S> {
    fn write(&self, file: &mut BinaryWriter) {
        file.bytes(b"C");
        word(file, self.radius());
        word(file, self.half_length());
    }
}

/// The sets of shapes of the scenes.
macro_rules! sets {
    ($($scene:ident: $($shape:ident),+;)+) => {$(
        impl<S: Scalar> Traced<S> for scenes::$scene::Piece<S> {
            fn write(&self, file: &mut BinaryWriter) {
                match self { $(Self::$shape(shape) => shape.write(file)),+ }
            }
        }
    )+};
}

sets! {
    billiards: Sphere, HalfSpace;
    dice: Cuboid, HalfSpace;
    maze: Sphere, Cuboid, HalfSpace;
    pinball: Sphere, Capsule, HalfSpace;
    stack: Cuboid, HalfSpace;
}
