//! Is this chip one of those with the same bits? Needs nothing of it but the core.

use crate::number::{NAME, Real};
use crate::scenes::pins::pin;
use crate::scenes::{billiards, cradle, dice, edge, impacts, maze, pinball, shapes, stack, table};
use rtt_target::rprintln;

type State = fn() -> Option<u64>;

const SCENES: [(&str, State); 10] = [
    ("impacts", impacts::hash::<Real>),
    ("billiard_break", table::hash::<Real>),
    ("edge", edge::hash::<Real>),
    ("newtons_cradle", cradle::hash::<Real>),
    ("dice", dice::hash::<Real>),
    ("marble_maze", maze::hash::<Real>),
    ("billiards", billiards::hash::<Real>),
    ("stack", stack::hash::<Real>),
    ("pinball", pinball::hash::<Real>),
    ("shapes", || shapes::meet_all::<Real>(&mut |_| ())),
];

/// Prints each pinned state beside what came of its scene here.
pub fn print() {
    rprintln!("carom on this chip, in {}", NAME);
    let mut same = float_environment();
    for (scene, state) in SCENES {
        let (pinned, found) = (pin(scene, NAME).unwrap_or_default(), state().unwrap_or_default());
        same &= found == pinned;
        if found == pinned {
            rprintln!("{:<15} {:016x}  as pinned", scene, found);
        } else {
            rprintln!("{:<15} {:016x}  pinned, but here {:016x}", scene, pinned, found);
        }
    }
    rprintln!("{}", if same { "the same bits as elsewhere" } else { "NOT the same bits as elsewhere" });
}

/// Says what is wrong with it, if something is.
fn float_environment() -> bool {
    #[cfg(feature = "f32")]
    if let Err(error) = carom::check_float_environment() {
        rprintln!("{}", error);
        return false;
    }
    true
}
