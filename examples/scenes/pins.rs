//! The state hashes that every machine must reach, by number type. A changed one is a changed result: say so in the
//! changelog.

type Pins = [(&'static str, u64); 6];

/// After the ten thousand impacts.
const IMPACTS: Pins = [("f32", 0), ("f64", 0), ("i16f16", 0), ("i12f20", 0), ("i8f24", 0), ("micromath", 0)];

/// After the billiard break.
const BILLIARD_BREAK: Pins = [("f32", 0), ("f64", 0), ("i16f16", 0), ("i12f20", 0), ("i8f24", 0), ("micromath", 0)];

fn pin(pins: &Pins, scalar: &str) -> Option<u64> {
    pins.iter().find(|(name, _)| *name == scalar).map(|(_, hash)| *hash)
}

/// The hash after the ten thousand impacts.
pub fn impacts(scalar: &str) -> Option<u64> {
    pin(&IMPACTS, scalar)
}

/// The hash after the billiard break.
pub fn billiard_break(scalar: &str) -> Option<u64> {
    pin(&BILLIARD_BREAK, scalar)
}
