//! The worlds that there are: each a set of shapes, and how much it holds.

use core::ffi::c_void;

use super::export;
use super::pointer::{check, read, write};
use super::room::{ALIGN, Room};
use super::worlds::*;
use crate::shape::{Piece, Round};
use crate::status::carom_status;
use crate::types::*;

#[cfg(feature = "fixed")]
use fixed::types::{I12F20, I16F16};

/// How the memory of a world has to be aligned: what is declared as an array of uint64_t is.
pub const CAROM_WORLD_ALIGN: usize = 8;
const _: () = assert!(CAROM_WORLD_ALIGN >= ALIGN);

/// Worlds of one number type: for each its name and its bodies, manifolds, points and bytes.
macro_rules! capacities {
    ($p:ident, $P:ident, $number:ty, $set:ident $world:ident $what:literal: $($bodies:literal x $manifolds:literal x $points:literal = $size:literal;)+) => {
        pastey::paste! { $(
            #[doc = concat!(" Bytes of a world of ", $bodies, $what, ", ", $manifolds, " pairs that touch and ", $points, " points.")]
            pub const [<$P _ $world:upper _ $bodies X $points _SIZE>]: usize = $size;

            export! {
                #[doc = concat!(" A world of up to ", $bodies, $what, ", and in a step up to ", $manifolds, " pairs of surfaces that touch")]
                #[doc = concat!(" or are about to, with up to ", $points, " points in all.")]
                ///
                #[doc = concat!(" `memory` is an array of uint64_t of `size` bytes, ", stringify!([<$P _ $world:upper _ $bodies X $points _SIZE>]), " at least.")]
                /// It is the world's until you use it for something else: there is nothing to free. Writes to `world` what the
                /// other functions take. No pointer in it leads into itself: a copy of the memory keeps a state, and copied back
                /// it brings the state back.
                fn [<$p _ $world _ $bodies x $points _init>](
                    memory: *mut c_void,
                    size: usize,
                    settings: *const [<$p _settings>],
                    world: *mut *mut [<$p _world>],
                ) {
                    check(world)?;
                    let settings = read(settings)?.core()?;
                    type Kind = Room<$number, $set<$number>, $bodies, $manifolds, $points>;
                    let head = Kind::init::<{ [<$P _ $world:upper _ $bodies X $points _SIZE>] }>(memory, size, settings)?;
                    write(world, head.cast())
                }
            }
        )+

            #[cfg(test)]
            mod [<$p _ $world _sizes>] {
                use super::*;

                /// The numbers in the header are no more than the next multiple of 64: what is given away is less than that.
                #[test]
                fn sizes() {
                    let mut lines = std::vec::Vec::new();
                    $({
                        let needed = size_of::<Room<$number, $set<$number>, $bodies, $manifolds, $points>>().next_multiple_of(64);
                        if $size != needed {
                            lines.push(std::format!("{} x {} x {} = {needed};", $bodies, $manifolds, $points));
                        }
                    })+
                    assert!(lines.is_empty(), "write in capacities! of {}: {lines:#?}", stringify!($p));
                }
            }
        }
    };
}

// A world of another capacity is another line here.
#[cfg(feature = "f32")]
capacities! { carom_f32, CAROM_F32, f32, Piece world " bodies":
    4 x 4 x 12 = 5248;
    16 x 12 x 12 = 10304;
    16 x 32 x 64 = 25920;
    64 x 128 x 256 = 102848;
}
#[cfg(feature = "fixed")]
capacities! { carom_q16, CAROM_Q16, I16F16, Piece world " bodies":
    4 x 4 x 12 = 5440;
    16 x 12 x 12 = 10752;
    16 x 32 x 64 = 26752;
    64 x 128 x 256 = 106176;
}
#[cfg(feature = "fixed")]
capacities! { carom_q20, CAROM_Q20, I12F20, Piece world " bodies":
    4 x 4 x 12 = 5440;
    16 x 12 x 12 = 10752;
    16 x 32 x 64 = 26752;
    64 x 128 x 256 = 106176;
}

// Worlds that hold spheres and half-spaces alone: the pairs of the other shapes are not linked.
#[cfg(feature = "f32")]
capacities! { carom_f32, CAROM_F32, f32, Round balls " spheres and half-spaces":
    16 x 16 x 16 = 11712;
}
#[cfg(feature = "fixed")]
capacities! { carom_q16, CAROM_Q16, I16F16, Round balls " spheres and half-spaces":
    16 x 16 x 16 = 12224;
}
#[cfg(feature = "fixed")]
capacities! { carom_q20, CAROM_Q20, I12F20, Round balls " spheres and half-spaces":
    16 x 16 x 16 = 12224;
}
